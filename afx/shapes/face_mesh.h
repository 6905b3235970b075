// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Polygons with what their corners have, and the triangles of them. Source: ISO/IEC 14772-1:1997
// (VRML97), IndexedFaceSet, creaseAngle (clauses not checked).
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "afx/shape.h"
#include "codec/error.h"

namespace afx {

/// Faces with 3 or more corners; others, and those without area, show nothing.
struct FaceMesh {
  std::vector<glm::vec3> points;    ///< finite
  std::vector<uint32_t> corners;    ///< numbers of points, face after face
  std::vector<uint32_t> starts{0};  ///< the first corner of each face, then their number
  std::vector<glm::vec3> normals;   ///< one a corner, or empty: they are made. Of length 0: the
                                    ///< face's own
  std::vector<glm::vec2> texture_coordinates;  ///< one a corner, or empty: from the bounding box
  std::vector<glm::vec3> colours;              ///< one a corner, or empty
  bool ccw = true;         ///< the corners run counter-clockwise around the outside
  bool convex = true;      ///< false: faces may be concave
  bool solid = true;       ///< only the outside is seen
  float crease_angle = 0;  ///< radians: faces that meet at a smaller angle are one smooth surface

  [[nodiscard]] size_t faces() const { return starts.size() - 1; }
};

/// Bytes that making triangles takes for each corner, at most; callers hold it against their limit.
constexpr uint64_t kFaceCornerBytes = 192;

/// The triangles. Corners that are alike in everything become one.
/// Errors  limit_exceeded: concave faces have too many corners
Result<Geometry> geometry_of(const FaceMesh& mesh);

/// The normal of each face on its outside, of length 1, or 0 where it has no area.
std::vector<glm::dvec3> face_normals(const FaceMesh& mesh);

/// A normal for each corner: the faces that meet in its point, and are one smooth surface by edges
/// that they share, weighted by their angles there.
std::vector<glm::vec3> crease_normals(const FaceMesh& mesh,
                                      const std::vector<glm::dvec3>& face_normals);

}  // namespace afx
