// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/octree_stream.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace afx {
namespace {

using Bytes = std::vector<uint8_t>;

DecodedOctreeStream decode(const Bytes& data, Diagnostics& diagnostics,
                           OctreeDecodeOptions options = {}) {
  return decode_octree_stream(data, options, diagnostics);
}

// u(5) 1, u(1) 1, u(3) 0, align: 00001 1 000 0000000; start code; the frame of no symbols: 01
// 000000.
const Bytes kOneVoxel{0x0C, 0x00, 0x00, 0x00, 0x01, 0xC8, 0x40};

TEST(OctreeStream, TheSmallestStreamByHand) {
  const auto encoded = encode_octree_stream({1, 0, {OctreeFields{}}});
  ASSERT_TRUE(encoded.ok());
  EXPECT_EQ(encoded.value(), kOneVoxel);
  Diagnostics diagnostics;
  const DecodedOctreeStream decoded = decode(kOneVoxel, diagnostics);
  ASSERT_TRUE(decoded.status.ok());
  EXPECT_EQ(decoded.stream.resolution, 1U);
  EXPECT_EQ(decoded.stream.textures, 0U);
  ASSERT_EQ(decoded.stream.frames.size(), 1U);
  EXPECT_EQ(decoded.infos[0].byte, 6U);
  EXPECT_EQ(decoded.infos[0].bits, 2U);
  EXPECT_EQ(diagnostics.count(), 0U);
  EXPECT_TRUE(looks_like_octree_stream(kOneVoxel));
}

TEST(OctreeStream, TracesTheHeaderWithBitOffsets) {
  std::string seen;
  const codec::Trace trace = [&](const codec::TraceElement& e) {
    seen += std::to_string(e.bit) + "+" + std::to_string(e.width) + " " + std::string(e.path) +
            "=" + std::to_string(e.value) + "\n";
  };
  Diagnostics diagnostics;
  // resolution 2: 00010 10 000 and 6 zeros; then the root by hand of the frame coder's test.
  const Bytes data{0x14, 0x00, 0x00, 0x00, 0x01, 0xC8, 0xFE, 0x40};
  ASSERT_TRUE(decode(data, diagnostics, {.trace = &trace}).status.ok());
  EXPECT_EQ(seen,
            "0+5 octree_stream/resolution_bits=2\n"
            "5+2 octree_stream/octreeResolution=2\n"
            "7+3 octree_stream/texture_bits=0\n"
            "10+0 octree_stream/numOfTextures=0\n"
            "10+6 octree_stream/align=0\n"
            "16+32 octree_stream/octree_frame_start_code=456\n"
            "48+10 octree_stream/octree_frame[0]/level[0].symbols=1\n"
            "58+6 octree_stream/align=0\n");
}

struct BadStream {
  Bytes data;
  Errc code;
  uint64_t bit;
  const char* text;
};

TEST(OctreeStream, SaysWhereABadHeaderIsWrong) {
  const BadStream cases[] = {
      {{},
       Errc::truncated,
       0,
       "the data end inside octree_stream/resolution_bits (expected 5 bits, 0 are left)"},
      {{0x00}, Errc::malformed, 5, "octreeResolution is 0 (expected at least 1)"},
      {{0x08, 0x00}, Errc::malformed, 5, "octreeResolution is 0 (expected at least 1)"},
      {{0xF8},
       Errc::truncated,
       5,
       "the data end inside octree_stream/octreeResolution (expected 31 bits, 3 are left)"},
      {{0x0C, 0x00, 0x00, 0x00},
       Errc::truncated,
       16,
       "the data end inside octree_stream/octree_frame_start_code (expected 32 bits, 16 are left)"},
      {{0x0C, 0x00, 0x00, 0x00, 0x01, 0xC9, 0x40},
       Errc::malformed,
       16,
       "no octree_frame_start_code (expected the bytes 00 00 01 C8)"},
      {{0x0C, 0x00, 0x00, 0x00, 0x01, 0xC8},
       Errc::truncated,
       48,
       "the data end where the octree frame begins (expected its 2 bits)"},
  };
  for (const BadStream& bad : cases) {
    Diagnostics diagnostics;
    const DecodedOctreeStream decoded = decode(bad.data, diagnostics);
    ASSERT_FALSE(decoded.status.ok());
    EXPECT_EQ(decoded.status.error().code, bad.code) << bad.text;
    EXPECT_EQ(decoded.status.error().place, Place::at_bit(bad.bit)) << bad.text;
    EXPECT_EQ(decoded.status.error().text, bad.text);
    EXPECT_FALSE(looks_like_octree_stream(bad.data) && bad.bit < 48);
  }
}

TEST(OctreeStream, AcceptsWidthsThatAreNotTheLeastAndSaysSo) {
  // u(5) 3, u(3) 001, u(3) 1, u(1) 0: 00011 001 001 0 0000
  const Bytes data{0x19, 0x20, 0x00, 0x00, 0x01, 0xC8, 0x40};
  Diagnostics diagnostics;
  ASSERT_TRUE(decode(data, diagnostics).status.ok());
  ASSERT_EQ(diagnostics.count(), 2U);
  EXPECT_EQ(diagnostics.warnings()[0].code, "non_minimal_width");
  EXPECT_EQ(diagnostics.warnings()[0].place, Place::at_bit(0));
  EXPECT_EQ(diagnostics.warnings()[1].place, Place::at_bit(8));
}

TEST(OctreeStream, WhatFollowsTheLastFrameIsAWarningWithItsPlace) {
  Bytes data = kOneVoxel;
  data.insert(data.end(), {0x00, 0x00, 0x01});
  Diagnostics diagnostics;
  ASSERT_TRUE(decode(data, diagnostics).status.ok());
  ASSERT_EQ(diagnostics.count(), 1U);
  EXPECT_EQ(diagnostics.warnings()[0].code, "trailing_bytes");
  EXPECT_EQ(diagnostics.warnings()[0].place, Place::at_byte(7));
  EXPECT_EQ(diagnostics.warnings()[0].text, "3 bytes after the last frame belong to none");
}

TEST(OctreeStream, BitsInAnAlignAreAWarning) {
  Bytes data = kOneVoxel;
  data[1] |= 1;
  data[6] |= 4;
  Diagnostics diagnostics;
  ASSERT_TRUE(decode(data, diagnostics).status.ok());
  ASSERT_EQ(diagnostics.count(), 2U);
  EXPECT_EQ(diagnostics.warnings()[0].place, Place::at_bit(9));
  EXPECT_EQ(diagnostics.warnings()[1].place, Place::at_bit(50));
}

OctreeStream many_frames() {
  OctreeStream stream{4, 3, {}};
  for (int i = 0; i < 20; ++i) {
    const auto child = static_cast<uint8_t>(1 << i % 8);
    stream.frames.push_back(
        {{child, static_cast<uint8_t>(i * 37 + 1)}, {static_cast<uint8_t>(1 + i % 3)}});
  }
  return stream;
}

TEST(OctreeStream, FramesAreTheSameOnAnyNumberOfThreads) {
  const OctreeStream stream = many_frames();
  const Bytes data = encode_octree_stream(stream, 1).value();
  for (const unsigned threads : {1U, 2U, 3U, 8U}) {
    EXPECT_EQ(encode_octree_stream(stream, threads).value(), data);
    Diagnostics diagnostics;
    const DecodedOctreeStream decoded = decode(data, diagnostics, {.threads = threads});
    ASSERT_TRUE(decoded.status.ok());
    EXPECT_EQ(decoded.stream.frames, stream.frames);
    EXPECT_EQ(diagnostics.count(), 0U);
  }
}

// Several threads guess that frames begin at start codes. Behind the last frame stand some that are
// out of reach, because bytes before them belong to no frame.
TEST(OctreeStream, WrongGuessesChangeNothing) {
  const OctreeStream stream = many_frames();
  Bytes data = encode_octree_stream(stream).value();
  data.push_back(0xAA);
  for (int i = 0; i < 50; ++i) data.insert(data.end(), {0x00, 0x00, 0x01, 0xC8, 0xFE, 0x40});
  for (const unsigned threads : {1U, 2U, 8U, 100U}) {
    Diagnostics diagnostics;
    const DecodedOctreeStream decoded = decode(data, diagnostics, {.threads = threads});
    EXPECT_TRUE(decoded.status.ok());
    EXPECT_EQ(decoded.stream.frames, stream.frames);
    ASSERT_EQ(diagnostics.count(), 1U);
    EXPECT_EQ(diagnostics.warnings()[0].text, "301 bytes after the last frame belong to none");
  }
}

TEST(OctreeStream, GivesOneFrameByNumber) {
  const OctreeStream stream = many_frames();
  const Bytes data = encode_octree_stream(stream).value();
  Diagnostics diagnostics;
  const DecodedOctreeStream decoded = decode(data, diagnostics, {.frame = 13});
  ASSERT_TRUE(decoded.status.ok());
  ASSERT_EQ(decoded.stream.frames.size(), 1U);
  EXPECT_EQ(decoded.stream.frames[0], stream.frames[13]);
  EXPECT_EQ(decoded.infos[0].number, 13U);
  const DecodedOctreeStream missing = decode(data, diagnostics, {.frame = 20});
  ASSERT_FALSE(missing.status.ok());
  EXPECT_EQ(missing.status.error().code, Errc::bad_argument);
  EXPECT_EQ(missing.status.error().text,
            "frame 20 is not there (the stream has 20, counted from 0)");
}

TEST(OctreeStream, CoarserLevelsHaveTheirOwnResolution) {
  const OctreeStream stream = many_frames();
  const Bytes data = encode_octree_stream(stream).value();
  for (const std::optional<uint32_t> frame :
       {std::optional<uint32_t>{}, std::optional<uint32_t>{3}}) {
    Diagnostics diagnostics;
    const DecodedOctreeStream decoded = decode(data, diagnostics, {.levels = 1, .frame = frame});
    ASSERT_TRUE(decoded.status.ok());
    EXPECT_EQ(decoded.stream.frames.size(), frame ? 1U : 20U);
    EXPECT_EQ(decoded.infos.back().resolution, 2U);
    EXPECT_EQ(decoded.stream.frames.back().octree.size(), 1U);
  }
}

TEST(OctreeStream, EncoderSaysWhatCannotBeCoded) {
  const std::pair<OctreeStream, const char*> cases[] = {
      {{0, 0, {{}}}, "octreeResolution is 0 (expected at least 1)"},
      {{0x80000000U, 0, {{}}},
       "octreeResolution is 2147483648 (the stream holds at most 2147483647)"},
      {{1, 128, {{}}},
       "the OctreeImage has 128 images, but numOfTextures of the stream holds at most 127"},
      {{1, 0, {}}, "there are no frames to encode (expected at least 1)"},
      {{2, 0, {{{1}, {}}, {{1, 1}, {}}}},
       "frame 1: field octree has 2 bytes, too many for its structure (expected 1 bytes for 1 "
       "levels)"},
  };
  for (const auto& [stream, text] : cases) {
    const auto encoded = encode_octree_stream(stream);
    ASSERT_FALSE(encoded.ok()) << text;
    EXPECT_EQ(encoded.error().code, Errc::bad_argument);
    EXPECT_EQ(encoded.error().text, text);
  }
}

}  // namespace
}  // namespace afx
