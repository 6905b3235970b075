// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/cube_cut.h"

#include <cmath>
#include <utility>
#include <vector>

namespace afx {
namespace {

// A corner of what is left of a triangle.
struct Corner {
  glm::dvec3 position;
  glm::dvec2 texture{0, 0};
  glm::dvec3 colour{1, 1, 1};
};
using Polygon = std::vector<Corner>;

Corner between(const Corner& p, const Corner& q, double t) {
  return {p.position + (q.position - p.position) * t, p.texture + (q.texture - p.texture) * t,
          p.colour + (q.colour - p.colour) * t};
}

// Keeps the part where sign * (coordinate - border) <= 0. Source: Sutherland and Hodgman, 1974.
Polygon cut(const Polygon& polygon, int axis, double border, double sign) {
  const auto height = [&](const Corner& c) { return sign * (c.position[axis] - border); };
  Polygon kept;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Corner& here = polygon[i];
    const Corner& next = polygon[(i + 1) % polygon.size()];
    const double h = height(here), n = height(next);
    if (h <= 0) kept.push_back(here);
    if ((h < 0 && n > 0) || (h > 0 && n < 0)) kept.push_back(between(here, next, h / (h - n)));
  }
  return kept;
}

bool holds(const Cube& cube, const glm::vec3& point) {
  const glm::dvec3 from = glm::dvec3(point) - cube.centre;
  const double half = cube.side / 2;
  return std::abs(from.x) <= half && std::abs(from.y) <= half && std::abs(from.z) <= half;
}

class Cutter {
 public:
  Cutter(const Mesh& mesh, const Cube& cube) : mesh_(mesh), cube_(cube), result_(mesh) {
    result_.triangles.clear();
    result_.material_of.clear();
  }

  Mesh run(uint64_t& outside) {
    outside = 0;
    for (size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const glm::uvec3 v = mesh_.triangles[t];
      if (holds(cube_, mesh_.positions[v.x]) && holds(cube_, mesh_.positions[v.y]) &&
          holds(cube_, mesh_.positions[v.z])) {
        add(v, mesh_.material_of[t]);
        continue;
      }
      ++outside;
      add_inside(v, mesh_.material_of[t]);
    }
    return std::move(result_);
  }

 private:
  void add(const glm::uvec3& triangle, uint32_t material) {
    result_.triangles.push_back(triangle);
    result_.material_of.push_back(material);
  }

  [[nodiscard]] Corner corner(uint32_t vertex) const {
    Corner corner{glm::dvec3(mesh_.positions[vertex])};
    if (!mesh_.texture_coords.empty()) corner.texture = glm::dvec2(mesh_.texture_coords[vertex]);
    if (!mesh_.colours.empty()) corner.colour = glm::dvec3(mesh_.colours[vertex]);
    return corner;
  }

  uint32_t add_vertex(const Corner& corner) {
    result_.positions.emplace_back(corner.position);
    if (!mesh_.texture_coords.empty()) result_.texture_coords.emplace_back(corner.texture);
    if (!mesh_.colours.empty()) result_.colours.emplace_back(corner.colour);
    return static_cast<uint32_t>(result_.positions.size() - 1);
  }

  void add_inside(const glm::uvec3& v, uint32_t material) {
    Polygon polygon{corner(v.x), corner(v.y), corner(v.z)};
    for (int axis = 0; axis < 3 && !polygon.empty(); ++axis) {
      polygon = cut(polygon, axis, cube_.centre[axis] + cube_.side / 2, 1);
      polygon = cut(polygon, axis, cube_.centre[axis] - cube_.side / 2, -1);
    }
    if (polygon.size() < 3) return;
    const uint32_t first = add_vertex(polygon[0]);
    uint32_t before = add_vertex(polygon[1]);
    for (size_t i = 2; i < polygon.size(); ++i) {
      const uint32_t here = add_vertex(polygon[i]);
      add({first, before, here}, material);
      before = here;
    }
  }

  const Mesh& mesh_;
  const Cube& cube_;
  Mesh result_;
};

}  // namespace

Mesh inside_of_cube(const Mesh& mesh, const Cube& cube, uint64_t& outside) {
  return Cutter(mesh, cube).run(outside);
}

PointCloud inside_of_cube(const PointCloud& cloud, const Grid& grid, uint64_t& outside) {
  PointCloud result;
  result.origin = cloud.origin;
  for (size_t i = 0; i < cloud.positions.size(); ++i) {
    if (!grid.holds(glm::dvec3(cloud.positions[i]))) continue;
    result.positions.push_back(cloud.positions[i]);
    if (!cloud.colours.empty()) result.colours.push_back(cloud.colours[i]);
    if (!cloud.normals.empty()) result.normals.push_back(cloud.normals[i]);
  }
  outside = cloud.positions.size() - result.positions.size();
  return result;
}

}  // namespace afx
