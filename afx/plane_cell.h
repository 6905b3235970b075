// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Surfaces sampled on the grids of lines of sight along x, y and z: what a sample stands for.
#pragma once

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <utility>

namespace afx {

/// The axis along which a normal has its largest part, 0..2; the later one of equal ones.
inline int main_axis(const glm::dvec3& normal) {
  const glm::dvec3 part = glm::abs(normal);
  if (part.z >= part.x && part.z >= part.y) return 2;
  return part.y >= part.x ? 1 : 0;
}

/// Half the sides of a piece of a plane.
struct HalfSides {
  glm::dvec3 u{0}, v{0};  ///< u x v is on the normal's side
};

/// The piece of a plane that is seen in a square cell of the grid along an axis.
/// normal   not perpendicular to the axis
/// half     half the side of the cell
inline HalfSides plane_cell(const glm::dvec3& normal, int axis, double half) {
  const int across = (axis + 1) % 3, along = (axis + 2) % 3;
  HalfSides sides;
  sides.u[across] = half;
  sides.u[axis] = -normal[across] / normal[axis] * half;
  sides.v[along] = half;
  sides.v[axis] = -normal[along] / normal[axis] * half;
  if (normal[axis] < 0) std::swap(sides.u, sides.v);
  return sides;
}

}  // namespace afx
