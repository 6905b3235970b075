// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/splat_tiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/test_scenes.h"

namespace afx::render {
namespace {

Camera front(double view_height) {
  return {.position = {0, 0, 10},
          .projection = Projection::orthographic,
          .view_height = view_height,
          .near_plane = 0.1};
}

TestModel full_cube(unsigned level) {
  TestModel model;
  model.level = level;
  for (uint64_t code = 0; code < uint64_t{1} << (3 * level); ++code) model.codes.push_back(code);
  model.colours.assign(model.codes.size(), kRed);
  return model;
}

/// How many splats the tiles look at, and how many of those looks a tile and a splat that meet
/// need.
struct Looks {
  double made = 0, needed = 0;
};

Looks looks_of(const TestModel& model, const RenderOptions& options, double view_height) {
  const SplatTiles tiles(model.scene(), front(view_height), options);
  Looks looks;
  const auto side = static_cast<float>(kTile * options.samples);
  for (uint32_t row = 0; row < tiles.rows(); ++row) {
    for (uint32_t column = 0; column < tiles.columns(); ++column) {
      const float left = static_cast<float>(column) * side, top = static_cast<float>(row) * side;
      for (uint32_t level = 0; level < tiles.levels(); ++level) {
        for (const uint32_t number : tiles.around(level, column, row)) {
          const Splat& s = tiles.splat(number);
          looks.made += 1;
          if (std::abs(s.x - (left + side / 2)) < s.radius + side / 2 &&
              std::abs(s.y - (top + side / 2)) < s.radius + side / 2)
            looks.needed += 1;
        }
      }
    }
  }
  return looks;
}

// 32 x 32 splats in front of each other 32 times, each 190 pixels wide on a picture of 128 x 128
// tiles. Were they looked at by every tile, that would be 32768 * 16384 looks, 400 times what is
// needed.
TEST(SplatTiles, LargeSplatsAreSeenOnlyByTilesAround) {
  const Looks looks =
      looks_of(full_cube(5), {.width = 4096, .height = 4096, .samples = 1, .threads = 2}, 1);
  EXPECT_LT(looks.made, 8 * looks.needed);
  EXPECT_LT(looks.needed, 32768 * 64.0);
}

// Whatever the size of the splats, from parts of a tile to the whole picture: each tile has those
// that touch it, once.
TEST(SplatTiles, EveryTileHasTheSplatsThatTouchIt) {
  TestModelMaker maker(4);
  for (uint32_t k = 0; k < 16; ++k) maker.add({k, (7 * k) % 16, k % 3}, kRed);
  const TestModel model = maker.make();
  for (const double view_height : {0.02, 0.1, 0.3, 1.0, 2.0, 40.0}) {
    const RenderOptions options{.width = 500, .height = 300, .samples = 2, .threads = 1};
    const SplatTiles tiles(model.scene(), front(view_height), options);
    const float side = 2 * kTile;
    std::vector<std::vector<uint32_t>> seen;
    uint32_t last = 0;
    for (uint32_t tile = 0; tile < tiles.columns() * tiles.rows(); ++tile) {
      seen.emplace_back();
      for (uint32_t level = 0; level < tiles.levels(); ++level)
        for (const uint32_t number :
             tiles.around(level, tile % tiles.columns(), tile / tiles.columns()))
          seen.back().push_back(number);
      std::sort(seen.back().begin(), seen.back().end());
      EXPECT_EQ(std::adjacent_find(seen.back().begin(), seen.back().end()), seen.back().end());
      if (!seen.back().empty()) last = std::max(last, seen.back().back());
    }
    for (uint32_t number = 0; number <= last; ++number) {
      const Splat& s = tiles.splat(number);
      for (uint32_t tile = 0; tile < seen.size(); ++tile) {
        const float x = (static_cast<float>(tile % tiles.columns()) + 0.5F) * side;
        const float y = (static_cast<float>(tile / tiles.columns()) + 0.5F) * side;
        const bool meets =
            std::abs(s.x - x) < s.radius + side / 2 && std::abs(s.y - y) < s.radius + side / 2;
        EXPECT_TRUE(!meets || std::binary_search(seen[tile].begin(), seen[tile].end(), number))
            << view_height << ' ' << number << ' ' << tile;
      }
    }
  }
}

}  // namespace
}  // namespace afx::render
