// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/software/tile_samples.h"

namespace afx::render {

TileSamples::TileSamples(const TileGrid& grid, const RenderOptions& options)
    : side(size_t{grid.side} * options.samples) {
  const size_t count = side * side + side + kPadding;
  for (std::vector<float>* list :
       {&depths, &walls, &wall_r, &wall_g, &wall_b, &sum_r, &sum_g, &sum_b, &sum_weight})
    list->resize(count);
}

void TileSamples::clear(uint32_t column, uint32_t row) {
  left = static_cast<float>(column * side);
  top = static_cast<float>(row * side);
  has_walls = false;
  std::fill(depths.begin(), depths.end(), kFar);
  for (std::vector<float>* sum : {&sum_r, &sum_g, &sum_b, &sum_weight})
    std::fill(sum->begin(), sum->end(), 0.0F);
}

}  // namespace afx::render
