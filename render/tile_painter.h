// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "render/renderer.h"
#include "render/splat_tiles.h"

namespace afx::render {

/// Draws one tile after another, at n x n samples a pixel. For one thread; holds 20 bytes a
/// sample and 4 for each splat that touches the tile.
class TilePainter {
 public:
  explicit TilePainter(const RenderOptions& options);

  /// Draws the splats that touch the tile into its part of the image.
  void paint(const SplatTiles& tiles, uint32_t column, uint32_t row, RenderedImage& image);

 private:
  /// Weighted colours in linear light, and the sum of the weights.
  struct Sum {
    float r = 0, g = 0, b = 0, weight = 0;
  };
  void clear();
  void collect(const SplatTiles& tiles, uint32_t column, uint32_t row);
  template <class Visit>
  void for_shapes(const SplatTiles& tiles, const Visit& visit) const;
  template <class Shape>
  void lay_depth(const Shape& shape);
  template <class Shape>
  void lay_colour(const Shape& shape);
  template <class Shape, class Visit>
  void for_rows(const Shape& shape, const Visit& visit) const;
  void resolve(uint32_t x, uint32_t y, RenderedImage& image) const;
  void resolve_pixel(size_t first, uint8_t* pixel, float* depth) const;

  const RenderOptions& options_;
  size_t side_;                // samples along the side of a tile
  float left_ = 0, top_ = 0;   // of the tile, in samples
  std::vector<float> depths_;  // of the nearest splat, row by row; infinite where none is
  std::vector<Sum> sums_;
  std::vector<uint32_t> touching_;  // numbers of the splats of the tile
};

}  // namespace afx::render
