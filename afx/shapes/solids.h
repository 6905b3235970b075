// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The solids of VRML97 as triangles. Source: ISO/IEC 14772-1:1997 (VRML97), Box, Cone, Cylinder,
// Sphere (clauses not checked): size, place and texture mapping.
#pragma once

#include <glm/vec3.hpp>

#include "afx/shape.h"

namespace afx {

/// Flat sides of a Sphere's equator, of a Cone's and a Cylinder's circle.
constexpr uint32_t kSolidSides = 32;
/// Rings of a Sphere from pole to pole.
constexpr uint32_t kSphereRings = 16;

/// A box around the origin; each side shows the whole picture. size   >= 0
Geometry box_geometry(const glm::vec3& size);
/// A sphere around the origin; the picture's edge is at the back (-z). radius   >= 0
Geometry sphere_geometry(float radius);

/// What a Cone and a Cylinder are made of.
struct RoundSolid {
  float radius = 1;  ///< >= 0
  float height = 2;  ///< >= 0; half of it above the origin
  bool side = true, bottom = true;
  bool top = true;  ///< a Cone has none
};
/// The axis is y; the picture's edge is at the back (-z).
Geometry cone_geometry(const RoundSolid& cone);
Geometry cylinder_geometry(const RoundSolid& cylinder);

}  // namespace afx
