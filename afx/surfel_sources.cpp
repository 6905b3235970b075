// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/surfel_sources.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <optional>
#include <string>

#include "afx/layer_leaning.h"
#include "afx/layer_samples.h"
#include "afx/octree_colours.h"
#include "afx/pixel_pieces.h"
#include "afx/reference_projection.h"
#include "afx/voxel_blocks.h"
#include "afx/voxel_surface.h"
#include "codec/octree_voxels.h"
#include "codec/parallel.h"

namespace afx {
namespace {

/// The pixels of a SimpleTexture, counted from the lower left.
class SimpleSamples {
 public:
  SimpleSamples(const DepthImage& image, const SimpleTexture& texture)
      : camera_(image.camera), texture_(texture), dmax_(texture.dmax()) {}

  [[nodiscard]] size_t count(uint32_t i, uint32_t j) const { return at(i, j) ? 1 : 0; }
  [[nodiscard]] PixelSample sample(uint32_t i, uint32_t j, size_t) const { return *at(i, j); }
  /// The distance seen in a pixel.
  [[nodiscard]] std::optional<double> nearest(uint32_t i, uint32_t j, double) const {
    const std::optional<PixelSample> seen = at(i, j);
    return seen ? std::optional(seen->distance) : std::nullopt;
  }

 private:
  [[nodiscard]] std::optional<PixelSample> at(uint32_t i, uint32_t j) const {
    const uint32_t row = texture_.colour.height - 1 - j;
    const uint16_t depth = texture_.depth.samples[size_t{row} * texture_.colour.width + i];
    const Rgba8 colour = colour_at(texture_.colour, i, row);
    if (depth == 0 || colour.a == 0) return std::nullopt;
    return PixelSample{depth_to_distance(depth, dmax_, camera_), colour};
  }

  const DepthCamera& camera_;
  const SimpleTexture& texture_;
  uint64_t dmax_;
};

/// Pixels as a DepthImage has them.
PixelGrid grid_of(const DepthImage& image, uint64_t dmax) {
  PixelGrid grid{image.camera, image.width(), image.height()};
  grid.step = (image.camera.far_plane - image.camera.near_plane) /
              static_cast<double>(std::max<uint64_t>(dmax, 2) - 1);
  return grid;
}

/// A unit vector perpendicular to a unit vector.
glm::vec3 perpendicular(const glm::vec3& n) {
  const glm::vec3 a = glm::abs(n);
  const glm::vec3 axis = a.x <= a.y && a.x <= a.z ? glm::vec3(1, 0, 0)
                         : a.y <= a.z             ? glm::vec3(0, 1, 0)
                                                  : glm::vec3(0, 0, 1);
  return glm::normalize(glm::cross(axis, n));
}

bool is_finite(const glm::dmat4& m) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      if (!std::isfinite(m[column][row])) return false;
  return true;
}

/// The pieces of each part of one object, its own coordinates.
Result<std::vector<Surfels>> parts_of(const DibrModel& model, unsigned threads,
                                      const Limits& limits, Diagnostics& diagnostics) {
  std::vector<Surfels> parts;
  const auto take = [&](Result<Surfels> part) -> Status {
    if (!part.ok()) return part.error();
    parts.push_back(std::move(part).value());
    return {};
  };
  if (const OctreeModel* octree = model.octree()) {
    if (Status s = take(surfels_of(*octree, threads, limits, diagnostics)); !s.ok())
      return s.error();
    return parts;
  }
  for (const DepthImage& image : *model.depth_images())
    if (Status s = take(surfels_of(image, threads, limits)); !s.ok()) return s.error();
  return parts;
}

}  // namespace

void push_square(Surfels& surfels, const glm::dvec3& centre, const glm::vec3& normal, float half,
                 Rgba8 colour) {
  const glm::vec3 n = normal == glm::vec3(0) ? glm::vec3(0, 0, 1) : normal;
  const glm::vec3 u = perpendicular(n);
  surfels.push_back(centre, half * u, half * glm::cross(n, u), colour);
}

void append(const Surfels& from, const glm::dmat4& to_world, Surfels& to) {
  const glm::dmat3 linear(to_world);
  const bool mirrors = glm::determinant(linear) < 0;
  for (size_t n = 0; n < from.size(); ++n) {
    const glm::vec3 u(linear * glm::dvec3(from.u[n])), v(linear * glm::dvec3(from.v[n]));
    const glm::dvec3 centre(to_world * glm::dvec4(from.centres[n], 1));
    to.push_back(centre, mirrors ? v : u, mirrors ? u : v, from.colours[n]);
  }
}

Result<Surfels> surfels_of(const DepthImage& image, unsigned threads, const Limits& limits) {
  if (Status checked = check_depth_image(image); !checked.ok()) return checked.error();
  if (const auto* simple = std::get_if<SimpleTexture>(&image.texture))
    return pieces_of(grid_of(image, simple->dmax()), SimpleSamples(image, *simple), threads,
                     limits);
  const auto& layers = std::get<PointTexture>(image.texture);
  if (Status memory = check_surfel_memory(layers.depths.size(), limits); !memory.ok())
    return memory.error();
  const PixelGrid grid = grid_of(image, layers.dmax());
  const LayerSamples samples(image, layers);
  Result<Surfels> pieces = pieces_of(grid, samples, threads, limits);
  if (pieces.ok()) lean_along_layers(grid, samples, threads, pieces.value());
  return pieces;
}

Result<Surfels> surfels_of(const OctreeModel& model, unsigned threads, const Limits& limits,
                           Diagnostics& diagnostics) {
  const unsigned levels = octree_levels(model.resolution);
  const auto coloured = colour_octree(model, levels, threads, limits, diagnostics);
  if (!coloured.ok()) return coloured.error();
  const ColouredVoxels& voxels = coloured.value();
  if (Status memory = check_surfel_memory(voxels.codes.size(), limits); !memory.ok())
    return memory.error();
  const VoxelBlocks blocks(voxels.codes);
  const auto [normals, heights, seen] = voxel_surface(voxels.codes, levels, blocks, threads);
  const double side = std::ldexp(1.0, -static_cast<int>(levels));
  const auto half = static_cast<float>(kVoxelHalfSide * side);
  Surfels surfels;
  surfels.reserve(voxels.codes.size());
  for (size_t n = 0; n < voxels.codes.size(); ++n) {
    const glm::dvec3 shift = side * static_cast<double>(heights[n]) * glm::dvec3(normals[n]);
    push_square(surfels, voxel_centre(voxels.codes[n], levels) + shift, normals[n], half,
                voxels.colours[n]);
  }
  return surfels;
}

Result<Surfels> surfels_of(std::span<const DibrModel> models, unsigned threads,
                           const Limits& limits, Diagnostics& diagnostics) {
  Surfels all;
  for (const DibrModel& model : models) {
    if (!is_finite(model.to_world))
      return Error{Errc::bad_argument, Place::none(), "a transform of the scene is not finite"};
    const auto parts = parts_of(model, threads, limits, diagnostics);
    if (!parts.ok()) return parts.error();
    for (const Surfels& part : parts.value()) {
      if (Status memory = check_surfel_memory(uint64_t{all.size()} + part.size(), limits);
          !memory.ok())
        return memory.error();
      append(part, model.to_world, all);
    }
  }
  if (!are_near_enough(all))
    return Error{Errc::bad_argument, Place::none(),
                 "a transform of the scene moves points beyond 1e37"};
  return all;
}

}  // namespace afx
