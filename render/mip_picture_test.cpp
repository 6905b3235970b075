// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/mip_picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace afx::render {
namespace {

Picture grey(uint32_t width, uint32_t height, std::vector<uint8_t> samples) {
  Picture picture(width, height, 1);
  picture.samples = std::move(samples);
  return picture;
}

TEST(MipPicture, HalvesDownToOnePixel) {
  const MipPicture mips(Picture(13, 4, 3));
  ASSERT_EQ(mips.levels().size(), 4U);
  const uint32_t sizes[4][2] = {{13, 4}, {6, 2}, {3, 1}, {1, 1}};
  for (size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(mips.levels()[k].width, sizes[k][0]);
    EXPECT_EQ(mips.levels()[k].height, sizes[k][1]);
    EXPECT_EQ(mips.levels()[k].pixels.size(), size_t{4} * sizes[k][0] * sizes[k][1]);
  }
  EXPECT_TRUE(mips.opaque());
}

TEST(MipPicture, MeansAreThoseOfLight) {
  // Half the light is 188 on the sRGB scale, a third 156, two thirds 213.
  EXPECT_EQ(MipPicture(grey(2, 1, {0, 255})).levels()[1].pixels,
            (std::vector<uint8_t>{188, 188, 188, 255}));
  EXPECT_EQ(MipPicture(grey(1, 3, {0, 255, 0})).levels()[1].pixels[0], 156);
  // Of five pixels in two, the middle one belongs to both by half: 2 of 5, 1 / 2 of 5 / 2.
  const MipPicture five(grey(5, 1, {255, 0, 0, 0, 0}));
  EXPECT_EQ(five.levels()[1].pixels[0], 170);  // 0.4
  EXPECT_EQ(five.levels()[1].pixels[4], 0);
}

TEST(MipPicture, TheColourOfWhatIsNotSeenDoesNotShow) {
  Picture picture(2, 1, 4);
  picture.samples = {255, 0, 0, 255, 0, 255, 0, 0};
  const MipPicture mips(picture);
  EXPECT_FALSE(mips.opaque());
  EXPECT_EQ(mips.levels()[1].pixels, (std::vector<uint8_t>{128, 0, 0, 128}));
  for (const float level : {0.0F, 0.5F, 1.0F}) {
    const glm::vec4 colour = mips.at({0.5F, 0.5F}, level, false, false);
    EXPECT_NEAR(colour.r, 1, 0.01);
    EXPECT_EQ(colour.g, 0);
    EXPECT_NEAR(colour.a, 0.5, 0.003);
  }
}

TEST(MipPicture, BetweenPixelsColoursAreMixed) {
  const MipPicture mips(grey(2, 2, {0, 100, 200, 40}));  // the lower row is 200, 40
  const auto value = [&](float s, float t, bool repeat) {
    return 255 * mips.at({s, t}, 0, repeat, repeat).r;
  };
  EXPECT_NEAR(value(0.25F, 0.75F, false), 0, 1e-4);
  EXPECT_NEAR(value(0.75F, 0.75F, false), 100, 1e-4);
  EXPECT_NEAR(value(0.25F, 0.25F, false), 200, 1e-4);
  EXPECT_NEAR(value(0.75F, 0.25F, false), 40, 1e-4);
  EXPECT_NEAR(value(0.5F, 0.5F, false), 85, 1e-4);
  EXPECT_NEAR(value(0, 1, false), 0, 1e-4);  // the corner's pixel goes on
  EXPECT_NEAR(value(-9, 7, false), 0, 1e-4);
  EXPECT_NEAR(value(0, 0.75F, true), 50, 1e-4);  // its neighbour is the other end
  EXPECT_NEAR(value(3.25F, -5.75F, true), 200, 1e-3);
  EXPECT_TRUE(std::isfinite(value(NAN, INFINITY, true)));
}

TEST(MipPicture, BetweenLevelsColoursAreMixed) {
  const MipPicture mips(grey(2, 1, {0, 255}));
  EXPECT_NEAR(255 * mips.at({0.25F, 0}, 0.5F, false, false).r, 94, 1e-3);  // of 0 and 188
  EXPECT_NEAR(255 * mips.at({0.25F, 0}, 9, false, false).r, 188, 1e-3);
  EXPECT_NEAR(255 * mips.at({0.25F, 0}, -3, false, false).r, 0, 1e-3);
  // A quarter of 64 pixels to the right, half of 16 down: 16 pixels at most.
  const MipPicture large(Picture(64, 16, 1));
  EXPECT_EQ(large.level_for({0.25F, 0}, {0, 0.5F}), 4);
}

TEST(MipPictures, HoldEachPictureOnce) {
  MipPictures pictures;
  const auto one = std::make_shared<Picture>(2, 2, 1);
  pictures.add(nullptr);
  pictures.add(one);
  const MipPicture* first = pictures.find(one.get());
  pictures.add(one);
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(pictures.find(one.get()), first);
  EXPECT_EQ(pictures.find(nullptr), nullptr);
}

}  // namespace
}  // namespace afx::render
