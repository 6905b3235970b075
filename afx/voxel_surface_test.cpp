// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/voxel_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "codec/octree_voxels.h"

namespace afx {
namespace {

/// A solid block of 16 x `high` x 16 voxels in a cube of 32, its top face in the middle.
std::vector<uint64_t> block(uint32_t high) {
  std::vector<uint64_t> codes;
  for (uint32_t z = 8; z < 24; ++z)
    for (uint32_t y = 16 - high; y < 16; ++y)
      for (uint32_t x = 8; x < 24; ++x) codes.push_back(codec::morton_code({x, y, z}));
  std::sort(codes.begin(), codes.end());
  return codes;
}

size_t place_of(const std::vector<uint64_t>& codes, Voxel v) {
  const uint64_t code = codec::morton_code(v);
  return static_cast<size_t>(std::lower_bound(codes.begin(), codes.end(), code) - codes.begin());
}

// In the middle of the top all is level: the normal points up, and the mean of the 18 voxels of two
// layers around (9 and 9) lies half a voxel below the centre, which is clamped to 0.45.
TEST(VoxelSurface, TheTopOfABlockFacesUpAndLiesLow) {
  const std::vector<uint64_t> codes = block(8);
  const VoxelSurface surface = voxel_surface(codes, 5, VoxelBlocks(codes), 2);
  const size_t top = place_of(codes, {16, 15, 16});
  EXPECT_NEAR(surface.normals[top].y, 1, 1e-5);
  EXPECT_NEAR(surface.heights[top], -0.45, 1e-5);
  EXPECT_EQ(surface.seen[top], top);
}

TEST(VoxelSurface, VoxelsUnderTheTopAreSeenAsItUpToTwoSteps) {
  const std::vector<uint64_t> codes = block(8);
  const VoxelSurface surface = voxel_surface(codes, 5, VoxelBlocks(codes), 1);
  const auto seen = [&](uint32_t y) { return surface.seen[place_of(codes, {16, y, 16})]; };
  EXPECT_EQ(seen(14), place_of(codes, {16, 15, 16}));
  EXPECT_EQ(seen(13), place_of(codes, {16, 15, 16}));
}

TEST(VoxelSurface, ALoneVoxelIsItself) {
  const std::vector<uint64_t> codes{codec::morton_code({3, 4, 5})};
  const VoxelSurface surface = voxel_surface(codes, 4, VoxelBlocks(codes), 1);
  EXPECT_EQ(surface.seen[0], 0U);
  EXPECT_EQ(surface.heights[0], 0);
}

TEST(VoxelSurface, IsTheSameForAnyNumberOfThreads) {
  const std::vector<uint64_t> codes = block(8);
  const VoxelSurface one = voxel_surface(codes, 5, VoxelBlocks(codes), 1);
  const VoxelSurface many = voxel_surface(codes, 5, VoxelBlocks(codes), 7);
  EXPECT_EQ(one.normals, many.normals);
  EXPECT_EQ(one.heights, many.heights);
  EXPECT_EQ(one.seen, many.seen);
}

}  // namespace
}  // namespace afx
