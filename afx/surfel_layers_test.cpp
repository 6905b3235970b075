// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/surfel_layers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <tuple>

#include "afx/surfel_sources.h"
#include "afx/surfel_test_models.h"

namespace afx {
namespace {

// Looks along -z from z = 0 at a box 4 wide and 4 high, 1 to 9 away.
DepthCamera plain_camera() { return {{0, 0, 0}, {1, 0, 0, 0}, true, {4, 4}, 1, 9}; }

PointTexture layers_or_fail(const Surfels& surfels, const DepthCamera& camera, uint32_t width,
                            uint32_t height, unsigned bits) {
  auto image = layer_surfels(surfels, {camera, width, height}, bits, {});
  EXPECT_TRUE(image.ok()) << image.error().text;
  if (!image.ok()) return {};
  EXPECT_TRUE(check_depth_image(image.value()).ok());
  return std::get<PointTexture>(image.value().texture);
}

// The depths of a pixel.
std::vector<uint32_t> depths_at(const PointTexture& points, uint32_t i, uint32_t j) {
  if (points.starts.empty()) return {};
  const size_t pixel = j * points.width + i;
  return {points.depths.begin() + points.starts[pixel],
          points.depths.begin() + points.starts[pixel + 1]};
}

void add_square(Surfels& surfels, const glm::dvec3& centre, float half, Rgba8 colour) {
  surfels.push_back(centre, {half, 0, 0}, {0, half, 0}, colour);
}

// 0 to 5 samples a pixel, their depths all different, near to far.
PointTexture random_layers(uint32_t width, uint32_t height, unsigned bits, uint32_t seed) {
  std::mt19937 random(seed);
  PointTexture points{width, height, bits, {0}, {}, {}};
  std::uniform_int_distribution<uint64_t> any(1, points.dmax());
  for (uint32_t pixel = 0; pixel < width * height; ++pixel) {
    std::vector<uint32_t> depths(random() % 6);
    for (uint32_t& depth : depths) depth = static_cast<uint32_t>(any(random));
    std::sort(depths.begin(), depths.end(), std::greater<>());
    depths.erase(std::unique(depths.begin(), depths.end()), depths.end());
    for (const uint32_t depth : depths) {
      const auto byte = [&] { return static_cast<uint8_t>(random()); };
      points.depths.push_back(depth);
      points.colours.push_back({byte(), byte(), byte(), 255});
    }
    points.starts.push_back(static_cast<uint32_t>(points.depths.size()));
  }
  return points;
}

class LayerRoundTrip : public ::testing::TestWithParam<std::tuple<bool, unsigned>> {};

TEST_P(LayerRoundTrip, InItsOwnCameraAPointTextureComesBackExactly) {
  const auto [orthographic, bits] = GetParam();
  const PointTexture points = random_layers(37, 29, bits, bits);
  const DepthImage image{test_camera(orthographic), points};
  const auto surfels = surfels_of(image, 1, {});
  ASSERT_TRUE(surfels.ok());
  EXPECT_EQ(layers_or_fail(surfels.value(), image.camera, 37, 29, bits), points);
}

TEST_P(LayerRoundTrip, ADepthImageComesBackAsOneLayer) {
  const bool orthographic = std::get<0>(GetParam());
  const unsigned bits = std::min(std::get<1>(GetParam()), 16U);  // it has no more
  const SimpleTexture simple = rough_texture(37, 29, bits, 3, 4);
  const auto surfels = surfels_of({test_camera(orthographic), simple}, 1, {});
  ASSERT_TRUE(surfels.ok());
  const PointTexture points =
      layers_or_fail(surfels.value(), test_camera(orthographic), 37, 29, bits);
  for (uint32_t j = 0; j < 29; ++j)
    for (uint32_t i = 0; i < 37; ++i) {
      const uint16_t depth = simple.depth.samples[(28 - j) * 37 + i];
      std::vector<uint32_t> expected;
      if (depth != 0) expected.push_back(depth);
      ASSERT_EQ(depths_at(points, i, j), expected);
    }
}

INSTANTIATE_TEST_SUITE_P(All, LayerRoundTrip,
                         ::testing::Combine(::testing::Bool(), ::testing::Values(8U, 16U, 32U)));

TEST(LayerSurfels, SortEachPixelNearToFarWhicheverWayItFaces) {
  Surfels surfels;
  add_square(surfels, {0.5, -0.5, -7}, 0.2F, {1, 0, 0, 255});
  surfels.push_back({0.4, -0.6, -3}, {0, 0.1, 0}, {0.1, 0, 0}, {2, 0, 0, 255});  // faces away
  surfels.push_back({0.6, -0.4, -5}, {0, 0, 0}, {0, 0, 0}, {3, 0, 0, 90});
  add_square(surfels, {0.5, -0.5, -4}, 0.2F, {4, 0, 0, 0});
  add_square(surfels, {0.5, -0.5, -9.1}, 0.2F, {5, 0, 0, 255});
  const PointTexture points = layers_or_fail(surfels, plain_camera(), 4, 4, 8);
  // 254 steps over 8: depth = 1 + (9 - distance) * 31.75.
  EXPECT_EQ(depths_at(points, 2, 1), (std::vector<uint32_t>{192, 128, 65}));
  EXPECT_EQ(points.depths.size(), 3U);
  EXPECT_EQ(points.colours, (std::vector<Rgba8>{{2, 0, 0}, {3, 0, 0}, {1, 0, 0}}));
}

TEST(LayerSurfels, MakeOneOfTheSameDepthWithTheMeanInLinearLight) {
  Surfels surfels;
  add_square(surfels, {0.5, 0.5, -5}, 0.2F, {0, 77, 0, 255});
  add_square(surfels, {0.6, 0.5, -5.001}, 0.2F, {255, 77, 0, 255});
  const PointTexture points = layers_or_fail(surfels, plain_camera(), 4, 4, 8);
  EXPECT_EQ(points.depths, std::vector<uint32_t>{128});
  EXPECT_EQ(points.colours, (std::vector<Rgba8>{{188, 77, 0}}));
}

TEST(LayerSurfels, PiecesLargerThanPixelsLeaveNoHoles) {
  Surfels surfels;  // two that share an edge and lean, 3 x 3 pixels each
  surfels.push_back({-1.5, 0, -5}, {1.5, 0, 0.75}, {0, 1.5, 0}, {9, 9, 9, 255});
  surfels.push_back({1.5, 0, -3.5}, {1.5, 0, 0.75}, {0, 1.5, 0}, {9, 9, 9, 255});
  DepthCamera camera = plain_camera();
  camera.field_of_view = {6, 6};
  const PointTexture points = layers_or_fail(surfels, camera, 6, 6, 16);
  for (uint32_t j = 0; j < 6; ++j)
    for (uint32_t i = 0; i < 6; ++i) {
      // The centre's row lies on the border between two rows of pixels; it belongs to the upper.
      const double x = i == 1 ? -1.5 : i == 4 ? 1.5 : i + 0.5 - 3;
      std::vector<uint32_t> expected;
      const double distance = 5 - (x + 1.5) / 2;
      if (j >= 2 && j < 4)
        expected.push_back(static_cast<uint32_t>(distance_to_depth(distance, 65535, camera)));
      if (j == 1 || j == 4) {  // covered up to 1.5: centres at 1.5 just so
        expected.push_back(static_cast<uint32_t>(distance_to_depth(distance, 65535, camera)));
      }
      EXPECT_EQ(depths_at(points, i, j), expected) << i << ' ' << j;
    }
}

TEST(LayerSurfels, FillOnlyWhereNothingElseIsNear) {
  Surfels surfels;
  add_square(surfels, {0.5, 0.5, -5}, 1.1F, {1, 1, 1, 255});    // covers its eight neighbours too
  add_square(surfels, {0.5, 0.5, -5.9}, 1.1F, {2, 2, 2, 255});  // so does this
  add_square(surfels, {1.5, 0.5, -5.5}, 0.2F, {3, 3, 3, 255});  // less than a pixel from both
  add_square(surfels, {1.5, 1.5, -6.5}, 0.2F, {4, 4, 4, 255});  // from the second
  const PointTexture points = layers_or_fail(surfels, plain_camera(), 4, 4, 16);
  const auto depth = [](double distance) {
    return static_cast<uint32_t>(distance_to_depth(distance, 65535, plain_camera()));
  };
  EXPECT_EQ(depths_at(points, 2, 2), (std::vector{depth(5), depth(5.9)}));
  EXPECT_EQ(depths_at(points, 3, 2), (std::vector{depth(5.5)}));
  EXPECT_EQ(depths_at(points, 3, 3), (std::vector{depth(5), depth(6.5)}));
  EXPECT_EQ(depths_at(points, 1, 2), (std::vector{depth(5)}));
}

TEST(LayerSurfels, BitsAreTheFewestThatStepByHalfAPixel) {
  EXPECT_EQ(depth_bits_for(1, 1), 8U);
  EXPECT_EQ(depth_bits_for(127, 1), 8U);  // 254 steps of half a pixel
  EXPECT_EQ(depth_bits_for(128, 1), 9U);
  EXPECT_EQ(depth_bits_for(255, 1), 9U);  // 510 steps
  EXPECT_EQ(depth_bits_for(255.1, 1), 10U);
  EXPECT_EQ(depth_bits_for(1, 1.0 / 1024), 12U);
  EXPECT_EQ(depth_bits_for(1e9, 1), 16U);
}

TEST(LayerSurfels, OfNothingIsAnEmptyTexture) {
  const PointTexture points = layers_or_fail({}, plain_camera(), 4, 4, 8);
  EXPECT_EQ(points.width, 4U);
  EXPECT_TRUE(points.depths.empty());
  EXPECT_TRUE(points.starts.empty());
}

TEST(LayerSurfels, RefuseWhatCannotBe) {
  Surfels surfels;
  for (int n = 0; n < 129; ++n) add_square(surfels, {0, 0, -5}, 10, {});
  const auto error = [&](uint32_t width, unsigned bits, uint64_t memory) {
    Limits limits;
    limits.memory = memory;
    const auto layers = layer_surfels(surfels, {plain_camera(), width, width}, bits, limits);
    return layers.ok() ? "none" : layers.error().text;
  };
  EXPECT_EQ(error(0, 8, 1000), "the picture is 0 x 0 pixels (expected 1 to 65535 along a side)");
  EXPECT_EQ(error(4, 33, 1000), "the depth has 33 bits (expected 1 to 32)");
  EXPECT_EQ(error(4, 8, 63), "the picture has 4 x 4 pixels (more than the limit)");
  EXPECT_EQ(error(4, 8, 16 * 129),
            "the samples of the pieces of surface take memory (more than the limit)");
}

}  // namespace
}  // namespace afx
