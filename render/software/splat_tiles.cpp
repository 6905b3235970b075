// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/software/splat_tiles.h"

#include <algorithm>

#include "codec/parallel.h"

namespace afx::render {
namespace {

constexpr size_t kMostChunks = 64;     // of a cloud; each holds a counter for each cell
constexpr size_t kLeastChunk = 16384;  // surfels

uint32_t cell_at(float place, float side, uint32_t count) {
  return static_cast<uint32_t>(std::clamp(place / side, 0.0F, static_cast<float>(count - 1)));
}

}  // namespace

SplatTiles::SplatTiles(std::span<const SurfelCloud> clouds, const Lens& lens,
                       const RenderOptions& options) {
  make_grids(TileGrid(options), options.samples);
  make_chunks(clouds);
  project(clouds, lens, options);
  place_chunks();
  parallel_for(chunks_.size(), options.threads, [&](size_t i) { fill_chunk(chunks_[i]); });
  chunks_.clear();
}

void SplatTiles::make_grids(const TileGrid& tiles, unsigned samples) {
  uint32_t columns = tiles.columns, rows = tiles.rows;
  for (auto side = static_cast<float>(tiles.side * samples);; side *= 2) {
    grids_.push_back({side, columns, rows, cells_});
    cells_ += size_t{columns} * rows;
    if (columns == 1 && rows == 1) return;
    columns = (columns + 1) / 2;
    rows = (rows + 1) / 2;
  }
}

void SplatTiles::add_chunks(size_t cloud, size_t count, size_t first_splat) {
  const size_t step = std::max(kLeastChunk, (count + kMostChunks - 1) / kMostChunks);
  for (size_t first = 0; first < count; first += step) {
    Chunk chunk;
    chunk.cloud = cloud;
    chunk.first = first;
    chunk.count = std::min(step, count - first);
    chunk.first_splat = first_splat + first;
    chunks_.push_back(std::move(chunk));
  }
}

void SplatTiles::make_chunks(std::span<const SurfelCloud> clouds) {
  size_t total = 0;
  for (size_t i = 0; i < clouds.size(); ++i) {
    add_chunks(i, clouds[i].surfels->size(), total);
    total += clouds[i].surfels->size();
  }
  splats_ = std::make_unique_for_overwrite<Splat[]>(total);
  slants_ = std::make_unique_for_overwrite<Slant[]>(total);
}

/// Fills the chunks with splats, and counts those of each cell.
void SplatTiles::project(std::span<const SurfelCloud> clouds, const Lens& lens,
                         const RenderOptions& options) {
  std::vector<SurfelProjection> projections;
  for (const SurfelCloud& cloud : clouds) projections.emplace_back(cloud, lens, options);
  parallel_for(chunks_.size(), options.threads, [&](size_t i) {
    Chunk& chunk = chunks_[i];
    const std::span<Splat> out(splats_.get() + chunk.first_splat, chunk.count);
    const std::span<Slant> slants(slants_.get() + chunk.first_splat, chunk.count);
    chunk.splats = projections[chunk.cloud].project(chunk.first, out, slants);
    count_chunk(chunk);
  });
}

/// Visits the numbers of the cells that the splat is put into.
template <class Visit>
void SplatTiles::for_cells(const Splat& s, const Visit& visit) const {
  size_t level = 0;
  while (level + 1 < grids_.size() && 2 * std::max(s.reach_x, s.reach_y) > grids_[level].side)
    ++level;
  const Grid& grid = grids_[level];
  const uint32_t x1 = cell_at(s.x + s.reach_x, grid.side, grid.columns);
  const uint32_t y1 = cell_at(s.y + s.reach_y, grid.side, grid.rows);
  for (uint32_t y = cell_at(s.y - s.reach_y, grid.side, grid.rows); y <= y1; ++y) {
    for (uint32_t x = cell_at(s.x - s.reach_x, grid.side, grid.columns); x <= x1; ++x) {
      visit(grid.first + size_t{y} * grid.columns + x);
    }
  }
}

void SplatTiles::count_chunk(Chunk& chunk) {
  chunk.cursors.assign(cells_, 0);
  for (size_t i = chunk.first_splat; i < chunk.first_splat + chunk.splats; ++i) {
    for_cells(splats_[i], [&](size_t cell) { ++chunk.cursors[cell]; });
  }
}

/// Turns counts into places: cell by cell, and in a cell chunk by chunk.
void SplatTiles::place_chunks() {
  starts_.reserve(cells_ + 1);
  uint32_t next = 0;
  for (size_t cell = 0; cell < cells_; ++cell) {
    starts_.push_back(next);
    for (Chunk& chunk : chunks_) {
      const uint32_t count = chunk.cursors[cell];
      chunk.cursors[cell] = next;
      next += count;  // at most four cells for each of fewer than 2^30 splats
    }
  }
  starts_.push_back(next);
  entries_.resize(next);
}

void SplatTiles::fill_chunk(Chunk& chunk) {
  for (size_t i = chunk.first_splat; i < chunk.first_splat + chunk.splats; ++i) {
    for_cells(splats_[i],
              [&](size_t cell) { entries_[chunk.cursors[cell]++] = static_cast<uint32_t>(i); });
  }
}

std::span<const uint32_t> SplatTiles::around(uint32_t level, uint32_t column, uint32_t row) const {
  const Grid& grid = grids_[level];
  const size_t cell = grid.first + size_t{row >> level} * grid.columns + (column >> level);
  return {entries_.data() + starts_[cell], starts_[cell + 1] - starts_[cell]};
}

}  // namespace afx::render
