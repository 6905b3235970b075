// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// One triangle, line or point on the grid of samples.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/lens.h"
#include "render/software/box_cells.h"
#include "render/software/shape_view.h"

namespace afx::render {

/// A value that changes evenly over the screen: x * right + y * down + c, in samples.
using Plane = glm::dvec3;

inline double value_at(const Plane& plane, double x, double y) {
  return plane.x * x + plane.y * y + plane.z;
}

/// A primitive as it lies on the screen. It covers the samples whose centres have values > 0, or 0
/// where is_closed(), of all its edges. Two triangles that share an edge have the same values
/// there, but for the sign, so each sample belongs to one of them. Corners lie on a grid of 1/256
/// sample, so that the values are exact: that holds too where many triangles meet in a sample.
///
/// Nothing is cut off where a triangle reaches behind the eye: the edges of the projected triangle
/// are those of the cone from the eye through it, and what lies behind has no sample in it. (There,
/// and far outside of the picture, edges are not exact.)
struct Piece {
  uint32_t shape, primitive;   ///< the primitive's number in its shape
  uint32_t edge_count;         ///< 3 or 4
  std::array<Plane, 4> edges;  ///< of a triangle: number k lies opposite to corner k
  /// Triangle: how much corner k counts at a place, by the ratios. Line: the same of its ends, in 0
  /// and 1. Point: not used.
  std::array<Plane, 3> parts;
  Plane depth;        ///< 1 / depth in perspective, else depth
  bool inverse;       ///< depth is 1 / depth
  bool back;          ///< a triangle seen from its inner side
  float least, most;  ///< of its depths
  float cut;          ///< samples whose depth is less are not covered; 0 if there are none
  glm::dvec2 ends;  ///< of a line, that may have been cut off: 0 is its first corner, 1 its second
  Box box;          ///< holds all samples that it covers
};

/// Whether samples with the value 0 belong to an edge's inner side.
inline bool is_closed(const Plane& edge) { return edge.x > 0 || (edge.x == 0 && edge.y > 0); }

/// Fills all but `shape`. False if it cannot be seen: outside the view, before the near plane, seen
/// from the edge, turned away, or with coordinates beyond all measure.
///
/// n   samples along the side of a pixel, the width of lines and points
[[nodiscard]] bool make_piece(const ShapeView& view, uint32_t primitive, const Lens& lens,
                              unsigned n, Piece& piece);

/// How much each corner of a piece counts at a place on the screen; their sum is 1, and each is
/// 0..1.
[[nodiscard]] glm::dvec3 corner_parts(const Piece& piece, Geometry::Kind kind, double x, double y);

}  // namespace afx::render
