// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/software/splat_tiles.h"

#include <algorithm>

#include "codec/parallel.h"

namespace afx::render {
namespace {

constexpr size_t kAtOnce = 16384;  // surfels that one task projects

Box box_of(const Splat& s) {
  return {s.x - s.reach_x, s.y - s.reach_y, s.x + s.reach_x, s.y + s.reach_y};
}

}  // namespace

std::vector<SplatTiles::Chunk> SplatTiles::chunks_of(std::span<const SurfelCloud> clouds) {
  std::vector<Chunk> chunks;
  size_t total = 0;
  for (size_t cloud = 0; cloud < clouds.size(); ++cloud) {
    const size_t size = clouds[cloud].surfels->size();
    for (size_t first = 0; first < size; first += kAtOnce)
      chunks.push_back({cloud, first, std::min(kAtOnce, size - first), total + first});
    total += size;
  }
  return chunks;
}

SplatTiles::SplatTiles(std::span<const SurfelCloud> clouds, const Lens& lens,
                       const RenderOptions& options) {
  const std::vector<Chunk> chunks = chunks_of(clouds);
  const size_t total = chunks.empty() ? 0 : chunks.back().first_splat + chunks.back().count;
  splats_ = std::make_unique_for_overwrite<Splat[]>(total);
  slants_ = std::make_unique_for_overwrite<Slant[]>(total);
  boxes_.assign(total, kNoBox);
  parallel_for(chunks.size(), options.threads, [&](size_t i) {
    const Chunk& chunk = chunks[i];
    const std::span<Splat> splats(splats_.get() + chunk.first_splat, chunk.count);
    const std::span<Slant> slants(slants_.get() + chunk.first_splat, chunk.count);
    const SurfelProjection projection(clouds[chunk.cloud], lens, options);
    const size_t drawn = projection.project(chunk.first, splats, slants);
    for (size_t k = 0; k < drawn; ++k) boxes_[chunk.first_splat + k] = box_of(splats[k]);
  });
  cells_ = BoxCells(boxes_, TileGrid(options), options.samples, options.threads);
}

}  // namespace afx::render
