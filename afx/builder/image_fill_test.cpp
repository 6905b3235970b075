// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/image_fill.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

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
  fill_unused(picture, used);
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
    fill_unused(picture, used);
    for (size_t i = 0; i < used.size(); ++i) {
      EXPECT_EQ(picture.samples[3 * i], 10);
      EXPECT_EQ(picture.samples[3 * i + 1], 200);
      EXPECT_EQ(picture.samples[3 * i + 2], 77);
    }
  }
}

TEST(FillUnused, HasNoHardEdgesOfItsOwn) {
  // Black at the left border, white at the right one: what lies between gets there gradually.
  Picture picture(64, 64, 3);
  std::vector<bool> used(64 * 64);
  for (uint32_t y = 0; y < 64; ++y) {
    used[y * 64] = used[y * 64 + 63] = true;
    std::fill_n(picture.pixel(63, y), 3, uint8_t{255});
  }
  fill_unused(picture, used);
  for (uint32_t x = 0; x + 1 < 64; ++x) {
    EXPECT_LT(std::abs(picture.pixel(x + 1, 32)[0] - picture.pixel(x, 32)[0]), 40) << x;
    EXPECT_GE(picture.pixel(x + 1, 32)[0], picture.pixel(x, 32)[0]) << x;
  }
  EXPECT_EQ(picture.pixel(1, 32)[0], 0);  // next to the object: its colour
  EXPECT_EQ(picture.pixel(62, 32)[0], 255);
}

TEST(FillUnused, MakesAnEmptyPictureGrey) {
  Picture picture(5, 5, 3);
  fill_unused(picture, std::vector<bool>(25));
  EXPECT_TRUE(std::all_of(picture.samples.begin(), picture.samples.end(),
                          [](uint8_t s) { return s == 128; }));
}

}  // namespace
}  // namespace afx
