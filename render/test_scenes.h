// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Voxel models for the tests of this folder.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <utility>
#include <vector>

#include "codec/octree_voxels.h"
#include "render/renderer.h"

namespace afx::render {

inline constexpr Rgba8 kRed{255, 0, 0, 255};
inline constexpr Rgba8 kBlue{0, 0, 255, 255};

/// Voxels with their colours.
struct TestModel {
  unsigned level = 0;
  std::vector<uint64_t> codes;
  std::vector<Rgba8> colours;

  [[nodiscard]] VoxelCloud cloud() const {
    return {VoxelTree::make(level, codes, colours).value(), glm::dmat4(1)};
  }
  [[nodiscard]] Scene scene() const { return {.voxels = {cloud()}}; }
  /// With the surface that voxels of models are drawn with.
  [[nodiscard]] VoxelCloud smooth_cloud() const {
    const VoxelSurface surface = voxel_surface(codes, level, VoxelBlocks(codes), 1);
    return {VoxelTree::make(level, codes, colours, &surface).value(), glm::dmat4(1)};
  }
};

/// Voxels added in any order, sorted in the end; of several in one place the first stays.
class TestModelMaker {
 public:
  explicit TestModelMaker(unsigned level) : level_(level) {}
  void add(Voxel v, Rgba8 colour) { voxels_.emplace_back(codec::morton_code(v), colour); }

  TestModel make() {
    std::stable_sort(voxels_.begin(), voxels_.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    voxels_.erase(std::unique(voxels_.begin(), voxels_.end(),
                              [](const auto& a, const auto& b) { return a.first == b.first; }),
                  voxels_.end());
    TestModel model;
    model.level = level_;
    for (const auto& [code, colour] : voxels_) {
      model.codes.push_back(code);
      model.colours.push_back(colour);
    }
    return model;
  }

 private:
  unsigned level_;
  std::vector<std::pair<uint64_t, Rgba8>> voxels_;
};

/// Adds the voxels that the sphere around the centre of the cube passes through: a shell one voxel
/// thick that no line of sight passes. Slabs are searched only where the sphere can be.
inline void add_sphere(TestModelMaker& maker, unsigned level, double radius, Rgba8 colour) {
  const int side = 1 << level;
  const double r = radius * side;
  const auto nearest = [side](int at) {
    const double a = at - side / 2.0;
    return a >= 0 ? a : -a - 1;
  };
  for (int z = 0; z < side; ++z) {
    for (int y = 0; y < side; ++y) {
      const double ny = nearest(y), nz = nearest(z);
      const double near2 = ny * ny + nz * nz;
      const double far2 = (ny + 1) * (ny + 1) + (nz + 1) * (nz + 1);
      if (near2 > r * r) continue;
      for (int x = 0; x < side; ++x) {
        const double nx = nearest(x);
        if (near2 + nx * nx > r * r || far2 + (nx + 1) * (nx + 1) < r * r) continue;
        maker.add({static_cast<uint32_t>(x), static_cast<uint32_t>(y), static_cast<uint32_t>(z)},
                  colour);
      }
    }
  }
}

/// Looks at the origin from `direction` at `distance`, with any roll.
inline Camera looking_at_origin(glm::dvec3 direction, double distance) {
  direction = glm::normalize(direction);
  Camera camera;
  camera.position = direction * distance;
  const glm::dvec3 back(0, 0, 1);
  const double cosine = glm::dot(back, direction);
  camera.orientation = cosine < -0.999999
                           ? glm::dquat(0, 0, 1, 0)
                           : glm::normalize(glm::dquat(1 + cosine, glm::cross(back, direction)));
  return camera;
}

/// Directions spread evenly over the sphere.
inline std::vector<glm::dvec3> directions(int count) {
  std::vector<glm::dvec3> all;
  for (int k = 0; k < count; ++k) {
    const double z = 1 - (2 * k + 1) / static_cast<double>(count);
    const double angle = k * 2.399963229728653;  // the golden angle
    const double r = std::sqrt(1 - z * z);
    all.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
  }
  return all;
}

}  // namespace afx::render
