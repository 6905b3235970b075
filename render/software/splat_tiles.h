// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Which surfels touch which tile of the picture.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "render/software/box_cells.h"
#include "render/software/surfel_splats.h"
#include "render/software/tile_samples.h"

namespace afx::render {

/// The splats of all surfels in a picture, by tiles.
class SplatTiles {
 public:
  /// What a surfel takes, without its places in cells.
  static constexpr uint64_t kBytes = sizeof(Splat) + sizeof(Slant) + sizeof(Box);

  /// clouds, options   checked; fewer than 2^30 surfels in all
  SplatTiles(std::span<const SurfelCloud> clouds, const Lens& lens, const RenderOptions& options);

  /// Replaces `out` by the numbers of all splats that touch a tile, in the order of the scene: so
  /// what is drawn does not depend on threads.
  void collect(uint32_t column, uint32_t row, std::vector<uint32_t>& out) const {
    cells_.collect(boxes_, column, row, out);
  }
  [[nodiscard]] const Splat& splat(uint32_t number) const { return splats_[number]; }
  [[nodiscard]] const Slant& slant(uint32_t number) const { return slants_[number]; }

 private:
  /// A run of surfels that one task projects, and where their splats begin.
  struct Chunk {
    size_t cloud;
    size_t first, count;  // in the cloud
    size_t first_splat;
  };
  static std::vector<Chunk> chunks_of(std::span<const SurfelCloud> clouds);

  std::unique_ptr<Splat[]> splats_;
  std::unique_ptr<Slant[]> slants_;
  std::vector<Box> boxes_;  // kNoBox: there is no such splat
  BoxCells cells_;
};

}  // namespace afx::render
