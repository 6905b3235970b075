// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/reference_views.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "afx/reference_projection.h"
#include "codec/octree_voxels.h"

namespace afx {
namespace {

TEST(ReferenceViews, LookAtTheCentreFromSixSides) {
  for (unsigned view = 0; view < kReferenceViews; ++view) {
    const ReferenceImage camera = reference_camera(view);
    const glm::vec3 ahead = camera.orientation * glm::vec3(0, 0, -1);
    EXPECT_NEAR(glm::length(camera.position + ahead), 0, 1e-6) << view;  // at distance 1
    EXPECT_NEAR(glm::dot(direction_to_camera(view), ahead), -1, 1e-6);
  }
  // Upright: no picture of the four sides lies on its side.
  for (unsigned view = 0; view < 4; ++view)
    EXPECT_NEAR((reference_camera(view).orientation * glm::vec3(0, 1, 0)).y, 1, 1e-6);
}

// The project's rule for pixels, in double precision from the camera, is the other source.
TEST(ReferenceViews, GiveThePixelsOfTheProjectionRule) {
  for (const unsigned levels : {0U, 1U, 4U}) {
    const uint32_t side = 1U << levels;
    for (const uint32_t size : {1U, 5U, 8U, 16U, 24U, 40U}) {
      for (unsigned view = 0; view < kReferenceViews; ++view) {
        const ReferenceView integers(view, levels, size);
        const ReferenceProjection rule(reference_camera(view), size, size);
        for (uint64_t code = 0; code < uint64_t{side} * side * side; ++code) {
          const Voxel voxel = codec::morton_decode(code);
          const glm::dvec3 centre = voxel_centre(code, levels);
          const auto expected = rule.pixel_at(rule.project(centre));
          const auto pixel = integers.pixel(voxel);
          ASSERT_TRUE(expected.inside);
          ASSERT_EQ(pixel.x, expected.i) << view << ' ' << size << ' ' << code;
          ASSERT_EQ(size - 1 - pixel.y, expected.j) << view << ' ' << size << ' ' << code;
          // Depth in voxels from the near side of the cube, which is half a side before the origin.
          ASSERT_NEAR(integers.depth(voxel), (rule.depth(centre) + 0.5) * side - 0.5, 1e-5);
        }
      }
    }
  }
}

constexpr Rgba8 kRed{255, 0, 0, 255}, kBlue{0, 0, 255, 255};

TEST(DrawView, ShowsTheVoxelInFront) {
  const std::vector<Voxel> voxels{{1, 2, 0}, {1, 2, 3}};  // the second is nearer to +z
  const std::vector<Rgba8> colours{kRed, kBlue};
  std::vector<uint8_t> seen(2);
  const Picture front = draw_view(ReferenceView(0, 2, 4), voxels, colours, seen);
  EXPECT_EQ(seen, (std::vector<uint8_t>{0, 1}));
  const uint8_t* pixel = front.pixel(1, 1);  // y = 2 of 4: the second row from the top
  EXPECT_EQ((std::vector<uint8_t>(pixel, pixel + 3)), (std::vector<uint8_t>{0, 0, 255}));
  const Picture back = draw_view(ReferenceView(1, 2, 4), voxels, colours, seen);
  EXPECT_EQ(seen, (std::vector<uint8_t>{1, 0}));
  EXPECT_EQ(back.pixel(2, 1)[0], 255);  // mirrored
}

TEST(DrawView, AtHalfTheSizeShowsTheMeanOfItsVoxels) {
  // Four voxels on one pixel, one of them a voxel behind, which a slope would have too; white is
  // half of them.
  const std::vector<Voxel> voxels{{0, 0, 3}, {1, 0, 3}, {0, 1, 2}, {1, 1, 3}, {0, 0, 0}};
  const Rgba8 white{255, 255, 255, 255}, black{0, 0, 0, 255};
  const std::vector<Rgba8> colours{white, black, white, black, kRed};
  std::vector<uint8_t> seen(5);
  const Picture picture = draw_view(ReferenceView(0, 2, 2), voxels, colours, seen);
  EXPECT_EQ(seen, (std::vector<uint8_t>{1, 1, 1, 1, 0}));
  EXPECT_EQ(picture.pixel(0, 1)[0], 188);  // half of white's light
  EXPECT_EQ(picture.pixel(0, 1)[2], 188);
}

TEST(DrawView, AtTwiceTheSizeCoversTheWholeSquareOfAVoxel) {
  const std::vector<Voxel> voxels{{0, 0, 0}, {1, 1, 0}};
  const std::vector<Rgba8> colours{kRed, kBlue};
  std::vector<uint8_t> seen(2);
  const Picture picture = draw_view(ReferenceView(0, 1, 4), voxels, colours, seen);
  for (uint32_t y = 0; y < 2; ++y)
    for (uint32_t x = 0; x < 2; ++x) {
      EXPECT_EQ(picture.pixel(x, y + 2)[0], 255);
      EXPECT_EQ(picture.pixel(x + 2, y)[2], 255);
    }
}

}  // namespace
}  // namespace afx
