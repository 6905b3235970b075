// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// From samples to pixels, a row of a tile at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "afx/picture.h"
#include "render/renderer.h"
#include "render/software/backdrop_painter.h"
#include "render/software/tile_samples.h"

namespace afx::render {

/// A row of pixels in linear light.
class PixelRow {
 public:
  explicit PixelRow(const TileGrid& grid);

  /// Means over the samples of each pixel, which are finished (SplatPainter::finish), and where
  /// they are asked for the least depths. row   of pixels in the tile
  void sum(const TileSamples& samples, uint32_t row, const RenderOptions& options);
  /// Lays them over the background.
  void blend(Rgba8 background);
  /// Lays the first `count` over the scene's backdrop. x, y   of the first pixel in the picture
  void blend(const BackdropPainter& backdrop, uint32_t x, uint32_t y, size_t count);
  /// Writes the first `count` pixels as RGBA, sRGB, straight alpha.
  void encode(uint8_t* pixels, size_t count) const;

  [[nodiscard]] const std::vector<float>& depths() const { return depths_; }

 private:
  // Colours times coverage, coverage; then straight colours and opacity.
  std::vector<float> r_, g_, b_, a_;
  std::vector<float> depths_;
};

}  // namespace afx::render
