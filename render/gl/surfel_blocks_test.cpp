// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/gl/surfel_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render/test_surfels.h"

namespace afx::render {
namespace {

TEST(SurfelBlocks, HoldEachSurfelOnceWithinTheirBalls) {
  Surfels surfels;
  add_square(surfels, 50, 2, 200, kRed);  // 40,000
  std::vector<SurfelVertex> vertices;
  const std::vector<SurfelBlock> blocks = make_blocks(surfels, vertices);
  ASSERT_EQ(vertices.size(), surfels.size());
  std::vector<std::pair<double, double>> places;
  uint32_t next = 0;
  for (const SurfelBlock& block : blocks) {
    EXPECT_EQ(block.first, next);
    next += block.count;
    EXPECT_LT(block.radius, 40);  // less than the square's 71: they lie close together
    for (uint32_t i = block.first; i < next; ++i) {
      EXPECT_LE(glm::length(glm::dvec3(vertices[i].offset)), block.radius * (1 + 1e-6));
      const glm::dvec3 at = block.centre + glm::dvec3(vertices[i].offset);
      places.emplace_back(std::round(at.y * 4), std::round(at.x * 4));
    }
    EXPECT_NEAR(block.reach, 2 * 50.0 / 200, 1e-6);
  }
  EXPECT_EQ(next, surfels.size());
  std::sort(places.begin(), places.end());
  EXPECT_EQ(std::unique(places.begin(), places.end()), places.end());
}

TEST(SurfelBlocks, LeaveOutWhatIsNotDrawn) {
  Surfels surfels;
  surfels.push_back({1, 2, 3}, {1, 0, 0}, {0, 1, 0}, kBlue);
  surfels.push_back({1, 2, 3}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0, 127});
  surfels.push_back({NAN, 2, 3}, {1, 0, 0}, {0, 1, 0}, kRed);
  surfels.push_back({1, 2, 3}, {1, 0, 0}, {0, INFINITY, 0}, kRed);
  std::vector<SurfelVertex> vertices;
  const std::vector<SurfelBlock> blocks = make_blocks(surfels, vertices);
  ASSERT_EQ(vertices.size(), 1U);
  EXPECT_EQ(vertices[0].colour, kBlue);
  ASSERT_EQ(blocks.size(), 1U);
  EXPECT_EQ(blocks[0].centre, glm::dvec3(1, 2, 3));
  EXPECT_TRUE(make_blocks({}, vertices).empty());
}

}  // namespace
}  // namespace afx::render
