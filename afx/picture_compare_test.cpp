// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/picture_compare.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace afx {
namespace {

Picture filled(uint32_t width, uint32_t height, uint32_t components, uint8_t value) {
  Picture p(width, height, components);
  std::fill(p.samples.begin(), p.samples.end(), value);
  return p;
}

TEST(PictureCompare, EqualPicturesHaveNoDifference) {
  const Picture a = filled(5, 3, 4, 77);
  const auto d = compare_pictures(a, a);
  ASSERT_TRUE(d.ok());
  EXPECT_EQ(d.value().differing_pixels, 0U);
  EXPECT_EQ(d.value().max_abs, 0U);
  EXPECT_EQ(d.value().mean_abs, 0);
  EXPECT_TRUE(std::isinf(d.value().psnr));
  EXPECT_EQ(d.value().ssim, 1);
}

TEST(PictureCompare, OneSampleThatDiffersIsMeasured) {
  const Picture a = filled(4, 5, 3, 100);
  Picture b = a;
  b.pixel(2, 3)[1] = 106;
  const auto d = compare_pictures(a, b);
  ASSERT_TRUE(d.ok());
  EXPECT_EQ(d.value().differing_pixels, 1U);
  EXPECT_EQ(d.value().max_abs, 6U);
  EXPECT_DOUBLE_EQ(d.value().mean_abs, 6.0 / 60);
  EXPECT_DOUBLE_EQ(d.value().mean_squared, 36.0 / 60);
  EXPECT_NEAR(d.value().psnr, 50.34927, 1e-4);  // 10 log10(65025 / 0.6)
}

TEST(PictureCompare, FlatPicturesDifferInSsimByTheirMeansAlone) {
  const auto d = compare_pictures(filled(20, 30, 1, 100), filled(20, 30, 1, 110));
  ASSERT_TRUE(d.ok());
  EXPECT_NEAR(d.value().ssim, 22006.5025 / 22106.5025, 1e-9);  // (2ab + C1) / (a^2 + b^2 + C1)
}

TEST(PictureCompare, SsimAgreesWithTheDefinitionCarriedOutInPython) {
  Picture a(14, 12, 1), b(14, 12, 1);
  for (uint32_t y = 0; y < 12; ++y) {
    for (uint32_t x = 0; x < 14; ++x) {
      a.pixel(x, y)[0] = static_cast<uint8_t>(x * 17 + y * 31);
      b.pixel(x, y)[0] = static_cast<uint8_t>(x * 17 + y * 31 + x * y % 7 * 5);
    }
  }
  const auto d = compare_pictures(a, b);
  ASSERT_TRUE(d.ok());
  EXPECT_NEAR(d.value().ssim, 0.6851318334188595, 1e-9);
}

TEST(PictureCompare, PicturesNarrowerThanTheWindowAreCompared) {
  Picture a = filled(1, 1, 4, 10), b = filled(1, 1, 4, 20);
  const auto d = compare_pictures(a, b);
  ASSERT_TRUE(d.ok());
  EXPECT_NEAR(d.value().ssim, (2 * 200 + 6.5025) / (100 + 400 + 6.5025), 1e-9);
}

TEST(PictureCompare, DifferentSizesAreRefusedWithBothSizes) {
  const auto d = compare_pictures(filled(2, 3, 4, 0), filled(3, 2, 4, 0));
  ASSERT_FALSE(d.ok());
  EXPECT_EQ(d.error().code, Errc::bad_argument);
  EXPECT_EQ(d.error().text,
            "pictures of different size: 2 x 3 with 4 components and 3 x 2 with 4 components");
  EXPECT_FALSE(compare_pictures(filled(2, 3, 4, 0), filled(2, 3, 3, 0)).ok());
}

TEST(PictureCompare, EmptyAndShortPicturesAreRefused) {
  EXPECT_FALSE(compare_pictures(Picture(), Picture()).ok());
  Picture cut = filled(2, 2, 3, 0);
  cut.samples.pop_back();
  EXPECT_FALSE(compare_pictures(filled(2, 2, 3, 0), cut).ok());
}

}  // namespace
}  // namespace afx
