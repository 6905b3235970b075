// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/image_fill.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace afx {
namespace {

TEST(FillUnused, LeavesUsedPixelsAlone) {
  Picture picture(9, 7, 3);
  std::vector<bool> used(63);
  for (size_t i = 0; i < 63; i += 4) {
    used[i] = true;
    for (size_t k = 0; k < 3; ++k) picture.samples[3 * i + k] = static_cast<uint8_t>(i + 50 * k);
  }
  const Picture before = picture;
  fill_unused(picture, used, ImageCoder::jpeg);
  for (size_t i = 0; i < 63; i += 4)
    for (size_t k = 0; k < 3; ++k) EXPECT_EQ(picture.samples[3 * i + k], before.samples[3 * i + k]);
}

TEST(FillUnused, ContinuesASingleColourEverywhere) {
  for (const uint32_t side : {1U, 2U, 3U, 31U, 64U}) {
    Picture picture(side, side, 3);
    std::vector<bool> used(size_t{side} * side);
    used[side / 2] = true;
    uint8_t* only = picture.pixel(side / 2, 0);
    only[0] = 10;
    only[1] = 200;
    only[2] = 77;
    fill_unused(picture, used, ImageCoder::jpeg);
    for (size_t i = 0; i < used.size(); ++i) {
      EXPECT_EQ(picture.samples[3 * i], 10);
      EXPECT_EQ(picture.samples[3 * i + 1], 200);
      EXPECT_EQ(picture.samples[3 * i + 2], 77);
    }
  }
}

TEST(FillUnused, FindsTheWaveThatUsedPixelsAreOf) {
  // One wave of the cosine transform, of which two columns are missing: there is no way to have
  // fewer coefficients than to continue it.
  const auto wave = [](uint32_t x) { return 128 + 20 * std::cos((2.0 * x + 1) * 3.14159265 / 16); };
  Picture picture(8, 8, 3);
  std::vector<bool> used(64);
  for (uint32_t y = 0; y < 8; ++y)
    for (uint32_t x = 0; x < 8; ++x) {
      if (x == 1 || x == 6) continue;
      used[y * 8 + x] = true;
      std::fill_n(picture.pixel(x, y), 3, static_cast<uint8_t>(std::lround(wave(x))));
    }
  fill_unused(picture, used, ImageCoder::jpeg);
  for (uint32_t y = 0; y < 8; ++y)
    for (const uint32_t x : {1U, 6U}) EXPECT_NEAR(picture.pixel(x, y)[1], wave(x), 2) << x;
}

TEST(FillUnused, KeepsBlocksApart) {
  // A black and a white pixel in two blocks side by side: neither shows in the other.
  Picture picture(16, 8, 3);
  std::vector<bool> used(128);
  used[7] = used[8] = true;
  std::fill_n(picture.pixel(8, 0), 3, uint8_t{255});
  fill_unused(picture, used, ImageCoder::jpeg);
  for (uint32_t x = 0; x < 16; ++x) EXPECT_EQ(picture.pixel(x, 5)[0], x < 8 ? 0 : 255) << x;
}

TEST(FillUnused, GivesEmptyBlocksTheColourAroundOrBefore) {
  // Four by three blocks; the second of the first row is black, the last of the last white.
  Picture picture(32, 24, 3);
  std::vector<bool> used(32 * 24);
  used[8] = used[23 * 32 + 31] = true;
  std::fill_n(picture.pixel(31, 23), 3, uint8_t{255});
  fill_unused(picture, used, ImageCoder::jpeg);
  const auto block = [&](uint32_t column, uint32_t row) {
    return picture.pixel(8 * column + 3, 8 * row + 4)[0];
  };
  EXPECT_EQ(block(0, 0), 0);    // beside the black one
  EXPECT_EQ(block(3, 0), 0);    // before: black, too
  EXPECT_EQ(block(2, 1), 128);  // between both
  EXPECT_EQ(block(3, 1), 255);
  EXPECT_EQ(block(0, 2), 255);  // before, in the row above
  EXPECT_EQ(block(1, 2), 255);
}

TEST(FillUnused, TakesAnyNumberOfComponents) {
  Picture picture(9, 3, 1);
  std::vector<bool> used(27);
  used[0] = true;
  picture.samples[0] = 77;
  fill_unused(picture, used, ImageCoder::jpeg);
  EXPECT_TRUE(std::all_of(picture.samples.begin(), picture.samples.end(),
                          [](uint8_t s) { return s == 77; }));
}

TEST(FillUnused, MakesAnEmptyPictureGrey) {
  Picture picture(5, 5, 3);
  fill_unused(picture, std::vector<bool>(25), ImageCoder::png);
  EXPECT_TRUE(std::all_of(picture.samples.begin(), picture.samples.end(),
                          [](uint8_t s) { return s == 128; }));
}

TEST(FillUnused, ForPngRepeatsPixelsAlongRowsAndRowsDownwards) {
  Picture picture(4, 4, 1);
  picture.samples = {0, 0, 0, 0,  //
                     0, 7, 0, 9,  //
                     0, 0, 0, 0,  //
                     5, 0, 0, 0};
  std::vector<bool> used(16);
  used[5] = used[7] = used[12] = true;
  fill_unused(picture, used, ImageCoder::png);
  EXPECT_EQ(picture.samples, (std::vector<uint8_t>{7, 7, 7, 9,  //
                                                   7, 7, 7, 9,  //
                                                   7, 7, 7, 9,  //
                                                   5, 5, 5, 5}));
}

}  // namespace
}  // namespace afx
