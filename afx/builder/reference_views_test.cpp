// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/reference_views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "afx/reference_projection.h"
#include "codec/octree_voxels.h"

namespace afx {
namespace {

// The renderer's rule, one voxel after the other, is the other source.
TEST(ReferenceViews, GiveThePixelsOfTheProjectionRule) {
  std::vector<ReferenceCamera> cameras;
  for (const uint32_t size : {1U, 5U, 16U, 40U}) {
    for (unsigned view = 0; view < kSideViews; ++view) cameras.push_back(side_camera(view, size));
    cameras.push_back(slanting_camera(glm::normalize(glm::dvec3(1, -2, 2)), size));
  }
  constexpr unsigned kLevels = 4;
  for (const ReferenceCamera& camera : cameras) {
    const ReferenceView view(camera, kLevels);
    const ReferenceProjection rule(camera.image, camera.width, camera.height);
    for (uint64_t code = 0; code < 4096; ++code) {
      const glm::dvec3 centre = voxel_centre(code, kLevels);
      const auto expected = rule.pixel_at(rule.project(centre));
      const ReferenceView::Sight sight = view.sight(codec::morton_decode(code));
      ASSERT_TRUE(expected.inside);
      ASSERT_EQ(sight.pixel.x, expected.i);
      ASSERT_EQ(camera.height - 1 - sight.pixel.y, expected.j);
      ASSERT_LE(sight.first.x, sight.pixel.x);
      ASSERT_LE(sight.first.y, sight.pixel.y);
      ASSERT_GE(sight.last.x, sight.pixel.x);
      ASSERT_GE(sight.last.y, sight.pixel.y);
      ASSERT_NEAR(sight.depth, rule.depth(centre) * 16, 1e-4);
    }
  }
}

constexpr Rgba8 kRed{255, 0, 0, 255}, kBlue{0, 0, 255, 255};

TEST(DrawView, ShowsTheVoxelInFront) {
  const std::vector<Voxel> voxels{{1, 2, 0}, {1, 2, 3}};  // the second is nearer to +z
  const std::vector<Rgba8> colours{kRed, kBlue};
  const DrawnView front = draw_view(ReferenceView(side_camera(0, 4), 2), voxels, colours);
  EXPECT_EQ(front.seen, (std::vector<bool>{false, true}));
  EXPECT_EQ(std::count(front.drawn.begin(), front.drawn.end(), true), 1);
  const uint8_t* pixel = front.picture.pixel(1, 1);  // y = 2 of 4: the second row from the top
  EXPECT_EQ((std::vector<uint8_t>(pixel, pixel + 3)), (std::vector<uint8_t>{0, 0, 255}));
  const DrawnView back = draw_view(ReferenceView(side_camera(1, 4), 2), voxels, colours);
  EXPECT_EQ(back.seen, (std::vector<bool>{true, false}));
  EXPECT_EQ(back.picture.pixel(2, 1)[0], 255);  // mirrored
}

TEST(DrawView, ShowsTheVoxelWhoseCentreIsOnThePixelWhereOthersReachIntoIt) {
  // 6 pixels for 4 voxels: voxel 1 covers 1.5 to 3, voxel 0 the pixel 1 up to its half.
  const std::vector<Voxel> voxels{{0, 0, 0}, {1, 0, 0}};
  const DrawnView view =
      draw_view(ReferenceView(side_camera(0, 6), 2), voxels, std::vector<Rgba8>{kRed, kBlue});
  EXPECT_EQ(view.picture.pixel(0, 5)[0], 255);
  EXPECT_EQ(view.picture.pixel(2, 5)[2], 255);
}

TEST(DrawView, SlantingShowsASlopeWhole) {
  // A plane x + y = 15 of voxels, straight in front of the camera: two voxels on many a pixel.
  std::vector<Voxel> voxels;
  for (uint32_t x = 0; x < 16; ++x)
    for (uint32_t z = 0; z < 16; ++z) voxels.push_back({x, 15 - x, z});
  const std::vector<Rgba8> colours(voxels.size(), kRed);
  const ReferenceCamera camera = slanting_camera(glm::normalize(glm::dvec3(1, 1, 0)), 16);
  const DrawnView view = draw_view(ReferenceView(camera, 4), voxels, colours);
  EXPECT_EQ(std::count(view.seen.begin(), view.seen.end(), true), 256);
  // From the other side of a second plane none of it is seen.
  std::vector<Voxel> behind = voxels;
  for (uint32_t x = 3; x < 16; ++x)
    for (uint32_t z = 0; z < 16; ++z) behind.push_back({x, 18 - x, z});
  const DrawnView hidden =
      draw_view(ReferenceView(camera, 4), behind, std::vector<Rgba8>(behind.size(), kRed));
  for (size_t i = 0; i < 256; ++i) {
    if (voxels[i].x > 2 && voxels[i].x < 13) {
      EXPECT_FALSE(hidden.seen[i]) << i;
    }
  }
}

TEST(DrawView, AtHalfTheSizeShowsTheMeanOfItsVoxels) {
  // Four voxels on one pixel, one of them a voxel behind, which a slope would have too; white is
  // half of them.
  const std::vector<Voxel> voxels{{0, 0, 3}, {1, 0, 3}, {0, 1, 2}, {1, 1, 3}, {0, 0, 0}};
  const Rgba8 white{255, 255, 255, 255}, black{0, 0, 0, 255};
  const std::vector<Rgba8> colours{white, black, white, black, kRed};
  const DrawnView view = draw_view(ReferenceView(side_camera(0, 2), 2), voxels, colours);
  EXPECT_EQ(view.seen, (std::vector<bool>{true, true, true, true, false}));
  EXPECT_EQ(view.picture.pixel(0, 1)[0], 188);  // half of white's light
  EXPECT_EQ(view.picture.pixel(0, 1)[2], 188);
}

TEST(DrawView, AtTwiceTheSizeCoversTheWholeSquareOfAVoxel) {
  const std::vector<Voxel> voxels{{0, 0, 0}, {1, 1, 0}};
  const std::vector<Rgba8> colours{kRed, kBlue};
  const DrawnView view = draw_view(ReferenceView(side_camera(0, 4), 1), voxels, colours);
  for (uint32_t y = 0; y < 2; ++y)
    for (uint32_t x = 0; x < 2; ++x) {
      EXPECT_EQ(view.picture.pixel(x, y + 2)[0], 255);
      EXPECT_EQ(view.picture.pixel(x + 2, y)[2], 255);
    }
}

}  // namespace
}  // namespace afx
