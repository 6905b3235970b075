// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/surfel_voxels.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "afx/srgb.h"

namespace afx {
namespace {

constexpr double kPointSide = 1.001;  // of a voxel; a piece of just its size is a point
constexpr double kVoxelSide = 1.75;   // the longest that a voxel's own piece is
constexpr uint64_t kQuadBytes =
    4 * 2 * sizeof(glm::vec3) + 2 * (sizeof(glm::uvec3) + sizeof(uint32_t));

/// The pieces in two kinds, both around the centre of the grid.
struct Parts {
  PointCloud points;
  Mesh quads;
};

glm::vec3 linear_colour(Rgba8 c) {
  const auto& linear = srgb_to_linear();
  return {linear[c.r], linear[c.g], linear[c.b]};
}

class Splitter {
 public:
  Splitter(const Surfels& surfels, const Grid& grid) : surfels_(surfels), grid_(grid) {
    parts_.quads.materials.emplace_back();
    parts_.quads.has_colours = true;
  }

  Result<Parts> split(const Limits& limits) {
    const auto cube = static_cast<double>(1U << grid_.levels);
    for (size_t n = 0; n < surfels_.size(); ++n) {
      const glm::dvec3 place =
          (surfels_.centres[n] - grid_.object_centre) * grid_.scale + glm::dvec3(grid_.middle);
      const auto inside = [&](double v) { return v >= 0 && v <= cube; };
      const double side = 2 * grid_.scale * std::max(length(surfels_.u[n]), length(surfels_.v[n]));
      if (surfels_.colours[n].a == 0 || !inside(place.x) || !inside(place.y) || !inside(place.z) ||
          !(side <= 4 * cube))
        continue;
      if (side <= kPointSide || (side <= kVoxelSide && is_across_the_middle(n, place)))
        add_point(n);
      else
        add_quad(n);
      if (parts_.quads.positions.size() / 4 > limits.memory / kQuadBytes)
        return Error{Errc::limit_exceeded, Place::none(),
                     "the pieces of surface take more memory than the limit"};
    }
    return std::move(parts_);
  }

 private:
  static double length(const glm::vec3& v) { return glm::length(glm::dvec3(v)); }

  [[nodiscard]] bool is_across_the_middle(size_t n, const glm::dvec3& place) const {
    const glm::dvec3 normal = glm::cross(glm::dvec3(surfels_.u[n]), glm::dvec3(surfels_.v[n]));
    const glm::dvec3 off = place - glm::floor(place) - 0.5;
    return glm::length(glm::cross(off, normal)) < 1e-3 * glm::length(normal);
  }

  [[nodiscard]] glm::vec3 around_centre(size_t n, const glm::vec3& off) const {
    return glm::vec3(surfels_.centres[n] - grid_.object_centre + glm::dvec3(off));
  }

  void add_point(size_t n) {
    parts_.points.positions.push_back(around_centre(n, glm::vec3(0)));
    parts_.points.colours.push_back(surfels_.colours[n]);
    parts_.points.normals.push_back(glm::cross(surfels_.u[n], surfels_.v[n]) *
                                    static_cast<float>(grid_.scale * grid_.scale));
  }

  void add_quad(size_t n) {
    Mesh& mesh = parts_.quads;
    const auto first = static_cast<uint32_t>(mesh.positions.size());
    const glm::vec3 u = surfels_.u[n], v = surfels_.v[n];
    for (const glm::vec3& corner : {-u - v, u - v, u + v, -u + v}) {
      mesh.positions.push_back(around_centre(n, corner));
      mesh.colours.push_back(linear_colour(surfels_.colours[n]));
    }
    mesh.triangles.emplace_back(first, first + 1, first + 2);
    mesh.triangles.emplace_back(first, first + 2, first + 3);
    mesh.material_of.insert(mesh.material_of.end(), 2, 0);
  }

  const Surfels& surfels_;
  const Grid& grid_;
  Parts parts_;
};

Rgba8 mean_of(Rgba8 a, Rgba8 b) {
  if (a == b) return a;
  const glm::vec3 mean = 0.5F * (linear_colour(a) + linear_colour(b));
  return {linear_to_srgb(mean.x), linear_to_srgb(mean.y), linear_to_srgb(mean.z), 255};
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
                               const Limits& limits) {
  Result<Parts> parts = Splitter(surfels, grid).split(limits);
  if (!parts.ok()) return parts.error();
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
