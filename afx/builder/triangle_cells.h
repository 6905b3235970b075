// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Which cells of a grid a triangle passes through, exactly.
//
// A cell is half-open: it holds its lower sides and not its upper ones, so every point lies in just
// one cell, and a triangle in the plane between two layers of cells sets one of them. A triangle
// and a box do not meet if, and only if, one of 13 directions separates them: the box's three, the
// triangle's normal, and the products of their edges. The last nine are the separating lines of the
// three projections along the axes; seen from a cell's number each test is A*i + B*j + C >= 0 with
// integers. Columns of cells along the axis nearest to the normal hold few candidates each.
// Source: the separating axis theorem; the split into projections after Schwarz and Seidel, "Fast
// parallel surface and solid voxelization on GPUs", ACM Transactions on Graphics 29(6), 2010.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

namespace afx {

/// A range of cells on each axis, both ends in it.
struct CellRange {
  glm::ivec3 low{0, 0, 0};
  glm::ivec3 high{0, 0, 0};
};

/// The tests of one triangle against cells of side 2^cell_bits. Coordinates are in 0..2^19, so that
/// no product leaves 64 bits: the normal's components stay below 2^39.
class TriangleCells {
 public:
  /// cell_bits   0..19
  TriangleCells(const std::array<glm::ivec3, 3>& corners, int cell_bits);

  /// Calls visit(x, y, z) for each cell within `range` that the triangle passes through.
  template <class Visit>
  void for_each(const CellRange& range, Visit&& visit) const {
    const CellRange box = within(range);
    const int w = axis_, u = (axis_ + 1) % 3, v = (axis_ + 2) % 3;
    glm::ivec3 cell;
    for (cell[v] = box.low[v]; cell[v] <= box.high[v]; ++cell[v]) {
      Interval row{box.low[u], box.high[u]};
      limit_row(cell[v], row);
      for (cell[u] = static_cast<int>(row.low); cell[u] <= row.high; ++cell[u]) {
        Interval column{box.low[w], box.high[w]};
        limit_column(cell[u], cell[v], column);
        for (cell[w] = static_cast<int>(column.low); cell[w] <= column.high; ++cell[w])
          visit(cell.x, cell.y, cell.z);
      }
    }
  }

 private:
  struct Interval {
    int64_t low, high;
  };
  /// a*i + b*j + c >= 0, i and j the numbers of a cell in a projection.
  struct Line {
    int64_t a, b, c;
  };
  /// The lines that bound the triangle's shadow along one axis. A shadow without area has two for
  /// each edge.
  struct Shadow {
    std::array<Line, 6> lines;
    int count = 0;
  };
  /// a[0]*x + a[1]*y + a[2]*z + c >= 0.
  struct Plane {
    std::array<int64_t, 3> a;
    int64_t c;
  };

  [[nodiscard]] CellRange within(const CellRange& range) const;
  void add_edge(Shadow& shadow, int u, int v, int from, int to, bool reversed) const;
  [[nodiscard]] Shadow shadow_along(int axis, int64_t normal) const;
  void limit_row(int v, Interval& row) const;
  void limit_column(int u, int v, Interval& column) const;
  static void limit(int64_t a, int64_t b, Interval& interval);

  std::array<glm::ivec3, 3> corners_;
  int64_t cell_;
  CellRange bounds_;
  int axis_ = 0;                   ///< the columns' direction
  std::array<Shadow, 3> shadows_;  ///< [k] along axis k, lines in the axes k+1, k+2
  std::array<Plane, 2> planes_;    ///< the cell reaches the plane from below, and from above
};

}  // namespace afx
