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

#include "render/software/surfel_splats.h"
#include "render/software/tile_samples.h"

namespace afx::render {

/// The splats of all surfels in a picture, sorted into square cells. The cells of level 0 are the
/// tiles, those of level n are 2^n tiles wide; at the top one cell holds the whole picture. A splat
/// lies in the finest level whose cells are as wide as it is, there in the one to four cells that
/// it touches: so large splats cost no more memory than small ones, and tiles they are far from do
/// not see them. Within a cell splats keep their order in the scene; so what is drawn does not
/// depend on threads.
class SplatTiles {
 public:
  /// clouds, options   checked; fewer than 2^30 surfels in all
  SplatTiles(std::span<const SurfelCloud> clouds, const Lens& lens, const RenderOptions& options);

  [[nodiscard]] uint32_t levels() const { return static_cast<uint32_t>(grids_.size()); }
  /// Numbers of the splats of a level in the cell around a tile. Together the levels hold every
  /// splat that touches the tile, each once; at levels above 0 also some that do not.
  [[nodiscard]] std::span<const uint32_t> around(uint32_t level, uint32_t column,
                                                 uint32_t row) const;
  [[nodiscard]] const Splat& splat(uint32_t number) const { return splats_[number]; }
  [[nodiscard]] const Slant& slant(uint32_t number) const { return slants_[number]; }

 private:
  /// A run of surfels that one task projects. Its splats begin at the number of the first one.
  struct Chunk {
    size_t cloud = 0;
    size_t first = 0;  // in its cloud
    size_t count = 0;
    size_t first_splat = 0;
    size_t splats = 0;
    std::vector<uint32_t> cursors;  // for each cell: first a count, then where to write next
  };
  /// The cells of one level.
  struct Grid {
    float side;  // of a cell, in samples
    uint32_t columns, rows;
    size_t first;  // the number of its first cell among all
  };

  void make_grids(const TileGrid& tiles, unsigned samples);
  void make_chunks(std::span<const SurfelCloud> clouds);
  void add_chunks(size_t cloud, size_t count, size_t first_splat);
  void project(std::span<const SurfelCloud> clouds, const Lens& lens, const RenderOptions& options);
  void count_chunk(Chunk& chunk);
  void place_chunks();
  void fill_chunk(Chunk& chunk);
  template <class Visit>
  void for_cells(const Splat& splat, const Visit& visit) const;

  std::vector<Grid> grids_;  // by level
  size_t cells_ = 0;         // of all levels
  std::unique_ptr<Splat[]> splats_;
  std::unique_ptr<Slant[]> slants_;
  std::vector<Chunk> chunks_;
  std::vector<uint32_t> starts_;  // of each cell in entries_, and the end
  std::vector<uint32_t> entries_;
};

}  // namespace afx::render
