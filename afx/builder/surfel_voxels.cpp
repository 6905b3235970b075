// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/surfel_voxels.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "afx/builder/cube_cut.h"
#include "afx/srgb.h"

namespace afx {
namespace {

constexpr double kPointSide = 1.001;  // of a voxel; a piece of just its size is a point
constexpr double kVoxelSide = 1.75;   // the longest that a voxel's own piece is
constexpr double kMostCubes = 256;    // along a piece: beyond, its corners lose their places
// Twice: as they are, and cut.
constexpr uint64_t kQuadBytes =
    2 * (4 * 2 * sizeof(glm::vec3) + 2 * (sizeof(glm::uvec3) + sizeof(uint32_t)));

/// The pieces in two kinds, both around the centre of the grid.
struct Parts {
  PointCloud points;
  Mesh quads;
  uint64_t outside = 0;  ///< pieces that reach out of the cube
};

/// The octree's cube around the centre of the grid, and what fixed point rounds into it.
Cube cube_around_centre(const Grid& grid) {
  const auto voxels = static_cast<double>(1U << grid.levels);
  return {glm::dvec3((voxels / 2 - grid.middle) / grid.scale),
          (voxels + 1.0 / kSubvoxels) / grid.scale};
}

class Splitter {
 public:
  Splitter(const Surfels& surfels, const Grid& grid)
      : surfels_(surfels), grid_(grid), cube_(cube_around_centre(grid)) {
    parts_.quads.materials.emplace_back();
    parts_.quads.has_colours = true;
  }

  Result<Parts> split(const Limits& limits) {
    for (size_t n = 0; n < surfels_.size(); ++n) {
      if (surfels_.colours[n].a != 0) add(n);
      if (parts_.quads.positions.size() / 4 > limits.memory / kQuadBytes)
        return Error{Errc::limit_exceeded, Place::none(),
                     "the pieces of surface take more memory than the limit"};
    }
    if (parts_.outside > 0) {
      uint64_t triangles = 0;
      parts_.quads = inside_of_cube(parts_.quads, cube_, triangles);
    }
    return std::move(parts_);
  }

 private:
  void add(size_t n) {
    const double side = 2 * grid_.scale * std::max(length(surfels_.u[n]), length(surfels_.v[n]));
    const glm::dvec3 place = grid_.to_voxels(surfels_.centres[n]);
    if (side <= kPointSide || (side <= kVoxelSide && is_across_the_middle(n, place)))
      add_point(n);
    else if (side <= kMostCubes * static_cast<double>(1U << grid_.levels))
      add_quad(n);
    else
      ++parts_.outside;
  }

  static double length(const glm::vec3& v) { return glm::length(glm::dvec3(v)); }

  [[nodiscard]] bool is_across_the_middle(size_t n, const glm::dvec3& place) const {
    const glm::dvec3 normal = glm::cross(glm::dvec3(surfels_.u[n]), glm::dvec3(surfels_.v[n]));
    const glm::dvec3 off = place - glm::floor(place) - 0.5;
    return glm::length(glm::cross(off, normal)) < 1e-3 * glm::length(normal);
  }

  [[nodiscard]] glm::vec3 around_centre(size_t n, const glm::vec3& off) const {
    return glm::vec3(surfels_.centres[n] - grid_.object_centre + glm::dvec3(off));
  }

  /// Whether a point around the centre is in the cube.
  [[nodiscard]] bool holds(const glm::vec3& point) const {
    const glm::dvec3 off = glm::abs(glm::dvec3(point) - cube_.centre);
    const double half = cube_.side / 2;
    return off.x <= half && off.y <= half && off.z <= half;
  }

  void add_point(size_t n) {
    const glm::vec3 centre = around_centre(n, glm::vec3(0));
    if (!holds(centre)) {
      ++parts_.outside;
      return;
    }
    parts_.points.positions.push_back(centre);
    parts_.points.colours.push_back(surfels_.colours[n]);
    parts_.points.normals.push_back(glm::cross(surfels_.u[n], surfels_.v[n]) *
                                    static_cast<float>(grid_.scale * grid_.scale));
  }

  void add_quad(size_t n) {
    Mesh& mesh = parts_.quads;
    const auto first = static_cast<uint32_t>(mesh.positions.size());
    const glm::vec3 u = surfels_.u[n], v = surfels_.v[n];
    bool inside = true;
    for (const glm::vec3& off : {-u - v, u - v, u + v, -u + v}) {
      const glm::vec3 corner = around_centre(n, off);
      inside = inside && holds(corner);
      mesh.positions.push_back(corner);
      mesh.colours.emplace_back(linear_light(surfels_.colours[n]));
    }
    if (!inside) ++parts_.outside;
    mesh.triangles.emplace_back(first, first + 1, first + 2);
    mesh.triangles.emplace_back(first, first + 2, first + 3);
    mesh.material_of.insert(mesh.material_of.end(), 2, 0);
  }

  const Surfels& surfels_;
  const Grid& grid_;
  Cube cube_;  // around the centre
  Parts parts_;
};

Rgba8 mean_of(Rgba8 a, Rgba8 b) {
  if (a == b) return a;
  return to_srgb((linear_light(a) + linear_light(b)) / 2.0);
}

glm::vec3 mean_of(const glm::vec3& a, const glm::vec3& b) {
  const float length = glm::length(a + b);
  return length > 1e-6F ? (a + b) / length : glm::vec3(0);
}

/// Both lists in one; what is in both has the mean.
SurfaceVoxels merge(const SurfaceVoxels& a, const SurfaceVoxels& b) {
  SurfaceVoxels all;
  const auto add = [&](const SurfaceVoxels& from, size_t n) {
    all.codes.push_back(from.codes[n]);
    all.colours.push_back(from.colours[n]);
    all.normals.push_back(from.normals[n]);
  };
  size_t i = 0, k = 0;
  while (i < a.codes.size() || k < b.codes.size()) {
    const bool first = k == b.codes.size() || (i < a.codes.size() && a.codes[i] <= b.codes[k]);
    const bool both = first && k < b.codes.size() && a.codes[i] == b.codes[k];
    if (first)
      add(a, i++);
    else
      add(b, k++);
    if (!both) continue;
    all.colours.back() = mean_of(all.colours.back(), b.colours[k]);
    all.normals.back() = mean_of(all.normals.back(), b.normals[k]);
    ++k;
  }
  return all;
}

}  // namespace

Result<SurfaceVoxels> voxelize(const Surfels& surfels, const Grid& grid, unsigned threads,
                               const Limits& limits, uint64_t& outside) {
  Result<Parts> parts = Splitter(surfels, grid).split(limits);
  if (!parts.ok()) return parts.error();
  outside = parts.value().outside;
  Grid around_centre = grid;
  around_centre.object_centre = glm::dvec3(0);
  auto points = voxelize(parts.value().points, around_centre, limits);
  if (!points.ok() || parts.value().quads.triangles.empty()) return points;
  const auto quads = voxelize(parts.value().quads, around_centre, threads, limits);
  if (!quads.ok()) return quads.error();
  SurfaceVoxels all = merge(points.value(), quads.value());
  if (all.codes.size() > limits.octree_nodes)
    return Error{Errc::limit_exceeded, Place::none(),
                 "the surface has more voxels than the limit (a lower resolution has fewer)"};
  return all;
}

}  // namespace afx
