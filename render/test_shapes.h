// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Shapes for the tests of this folder.
#pragma once

#include <glm/geometric.hpp>
#include <memory>
#include <utility>
#include <vector>

#include "render/scene.h"

namespace afx::render {

/// A look of one colour whatever light falls on it.
inline Look glowing(glm::vec3 colour, float transparency = 0) {
  return {.diffuse = glm::vec3(0), .emissive = colour, .transparency = transparency};
}

inline Shape shape_of(Geometry geometry, Look look) {
  return {.geometry = std::make_shared<Geometry>(std::move(geometry)),
          .look = std::make_shared<Look>(std::move(look)),
          .to_world = glm::dmat4(1),
          .lights = {}};
}

/// Adds two triangles; the corners run counter-clockwise from outside.
inline void add_quad(Geometry& geometry, const glm::vec3 (&corners)[4]) {
  const auto first = static_cast<uint32_t>(geometry.positions.size());
  const glm::vec3 normal =
      glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
  for (const glm::vec3& corner : corners) {
    geometry.positions.push_back(corner);
    geometry.normals.push_back(normal);
  }
  for (const uint32_t k : {0U, 1U, 2U, 0U, 2U, 3U}) geometry.indices.push_back(first + k);
}

/// The square |x| <= half, |y| <= half at that z, seen from +z, with texture coordinates 0..1.
inline Geometry square(float half, float z) {
  Geometry geometry;
  add_quad(geometry, {{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}});
  geometry.texture_coordinates = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  return geometry;
}

/// The cube |x|, |y|, |z| <= half, each face with corners of its own.
inline Geometry cube(float half) {
  Geometry geometry;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-half, half}) {
      const auto corner = [&](float a, float b) {
        glm::vec3 p;
        p[axis] = side;
        p[(axis + 1) % 3] = side > 0 ? a : b;
        p[(axis + 2) % 3] = side > 0 ? b : a;
        return p;
      };
      add_quad(geometry, {corner(-half, -half), corner(half, -half), corner(half, half),
                          corner(-half, half)});
    }
  }
  return geometry;
}

}  // namespace afx::render
