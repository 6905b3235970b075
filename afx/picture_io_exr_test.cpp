// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "afx/picture_io.h"

namespace afx {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kHalfStep = 1.0F / 2048;  // of half precision, as a part of the value

TEST(Exr, HoldsPremultipliedLinearLight) {
  Picture picture(2, 1, 4);
  picture.samples = {255, 188, 0, 128, 255, 255, 255, 0};
  const auto bytes = encode_picture(picture, "exr");
  ASSERT_TRUE(bytes.ok()) << bytes.error().text;
  const auto stored = decode_float_picture(bytes.value());
  ASSERT_TRUE(stored.ok()) << stored.error().text;
  // IEC 61966-2-1: 188 is ((188 / 255 + 0.055) / 1.055)^2.4 of the light of 255.
  const float light = std::pow((188.0F / 255 + 0.055F) / 1.055F, 2.4F);
  const float alpha = 128.0F / 255;
  const float expected[] = {alpha, light * alpha, 0, alpha, 0, 0, 0, 0};
  ASSERT_EQ(stored.value().samples.size(), 8U);
  for (size_t i = 0; i < 8; ++i)
    EXPECT_NEAR(stored.value().samples[i], expected[i], expected[i] * kHalfStep) << i;
}

TEST(Exr, GivesBackEveryColourThatIsNotAlmostTransparent) {
  for (const int alpha : {255, 128, 32}) {
    Picture picture(256, 1, 4);
    for (uint32_t x = 0; x < 256; ++x) {
      const auto value = static_cast<uint8_t>(x);
      uint8_t* pixel = picture.pixel(x, 0);
      pixel[0] = value;
      pixel[1] = static_cast<uint8_t>(255 - value);
      pixel[2] = 77;
      pixel[3] = static_cast<uint8_t>(alpha);
    }
    const auto bytes = encode_picture(picture, "exr");
    ASSERT_TRUE(bytes.ok()) << bytes.error().text;
    const auto again = decode_picture(bytes.value());
    ASSERT_TRUE(again.ok()) << again.error().text;
    EXPECT_EQ(again.value().samples, picture.samples) << alpha;
  }
}

TEST(Exr, HoldsDistancesExactly) {
  Picture grey(3, 20, 1);
  grey.samples.assign(60, 255);
  std::vector<float> depth(60, kInfinity);
  depth[0] = 1.0F / 3;
  depth[59] = 123456.789F;
  const auto bytes = encode_picture(grey, "exr", {.depth = depth});
  ASSERT_TRUE(bytes.ok()) << bytes.error().text;
  const auto stored = decode_float_picture(bytes.value());
  ASSERT_TRUE(stored.ok()) << stored.error().text;
  ASSERT_EQ(stored.value().components, 2U);  // Y and Z
  for (size_t i = 0; i < 60; ++i) {
    EXPECT_EQ(stored.value().samples[2 * i], 1) << i;
    EXPECT_EQ(stored.value().samples[2 * i + 1], depth[i]) << i;
  }
}

TEST(Exr, IsTheSameEachTimeAndHoldsNoDate) {
  const Picture picture(40, 40, 4);
  const auto first = encode_picture(picture, "exr"), second = encode_picture(picture, "exr");
  ASSERT_TRUE(first.ok() && second.ok());
  EXPECT_EQ(first.value(), second.value());
  const std::string text(first.value().begin(), first.value().end());
  for (const char* word : {"DateTime", "Software", "OpenImageIO"})
    EXPECT_EQ(text.find(word), std::string::npos) << word;
  // The library always writes the attribute; its size is 0.
  EXPECT_NE(text.find(std::string("capDate\0string\0\0\0\0\0", 19)), std::string::npos);
}

TEST(Exr, AloneHoldsDepth) {
  const Picture picture(2, 2, 4);
  const std::vector<float> depth(4, 1.0F), few(3, 1.0F);
  const auto png = encode_picture(picture, "png", {.depth = depth});
  ASSERT_FALSE(png.ok());
  EXPECT_EQ(png.error().text, "of the picture formats OpenEXR alone holds depth");
  const auto wrong = encode_picture(picture, "exr", {.depth = few});
  ASSERT_FALSE(wrong.ok());
  EXPECT_EQ(wrong.error().code, Errc::bad_argument);
  const DeepPicture deep{2, 2, 1, 16, {0, 1, 2, 3}};
  EXPECT_FALSE(encode_picture(deep, "exr").ok());
}

}  // namespace
}  // namespace afx
