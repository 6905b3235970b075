// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/texture_alpha.h"

#include <gtest/gtest.h>

#include <vector>

namespace afx {
namespace {

Picture row(uint32_t components, std::vector<uint8_t> samples) {
  Picture picture(static_cast<uint32_t>(samples.size()) / components, 1, components);
  picture.samples = std::move(samples);
  return picture;
}

TEST(TextureAlpha, IsMixedWhereSomeIsBelowAHalfAndSomeIsNot) {
  EXPECT_TRUE(has_mixed_alpha(row(2, {9, 127, 9, 128})));
  EXPECT_FALSE(has_mixed_alpha(row(2, {9, 127, 9, 0})));
  EXPECT_FALSE(has_mixed_alpha(row(2, {9, 255, 9, 128})));
  EXPECT_FALSE(has_mixed_alpha(row(1, {0, 255})));
}

TEST(TextureAlpha, IsKeptAsTheRuleSays) {
  const Picture mixed = row(4, {1, 2, 3, 0, 4, 5, 6, 255});
  const Picture opaque = row(4, {1, 2, 3, 255, 4, 5, 6, 255});
  const Picture faint = row(4, {1, 2, 3, 100, 4, 5, 6, 100});
  const std::vector<uint8_t> plain = {1, 2, 3, 4, 5, 6};
  const auto samples = [](const Picture& picture, AlphaRule rule) {
    return with_alpha_by_rule(picture, rule).samples;
  };
  EXPECT_EQ(samples(mixed, AlphaRule::ignore), plain);
  EXPECT_EQ(samples(mixed, AlphaRule::as_is), mixed.samples);
  EXPECT_EQ(samples(mixed, AlphaRule::if_mixed), mixed.samples);
  EXPECT_EQ(samples(opaque, AlphaRule::as_is), plain);
  EXPECT_EQ(samples(faint, AlphaRule::as_is), faint.samples);
  EXPECT_EQ(samples(faint, AlphaRule::if_mixed), plain);
  EXPECT_EQ(samples(row(3, plain), AlphaRule::as_is), plain);
}

TEST(TextureAlpha, ComesFromTheColoursOfAnOpacityPictureOrFromItsAlpha) {
  const Picture colours = row(3, {1, 2, 3, 4, 5, 6});
  EXPECT_EQ(with_opacity(colours, row(1, {0, 200})).samples,
            (std::vector<uint8_t>{1, 2, 3, 0, 4, 5, 6, 200}));
  EXPECT_EQ(with_opacity(colours, row(3, {30, 60, 90, 255, 255, 255})).samples,
            (std::vector<uint8_t>{1, 2, 3, 60, 4, 5, 6, 255}));
  EXPECT_EQ(with_opacity(colours, row(2, {77, 255, 77, 10})).samples,
            (std::vector<uint8_t>{1, 2, 3, 255, 4, 5, 6, 10}));
}

TEST(TextureAlpha, TakesTheSizeOfTheColours) {
  EXPECT_EQ(with_opacity(row(1, {1, 2, 3, 4}), row(1, {0, 255})).samples,
            (std::vector<uint8_t>{1, 1, 1, 0, 2, 2, 2, 0, 3, 3, 3, 255, 4, 4, 4, 255}));
  EXPECT_EQ(with_opacity(Picture(), row(1, {7})).samples, (std::vector<uint8_t>{255, 255, 255, 7}));
}

}  // namespace
}  // namespace afx
