// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/image_target.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "afx/picture_compare.h"
#include "afx/picture_io.h"

namespace afx {
namespace {

// Two pictures of waves and some noise, half of their pixels used.
struct Images {
  std::vector<ReferenceImage> images = std::vector<ReferenceImage>(2);
  std::vector<std::vector<bool>> used;

  Images() {
    std::mt19937 random(1);
    for (ReferenceImage& image : images) {
      image.picture = Picture(48, 40, 3);
      for (size_t i = 0; i < image.picture.samples.size(); ++i)
        image.picture.samples[i] = static_cast<uint8_t>(
            120 + 80 * std::sin(static_cast<double>(i) / 90) + static_cast<int>(random() % 20));
      used.emplace_back(48 * 40);
      for (size_t i = 0; i < used.back().size(); ++i) used.back()[i] = i % 48 < 24;
    }
  }
};

TEST(CodeImages, SaysBytesAndPsnrOfTheFiles) {
  Images set;
  set.used.assign(2, std::vector<bool>(48 * 40, true));
  const auto coded = code_images(set.images, set.used, 75, 1);
  ASSERT_TRUE(coded.ok()) << coded.error().text;
  uint64_t bytes = 0;
  double squared = 0;
  for (size_t k = 0; k < 2; ++k) {
    bytes += coded.value().files[k].size();
    const auto decoded = decode_picture(coded.value().files[k]);
    ASSERT_TRUE(decoded.ok());
    squared += compare_pictures(set.images[k].picture, decoded.value()).value().mean_squared / 2;
  }
  EXPECT_EQ(coded.value().bytes, bytes);
  EXPECT_NEAR(coded.value().psnr, 10 * std::log10(255.0 * 255.0 / squared), 1e-9);
}

TEST(CodeImages, CountsOnlyUsedPixels) {
  Images set;
  const double half = code_images(set.images, set.used, 50, 1).value().psnr;
  // What is not used may be as hard to code as it likes.
  std::mt19937 random(5);
  for (ReferenceImage& image : set.images)
    for (uint32_t y = 0; y < 40; ++y)
      for (uint32_t x = 24; x < 48; ++x)
        image.picture.pixel(x, y)[1] = static_cast<uint8_t>(random());
  EXPECT_EQ(code_images(set.images, set.used, 50, 1).value().psnr, half);  // at a border of blocks
  set.used.assign(2, std::vector<bool>(48 * 40));
  EXPECT_EQ(code_images(set.images, set.used, 50, 1).value().psnr, 99);
}

TEST(CodeImages, MeetsASizeAsCloselyAsQualitiesLet) {
  const Images set;
  const auto expected = code_images(set.images, set.used, 60, 1);
  const auto next = code_images(set.images, set.used, 61, 1);
  ASSERT_LT(expected.value().bytes, next.value().bytes);
  for (const uint64_t target : {expected.value().bytes, next.value().bytes - 1}) {
    const auto found = code_images_to_size(set.images, set.used, target, 2);
    ASSERT_TRUE(found.ok()) << found.error().text;
    EXPECT_EQ(found.value().quality, 60);
    EXPECT_EQ(found.value().files, expected.value().files);
  }
  EXPECT_EQ(code_images_to_size(set.images, set.used, 1 << 20, 1).value().quality, 100);
}

TEST(CodeImages, MeetsAPsnrWithTheLeastQuality) {
  const Images set;
  const auto before = code_images(set.images, set.used, 69, 1);
  const auto expected = code_images(set.images, set.used, 70, 1);
  ASSERT_LT(before.value().psnr, expected.value().psnr);
  const auto found = code_images_to_psnr(set.images, set.used, expected.value().psnr, 2);
  ASSERT_TRUE(found.ok()) << found.error().text;
  EXPECT_EQ(found.value().quality, 70);
  EXPECT_EQ(found.value().files, expected.value().files);
  EXPECT_EQ(code_images_to_psnr(set.images, set.used, 1, 1).value().quality, 1);
}

TEST(CodeImages, SayWhatIsTheLeastAndTheBestThatCanBeHad) {
  const Images set;
  const auto least = code_images(set.images, set.used, 1, 1);
  const auto small = code_images_to_size(set.images, set.used, least.value().bytes - 1, 1);
  ASSERT_FALSE(small.ok());
  EXPECT_EQ(small.error().code, Errc::bad_argument);
  EXPECT_EQ(small.error().text, "the images take " + std::to_string(least.value().bytes) +
                                    " bytes even as JPEG of quality 1 (" +
                                    std::to_string(least.value().bytes - 1) + " are asked for)");
  const auto fine = code_images_to_psnr(set.images, set.used, 90, 1);
  ASSERT_FALSE(fine.ok());
  EXPECT_EQ(fine.error().code, Errc::bad_argument);
  const double best = code_images(set.images, set.used, 100, 1).value().psnr;
  char text[100];
  std::snprintf(text, sizeof text,
                "the images reach %.2f dB as JPEG of quality 100 (90.00 dB is asked for)", best);
  EXPECT_EQ(fine.error().text, text);
}

TEST(CodeImages, RefuseWhatDoesNotFit) {
  Images set;
  const auto text = [&](int quality) {
    const auto coded = code_images(set.images, set.used, quality, 1);
    return coded.ok() ? std::string() : coded.error().text;
  };
  EXPECT_EQ(text(0), "the JPEG quality is not in 1..100");
  EXPECT_EQ(text(101), "the JPEG quality is not in 1..100");
  set.used[1].pop_back();
  EXPECT_EQ(text(50), "images[1] has not as many pixels as are listed");
  set.used.pop_back();
  EXPECT_EQ(text(50), "1 lists of used pixels for 2 images");
  set.used.emplace_back();
  set.images[1].picture = {};
  EXPECT_EQ(text(50), "images[1] has no picture");
}

}  // namespace
}  // namespace afx
