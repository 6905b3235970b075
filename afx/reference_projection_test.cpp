// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/reference_projection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <vector>

namespace afx {
namespace {

TEST(ReferenceProjection, PixelsBeginOneSixtyFourthBeforeTheirBorder) {
  const ReferenceProjection p(ReferenceImage{}, 4, 4);
  struct Case {
    double x;
    uint32_t i;
    bool inside;
  };
  const double s = 1.0 / 64;
  const Case cases[] = {
      {-s, 0, true},           {-s - 1e-9, 0, false}, {0, 0, true},     {1 - s, 1, true},
      {1 - s - 1e-9, 0, true}, {1, 1, true},          {2.999, 3, true}, {4 - 2 * s, 3, true},
      {4 - s, 3, true},        {4, 3, true},          {4 + s, 3, true}, {4 + s + 1e-9, 3, false},
      {1e300, 3, false},       {-1e300, 0, false},
  };
  for (const Case& c : cases) {
    const auto across = p.pixel_at({c.x, 0.5});
    EXPECT_EQ(across.i, c.i) << c.x;
    EXPECT_EQ(across.inside, c.inside) << c.x;
    const auto up = p.pixel_at({0.5, c.x});
    EXPECT_EQ(up.j, c.i) << c.x;
    EXPECT_EQ(up.inside, c.inside) << c.x;
  }
}

TEST(ReferenceProjection, ProjectsByTheFormulaOfTheNode) {
  ReferenceImage image;
  image.position = {0.25F, -0.5F, 7};
  image.field_of_view = {2, 4};
  const ReferenceProjection p(image, 100, 10);
  // u = (x - 0.25)/2 + 0.5, v = (y + 0.5)/4 + 0.5
  const auto at = p.project({0.75, 0.1, -0.3});
  EXPECT_NEAR(at.x, (0.5 / 2 + 0.5) * 100, 1e-9);
  EXPECT_NEAR(at.y, (0.6 / 4 + 0.5) * 10, 1e-9);
  EXPECT_NEAR(p.depth({0.75, 0.1, -0.3}), 0.3, 1e-12);
}

TEST(ReferenceProjection, ACameraTurnedToTheRightFaceSeesMinusZOnItsRight) {
  ReferenceImage image;
  image.position = {10, 0, 0};
  const float h = std::sqrt(0.5F);
  image.orientation = glm::quat(h, 0, h, 0);  // 90 degrees about +y: it looks along -x
  const ReferenceProjection p(image, 2, 2);
  EXPECT_NEAR(p.to_camera().x, 1, 1e-7);
  const auto at = p.project({0.1, 0.2, -0.25});
  EXPECT_NEAR(at.x, 1.5, 1e-6);
  EXPECT_NEAR(at.y, 1.4, 1e-6);
  EXPECT_NEAR(p.depth({0.1, 0.2, -0.25}), -0.1, 1e-7);
}

TEST(ReferenceProjection, ASquareCoversThePixelsItOverlaps) {
  const ReferenceProjection p(ReferenceImage{}, 8, 8);  // a pixel has side 1/8
  const auto fits = p.square({2.5, 3.5}, 1.0 / 8);
  EXPECT_EQ(fits.i0, 2U);
  EXPECT_EQ(fits.i1, 3U);
  EXPECT_EQ(fits.j0, 3U);
  EXPECT_EQ(fits.j1, 4U);
  const auto shifted = p.square({3, 3.5}, 1.0 / 8);  // half on each of two
  EXPECT_EQ(shifted.i0, 2U);
  EXPECT_EQ(shifted.i1, 4U);
  const auto touching = p.square({2.51, 3.5}, 1.0 / 8);  // 0.01 < 1/64 over the border
  EXPECT_EQ(touching.count(), 1U);
  const auto all = p.square({4, 4}, 1);
  EXPECT_EQ(all.count(), 64U);
  const auto corner = p.square({0, 0}, 1);  // a quarter of it lies on the picture
  EXPECT_EQ(corner.count(), 16U);
  EXPECT_EQ(p.square({-2, 4}, 1.0 / 8).count(), 0U);
  EXPECT_EQ(p.square({1e300, -1e300}, 1).count(), 0U);
}

TEST(ReferenceProjection, AFieldOfViewThatMakesVoxelsHugeIsNotDrawable) {
  ReferenceImage image;
  const std::vector<uint64_t> codes(1 << 16, 0);
  const auto check = [&](size_t voxels, const std::vector<uint8_t>& images, size_t count) {
    const std::vector<ReferenceProjection> all(count, {image, 1024, 1024});
    return check_drawable(all, std::span(codes).first(voxels), images, 8, 2);
  };
  EXPECT_TRUE(check(codes.size(), {}, 6).ok());
  // Every voxel covers the whole picture, 2^20 pixels: 2^11 of them, on whatever images, are the
  // most.
  image.position = {-0.499F, -0.499F, 10};
  image.field_of_view = {1e-6F, 1e-6F};
  EXPECT_TRUE(check(2048, {}, 1).ok());
  const Status one = check(2049, {}, 1);
  ASSERT_FALSE(one.ok());
  EXPECT_EQ(one.error().code, Errc::limit_exceeded);
  EXPECT_EQ(one.error().text.substr(0, 55),
            "the voxels cover more than 2^31 pixels of the 1 images ");
  EXPECT_TRUE(check(1024, {}, 2).ok());
  EXPECT_FALSE(check(1025, {}, 2).ok());
  // Each on one image of the two, or on none.
  EXPECT_TRUE(check(2048, std::vector<uint8_t>(2048, 2), 2).ok());
  EXPECT_FALSE(check(2049, std::vector<uint8_t>(2049, 2), 2).ok());
  EXPECT_TRUE(check(codes.size(), std::vector<uint8_t>(codes.size(), 0), 2).ok());
}

TEST(ReferenceProjection, VoxelsBesideTheImageCountAsOnePixel) {
  ReferenceImage image;
  image.position = {100, 0, 10};
  const std::vector<uint64_t> codes(1 << 16, 0);
  // A square so large that only counting tells that none of it lies on the picture.
  image.field_of_view = {1e-6F, 1e-6F};
  const std::vector<ReferenceProjection> all(255, {image, 8192, 8192});
  EXPECT_TRUE(check_drawable(all, codes, {}, 8, 2).ok());
}

TEST(ReferenceImages, BadOnesAreNamedWithTheirField) {
  const auto text = [](const ReferenceImage& image) {
    const ReferenceImage images[] = {ReferenceImage{}, image};
    const Status s = check_reference_images(images, Limits{});
    return s.ok() ? std::string("ok") : s.error().text;
  };
  ReferenceImage image;
  EXPECT_EQ(text(image), "ok");
  image.field_of_view = {1, 0};
  EXPECT_NE(text(image).find("images[1]/fieldOfView is 1.000000 0.000000"), std::string::npos);
  image.field_of_view = {NAN, 1};
  EXPECT_NE(text(image), "ok");
  image = {};
  image.position.y = INFINITY;
  EXPECT_EQ(text(image), "images[1]/position is not finite");
  image = {};
  image.orientation = glm::quat(0, 0, 0, 0);
  EXPECT_EQ(text(image), "images[1]/orientation is not a rotation");
  image = {};
  image.picture = Picture(2, 2, 5);
  EXPECT_EQ(text(image), "images[1] has 5 components (expected 1 to 4)");
  image.picture = Picture(2, 2, 3);
  image.picture.samples.pop_back();
  EXPECT_EQ(text(image), "images[1] has 11 samples (expected 12)");
}

}  // namespace
}  // namespace afx
