// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/view_choice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <glm/geometric.hpp>

#include "codec/octree_voxels.h"

namespace afx {
namespace {

std::vector<uint64_t> voxels_where(unsigned levels, const std::function<bool(Voxel)>& is_set) {
  std::vector<uint64_t> codes;
  for (uint64_t code = 0; code < uint64_t{1} << (3 * levels); ++code)
    if (is_set(codec::morton_decode(code))) codes.push_back(code);
  return codes;
}

TEST(ChooseDirections, FindsNoneForWhatTheSidesShow) {
  const auto cube = voxels_where(4, [](Voxel v) { return v.x > 3 && v.y > 3 && v.z > 3; });
  EXPECT_TRUE(choose_directions(cube, 4, {}).empty());
  EXPECT_TRUE(choose_directions(std::vector<uint64_t>{0}, 0, {}).empty());
}

// A floor and a roof, each two voxels thick, and a column between: what of them faces the other is
// seen by no side, but all around alike from the edges.
bool is_pavilion(Voxel v) {
  const bool plate = v.y / 2 == 2 || v.y / 2 == 6;
  const bool column = v.x / 2 == 8 && v.z / 2 == 8;
  return plate || (column && v.y >= 4 && v.y < 14);
}

TEST(ChooseDirections, LooksUnderARoof) {
  const auto codes = voxels_where(5, is_pavilion);
  const auto directions = choose_directions(codes, 5, {});
  ASSERT_FALSE(directions.empty());
  for (const glm::dvec3& d : directions) {
    EXPECT_NEAR(glm::length(d), 1, 1e-12);
    EXPECT_LT(std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}), 0.99);  // no side
  }
  // Both onto the floor and up to the roof.
  EXPECT_TRUE(std::any_of(directions.begin(), directions.end(), [](auto& d) { return d.y > 0; }));
  EXPECT_TRUE(std::any_of(directions.begin(), directions.end(), [](auto& d) { return d.y < 0; }));
}

TEST(ChooseDirections, StopsWhereItIsTold) {
  const auto codes = voxels_where(5, is_pavilion);
  const auto all = choose_directions(codes, 5, {});
  const auto two = choose_directions(codes, 5, {.most = 2});
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(two[0], all[0]);
  EXPECT_EQ(two[1], all[1]);
  EXPECT_LT(choose_directions(codes, 5, {.least_gain = 0.05}).size(), all.size());
  EXPECT_TRUE(choose_directions(codes, 5, {.least_gain = 0.9}).empty());
  EXPECT_TRUE(choose_directions(codes, 5, {.most = 0}).empty());
}

TEST(ChooseDirections, IsTheSameForAnyNumberOfThreads) {
  const auto codes = voxels_where(5, is_pavilion);
  EXPECT_EQ(choose_directions(codes, 5, {.threads = 1}),
            choose_directions(codes, 5, {.threads = 3}));
}

}  // namespace
}  // namespace afx
