// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/software/box_cells.h"

#include <algorithm>

#include "codec/parallel.h"

namespace afx::render {
namespace {

constexpr size_t kMostChunks = 64;  // each holds a counter for each cell
constexpr size_t kLeastChunk = 16384;

uint32_t cell_at(float place, float side, uint32_t count) {
  return static_cast<uint32_t>(std::clamp(place / side, 0.0F, static_cast<float>(count - 1)));
}

bool is_none(const Box& box) { return !(box.x0 <= box.x1); }

}  // namespace

BoxCells::BoxCells(std::span<const Box> boxes, const TileGrid& tiles, unsigned samples,
                   unsigned threads) {
  if (std::all_of(boxes.begin(), boxes.end(), is_none)) return;
  make_grids(tiles, samples);
  const size_t step = std::max(kLeastChunk, (boxes.size() + kMostChunks - 1) / kMostChunks);
  for (size_t first = 0; first < boxes.size(); first += step)
    chunks_.push_back({first, std::min(step, boxes.size() - first), {}});
  parallel_for(chunks_.size(), threads, [&](size_t i) {
    Chunk& chunk = chunks_[i];
    chunk.cursors.assign(cells_, 0);
    for (const Box& box : boxes.subspan(chunk.first, chunk.count))
      for_cells(box, [&](size_t cell) { ++chunk.cursors[cell]; });
  });
  place();
  parallel_for(chunks_.size(), threads, [&](size_t i) {
    Chunk& chunk = chunks_[i];
    for (size_t k = chunk.first; k < chunk.first + chunk.count; ++k) {
      for_cells(boxes[k],
                [&](size_t cell) { entries_[chunk.cursors[cell]++] = static_cast<uint32_t>(k); });
    }
  });
  chunks_.clear();
}

void BoxCells::make_grids(const TileGrid& tiles, unsigned samples) {
  uint32_t columns = tiles.columns, rows = tiles.rows;
  for (auto side = static_cast<float>(tiles.side * samples);; side *= 2) {
    grids_.push_back({side, columns, rows, cells_});
    cells_ += size_t{columns} * rows;
    if (columns == 1 && rows == 1) return;
    columns = (columns + 1) / 2;
    rows = (rows + 1) / 2;
  }
}

/// Visits the numbers of the cells that the box is put into.
template <class Visit>
void BoxCells::for_cells(const Box& box, const Visit& visit) const {
  if (is_none(box)) return;
  const float width = std::max(box.x1 - box.x0, box.y1 - box.y0);
  size_t level = 0;
  while (level + 1 < grids_.size() && width > grids_[level].side) ++level;
  const Grid& grid = grids_[level];
  const uint32_t x1 = cell_at(box.x1, grid.side, grid.columns);
  const uint32_t y1 = cell_at(box.y1, grid.side, grid.rows);
  for (uint32_t y = cell_at(box.y0, grid.side, grid.rows); y <= y1; ++y)
    for (uint32_t x = cell_at(box.x0, grid.side, grid.columns); x <= x1; ++x)
      visit(grid.first + size_t{y} * grid.columns + x);
}

/// Turns counts into places: cell by cell, and in a cell chunk by chunk.
void BoxCells::place() {
  starts_.reserve(cells_ + 1);
  uint32_t next = 0;
  for (size_t cell = 0; cell < cells_; ++cell) {
    starts_.push_back(next);
    for (Chunk& chunk : chunks_) {
      const uint32_t count = chunk.cursors[cell];
      chunk.cursors[cell] = next;
      next += count;  // at most four cells for each of fewer than 2^30 boxes
    }
  }
  starts_.push_back(next);
  entries_.resize(next);
}

void BoxCells::collect(std::span<const Box> boxes, uint32_t column, uint32_t row,
                       std::vector<uint32_t>& out) const {
  out.clear();
  if (entries_.empty()) return;
  const float side = grids_[0].side;
  const float left = static_cast<float>(column) * side, top = static_cast<float>(row) * side;
  for (size_t level = 0; level < grids_.size(); ++level) {
    const Grid& grid = grids_[level];
    const size_t cell = grid.first + size_t{row >> level} * grid.columns + (column >> level);
    for (uint32_t k = starts_[cell]; k < starts_[cell + 1]; ++k) {
      const Box& box = boxes[entries_[k]];
      if (box.x1 >= left && box.x0 <= left + side && box.y1 >= top && box.y0 <= top + side)
        out.push_back(entries_[k]);
    }
  }
  std::sort(out.begin(), out.end());
}

}  // namespace afx::render
