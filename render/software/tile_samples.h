// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// A picture is drawn tile by tile; what one tile holds while it is drawn.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "render/renderer.h"

namespace afx::render {

/// The square tiles of a picture, row by row from the upper left corner.
struct TileGrid {
  explicit TileGrid(const RenderOptions& options)
      : side(options.samples == 1 ? 128 : 32),
        columns((options.width + side - 1) / side),
        rows((options.height + side - 1) / side) {}

  uint32_t side;  ///< of a tile, in pixels: small enough for its samples to stay in the cache
  uint32_t columns, rows;
};

inline constexpr float kFar = std::numeric_limits<float>::infinity();

/// The samples of a tile, row by row. Depths are distances to the plane through the camera, colours
/// linear light.
class TileSamples {
 public:
  /// For tiles of that grid. Lists have room for a row and kPadding more than the samples.
  TileSamples(const TileGrid& grid, const RenderOptions& options);

  /// Begins a tile.
  void clear(uint32_t column, uint32_t row);

  static constexpr size_t kPadding = 8;

  size_t side;                                ///< samples along a side
  float left = 0, top = 0;                    ///< of the tile in the picture, in samples
  std::vector<float> depths;                  ///< of the nearest thing, infinite where none is
  std::vector<float> walls;                   ///< of the nearest opaque shape
  std::vector<float> wall_r, wall_g, wall_b;  ///< its colour
  std::vector<float> sum_r, sum_g, sum_b, sum_weight;  ///< of splats: weighted sums
  bool has_walls = false;  ///< else `walls` and their colours are not kept
};

}  // namespace afx::render
