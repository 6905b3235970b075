// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Which boxes touch which tile of the picture.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "render/software/tile_samples.h"

namespace afx::render {

/// A rectangle on the screen, in samples; none if x1 < x0.
struct Box {
  float x0, y0, x1, y1;
};

inline constexpr Box kNoBox{0, 0, -1, -1};

/// Boxes sorted into square cells. The cells of level 0 are the tiles, those of level n are 2^n
/// tiles wide; at the top one cell holds the whole picture. A box lies in the finest level whose
/// cells are as wide as it is, there in the one to four cells that it touches. What comes out does
/// not depend on threads.
class BoxCells {
 public:
  BoxCells() = default;  ///< none
  /// Boxes outside of the picture count for the cells at its border.
  BoxCells(std::span<const Box> boxes, const TileGrid& tiles, unsigned samples, unsigned threads);

  [[nodiscard]] bool empty() const { return entries_.empty(); }
  /// Replaces `out` by the numbers of all boxes that touch a tile, rising.
  void collect(std::span<const Box> boxes, uint32_t column, uint32_t row,
               std::vector<uint32_t>& out) const;

 private:
  /// A run of boxes that one task sorts in.
  struct Chunk {
    size_t first, count;
    std::vector<uint32_t> cursors;  // for each cell: first a count, then where to write next
  };
  /// The cells of one level.
  struct Grid {
    float side;  // of a cell, in samples
    uint32_t columns, rows;
    size_t first;  // the number of its first cell among all
  };

  void make_grids(const TileGrid& tiles, unsigned samples);
  void place();
  template <class Visit>
  void for_cells(const Box& box, const Visit& visit) const;

  std::vector<Grid> grids_;  // by level
  size_t cells_ = 0;         // of all levels
  std::vector<Chunk> chunks_;
  std::vector<uint32_t> starts_;  // of each cell in entries_, and the end
  std::vector<uint32_t> entries_;
};

}  // namespace afx::render
