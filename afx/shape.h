// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Ordinary geometry as renderers take it: what Shape nodes show, resolved to triangles, lines and
// points with their looks. Source: ISO/IEC 14772-1:1997 (VRML97), Shape, Appearance, Material and
// the geometry nodes (clauses not checked).
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "afx/picture.h"

namespace afx {

/// Triangles, lines or points in local coordinates.
struct Geometry {
  enum class Kind : uint8_t { triangles, lines, points };
  Kind kind = Kind::triangles;
  std::vector<glm::vec3> positions{};  ///< of the corners; finite
  std::vector<glm::vec3> normals{};    ///< triangles: one for each position, of length 1, outwards;
                                       ///< else empty
  std::vector<glm::vec2> texture_coordinates{};  ///< one for each position, (0, 0) the lower left
                                                 ///< corner of the picture; or empty
  std::vector<glm::vec3> colours{};  ///< one for each position, 0..1, instead of the diffuse colour
                                     ///< (lines, points: the emissive); or empty
  std::vector<uint32_t> indices{};   ///< numbers of positions: 3, 2 or 1 for each primitive
  /// Triangles: only the outside is drawn, from where the corners run counter-clockwise. Otherwise
  /// both sides are, and light falls on the one that is seen.
  bool solid = true;
};

/// Corners of one primitive.
constexpr size_t corners_of(Geometry::Kind kind) {
  return kind == Geometry::Kind::triangles ? 3 : kind == Geometry::Kind::lines ? 2 : 1;
}

/// How a surface looks. Colours are display values (sRGB), 0..1; lighting is reckoned with them as
/// they are, as VRML97 does.
struct Look {
  bool lit = true;  ///< false: shown in full brightness, in the colour that diffuse and emissive
                    ///< both hold then: white where there is no Material
  glm::vec3 diffuse{0.8F};
  glm::vec3 specular{0};
  glm::vec3 emissive{0};
  float ambient_intensity = 0.2F;
  float shininess = 0.2F;
  float transparency = 0;  ///< 0 opaque..1 invisible
  /// 1 or 2 components: multiplies the diffuse colour or the corners';
  /// 3 or 4: takes its place. The last of 2 or 4 is opacity, in place of 1 - transparency.
  std::shared_ptr<const Picture> texture{};
  bool repeat_s = true, repeat_t = true;  ///< false: the picture's edge goes on
  glm::mat3 texture_transform{1};         ///< applied to (s, t, 1)
};

/// A light, in world coordinates.
struct Light {
  enum class Kind : uint8_t { directional, point, spot };
  Kind kind = Kind::directional;
  glm::vec3 colour{1};  ///< display values, 0..1
  float intensity = 1;  ///< 0..1
  float ambient_intensity = 0;
  glm::dvec3 location{0};           ///< point, spot
  glm::dvec3 direction{0, 0, -1};   ///< directional, spot: where it shines, of length 1
  glm::dvec3 attenuation{1, 0, 0};  ///< by distance in world units: 1 / max(1, a + b d + c d^2)
  double radius = 100;              ///< in world units: what is farther is not lit
  double beam_width = 1.570796;     ///< spot: radians from the axis; full light inside
  double cut_off_angle = 0.785398;  ///< spot: no light outside; from the beam's edge linearly less
};

/// One thing to draw: a geometry with its look and place. Objects may share both.
struct Shape {
  std::shared_ptr<const Geometry> geometry;  ///< not null
  std::shared_ptr<const Look> look;          ///< not null
  glm::dmat4 to_world{1};                    ///< affine
  std::vector<uint32_t> lights{};  ///< numbers of those that fall on it, of the scene's list
};

}  // namespace afx
