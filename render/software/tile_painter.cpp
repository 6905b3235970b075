// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/software/tile_painter.h"

#include <algorithm>

#include "render/software/splat_painter.h"

namespace afx::render {

void TilePainter::resolve(uint32_t x, uint32_t y, RenderedImage& image) {
  const RenderOptions& options = frame_.options;
  const uint32_t columns = std::min(frame_.grid.side, options.width - x);
  const uint32_t rows = std::min(frame_.grid.side, options.height - y);
  for (uint32_t row = 0; row < rows; ++row) {
    pixels_.sum(samples_, row, options);
    if (frame_.backdrop) {
      pixels_.blend(*frame_.backdrop, x, y + row, columns);
    } else {
      pixels_.blend(options.background);
    }
    pixels_.encode(image.picture.pixel(x, y + row), columns);
    if (!options.depth) continue;
    std::copy_n(pixels_.depths().begin(), columns,
                image.depth.begin() + static_cast<ptrdiff_t>(size_t{y + row} * options.width + x));
  }
}

void TilePainter::paint(uint32_t column, uint32_t row, RenderedImage& image) {
  samples_.clear(column, row);
  shapes_.lay_walls(column, row, samples_);
  const SplatTiles& tiles = frame_.surfels;
  tiles.collect(column, row, surfels_);
  for (const uint32_t i : surfels_)
    painter_.lay_surfel_depth(tiles.splat(i), tiles.slant(i), samples_);
  discs_.clear();
  for (const OctreeView& octree : frame_.octrees) walk_.run(octree, samples_, discs_);
  for (const uint32_t i : surfels_)
    painter_.lay_surfel_colour(tiles.splat(i), tiles.slant(i), samples_);
  for (const TileDisc& disc : discs_) painter_.lay_disc_colour(disc, samples_);
  painter_.finish(samples_);
  shapes_.lay_fog(samples_);
  shapes_.lay_glass(column, row, samples_);
  resolve(column * frame_.grid.side, row * frame_.grid.side, image);
}

}  // namespace afx::render
