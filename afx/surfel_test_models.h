// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// For tests: depth images and octrees whose surfaces can be told beforehand.
#pragma once

#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <random>
#include <utility>
#include <vector>

#include "afx/depth_image.h"
#include "afx/octree_model.h"
#include "codec/octree_voxels.h"

namespace afx {

inline DepthCamera test_camera(bool orthographic) {
  DepthCamera camera;
  camera.position = {1, -2, 3};
  camera.orientation = glm::angleAxis(0.7, glm::normalize(glm::dvec3(1, 2, -1)));
  camera.orthographic = orthographic;
  camera.field_of_view = orthographic ? glm::dvec2(4, 3) : glm::dvec2(0.9, 0.7);
  camera.near_plane = 2;
  camera.far_plane = 6;
  return camera;
}

/// A picture of one colour without depths.
inline SimpleTexture empty_texture(uint32_t width, uint32_t height, unsigned bits,
                                   uint32_t components = 3) {
  SimpleTexture texture;
  texture.colour = Picture(width, height, components);
  texture.depth = {width, height, 1, bits, std::vector<uint16_t>(size_t{width} * height)};
  return texture;
}

/// Random colours over slopes, cliffs and holes.
inline SimpleTexture rough_texture(uint32_t width, uint32_t height, unsigned bits,
                                   uint32_t components, uint32_t seed) {
  std::mt19937 random(seed);
  SimpleTexture texture = empty_texture(width, height, bits, components);
  for (uint8_t& sample : texture.colour.samples) sample = static_cast<uint8_t>(random());
  const auto most = static_cast<double>(texture.dmax());
  for (uint32_t y = 0; y < height; ++y)
    for (uint32_t x = 0; x < width; ++x) {
      const double slope = 0.2 + 0.6 * (x + 0.7 * y) / (width + height);
      const double depth = random() % 5 == 0 ? static_cast<double>(random() % 1000) / 1000 : slope;
      const bool seen = random() % 6 != 0;
      uint8_t* pixel = texture.colour.pixel(x, y);
      if (components % 2 == 0 && seen && pixel[components - 1] == 0) pixel[components - 1] = 1;
      texture.depth.samples[size_t{y} * width + x] =
          seen ? static_cast<uint16_t>(1 + depth * (most - 1)) : uint16_t{0};
      if (!seen) std::fill_n(pixel, components, uint8_t{0});
    }
  return texture;
}

/// The voxels that the surface of a sphere around the cube's centre passes through, as Morton
/// codes. radius   in units of the cube
inline std::vector<uint64_t> sphere_voxels(unsigned levels, double radius) {
  const uint32_t side = 1U << levels;
  std::vector<uint64_t> codes;
  for (uint64_t code = 0; code < uint64_t{side} * side * side; ++code) {
    const Voxel v = codec::morton_decode(code);
    const glm::dvec3 low = glm::dvec3(v.x, v.y, v.z) / double(side) - 0.5;
    const glm::dvec3 high = low + 1.0 / side;
    const glm::dvec3 nearest = glm::clamp(glm::dvec3(0), low, high);
    const glm::dvec3 farthest = glm::max(glm::abs(low), glm::abs(high));
    if (glm::length(nearest) <= radius && glm::length(farthest) >= radius) codes.push_back(code);
  }
  return codes;
}

/// An octree without images.
inline OctreeModel octree_of(const std::vector<uint64_t>& codes, unsigned levels) {
  OctreeModel model;
  model.resolution = 1U << levels;
  model.fields.octree = codec::octree_from_morton(codes, levels);
  return model;
}

}  // namespace afx
