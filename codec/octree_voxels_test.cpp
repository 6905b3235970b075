// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "codec/octree_voxels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <vector>

namespace afx::codec {
namespace {

std::vector<uint64_t> random_codes(unsigned levels, size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::set<uint64_t> codes;
  while (codes.size() < count) codes.insert(random() >> (64 - 3 * levels));
  return {codes.begin(), codes.end()};
}

TEST(Morton, InterleavesTheCoordinates) {
  EXPECT_EQ(morton_code({1, 0, 0}), 1U);
  EXPECT_EQ(morton_code({0, 1, 0}), 2U);
  EXPECT_EQ(morton_code({0, 0, 1}), 4U);
  EXPECT_EQ(morton_code({5, 3, 6}),
            0b101'110'011U);  // (bit 2: x1 z1) (bit 1: y1 z1) (bit 0: x1 y1)
  const uint32_t most = (1U << 21) - 1;
  EXPECT_EQ(morton_code({most, most, most}), (uint64_t{1} << 63) - 1);
  EXPECT_EQ(morton_decode(morton_code({123456, 2097151, 7})), (Voxel{123456, 2097151, 7}));
}

TEST(OctreeVoxels, ATreeByHand) {
  // Root: children 0 and 7; child 0 has its corner 1, child 7 its corners 0 and 6.
  const std::vector<uint8_t> octree{0b10000001, 0b00000010, 0b01000001};
  const auto counts = octree_level_counts(octree, 2);
  ASSERT_TRUE(counts.ok());
  EXPECT_EQ(counts.value(), (std::vector<uint64_t>{1, 2, 3}));
  const auto voxels = octree_voxels(octree, 2, 2);
  ASSERT_TRUE(voxels.ok());
  EXPECT_EQ(voxels.value(), (std::vector<Voxel>{{1, 0, 0}, {2, 2, 2}, {2, 3, 3}}));
  const auto codes = octree_morton(octree, 2, 2);
  ASSERT_TRUE(codes.ok());
  EXPECT_EQ(codes.value(), (std::vector<uint64_t>{1, 56, 62}));
  EXPECT_EQ(octree_morton(octree, 2, 1).value(), (std::vector<uint64_t>{0, 7}));
  EXPECT_EQ(octree_morton(octree, 2, 0).value(), (std::vector<uint64_t>{0}));
}

TEST(OctreeVoxels, CodesComeBackFromTheOctreeMadeOfThem) {
  for (unsigned levels = 1; levels <= 21; ++levels) {
    const auto codes =
        random_codes(levels, std::min<size_t>(500, size_t{1} << (3 * levels - 1)), levels);
    const auto octree = octree_from_morton(codes, levels);
    const auto back = octree_morton(octree, levels, levels);
    ASSERT_TRUE(back.ok());
    EXPECT_EQ(back.value(), codes) << levels;
    const auto voxels = octree_voxels(octree, levels, levels);
    ASSERT_TRUE(voxels.ok());
    for (size_t i = 0; i < codes.size(); ++i) EXPECT_EQ(voxels.value()[i], morton_decode(codes[i]));
  }
}

TEST(OctreeVoxels, EmptyAndSingleObjects) {
  EXPECT_EQ(octree_from_morton({}, 3), (std::vector<uint8_t>{0}));
  EXPECT_EQ(octree_from_morton({}, 0), (std::vector<uint8_t>{}));
  const std::vector<uint8_t> empty{0};
  EXPECT_TRUE(octree_morton(empty, 5, 5).value().empty());
  EXPECT_EQ(octree_voxels({}, 0, 0).value(), (std::vector<Voxel>{{0, 0, 0}}));
}

TEST(OctreeVoxels, ThirtyOneLevelsHaveCoordinatesButNoMortonCodes) {
  std::vector<uint8_t> octree(31, 0x80);  // always the far corner
  EXPECT_EQ(octree_voxels(octree, 31, 31).value(),
            (std::vector<Voxel>{{0x7fffffff, 0x7fffffff, 0x7fffffff}}));
  const auto codes = octree_morton(octree, 31, 31);
  ASSERT_FALSE(codes.ok());
  EXPECT_EQ(codes.error().code, Errc::unsupported);
}

struct BadOctree {
  std::vector<uint8_t> octree;
  unsigned levels;
  const char* text;
};

TEST(OctreeVoxels, SaysWhatIsWrongWithFieldsThatDoNotFit) {
  const BadOctree cases[] = {
      {{},
       1,
       "field octree has 0 bytes, too few for its structure (level 0 begins at byte 0 and has 1 "
       "nodes)"},
      {{3, 1},
       2,
       "field octree has 2 bytes, too few for its structure (level 1 begins at byte 1 and has 2 "
       "nodes)"},
      {{1, 1},
       1,
       "field octree has 2 bytes, too many for its structure (expected 1 bytes for 1 levels)"},
      {{0, 1},
       2,
       "field octree has 2 bytes, too many for its structure (expected 1 bytes for 2 levels)"},
  };
  for (const BadOctree& bad : cases) {
    const auto counts = octree_level_counts(bad.octree, bad.levels);
    ASSERT_FALSE(counts.ok());
    EXPECT_EQ(counts.error().code, Errc::bad_argument);
    EXPECT_EQ(counts.error().text, bad.text);
  }
}

TEST(OctreeVoxels, StopsAtTheLimitOfNodes) {
  const std::vector<uint8_t> full{255, 255, 255, 255, 255, 255, 255, 255, 255};
  EXPECT_TRUE(octree_level_counts(full, 2, {.octree_nodes = 73}).ok());
  const auto counts = octree_level_counts(full, 2, {.octree_nodes = 72});
  ASSERT_FALSE(counts.ok());
  EXPECT_EQ(counts.error().code, Errc::limit_exceeded);
}

TEST(VoxelImages, AreInheritedFromTheDeepestNamedNode) {
  // The tree by hand above; root undefined, child 0 has image 2, child 7 is undefined, its voxels 1
  // and 0.
  const OctreeFields fields{{0b10000001, 0b00000010, 0b01000001}, {0, 2, 0, 1, 0}};
  EXPECT_EQ(octree_voxel_images(fields, 2, 2).value(), (std::vector<uint8_t>{2, 1, 0}));
  EXPECT_EQ(octree_voxel_images(fields, 2, 1).value(), (std::vector<uint8_t>{2, 0}));
  EXPECT_EQ(octree_voxel_images(fields, 2, 0).value(), (std::vector<uint8_t>{0}));
}

TEST(VoxelImages, TooFewOrTooManySymbolsAreErrors) {
  OctreeFields fields{{0b10000001, 0b00000010, 0b01000001}, {0, 2, 0, 1}};
  auto images = octree_voxel_images(fields, 2, 2);
  ASSERT_FALSE(images.ok());
  EXPECT_EQ(images.error().text,
            "field voxelImageIndex has 4 symbols, too few for the octree (expected at least 5)");
  fields.voxel_image_index = {1, 1};
  images = octree_voxel_images(fields, 2, 2);
  ASSERT_FALSE(images.ok());
  EXPECT_EQ(images.error().text,
            "field voxelImageIndex has 2 symbols, too many for the octree (expected 1)");
}

TEST(ImageIndex, NamesEachUniformSubtreeOnceAtItsTop) {
  const std::vector<uint8_t> octree{0b10000001, 0b00000010, 0b01000001};
  EXPECT_EQ(octree_image_index(octree, 2, std::vector<uint8_t>{3, 3, 3}),
            (std::vector<uint8_t>{3}));
  EXPECT_EQ(octree_image_index(octree, 2, std::vector<uint8_t>{1, 3, 3}),
            (std::vector<uint8_t>{0, 1, 3}));
  EXPECT_EQ(octree_image_index(octree, 2, std::vector<uint8_t>{2, 1, 0}),
            (std::vector<uint8_t>{0, 2, 0, 1, 0}));
}

TEST(ImageIndex, GivesEveryVoxelItsImageBack) {
  std::mt19937 random(7);
  for (unsigned levels = 1; levels <= 6; ++levels) {
    const auto codes =
        random_codes(levels, std::min<size_t>(300, size_t{1} << (3 * levels - 1)), levels);
    std::vector<uint8_t> images;
    for (size_t i = 0; i < codes.size(); ++i) images.push_back(static_cast<uint8_t>(random() % 4));
    OctreeFields fields{octree_from_morton(codes, levels), {}};
    fields.voxel_image_index = octree_image_index(fields.octree, levels, images);
    const auto back = octree_voxel_images(fields, levels, levels);
    ASSERT_TRUE(back.ok());
    EXPECT_EQ(back.value(), images);
  }
}

}  // namespace
}  // namespace afx::codec
