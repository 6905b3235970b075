// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/software/tile_samples.h"

namespace afx::render {

TileSamples::TileSamples(const TileGrid& grid, const RenderOptions& options)
    : side(size_t{grid.side} * options.samples), blocks_((side + kBlock - 1) / kBlock) {
  const size_t count = side * side + kPadding;
  for (std::vector<float>* list :
       {&depths, &walls, &wall_r, &wall_g, &wall_b, &sum_r, &sum_g, &sum_b, &sum_weight})
    list->resize(count);
  farthest_.resize(blocks_ * blocks_);
}

void TileSamples::clear(uint32_t column, uint32_t row) {
  left = static_cast<float>(column * side);
  top = static_cast<float>(row * side);
  has_walls = false;
  std::fill(depths.begin(), depths.end(), kFar);
  for (std::vector<float>* sum : {&sum_r, &sum_g, &sum_b, &sum_weight})
    std::fill(sum->begin(), sum->end(), 0.0F);
  std::fill(farthest_.begin(), farthest_.end(), Block{kFar, false});
}

void TileSamples::touch(size_t x0, size_t y0, size_t x1, size_t y1) {
  for (size_t y = y0 / kBlock; y <= (y1 - 1) / kBlock; ++y)
    for (size_t x = x0 / kBlock; x <= (x1 - 1) / kBlock; ++x)
      farthest_[y * blocks_ + x].changed = true;
}

float TileSamples::farthest(size_t column, size_t row) {
  Block& block = farthest_[row * blocks_ + column];
  if (!block.changed) return block.farthest;
  const size_t x0 = column * kBlock, y0 = row * kBlock;
  const size_t width = std::min(kBlock, side - x0), y1 = std::min(y0 + kBlock, side);
  float most[kBlock] = {};
  for (size_t y = y0; y < y1; ++y) {
    const float* depth = &depths[y * side + x0];
    for (size_t x = 0; x < width; ++x) most[x] = std::max(most[x], depth[x]);
  }
  block = {*std::max_element(most, most + width), false};
  return block.farthest;
}

bool TileSamples::hides(float x0, float y0, float x1, float y1, float depth) {
  const float last = static_cast<float>(side) - 1;
  const auto block = [&](float at) {
    return static_cast<size_t>(std::clamp(at, 0.0F, last)) / kBlock;
  };
  const size_t column = block(x0), end_column = block(x1);
  for (size_t y = block(y0); y <= block(y1); ++y)
    for (size_t x = column; x <= end_column; ++x)
      if (!(farthest(x, y) < depth)) return false;
  return true;
}

}  // namespace afx::render
