// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The frame coder, against bytes by hand and against the plain coder.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "codec/octree_decoder.h"
#include "codec/octree_encoder.h"
#include "codec/octree_voxels.h"
#include "codec/plain/octree_plain.h"

namespace afx::codec {
namespace {

using Bytes = std::vector<uint8_t>;

struct Case {
  OctreeFields fields;
  unsigned levels;
  unsigned textures;
};

OctreeFrame decode(std::span<const uint8_t> data, const Case& c, Diagnostics& diagnostics,
                   unsigned stop = 32) {
  return decode_octree_frame(data, {.levels = c.levels, .textures = c.textures, .stop_level = stop},
                             diagnostics);
}

/// A random tree in which so many percent of the possible children exist, childless nodes and
/// images among them.
Case random_case(unsigned seed, unsigned levels, unsigned percent, unsigned textures,
                 size_t most_nodes = 20000) {
  std::mt19937 random(seed);
  Case c{{}, levels, textures};
  std::vector<uint8_t> open{textures > 0 ? uint8_t{1}
                                         : uint8_t{0}};  // a node each: has it a texture symbol
  for (unsigned level = 0; level <= levels; ++level) {
    std::vector<uint8_t> below;
    for (const uint8_t is_open : open) {
      unsigned symbol = 0;
      for (unsigned child = 0; child < 8; ++child)
        symbol |= (random() % 100 < percent ? 1U : 0U) << child;
      if (below.size() + c.fields.octree.size() > most_nodes) symbol &= 1;
      if (level < levels) c.fields.octree.push_back(static_cast<uint8_t>(symbol));
      uint8_t image = 0;
      if (is_open != 0) {
        image = random() % 3 == 0 ? static_cast<uint8_t>(1 + random() % textures) : uint8_t{0};
        c.fields.voxel_image_index.push_back(image);
      }
      if (level < levels) {
        below.insert(below.end(), static_cast<size_t>(std::popcount(symbol)),
                     is_open != 0 && image == 0 ? uint8_t{1} : uint8_t{0});
      }
    }
    open = std::move(below);
  }
  return c;
}

std::vector<Case> random_cases() {
  std::vector<Case> cases;
  unsigned seed = 1;
  for (const unsigned textures : {0U, 1U, 6U, 127U}) {
    for (const unsigned percent : {15U, 36U, 70U}) {
      for (const unsigned levels : {0U, 1U, 3U, 5U, 12U, 31U})
        cases.push_back(random_case(seed++, levels, percent, textures));
    }
  }
  return cases;
}

// Root symbol s of 256 at frequency 1 each: cum[s] = 256 - s. With s = 1 the interval of 65536
// codes becomes [65536 * 254 / 256, 65536 * 255 / 256) = [FE00, FF00): eight shared bits 1111 1110,
// back to all codes; then the ending 01. So 1111 1110 01.
TEST(OctreeCoder, ARootByHand) {
  const Case c{{{1}, {}}, 1, 0};
  Bytes out;
  const auto bits = encode_octree_frame(c.fields, c.levels, c.textures, out);
  ASSERT_TRUE(bits.ok());
  EXPECT_EQ(bits.value(), 10U);
  EXPECT_EQ(out, (Bytes{0xFE, 0x40}));
  Diagnostics diagnostics;
  const OctreeFrame frame = decode(out, c, diagnostics);
  EXPECT_TRUE(frame.status.ok());
  EXPECT_EQ(frame.fields, c.fields);
  EXPECT_EQ(frame.bits, 10U);
  EXPECT_EQ(diagnostics.count(), 0U);
}

// No symbol at all: only the ending 01.
TEST(OctreeCoder, OneVoxelWithoutImagesIsTwoBits) {
  Bytes out;
  EXPECT_EQ(encode_octree_frame({}, 0, 0, out).value(), 2U);
  EXPECT_EQ(out, (Bytes{0x40}));
  Diagnostics diagnostics;
  EXPECT_TRUE(decode(out, {{}, 0, 0}, diagnostics).status.ok());
  EXPECT_EQ(decode({}, {{}, 0, 0}, diagnostics).status.error().code, Errc::truncated);
}

TEST(OctreeCoder, EncodesTheBytesOfThePlainCoder) {
  for (const Case& c : random_cases()) {
    Bytes out;
    const auto bits = encode_octree_frame(c.fields, c.levels, c.textures, out);
    ASSERT_TRUE(bits.ok()) << bits.error().text;
    EXPECT_EQ((bits.value() + 7) / 8, out.size());
    EXPECT_EQ(out, plain::encode_frame(c.fields, c.levels, c.textures));
  }
}

TEST(OctreeCoder, DecodesWhatItEncodesAndFindsTheEnd) {
  for (const Case& c : random_cases()) {
    Bytes out;
    const uint64_t bits = encode_octree_frame(c.fields, c.levels, c.textures, out).value();
    for (const uint8_t behind : {uint8_t{0}, uint8_t{0xFF}}) {
      Bytes data = out;
      data.insert(data.end(), 9, behind);
      Diagnostics diagnostics;
      const OctreeFrame frame = decode(data, c, diagnostics);
      ASSERT_TRUE(frame.status.ok()) << frame.status.error().text;
      EXPECT_EQ(frame.fields, c.fields);
      EXPECT_EQ(frame.bits, bits);
      EXPECT_EQ(frame.node_symbols, c.fields.octree.size());
      EXPECT_EQ(frame.texture_symbols, c.fields.voxel_image_index.size());
    }
  }
}

TEST(OctreeCoder, WarnsOfChildlessNodesWithTheirCount) {
  const Case c{{{0b111, 0, 1, 0}, {}}, 2, 0};
  Bytes out;
  ASSERT_TRUE(encode_octree_frame(c.fields, c.levels, 0, out).ok());
  Diagnostics diagnostics;
  EXPECT_EQ(decode(out, c, diagnostics).fields, c.fields);
  ASSERT_EQ(diagnostics.count(), 1U);
  EXPECT_EQ(diagnostics.warnings()[0].code, "octree_childless_node");
  EXPECT_EQ(diagnostics.warnings()[0].text, "2 nodes below the root have no children (symbol 0)");
}

TEST(OctreeCoder, WarnsWhereTheEndingIsNotAnEncoders) {
  Bytes out{0xFE, 0x80};  // ARootByHand with the ending 10
  Diagnostics diagnostics;
  EXPECT_TRUE(decode(out, {{}, 1, 0}, diagnostics).status.ok());
  ASSERT_EQ(diagnostics.count(), 1U);
  EXPECT_EQ(diagnostics.warnings()[0].code, "octree_bad_ending");
}

TEST(OctreeCoder, WarnsOfABadEndingOfAFrameWithoutSymbolsToo) {
  Diagnostics diagnostics;
  EXPECT_TRUE(decode(Bytes{0x00}, {{}, 0, 0}, diagnostics).status.ok());
  EXPECT_EQ(diagnostics.count(), 1U);
}

TEST(OctreeCoder, RefusesFieldsThatDoNotFitAndAppendsNothing) {
  struct Bad {
    Case c;
    const char* text;
  };
  const Bad cases[] = {
      {{{{1}, {}}, 1, 2},
       "field voxelImageIndex is empty (expected at least 1 symbol, as there are images)"},
      {{{{1}, {1}}, 1, 0},
       "field voxelImageIndex has 1 symbols, but there are no images (expected none)"},
      {{{{1}, {0, 3}}, 1, 2},
       "field voxelImageIndex has 3 at position 1 (expected 0..2, the number of images)"},
      {{{{3}, {0, 1}}, 1, 2},
       "field voxelImageIndex has 2 symbols, too few for the octree (expected at least 3)"},
      {{{{1, 1}, {0}}, 2, 2},
       "field voxelImageIndex has 1 symbols, too few for the octree (expected at least 2)"},
      {{{{3}, {1, 1}}, 1, 2},
       "field voxelImageIndex has 2 symbols, too many for the octree (expected 1)"},
      {{{{3}, {}}, 2, 0},
       "field octree has 1 bytes, too few for its structure (level 1 begins at byte 1 and has 2 "
       "nodes)"},
  };
  for (const Bad& bad : cases) {
    Bytes out{42};
    const auto bits = encode_octree_frame(bad.c.fields, bad.c.levels, bad.c.textures, out);
    ASSERT_FALSE(bits.ok());
    EXPECT_EQ(bits.error().code, Errc::bad_argument);
    EXPECT_EQ(bits.error().text, bad.text);
    EXPECT_EQ(out, Bytes{42});
  }
}

/// What a coarser model must be: the symbols of the levels above, and zeros for undefined voxels.
OctreeFields coarse(const Case& c, unsigned level) {
  const auto counts = octree_level_counts(c.fields.octree, c.levels).value();
  OctreeFields fields;
  size_t nodes = 0;
  for (unsigned l = 0; l < level; ++l) nodes += counts[l];
  fields.octree.assign(c.fields.octree.begin(),
                       c.fields.octree.begin() + static_cast<ptrdiff_t>(nodes));
  if (c.textures == 0) return fields;
  std::vector<bool> open{true};
  size_t node = 0;
  size_t texture = 0;
  for (unsigned l = 0; l < level; ++l) {
    std::vector<bool> below;
    for (const bool is_open : open) {
      const bool stays = is_open && c.fields.voxel_image_index[texture] == 0;
      if (is_open) fields.voxel_image_index.push_back(c.fields.voxel_image_index[texture++]);
      below.insert(below.end(), static_cast<size_t>(std::popcount(c.fields.octree[node++])), stays);
    }
    open = std::move(below);
  }
  for (const bool is_open : open) {
    if (is_open) fields.voxel_image_index.push_back(0);
  }
  return fields;
}

TEST(OctreeCoder, StopsEarlyWithTheCoarserModel) {
  for (const Case& c : random_cases()) {
    Bytes out;
    ASSERT_TRUE(encode_octree_frame(c.fields, c.levels, c.textures, out).ok());
    for (unsigned level = 0; level < c.levels; ++level) {
      Diagnostics diagnostics;
      const OctreeFrame frame = decode(out, c, diagnostics, level);
      ASSERT_TRUE(frame.status.ok() && frame.usable);
      EXPECT_EQ(frame.levels, level);
      EXPECT_EQ(frame.fields, coarse(c, level));
      OctreeFields cut = c.fields;
      coarsen_octree(cut, c.levels, level);
      EXPECT_EQ(cut, frame.fields);
      EXPECT_TRUE(check_octree_fields(frame.fields, level, c.textures).ok());
    }
  }
}

/// The symbols, nodes and images, of the levels above `level`.
uint64_t symbols_above(const Case& c, unsigned level) {
  if (level == c.levels && c.textures == 0) return c.fields.octree.size();
  const OctreeFields fields = coarse(c, level);
  uint64_t voxels_coded = 0;  // the zeros that coarse() appended
  if (c.textures > 0) {
    const auto images = octree_voxel_images(fields, level, level).value();
    voxels_coded = static_cast<uint64_t>(std::count(images.begin(), images.end(), uint8_t{0}));
  }
  return fields.octree.size() + fields.voxel_image_index.size() - voxels_coded;
}

/// By the text: the deepest level above which every symbol is whole; -1 if not even the root is.
int deepest_whole_level(const Case& c, uint64_t whole) {
  int deepest = -1;
  for (unsigned level = 1; level <= c.levels; ++level) {
    if (symbols_above(c, level) <= whole) deepest = static_cast<int>(level);
  }
  return deepest;
}

/// Of the voxels' own symbols those that are whole stay, and the rest are 0.
OctreeFields with_whole_voxels(const Case& c, uint64_t whole) {
  OctreeFields fields = c.fields;
  const uint64_t kept = whole - fields.octree.size();
  for (size_t i = kept; i < fields.voxel_image_index.size(); ++i) fields.voxel_image_index[i] = 0;
  return fields;
}

/// Claims about a frame cut to `bytes`, by the plain coder and the text's rule of what is whole.
void check_truncation(const Case& c, const Bytes& whole, size_t bytes) {
  // Of exact size: a sanitizer sees one byte too far.
  const Bytes data(whole.begin(), whole.begin() + static_cast<ptrdiff_t>(bytes));
  Diagnostics diagnostics;
  const OctreeFrame frame = decode(data, c, diagnostics);
  const plain::Frame expected = plain::decode_frame(data, c.levels, c.textures, UINT64_MAX);
  ASSERT_EQ(!frame.status.ok(), expected.truncated);
  if (frame.status.ok()) return;
  EXPECT_EQ(frame.status.error().code, Errc::truncated);
  EXPECT_EQ(frame.status.error().place, Place::at_byte(bytes));
  EXPECT_EQ(frame.node_symbols, expected.fields.octree.size());
  EXPECT_EQ(frame.texture_symbols, expected.fields.voxel_image_index.size());
  const int level = deepest_whole_level(c, expected.whole);
  ASSERT_EQ(frame.usable, level >= 0) << bytes;
  if (level < 0) return;
  ASSERT_EQ(frame.levels, static_cast<unsigned>(level)) << bytes;
  const bool all_levels = frame.levels == c.levels;
  EXPECT_EQ(frame.fields,
            all_levels ? with_whole_voxels(c, expected.whole) : coarse(c, frame.levels))
      << bytes;
}

TEST(OctreeCoder, EveryTruncationGivesTheDeepestWholeLevel) {
  for (const Case& c : {random_case(100, 6, 30, 0, 400), random_case(101, 6, 30, 5, 400),
                        random_case(102, 31, 20, 3, 200), random_case(103, 3, 90, 1, 400),
                        random_case(104, 0, 50, 4)}) {
    Bytes out;
    ASSERT_TRUE(encode_octree_frame(c.fields, c.levels, c.textures, out).ok());
    for (size_t bytes = 0; bytes < out.size(); ++bytes) check_truncation(c, out, bytes);
  }
}

// 73 nodes at most: a root symbol (10 bits of code used) and eight more, then 64 voxels whose
// images are missing. The data are cut by a byte, so only the voxels' images can be short.
TEST(OctreeCoder, MissingVoxelImagesLeaveTheWholeGeometry) {
  Case c{{Bytes(9, 255), {}}, 2, 2};
  c.fields.voxel_image_index.assign(1 + 8 + 64, 0);
  for (size_t i = 9; i < 73; ++i)
    c.fields.voxel_image_index[i] = static_cast<uint8_t>(1 + (i * 7 + i / 5) % 2);
  Bytes out;
  ASSERT_TRUE(encode_octree_frame(c.fields, c.levels, c.textures, out).ok());
  out.resize(out.size() - 3);
  Diagnostics diagnostics;
  const OctreeFrame frame = decode(out, c, diagnostics);
  ASSERT_FALSE(frame.status.ok());
  ASSERT_TRUE(frame.usable);
  EXPECT_EQ(frame.levels, 2U);
  EXPECT_EQ(frame.fields.octree, c.fields.octree);
  ASSERT_EQ(frame.fields.voxel_image_index.size(), 73U);
  EXPECT_EQ(frame.fields.voxel_image_index[9], c.fields.voxel_image_index[9]);
  EXPECT_EQ(frame.fields.voxel_image_index[72], 0);
}

TEST(OctreeCoder, SaysAtWhichSymbolTheDataEnd) {
  const Case c{{{255, 1, 2, 3, 4, 5, 6, 7, 8}, {}}, 2, 0};
  Bytes out;
  ASSERT_TRUE(encode_octree_frame(c.fields, c.levels, 0, out).ok());
  out.resize(4);
  Diagnostics diagnostics;
  const OctreeFrame frame = decode_octree_frame(out, {.levels = 2, .base_byte = 100}, diagnostics);
  ASSERT_FALSE(frame.status.ok());
  EXPECT_EQ(frame.status.error().place, Place::at_byte(104));
  // Each symbol costs about eight bits: with 32 the fourth is the first that does not end
  // before 30.
  EXPECT_EQ(frame.status.error().text,
            "the data end inside the octree frame, at symbol 4 of 9 known so far (9 nodes, 0 image "
            "indices)");
}

TEST(OctreeCoder, CountsTheVoxelsImageAtHandAsKnown) {
  Diagnostics diagnostics;
  const OctreeFrame frame = decode(Bytes{}, {{}, 0, 3}, diagnostics);
  ASSERT_FALSE(frame.status.ok());
  EXPECT_EQ(frame.status.error().text,
            "the data end inside the octree frame, at symbol 1 of 1 known so far (0 nodes, 1 image "
            "indices)");
}

TEST(OctreeCoder, ASmallStreamThatPromisesAFullTreeStopsAtTheLimit) {
  // The far too long beginning of a full tree of 31 levels: 255 again and again.
  Bytes full;
  {
    OctreeFields fields;
    fields.octree.assign(1 + 8 + 64 + 512 + 4096 + 32768, 255);
    ASSERT_TRUE(encode_octree_frame(fields, 6, 0, full).ok());
  }
  EXPECT_LT(full.size(), 1000U);
  for (const uint64_t limit : {uint64_t{1}, uint64_t{73}, uint64_t{5000}, uint64_t{100000}}) {
    Diagnostics diagnostics;
    OctreeFrameOptions options{.levels = 31};
    options.limits.octree_nodes = limit;
    const OctreeFrame frame = decode_octree_frame(full, options, diagnostics);
    ASSERT_FALSE(frame.status.ok());
    EXPECT_EQ(frame.status.error().code, Errc::limit_exceeded) << limit;
    EXPECT_FALSE(frame.usable);
    EXPECT_LE(frame.node_symbols, limit + 2048);
  }
  full.resize(40);
  Diagnostics diagnostics;
  const OctreeFrame frame = decode_octree_frame(full, {.levels = 31}, diagnostics);
  ASSERT_FALSE(frame.status.ok());
  EXPECT_EQ(frame.status.error().code, Errc::truncated);
}

TEST(OctreeCoder, StopsAtTheLimitOfMemory) {
  const Case c{{Bytes(1 + 8 + 64 + 512, 255), {1}}, 4, 1};
  Bytes out;
  ASSERT_TRUE(encode_octree_frame(c.fields, c.levels, c.textures, out).ok());
  OctreeFrameOptions options{.levels = c.levels, .textures = c.textures};
  options.limits.memory = 500;
  Diagnostics diagnostics;
  const OctreeFrame frame = decode_octree_frame(out, options, diagnostics);
  ASSERT_FALSE(frame.status.ok());
  EXPECT_EQ(frame.status.error().code, Errc::limit_exceeded);
}

TEST(OctreeCoder, RandomBytesDecodeAsThePlainCoderDecodesThem) {
  std::mt19937 random(9);
  for (int round = 0; round < 2000; ++round) {
    Bytes data(random() % 200);
    for (uint8_t& byte : data) byte = static_cast<uint8_t>(random() >> 3);
    const unsigned levels = static_cast<unsigned>(random() % 8);
    const unsigned textures = static_cast<unsigned>(random() % 5);
    Diagnostics diagnostics;
    const OctreeFrame frame =
        decode_octree_frame(data, {.levels = levels, .textures = textures}, diagnostics);
    const plain::Frame expected = plain::decode_frame(data, levels, textures, UINT64_MAX);
    ASSERT_EQ(frame.status.ok(), !expected.truncated);
    ASSERT_EQ(frame.bits, expected.bits);
    if (frame.status.ok()) {
      ASSERT_EQ(frame.fields, expected.fields);
    }
  }
}

}  // namespace
}  // namespace afx::codec
