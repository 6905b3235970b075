// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/voxel_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "codec/octree_voxels.h"
#include "render/test_scenes.h"

namespace afx::render {
namespace {

std::shared_ptr<const VoxelTree> tree_of(const TestModel& model) {
  return VoxelTree::make(model.level, model.codes, model.colours).value();
}

TEST(VoxelTree, ItsSymbolsAreTheBreadthFirstBytesOfTheOctree) {
  TestModelMaker maker(5);
  add_sphere(maker, 5, 0.4, kRed);
  const TestModel model = maker.make();
  const auto tree = tree_of(model);
  std::vector<uint8_t> bytes;
  for (unsigned level = 0; level < tree->level(); ++level)
    for (const VoxelTree::Branch branch : tree->branches(level)) bytes.push_back(branch.symbol);
  EXPECT_EQ(bytes, codec::octree_from_morton(model.codes, 5));
}

TEST(VoxelTree, EveryLevelHasTheCellsThatHoldVoxels) {
  TestModelMaker maker(6);
  add_sphere(maker, 6, 0.4, kRed);
  const TestModel model = maker.make();
  const auto tree = tree_of(model);
  for (unsigned level = 0; level <= 6; ++level) {
    std::vector<uint64_t> cells;
    for (const uint64_t code : model.codes) {
      const uint64_t cell = code >> (3 * (6 - level));
      if (cells.empty() || cells.back() != cell) cells.push_back(cell);
    }
    EXPECT_EQ(tree->codes(level), cells) << level;
    EXPECT_EQ(tree->nodes(level), cells.size());
  }
}

// A wall two voxels thick across x: red towards +x, blue towards -x. From above one sees both, in
// linear light half of each: sRGB 188.
TEST(VoxelTree, ANodeHasTheColoursThatAreSeenFromEachSide) {
  TestModelMaker maker(1);
  for (uint32_t y = 0; y < 2; ++y) {
    for (uint32_t z = 0; z < 2; ++z) {
      maker.add({0, y, z}, kBlue);
      maker.add({1, y, z}, kRed);
    }
  }
  const auto tree = tree_of(maker.make());
  const VoxelTree::Sides& sides = tree->sides(0)[0];
  EXPECT_EQ(sides.from[0], kRed);
  EXPECT_EQ(sides.from[1], kBlue);
  for (int side = 2; side < 6; ++side) EXPECT_EQ(sides.from[side], (Rgba8{188, 0, 188, 255}));
}

// Level 1 has a red node at +x that covers a quarter of its face from there, and a blue one behind
// it that covers all: 1/4 red and 3/4 blue. From -x the blue one alone is seen.
TEST(VoxelTree, WhatANodeDoesNotCoverLetsTheOneBehindBeSeen) {
  TestModelMaker maker(2);
  maker.add({3, 0, 0}, kRed);
  for (uint32_t y = 0; y < 2; ++y)
    for (uint32_t z = 0; z < 2; ++z) maker.add({0, y, z}, kBlue);
  const auto tree = tree_of(maker.make());
  EXPECT_EQ(tree->sides(0)[0].from[0], (Rgba8{137, 0, 225, 255}));  // sRGB of 1/4 and 3/4
  EXPECT_EQ(tree->sides(0)[0].from[1], kBlue);
}

// Two of the eight voxels of level 1, with normals along +x and +y and heights of 0.2 and -0.1
// sides: 0.4 and -0.2 half sides are 51 and -25 parts of 127. Their parent's normal is (1, 1, 0) /
// sqrt 2; it lies at the mean of both points, from its centre (1, 1, 1) on in voxels:
// ((0.7 + 1.5) / 2 - 1, (0.5 + 0.4) / 2 - 1, (0.5 + 0.5) / 2 - 1), halves of its side being one
// voxel.
TEST(VoxelTree, FacetsLieWhereTheSurfaceIsAndThoseAboveAtTheMean) {
  const std::vector<uint64_t> codes{0, 1};
  const std::vector<Rgba8> colours{kRed, kBlue};
  const VoxelSurface surface{{{1, 0, 0}, {0, 1, 0}}, {0.2F, -0.1F}, {0, 1}};
  const auto tree = VoxelTree::make(1, codes, colours, &surface).value();
  const auto expect = [](const VoxelTree::Facet& facet, glm::ivec3 normal, glm::ivec3 shift) {
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(facet.normal[k], normal[k]) << k;
      EXPECT_EQ(facet.shift[k], shift[k]) << k;
    }
  };
  expect(tree->facets(1)[0], {127, 0, 0}, {51, 0, 0});
  expect(tree->facets(1)[1], {0, 127, 0}, {0, -25, 0});
  expect(tree->facets(0)[0], {90, 90, 0}, {13, -70, -64});
}

TEST(VoxelTree, NormalsThatDisagreeMakeNone) {
  const std::vector<uint64_t> codes{0, 1};
  const VoxelSurface surface{{{1, 0, 0}, {-1, 0, 0}}, {0, 0}, {0, 1}};
  const auto tree = VoxelTree::make(1, codes, std::vector<Rgba8>(2), &surface).value();
  for (int k = 0; k < 3; ++k) EXPECT_EQ(tree->facets(0)[0].normal[k], 0);
}

TEST(VoxelTree, AVoxelHasTheColourOfTheOneThatIsSeen) {
  const std::vector<uint64_t> codes{0, 1};
  const std::vector<Rgba8> colours{kRed, kBlue};
  const VoxelSurface surface{{{1, 0, 0}, {1, 0, 0}}, {0, 0}, {1, 1}};
  const auto tree = VoxelTree::make(1, codes, colours, &surface).value();
  EXPECT_EQ(tree->colours()[0], kBlue);
  EXPECT_EQ(tree->sides(0)[0].from[1], kBlue);
}

TEST(VoxelTree, SurfacesThatDoNotFitAreRefused) {
  const auto text = [](const VoxelSurface& surface) {
    const std::vector<uint64_t> codes{0, 1};
    const auto tree = VoxelTree::make(1, codes, std::vector<Rgba8>(2), &surface);
    return tree.ok() ? std::string("ok") : tree.error().text;
  };
  const std::vector<glm::vec3> normals(2, {1, 0, 0});
  EXPECT_EQ(text({normals, {0, 0}, {0, 1}}), "ok");
  EXPECT_EQ(text({normals, {0, 0}, {0}}),
            "2 voxels with 2 normals, 2 heights and 1 seen (expected as many)");
  EXPECT_EQ(text({normals, {0, 0}, {0, 2}}), "voxel 1 is seen as another one that is not there");
  EXPECT_EQ(text({normals, {0, NAN}, {0, 1}}),
            "the surface in voxel 1 has no finite normal, or a height beyond 1");
}

TEST(VoxelTree, LimitsAreKeptBeforeTheMemoryIsAskedFor) {
  const std::vector<uint64_t> codes{0, 7};
  Limits limits;
  limits.memory = 300;  // working at two levels of 3 nodes takes more
  const auto tree = VoxelTree::make(1, codes, std::vector<Rgba8>(2), nullptr, limits);
  ASSERT_FALSE(tree.ok());
  EXPECT_EQ(tree.error().code, Errc::limit_exceeded);
  EXPECT_EQ(tree.error().text,
            "an octree of 2 voxels needs more memory to be drawn than the limits allow");
}

TEST(VoxelTree, ATreeWithoutVoxelsHasNoNodes) {
  const auto tree = VoxelTree::make(3, {}, {}).value();
  EXPECT_EQ(tree->level(), 3U);
  EXPECT_EQ(tree->voxels(), 0U);
  EXPECT_TRUE(tree->codes(2).empty());
}

TEST(VoxelTree, VoxelsThatDoNotFitAreRefused) {
  const auto text = [](unsigned level, const std::vector<uint64_t>& codes, size_t colours) {
    const auto tree = VoxelTree::make(level, codes, std::vector<Rgba8>(colours));
    return tree.ok() ? std::string("ok") : tree.error().text;
  };
  EXPECT_EQ(text(1, {0, 7}, 2), "ok");
  EXPECT_EQ(text(1, {0}, 0), "1 voxels with 0 colours (expected as many)");
  EXPECT_EQ(text(22, {0}, 1), "voxels of level 22 (expected at most 21)");
  EXPECT_EQ(text(1, {0, 3, 3}, 3),
            "voxel 1 does not come before the one after it (expected ascending codes)");
  EXPECT_EQ(text(1, {8}, 1), "a voxel lies outside of the cube of level 1");
}

}  // namespace
}  // namespace afx::render
