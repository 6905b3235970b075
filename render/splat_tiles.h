// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Which splats touch which tile of the picture.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "render/splats.h"

namespace afx::render {

/// The side of a tile in pixels.
inline constexpr uint32_t kTile = 32;

/// All splats of a picture, sorted into square tiles. Within a tile they keep their order in the
/// scene, the large ones (wider than a tile) first; so what is drawn does not depend on threads.
class SplatTiles {
 public:
  /// scene, camera, options   checked; fewer than 2^30 voxels in all
  SplatTiles(const Scene& scene, const Camera& camera, const RenderOptions& options);

  [[nodiscard]] uint32_t columns() const { return columns_; }
  [[nodiscard]] uint32_t rows() const { return rows_; }
  /// Numbers of the splats that may touch every tile.
  [[nodiscard]] std::span<const uint32_t> large() const { return large_; }
  /// Numbers of the others that touch a tile.
  [[nodiscard]] std::span<const uint32_t> small(uint32_t column, uint32_t row) const;
  [[nodiscard]] const Splat& splat(uint32_t number) const { return splats_[number]; }

 private:
  /// A run of voxels that one task projects. Its splats begin at the number of its first voxel.
  struct Chunk {
    size_t cloud = 0;
    size_t first_voxel = 0;  // in its cloud
    size_t voxels = 0;
    size_t first_splat = 0;
    size_t splats = 0;
    std::vector<uint32_t> cursors;  // for each tile: first a count, then where to write next
    std::vector<uint32_t> large;
  };
  struct Range {
    uint32_t x0, x1, y0, y1;  // tiles, both ends included
  };

  void make_chunks(const Scene& scene);
  void count_chunk(Chunk& chunk);
  void place_chunks();
  void fill_chunk(Chunk& chunk);
  [[nodiscard]] bool is_large(const Splat& splat) const;
  [[nodiscard]] Range tiles_of(const Splat& splat) const;

  uint32_t columns_, rows_;
  float tile_samples_;
  std::unique_ptr<Splat[]> splats_;
  std::vector<Chunk> chunks_;
  std::vector<uint32_t> starts_;  // of each tile in entries_, and the end
  std::vector<uint32_t> entries_;
  std::vector<uint32_t> large_;
};

}  // namespace afx::render
