// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Lays triangles, lines and points into the samples of a tile. Each is shaded once in a pixel, in
// the middle of those of its samples there that are seen: edges are smooth, and light is reckoned
// no oftener than needed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/software/fog_painter.h"
#include "render/software/frame.h"
#include "render/software/shape_shader.h"
#include "render/software/tile_samples.h"

namespace afx::render {

/// For one thread; holds 4 bytes a sample where there are shapes, and some 300 for each primitive
/// that touches the tile.
class ShapePainter {
 public:
  explicit ShapePainter(const Frame& frame);

  /// Lays the opaque shapes: fills the walls and their colours, and lets depths sink to them. To be
  /// called before all else.
  void lay_walls(uint32_t column, uint32_t row, TileSamples& tile);
  /// Mixes fog into all that is there. To be called when the sums are colours with coverage.
  void lay_fog(TileSamples& tile) const { fog_.lay(tile); }
  /// Lays the transparent shapes over that. Depths stay.
  void lay_glass(uint32_t column, uint32_t row, TileSamples& tile);

 private:
  /// Some samples of a pixel that see the same piece.
  struct Group {
    size_t count;
    size_t samples[64];
    double x, y;  // their middle on the screen
  };

  template <class Lay>
  void shade_tile(const TileSamples& tile, const Lay& lay);
  template <class Lay>
  void shade_pixel(const TileSamples& tile, size_t first, const Lay& lay);
  [[nodiscard]] Group take_group(const TileSamples& tile, size_t first, size_t sample);
  void blend(const Piece& piece, TileSamples& tile);

  const Frame& frame_;
  ShapeShader shader_;
  FogPainter fog_;
  std::vector<Piece> pieces_;
  std::vector<int32_t> seen_;  // for each sample the number of a piece, or kNone
};

}  // namespace afx::render
