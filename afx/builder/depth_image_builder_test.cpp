// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/depth_image_builder.h"

#include <gtest/gtest.h>

#include "afx/builder/test_meshes.h"
#include "afx/builder/view_sources.h"

namespace afx {
namespace {

class DepthImageBuilderTest : public ::testing::Test {
 protected:
  DepthImageBuilderTest()
      : box_(box_mesh({-1, -1, -1}, {1, 1, 1})), look_(box_, Shade::never), views_(look_, 2, {}) {}

  Mesh box_;
  MeshLook look_;
  MeshViews views_;
};

TEST_F(DepthImageBuilderTest, SixViewsOfABoxAreFilledByItsSides) {
  const auto built = build_depth_images(views_, {.resolution = 32});
  ASSERT_TRUE(built.ok()) << built.error().text;
  ASSERT_EQ(built.value().images.size(), 6U);
  EXPECT_EQ(built.value().pixels, 6U * 32 * 32);
  EXPECT_EQ(built.value().used, built.value().pixels);
  EXPECT_FALSE(built.value().coverage.has_value());
  for (const DepthImage& image : built.value().images) EXPECT_TRUE(check_depth_image(image).ok());
}

TEST_F(DepthImageBuilderTest, AutomaticViewsOfABoxAreSixThatSeeAll) {
  const auto built = build_depth_images(views_, {.resolution = 32, .views = 0});
  ASSERT_TRUE(built.ok());
  EXPECT_EQ(built.value().images.size(), 6U);
  ASSERT_TRUE(built.value().coverage.has_value());
  EXPECT_EQ(built.value().coverage->part(), 1);
}

TEST_F(DepthImageBuilderTest, GivenCamerasAreTakenAsTheyAre) {
  const Shot shot{{{0, 0, 10}, {1, 0, 0, 0}, true, {4, 4}, 8, 12}, 20, 10};
  const auto built = build_depth_images(views_, {.depth_bits = 16, .shots = {shot}});
  ASSERT_TRUE(built.ok());
  ASSERT_EQ(built.value().images.size(), 1U);
  EXPECT_EQ(built.value().images[0].camera, shot.camera);
  EXPECT_EQ(built.value().pixels, 200U);
  EXPECT_EQ(built.value().used, 50U);  // half of the width and of the height
}

TEST_F(DepthImageBuilderTest, UnseenPixelsContinueTheirSurroundings) {
  const Shot shot{{{0, 0, 10}, {1, 0, 0, 0}, true, {4, 4}, 8, 12}, 20, 20};
  for (const ImageCoder coder : {ImageCoder::jpeg, ImageCoder::png}) {
    const auto built = build_depth_images(views_, {.coder = coder, .shots = {shot}});
    ASSERT_TRUE(built.ok());
    const auto& texture = std::get<SimpleTexture>(built.value().images[0].texture);
    ASSERT_EQ(texture.depth.samples[0], 0);
    EXPECT_EQ(colour_at(texture.colour, 0, 0), (Rgba8{255, 255, 255, 255}));  // as the box
  }
}

TEST_F(DepthImageBuilderTest, AllPicturesTogetherKeepToTheLimit) {
  Limits limits;
  limits.memory = 6 * 32 * 32 * 5;
  EXPECT_TRUE(build_depth_images(views_, {.resolution = 32, .limits = limits}).ok());
  --limits.memory;
  const auto built = build_depth_images(views_, {.resolution = 32, .limits = limits});
  ASSERT_FALSE(built.ok());
  EXPECT_EQ(built.error().code, Errc::limit_exceeded);
  EXPECT_EQ(built.error().text,
            "the pictures of 6 views take 30720 bytes (expected at most 30719)");
  // Twelve times the memory that there may be, but no picture that is too large by itself.
  EXPECT_EQ(build_depth_images(views_, {.resolution = 4096, .views = 255}).error().code,
            Errc::limit_exceeded);
}

TEST_F(DepthImageBuilderTest, RefusesOptionsOutOfRange) {
  EXPECT_EQ(build_depth_images(views_, {.resolution = 0}).error().text,
            "the resolution is 0 (expected 1 to 16384)");
  EXPECT_EQ(build_depth_images(views_, {.views = 256}).error().text,
            "there are 256 views (expected at most 255)");
  EXPECT_EQ(build_depth_images(views_, {.depth_bits = 10}).error().text,
            "the depths have 10 bits (expected 8 or 16)");
}

}  // namespace
}  // namespace afx
