// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/software/splat_tiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/test_surfels.h"

namespace afx::render {
namespace {

Camera front(double view_height) {
  return {.position = {0, 0, 10},
          .projection = Projection::orthographic,
          .view_height = view_height,
          .near_plane = 0.1};
}

/// Squares parallel to the picture at the centres of all cells of a cube of side 1, each as wide as
/// the cell's diagonal.
Surfels full_cube(int n) {
  Surfels surfels;
  const auto half = static_cast<float>(std::sqrt(0.5) / n);
  for (int k = 0; k < n * n * n; ++k) {
    const glm::dvec3 cell(k % n, k / n % n, k / n / n);
    surfels.push_back((cell + 0.5) / double(n) - 0.5, {half, 0, 0}, {0, half, 0}, kRed);
  }
  return surfels;
}

SplatTiles tiles_of(const Surfels& surfels, const RenderOptions& options, double view_height) {
  const Scene scene = scene_of(surfels);
  return {scene.surfels, Lens(front(view_height), options), options};
}

/// How many splats the tiles look at, and how many of those looks a tile and a splat that meet
/// need.
struct Looks {
  double made = 0, needed = 0;
};

Looks looks_of(const Surfels& surfels, const RenderOptions& options, double view_height) {
  const SplatTiles tiles = tiles_of(surfels, options, view_height);
  const TileGrid grid(options);
  Looks looks;
  const auto side = static_cast<float>(grid.side * options.samples);
  for (uint32_t row = 0; row < grid.rows; ++row) {
    for (uint32_t column = 0; column < grid.columns; ++column) {
      const float left = static_cast<float>(column) * side, top = static_cast<float>(row) * side;
      for (uint32_t level = 0; level < tiles.levels(); ++level) {
        for (const uint32_t number : tiles.around(level, column, row)) {
          const Splat& s = tiles.splat(number);
          looks.made += 1;
          if (std::abs(s.x - (left + side / 2)) < s.reach_x + side / 2 &&
              std::abs(s.y - (top + side / 2)) < s.reach_y + side / 2)
            looks.needed += 1;
        }
      }
    }
  }
  return looks;
}

// 32 x 32 splats in front of each other 32 times, each 190 pixels wide on a picture of 64 x 64
// tiles. Were they looked at by every tile, that would be 32768 * 4096 looks, 200 times what is
// needed.
TEST(SplatTiles, LargeSplatsAreSeenOnlyByTilesAround) {
  const Looks looks =
      looks_of(full_cube(32), {.width = 4096, .height = 4096, .samples = 1, .threads = 2}, 1);
  EXPECT_LT(looks.made, 8 * looks.needed);
  EXPECT_LT(looks.needed, 32768 * 64.0);
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
    std::vector<std::vector<uint32_t>> seen;
    uint32_t last = 0;
    for (uint32_t tile = 0; tile < grid.columns * grid.rows; ++tile) {
      seen.emplace_back();
      for (uint32_t level = 0; level < tiles.levels(); ++level)
        for (const uint32_t number : tiles.around(level, tile % grid.columns, tile / grid.columns))
          seen.back().push_back(number);
      std::sort(seen.back().begin(), seen.back().end());
      EXPECT_EQ(std::adjacent_find(seen.back().begin(), seen.back().end()), seen.back().end());
      if (!seen.back().empty()) last = std::max(last, seen.back().back());
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
