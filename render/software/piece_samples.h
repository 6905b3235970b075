// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Which samples of a tile a piece covers, and how deep it lies there.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "render/lanes.h"
#include "render/software/piece.h"
#include "render/software/tile_samples.h"

namespace afx::render {

/// A piece on the rows of a tile. Values are reckoned in float, and where that leaves a doubt on
/// which side of an edge a sample lies, in double: there the values of an edge and of its reverse
/// differ in nothing but the sign, so neighbours leave no gap between them.
/// Tiles are a multiple of kLanes samples wide.
class PieceRows {
 public:
  PieceRows(const Piece& piece, const TileSamples& tile)
      : piece_(piece), count_(piece.edge_count), last_(static_cast<float>(tile.side) - 1) {
    const double left = static_cast<double>(tile.left) + 0.5;
    const double top = static_cast<double>(tile.top) + 0.5;
    for (size_t k = 0; k < count_; ++k) {
      const Plane& plane = piece.edges[k];
      const double most = std::max(std::abs(plane.x), std::abs(plane.y));
      const double scale = most > 0 ? most : 1;
      edges_[k] = {value_at(plane, left, top) / scale, plane.y / scale,
                   static_cast<float>(plane.x / scale)};
    }
    depth_ = {value_at(piece.depth, left, top), piece.depth.y, to_float(piece.depth.x)};
    left_ = left, top_ = top;
    const auto inside = [&](float at) { return std::clamp(at, -1.0F, last_ + 1); };
    x0_ = inside(piece.box.x0 - tile.left - 1), x1_ = inside(piece.box.x1 - tile.left);
    y0_ = inside(piece.box.y0 - tile.top - 1), y1_ = inside(piece.box.y1 - tile.top);
  }

  [[nodiscard]] int first_row() const { return static_cast<int>(std::max(y0_, 0.0F)); }
  [[nodiscard]] int end_row() const { return static_cast<int>(std::min(y1_, last_) + 1); }

  /// Calls visit(column, covered, depth) for kLanes samples of a row at a time.
  template <class Visit>
  void for_lanes(int row, const Visit& visit) const {
    float values[4];  // at the row's beginning
    float first = x0_, last = x1_;
    for (size_t k = 0; k < count_; ++k) {
      const Edge& edge = edges_[k];
      values[k] = edge.begin(row);
      const float zero = -values[k] / edge.x;  // not used if x is 0
      if (edge.x > 0) first = std::max(first, zero - 1);
      if (edge.x < 0) last = std::min(last, zero + 1);
      if (edge.x == 0 && values[k] < -kDoubt) return;
    }
    first = std::max(first, 0.0F), last = std::min(last, last_);
    if (!(first <= last)) return;
    const int begin = static_cast<int>(first) & ~(kLanes - 1), end = static_cast<int>(last);
    // A plane seen from aside changes much over a tile, but not over the part that is covered.
    const float start = to_float(depth_.c + depth_.y * row + piece_.depth.x * begin);
    for (int column = begin; column <= end; column += kLanes) {
      const LaneMask covered = inside(values, column, row);
      if (!any(covered)) continue;
      const Lanes x = lane_numbers() + static_cast<float>(column - begin);
      visit_lanes(column, covered, start + depth_.x * x, visit);
    }
  }

 private:
  struct Edge {
    double c, y;
    float x;

    [[nodiscard]] float begin(int row) const { return to_float(c + y * row); }
  };

  static float to_float(double value) { return static_cast<float>(std::clamp(value, -1e30, 1e30)); }

  [[nodiscard]] LaneMask inside(const float* values, int column, int row) const {
    const Lanes x = lane_numbers() + static_cast<float>(column);
    Lanes nearest = all(1);
    Lanes lowest = all(1);
    for (size_t k = 0; k < count_; ++k) {
      const Lanes value = values[k] + edges_[k].x * x;
      lowest = least(lowest, value);
      nearest = least(nearest, most(value, -value));
    }
    if (any(nearest < kDoubt)) return inside_exactly(column, row);
    return lowest > 0;
  }

  [[nodiscard]] LaneMask inside_exactly(int column, int row) const {
    LaneMask inside{};
    for (int lane = 0; lane < kLanes; ++lane) {
      bool in = true;
      for (size_t k = 0; k < count_; ++k) {
        const double value = value_at(piece_.edges[k], left_ + (column + lane), top_ + row);
        in = in && (value > 0 || (value == 0 && is_closed(piece_.edges[k])));
      }
      inside[lane] = in ? -1 : 0;
    }
    return inside;
  }

  template <class Visit>
  void visit_lanes(int column, LaneMask covered, Lanes value, const Visit& visit) const {
    const Lanes depth = piece_.inverse ? 1 / (value > 0 ? value : all(1e-37F)) : value;
    covered &= depth >= piece_.cut;
    visit(static_cast<size_t>(column), covered,
          least(most(depth, all(piece_.least)), all(piece_.most)));
  }

  /// Of values in samples, for tiles of up to 512: four roundings of a float of that size are less.
  static constexpr float kDoubt = 2e-4F;

  const Piece& piece_;
  size_t count_;
  float last_;  // of the numbers of columns and rows
  Edge edges_[4];
  Edge depth_;
  double left_, top_;  // of the first sample's centre
  float x0_, x1_, y0_, y1_;
};

/// Calls visit(at, covered, depth) for all samples that a piece covers, kLanes at a time from
/// number `at` on, within a row.
template <class Visit>
void for_covered(const Piece& piece, const TileSamples& tile, const Visit& visit) {
  const PieceRows rows(piece, tile);
  const int end = rows.end_row();
  for (int row = rows.first_row(); row < end; ++row) {
    const size_t start = static_cast<size_t>(row) * tile.side;
    rows.for_lanes(row, [&](size_t column, LaneMask covered, Lanes depth) {
      visit(start + column, covered, depth);
    });
  }
}

}  // namespace afx::render
