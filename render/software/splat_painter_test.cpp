// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The painters for each kind of processor against the plain one.
#include "render/software/splat_painter.h"

#include <gtest/gtest.h>

#include <random>

namespace afx::render {
namespace {

/// Splats of all sizes in and around a tile of 96 x 96 samples.
Splat random_splat(std::minstd_rand& random) {
  const auto any = [&](float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random);
  };
  return {.x = any(-10, 110),
          .y = any(-10, 110),
          .reach_x = std::exp2(any(-0.5F, 6)),
          .reach_y = std::exp2(any(-0.5F, 6)),
          .depth = any(1, 2),
          .nearest = 1,
          .tolerance = any(0, 0.2F),
          .light = {any(0, 1), any(0, 1), any(0, 1)}};
}

Tilt random_tilt(std::minstd_rand& random, const Splat& splat) {
  std::uniform_real_distribution<float> any(-1, 1);
  const float a = 1 / (splat.reach_x * splat.reach_x), c = 1 / (splat.reach_y * splat.reach_y);
  return {
      any(random) / 100, any(random) / 100, 0.3F, a, any(random) * std::sqrt(a * c) / 2, c, 0.05F};
}

Slant random_slant(std::minstd_rand& random, const Splat& splat) {
  std::uniform_real_distribution<float> any(-1, 1);
  const auto scaled = [&] { return any(random) * 3 / splat.reach_x; };
  return {scaled(), scaled(), scaled(), scaled(), any(random) / 100, any(random) / 100, 0.3F, 0.5F};
}

/// A disc in its tile.
TileDisc disc_of(const SplatPainter& painter, const Splat& splat, const Tilt& tilt,
                 const TileSamples& tile) {
  EightDiscs eight{};
  eight.x[5] = splat.x, eight.y[5] = splat.y;
  eight.reach_x[5] = splat.reach_x, eight.reach_y[5] = splat.reach_y;
  EightRectangles boxes;
  painter.place(eight, tile, boxes);
  return {splat, tilt, boxes.at(5)};
}

/// A tile with splats laid by one painter; with a wall across half of it.
TileSamples painted(const SplatPainter& painter, bool wall) {
  const RenderOptions options{.width = 32, .height = 32, .samples = 3};
  TileSamples tile{TileGrid(options), options};
  tile.clear(0, 0);
  tile.has_walls = wall;
  std::fill(tile.walls.begin(), tile.walls.end(), kFar);
  if (wall) {
    for (size_t i = 0; i < tile.side * tile.side / 2; ++i)
      tile.walls[i] = tile.depths[i] = 1.2F, tile.wall_g[i] = 0.25F;
  }
  std::minstd_rand random(7);
  std::vector<Splat> splats;
  std::vector<Tilt> tilts;
  std::vector<Slant> slants;
  for (int i = 0; i < 400; ++i) {
    splats.push_back(random_splat(random));
    tilts.push_back(random_tilt(random, splats.back()));
    slants.push_back(random_slant(random, splats.back()));
  }
  for (size_t i = 0; i < splats.size(); ++i) {
    painter.lay_disc_depth(disc_of(painter, splats[i], tilts[i], tile), tile);
    painter.lay_surfel_depth(splats[i], slants[i], tile);
  }
  for (size_t i = 0; i < splats.size(); ++i) {
    painter.lay_disc_colour(disc_of(painter, splats[i], tilts[i], tile), tile);
    painter.lay_surfel_colour(splats[i], slants[i], tile);
  }
  painter.finish(tile);
  return tile;
}

TEST(SplatPainter, EveryKindOfProcessorGivesTheSameSamples) {
  if (&SplatPainter::best() == &SplatPainter::plain()) GTEST_SKIP() << "no AVX2";
  for (const bool wall : {false, true}) {
    const TileSamples plain = painted(SplatPainter::plain(), wall);
    const TileSamples best = painted(SplatPainter::best(), wall);
    const size_t count = plain.side * plain.side;
    for (size_t i = 0; i < count; ++i) {
      ASSERT_EQ(plain.depths[i], best.depths[i]) << i;
      ASSERT_EQ(plain.sum_r[i], best.sum_r[i]) << i;
      ASSERT_EQ(plain.sum_g[i], best.sum_g[i]) << i;
      ASSERT_EQ(plain.sum_b[i], best.sum_b[i]) << i;
      ASSERT_EQ(plain.sum_weight[i], best.sum_weight[i]) << i;
    }
  }
}

TEST(SplatPainter, AWallHidesWhatLiesBehindItAndIsSeenWhereNothingLiesBefore) {
  const RenderOptions options{.width = 32, .height = 32, .samples = 1};
  const SplatPainter& painter = SplatPainter::best();
  TileSamples tile{TileGrid(options), options};
  tile.clear(0, 0);
  tile.has_walls = true;
  std::fill(tile.walls.begin(), tile.walls.end(), 5.0F);
  std::fill(tile.depths.begin(), tile.depths.end(), 5.0F);
  std::fill(tile.wall_r.begin(), tile.wall_r.end(), 1.0F);
  // Just behind the wall, though within its tolerance of it; and just before.
  const Splat behind{.x = 8,
                     .y = 8,
                     .reach_x = 3,
                     .reach_y = 3,
                     .depth = 5.01F,
                     .nearest = 5.01F,
                     .tolerance = 0.1F,
                     .light = {0, 1, 0}};
  Splat before = behind;
  before.x = 24, before.depth = before.nearest = 4.99F;
  const Tilt tilt{0, 0, 0, 1 / 9.0F, 0, 1 / 9.0F, 0};
  for (const Splat& splat : {behind, before}) {
    const TileDisc disc = disc_of(painter, splat, tilt, tile);
    EXPECT_EQ(painter.lay_disc_depth(disc, tile), splat.depth < 5);
    painter.lay_disc_colour(disc, tile);
  }
  painter.finish(tile);
  const size_t hidden = 8 * tile.side + 8, seen = 8 * tile.side + 24;
  EXPECT_EQ(tile.sum_r[hidden], 1);
  EXPECT_EQ(tile.sum_g[hidden], 0);
  EXPECT_EQ(tile.sum_g[seen], 1);
  EXPECT_EQ(tile.sum_weight[seen], 1);
  EXPECT_EQ(tile.depths[seen], 4.99F);
  EXPECT_EQ(tile.depths[hidden], 5);
}

}  // namespace
}  // namespace afx::render
