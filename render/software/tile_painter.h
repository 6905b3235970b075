// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/renderer.h"
#include "render/software/frame.h"
#include "render/software/octree_walk.h"
#include "render/software/pixel_row.h"
#include "render/software/shape_painter.h"
#include "render/software/splat_painter.h"
#include "render/software/tile_samples.h"

namespace afx::render {

/// Draws one tile after another, at n x n samples a pixel. For one thread; holds 36 bytes a
/// sample, 4 for each surfel and 92 for each voxel that touches the tile, and what a ShapePainter
/// holds.
class TilePainter {
 public:
  explicit TilePainter(const Frame& frame)
      : frame_(frame), samples_(frame.grid, frame.options), pixels_(frame.grid), shapes_(frame) {}

  /// Draws a tile into its part of the image.
  void paint(uint32_t column, uint32_t row, RenderedImage& image);

 private:
  void resolve(uint32_t x, uint32_t y, RenderedImage& image);

  const Frame& frame_;
  const SplatPainter& painter_ = SplatPainter::best();
  TileSamples samples_;
  PixelRow pixels_;
  ShapePainter shapes_;
  OctreeWalk walk_;
  std::vector<uint32_t> surfels_;  // numbers of those of the tile
  std::vector<TileDisc> discs_;    // voxels of the tile that may be seen
};

}  // namespace afx::render
