// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/raw_bifs.h"

#include <gtest/gtest.h>

namespace afx::bifs {
namespace {

using Bytes = std::vector<uint8_t>;

// By hand from the layout in the header.
const Bytes kFile = {'B', 'I', 'F', 'S', 1, 2, 0, 2, 0xAA, 0xBB, 0, 0, 0x03, 0xE8,
                     0,   0,   0,   0,   0, 0, 0, 0, 1,    0,    0, 0, 1,    0xC0,
                     0,   0,   0,   1,   0, 0, 0, 5, 0,    0,    0, 0, 0};
const RawBifs kScene = {2, {0xAA, 0xBB}, 1000, {{0, true, {0xC0}}, {0x100000005, false, {}}}};

TEST(RawBifs, TheFileOfTheLayoutIsTheScene) {
  const auto read = read_raw_bifs(kFile, {});
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read.value(), kScene);
  EXPECT_EQ(write_raw_bifs(kScene).value(), kFile);
}

TEST(RawBifs, EveryTruncationIsAnErrorOrAShorterScene) {
  for (size_t size = 0; size < kFile.size(); ++size) {
    const auto read =
        read_raw_bifs(Bytes(kFile.begin(), kFile.begin() + static_cast<ptrdiff_t>(size)), {});
    if (size == 14 || size == 28) {  // between access units
      EXPECT_TRUE(read.ok());
      continue;
    }
    ASSERT_FALSE(read.ok()) << size;
    EXPECT_EQ(read.error().code, Errc::truncated) << size;
    EXPECT_LE(read.error().place.bit, size * 8);
  }
}

TEST(RawBifs, DamageIsNamedWithItsPlace) {
  const struct {
    size_t at;
    uint8_t byte;
    Errc code;
    uint64_t byte_of_error;
  } cases[] = {{0, 'b', Errc::malformed, 0},   {4, 2, Errc::unsupported, 4},
               {22, 7, Errc::malformed, 22},   {14, 0x80, Errc::malformed, 32},
               {26, 200, Errc::truncated, 23}, {7, 250, Errc::truncated, 6}};
  for (const auto& damage : cases) {
    Bytes bytes = kFile;
    bytes[damage.at] = damage.byte;
    const auto read = read_raw_bifs(bytes, {});
    ASSERT_FALSE(read.ok()) << damage.at;
    EXPECT_EQ(read.error().code, damage.code) << damage.at;
    EXPECT_EQ(read.error().place, Place::at_byte(damage.byte_of_error)) << damage.at;
  }
}

TEST(RawBifs, StaysWithinTheMemoryLimit) {
  Limits limits;
  limits.memory = 2 + 1 + 2 * sizeof(RawBifsUnit);
  EXPECT_TRUE(read_raw_bifs(kFile, limits).ok());
  --limits.memory;
  const auto read = read_raw_bifs(kFile, limits);
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().code, Errc::limit_exceeded);
}

TEST(RawBifs, TheWriterRefusesWhatTheReaderWould) {
  RawBifs scene = kScene;
  scene.timescale = 0;
  EXPECT_FALSE(write_raw_bifs(scene).ok());
  scene = kScene;
  scene.units[0].time = 0x200000000;
  EXPECT_FALSE(write_raw_bifs(scene).ok());
  scene = kScene;
  scene.config.resize(65536);
  EXPECT_FALSE(write_raw_bifs(scene).ok());
}

}  // namespace
}  // namespace afx::bifs
