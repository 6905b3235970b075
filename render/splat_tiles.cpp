// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/splat_tiles.h"

#include <algorithm>

#include "codec/parallel.h"

namespace afx::render {
namespace {

constexpr size_t kMostChunks = 64;     // of a cloud; each holds a counter for each tile
constexpr size_t kLeastChunk = 16384;  // voxels

uint32_t tile_at(float place, float tile, uint32_t count) {
  return static_cast<uint32_t>(std::clamp(place / tile, 0.0F, static_cast<float>(count - 1)));
}

}  // namespace

SplatTiles::SplatTiles(const Scene& scene, const Camera& camera, const RenderOptions& options)
    : columns_((options.width + kTile - 1) / kTile),
      rows_((options.height + kTile - 1) / kTile),
      tile_samples_(static_cast<float>(kTile * options.samples)) {
  make_chunks(scene);
  std::vector<SplatProjection> projections;
  for (const VoxelCloud& cloud : scene.voxels) projections.emplace_back(cloud, camera, options);
  parallel_for(chunks_.size(), options.threads, [&](size_t i) {
    Chunk& chunk = chunks_[i];
    chunk.splats = projections[chunk.cloud].project(
        chunk.first_voxel, {splats_.get() + chunk.first_splat, chunk.voxels});
    count_chunk(chunk);
  });
  place_chunks();
  parallel_for(chunks_.size(), options.threads, [&](size_t i) { fill_chunk(chunks_[i]); });
  chunks_.clear();
}

void SplatTiles::make_chunks(const Scene& scene) {
  size_t total = 0;
  for (size_t k = 0; k < scene.voxels.size(); ++k) {
    const size_t count = scene.voxels[k].codes.size();
    const size_t step = std::max(kLeastChunk, (count + kMostChunks - 1) / kMostChunks);
    for (size_t first = 0; first < count; first += step) {
      Chunk chunk;
      chunk.cloud = k;
      chunk.first_voxel = first;
      chunk.voxels = std::min(step, count - first);
      chunk.first_splat = total + first;
      chunks_.push_back(std::move(chunk));
    }
    total += count;
  }
  splats_ = std::make_unique_for_overwrite<Splat[]>(total);
}

bool SplatTiles::is_large(const Splat& splat) const { return 2 * splat.radius > tile_samples_; }

SplatTiles::Range SplatTiles::tiles_of(const Splat& s) const {
  return {tile_at(s.x - s.radius, tile_samples_, columns_),
          tile_at(s.x + s.radius, tile_samples_, columns_),
          tile_at(s.y - s.radius, tile_samples_, rows_),
          tile_at(s.y + s.radius, tile_samples_, rows_)};
}

void SplatTiles::count_chunk(Chunk& chunk) {
  chunk.cursors.assign(size_t{columns_} * rows_, 0);
  for (size_t i = chunk.first_splat; i < chunk.first_splat + chunk.splats; ++i) {
    if (is_large(splats_[i])) {
      chunk.large.push_back(static_cast<uint32_t>(i));
      continue;
    }
    const Range range = tiles_of(splats_[i]);
    for (uint32_t y = range.y0; y <= range.y1; ++y) {
      for (uint32_t x = range.x0; x <= range.x1; ++x) ++chunk.cursors[size_t{y} * columns_ + x];
    }
  }
}

/// Turns counts into places: tile by tile, and in a tile chunk by chunk.
void SplatTiles::place_chunks() {
  const size_t tiles = size_t{columns_} * rows_;
  starts_.reserve(tiles + 1);
  uint32_t next = 0;
  for (size_t tile = 0; tile < tiles; ++tile) {
    starts_.push_back(next);
    for (Chunk& chunk : chunks_) {
      const uint32_t count = chunk.cursors[tile];
      chunk.cursors[tile] = next;
      next += count;  // at most four tiles for each of fewer than 2^30 splats
    }
  }
  starts_.push_back(next);
  entries_.resize(next);
  for (const Chunk& chunk : chunks_)
    large_.insert(large_.end(), chunk.large.begin(), chunk.large.end());
}

void SplatTiles::fill_chunk(Chunk& chunk) {
  for (size_t i = chunk.first_splat; i < chunk.first_splat + chunk.splats; ++i) {
    if (is_large(splats_[i])) continue;
    const Range range = tiles_of(splats_[i]);
    for (uint32_t y = range.y0; y <= range.y1; ++y) {
      for (uint32_t x = range.x0; x <= range.x1; ++x) {
        entries_[chunk.cursors[size_t{y} * columns_ + x]++] = static_cast<uint32_t>(i);
      }
    }
  }
}

std::span<const uint32_t> SplatTiles::small(uint32_t column, uint32_t row) const {
  const size_t tile = size_t{row} * columns_ + column;
  return {entries_.data() + starts_[tile], starts_[tile + 1] - starts_[tile]};
}

}  // namespace afx::render
