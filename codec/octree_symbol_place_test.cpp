// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "codec/octree_symbol_place.h"

#include <gtest/gtest.h>

#include <vector>

#include "codec/octree_decoder.h"
#include "codec/octree_encoder.h"

namespace afx::codec {
namespace {

/// 1 + 8 + 64 + 512 + 4096 nodes, whose images are named at the voxels alone.
struct FullTree {
  static constexpr unsigned kLevels = 4;
  OctreeFields fields{std::vector<uint8_t>(1 + 8 + 64 + 512, 0xFF),
                      std::vector<uint8_t>(1 + 8 + 64 + 512 + 4096, 0)};
  FullTree() {
    for (size_t i = 585; i < fields.voxel_image_index.size(); ++i)
      fields.voxel_image_index[i] = static_cast<uint8_t>(1 + i % 2);
  }
  [[nodiscard]] std::vector<uint8_t> coded() const {
    std::vector<uint8_t> data;
    EXPECT_TRUE(encode_octree_frame(fields, kLevels, 2, data).ok());
    return data;
  }
};

TEST(OctreeSymbolPlace, TheFirstSymbolOfALevelBeginsWhereTheLevelBeforeEnds) {
  const FullTree tree;
  const std::vector<uint8_t> data = tree.coded();
  Diagnostics diagnostics;
  const OctreeFrame frame =
      decode_octree_frame(data, {.levels = FullTree::kLevels, .textures = 2}, diagnostics);
  ASSERT_TRUE(frame.status.ok());
  uint64_t nodes = 0, textures = 0;
  for (unsigned level = 0; level < FullTree::kLevels; ++level) {
    nodes += frame.stats[level].nodes;
    textures += frame.stats[level].texture_symbols;
    const bool voxels = level + 1 == FullTree::kLevels;
    const OctreeSymbol first{voxels, voxels ? textures : nodes};
    const uint64_t bit = frame.stats[level].end_bit - 2;  // the decoder's shifts
    EXPECT_EQ(octree_symbol_bit(data, tree.fields, FullTree::kLevels, 2, first), bit) << level;
  }
}

TEST(OctreeSymbolPlace, TheRootBeginsAtBitZeroAndWhatIsNotThereHasNoPlace) {
  const FullTree tree;
  const std::vector<uint8_t> data = tree.coded();
  EXPECT_EQ(octree_symbol_bit(data, tree.fields, FullTree::kLevels, 2, {false, 0}), 0U);
  EXPECT_EQ(octree_symbol_bit(data, tree.fields, FullTree::kLevels, 2, {false, 585}), std::nullopt);
  EXPECT_EQ(octree_symbol_bit(data, tree.fields, FullTree::kLevels, 2, {true, 4681}), std::nullopt);
}

}  // namespace
}  // namespace afx::codec
