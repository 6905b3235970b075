// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/scene.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <string>

#include "codec/octree_voxels.h"
#include "render/shape_check.h"

namespace afx::render {
namespace {

constexpr unsigned kOutlineLevel = 5;
constexpr size_t kManyObjects = 256;  // of these each is a box, or its outline would be too long
constexpr size_t kManyCorners = size_t{1} << 20;

Error bad(const std::string& text) { return {Errc::bad_argument, Place::none(), text}; }

Status check(const VoxelCloud& cloud) {
  if (cloud.tree == nullptr) return bad("a voxel cloud without voxels");
  return check_affine(cloud.local_to_world, "voxel cloud");
}

Status check(const SurfelCloud& cloud) {
  if (cloud.surfels == nullptr) return bad("a surfel cloud without surfels");
  const Surfels& s = *cloud.surfels;
  if (s.u.size() != s.size() || s.v.size() != s.size() || s.colours.size() != s.size()) {
    return bad(std::to_string(s.size()) + " surfels with " + std::to_string(s.u.size()) + " and " +
               std::to_string(s.v.size()) + " sides and " + std::to_string(s.colours.size()) +
               " colours (expected as many)");
  }
  return check_affine(cloud.local_to_world, "surfel cloud");
}

Status check_count(const Scene& scene) {
  uint64_t pieces = 0;
  for (const VoxelCloud& cloud : scene.voxels) pieces += cloud.tree->voxels();
  for (const SurfelCloud& cloud : scene.surfels) pieces += cloud.surfels->size();
  for (const Shape& shape : scene.shapes) pieces += shape.geometry->indices.size();
  if (pieces < uint64_t{1} << 30) return {};
  return Error{Errc::limit_exceeded, Place::none(),
               "a scene of " + std::to_string(pieces) +
                   " voxels, surfels and corners of shapes (expected fewer than 2^30)"};
}

void add_cell(const VoxelCloud& cloud, uint64_t cell, unsigned level,
              std::vector<glm::dvec3>& points) {
  const Voxel v = codec::morton_decode(cell);
  const double side = std::ldexp(1.0, -static_cast<int>(level));
  for (uint32_t k = 0; k < 8; ++k) {
    const glm::dvec4 corner((v.x + (k & 1U)) * side - 0.5, (v.y + (k >> 1U & 1U)) * side - 0.5,
                            (v.z + (k >> 2U)) * side - 0.5, 1);
    points.emplace_back(cloud.local_to_world * corner);
  }
}

bool is_finite(const glm::dvec3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

/// Visits the corners of the surfels that are drawn, in their local system.
template <class Visit>
void for_corners(const Surfels& surfels, const Visit& visit) {
  for (size_t i = 0; i < surfels.size(); ++i) {
    if (surfels.colours[i].a < kLeastOpacity) continue;
    const glm::dvec3 u(surfels.u[i]), v(surfels.v[i]);
    for (const glm::dvec3& side : {u + v, u - v, v - u, -u - v}) {
      const glm::dvec3 corner = surfels.centres[i] + side;
      if (is_finite(corner)) visit(corner);
    }
  }
}

struct Box {
  glm::dvec3 low{std::numeric_limits<double>::infinity()};
  glm::dvec3 high{-std::numeric_limits<double>::infinity()};

  void add(const glm::dvec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
};

void add_box(const Box& box, const glm::dmat4& to_world, std::vector<glm::dvec3>& points) {
  for (unsigned k = 0; k < 8; ++k) {
    const glm::dvec3 corner((k & 1U) != 0 ? box.high.x : box.low.x,
                            (k & 2U) != 0 ? box.high.y : box.low.y,
                            (k & 4U) != 0 ? box.high.z : box.low.z);
    points.emplace_back(to_world * glm::dvec4(corner, 1));
  }
}

void add_surfels(const SurfelCloud& cloud, unsigned level, std::vector<glm::dvec3>& points) {
  Box whole;
  for_corners(*cloud.surfels, [&](const glm::dvec3& p) { whole.add(p); });
  const int cells = 1 << level;
  const glm::dvec3 cell = (whole.high - whole.low) / static_cast<double>(cells);
  std::vector<Box> boxes(size_t{1} << (3 * level));
  for_corners(*cloud.surfels, [&](const glm::dvec3& p) {
    size_t at = 0;
    for (int k = 0; k < 3; ++k) {
      const double place = (p[k] - whole.low[k]) / cell[k];  // NaN in a flat box
      at = at * static_cast<size_t>(cells) +
           (place > 0 ? static_cast<size_t>(std::min(place, cells - 1.0)) : 0);
    }
    boxes[at].add(p);
  });
  for (const Box& box : boxes) {
    if (!(box.low.x <= box.high.x)) continue;
    add_box(box, cloud.local_to_world, points);
  }
}

void add_shape(const Shape& shape, bool as_box, std::vector<glm::dvec3>& points) {
  const Geometry& geometry = *shape.geometry;
  Box box;
  for (const uint32_t index : geometry.indices) {
    const glm::dvec3 corner(geometry.positions[index]);
    box.add(corner);
    if (!as_box && geometry.indices.size() <= kManyCorners)
      points.emplace_back(shape.to_world * glm::dvec4(corner, 1));
  }
  if ((as_box || geometry.indices.size() > kManyCorners) && !geometry.indices.empty())
    add_box(box, shape.to_world, points);
}

}  // namespace

Status check_scene(const Scene& scene) {
  for (const VoxelCloud& cloud : scene.voxels)
    if (Status s = check(cloud); !s.ok()) return s;
  for (const SurfelCloud& cloud : scene.surfels)
    if (Status s = check(cloud); !s.ok()) return s;
  for (const Shape& shape : scene.shapes)
    if (Status s = check_shape(shape, scene.lights.size()); !s.ok()) return s;
  for (const Light& light : scene.lights)
    if (Status s = check_light(light); !s.ok()) return s;
  if (scene.fog)
    if (Status s = check_fog(*scene.fog); !s.ok()) return s;
  if (scene.backdrop)
    if (Status s = check_backdrop(*scene.backdrop); !s.ok()) return s;
  return check_count(scene);
}

std::vector<glm::dvec3> outline(const Scene& scene) {
  std::vector<glm::dvec3> points;
  const size_t objects = scene.voxels.size() + scene.surfels.size() + scene.shapes.size();
  const unsigned finest = objects > kManyObjects ? 0 : kOutlineLevel;
  for (const VoxelCloud& cloud : scene.voxels) {
    const unsigned level = std::min(cloud.tree->level(), finest);
    for (const uint64_t cell : cloud.tree->codes(level)) add_cell(cloud, cell, level, points);
  }
  for (const SurfelCloud& cloud : scene.surfels) add_surfels(cloud, finest, points);
  for (const Shape& shape : scene.shapes) add_shape(shape, finest == 0, points);
  return points;
}

}  // namespace afx::render
