// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/software/splat_tiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/test_drawing.h"
#include "render/test_surfels.h"

namespace afx::render {
namespace {

SplatTiles tiles_of(const Surfels& surfels, const RenderOptions& options, double view_height) {
  const Scene scene = scene_of(surfels);
  return {scene.surfels, Lens(front(view_height), options), options};
}

// Whatever the size of the splats, from parts of a tile to the whole picture: each tile has those
// that touch it, once.
TEST(SplatTiles, EveryTileHasTheSplatsThatTouchIt) {
  Surfels surfels;
  for (int k = 0; k < 16; ++k) {
    const glm::dvec3 cell(k, (7 * k) % 16, k % 3);
    surfels.push_back((cell + 0.5) / 16.0 - 0.5, {0.04F, 0, 0}, {0, 0.05F, 0}, kRed);
  }
  for (const double view_height : {0.02, 0.1, 0.3, 1.0, 2.0, 40.0}) {
    const RenderOptions options{.width = 500, .height = 300, .samples = 2, .threads = 1};
    const SplatTiles tiles = tiles_of(surfels, options, view_height);
    const TileGrid grid(options);
    const auto side = static_cast<float>(2 * grid.side);
    std::vector<std::vector<uint32_t>> seen(grid.columns * grid.rows);
    uint32_t last = 0;
    for (uint32_t tile = 0; tile < seen.size(); ++tile) {
      tiles.collect(tile % grid.columns, tile / grid.columns, seen[tile]);
      EXPECT_TRUE(std::is_sorted(seen[tile].begin(), seen[tile].end()));
      EXPECT_EQ(std::adjacent_find(seen[tile].begin(), seen[tile].end()), seen[tile].end());
      if (!seen[tile].empty()) last = std::max(last, seen[tile].back());
    }
    for (uint32_t number = 0; number <= last; ++number) {
      const Splat& s = tiles.splat(number);
      for (uint32_t tile = 0; tile < seen.size(); ++tile) {
        const float x = (static_cast<float>(tile % grid.columns) + 0.5F) * side;
        const float y = (static_cast<float>(tile / grid.columns) + 0.5F) * side;
        const bool meets =
            std::abs(s.x - x) < s.reach_x + side / 2 && std::abs(s.y - y) < s.reach_y + side / 2;
        EXPECT_TRUE(!meets || std::binary_search(seen[tile].begin(), seen[tile].end(), number))
            << view_height << ' ' << number << ' ' << tile;
      }
    }
  }
}

}  // namespace
}  // namespace afx::render
