// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/grid.h"

#include <gtest/gtest.h>

namespace afx {
namespace {

TEST(Grid, FitsTheLongestSideOfAnObject) {
  // 4 long, resolution 6 of 8 voxels: one voxel of border on both sides.
  const Grid grid(Bounds{{10, 0, 0}, {14, 2, 1}}, 6);
  EXPECT_EQ(grid.levels, 3U);
  EXPECT_EQ(grid.to_voxels({10, 1, 0.5F}), glm::dvec3(1, 4, 4));
  EXPECT_EQ(grid.to_fixed({10, 1, 0.5F}), glm::ivec3(256, 1024, 1024));
  EXPECT_EQ(grid.to_fixed({14, 1, 0.5F}).x >> kSubvoxelBits, 6);  // the end, taken back
}

TEST(Grid, LaysTheOctreeIntoACube) {
  const Grid grid(Cube{{1, 2, 3}, 16}, 5);  // 8 voxels of side 2, from -7, -6, -5
  EXPECT_EQ(grid.levels, 3U);
  EXPECT_EQ(grid.to_voxels({-7, 2, 11}), glm::dvec3(0, 4, 8));
  const auto voxel = [&](float x) { return grid.to_fixed({x, 2, 3}).x >> kSubvoxelBits; };
  EXPECT_EQ(voxel(-7), 0);
  EXPECT_EQ(voxel(-5.0001F), 0);  // not rounded up
  EXPECT_EQ(voxel(-5), 1);
  EXPECT_EQ(voxel(8.9999F), 7);
}

TEST(Grid, HoldsWhatLiesInItsCube) {
  const Grid grid(Cube{{0, 0, 0}, 2}, 100);
  EXPECT_TRUE(grid.holds({-1, -1, -1}));
  EXPECT_TRUE(grid.holds({0, 0.999F, 0}));
  EXPECT_FALSE(grid.holds({0, 1, 0}));
  EXPECT_FALSE(grid.holds({0, 0, -1.001F}));
  EXPECT_FALSE(grid.holds({1e30F, 0, 0}));
}

}  // namespace
}  // namespace afx
