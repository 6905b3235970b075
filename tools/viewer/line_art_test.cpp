// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/viewer/line_art.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace afx::tools {
namespace {

render::Camera camera_at_two() {
  render::Camera camera;
  camera.position = {0, 0, 2};
  camera.field_of_view = 2 * std::atan(0.5);  // 2 high at distance 2
  return camera;
}

TEST(LineArt, AnOctreeHasTheTwelveEdgesOfItsCube) {
  render::Scene scene;
  const glm::dmat4 place = glm::scale(glm::translate(glm::dmat4(1), {5, 0, 0}), glm::dvec3(2));
  scene.voxels.push_back({nullptr, place});
  std::vector<Line> lines;
  add_boxes(scene, lines);
  ASSERT_EQ(lines.size(), 12U);
  for (const Line& line : lines) {
    EXPECT_DOUBLE_EQ(glm::length(line.b - line.a), 2);
    EXPECT_TRUE(line.a.x == 4 || line.a.x == 6);
    EXPECT_DOUBLE_EQ(std::abs(line.a.y), 1);
  }
}

TEST(LineArt, SurfelsHaveTheBoxOfTheirCentresNoneHaveNone) {
  auto surfels = std::make_shared<Surfels>();
  surfels->push_back({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {});
  surfels->push_back({1, 2, 3}, {1, 0, 0}, {0, 1, 0}, {});
  render::Scene scene;
  scene.surfels.push_back({surfels, glm::dmat4(1)});
  scene.surfels.push_back({std::make_shared<Surfels>(), glm::dmat4(1)});
  std::vector<Line> lines;
  add_boxes(scene, lines);
  ASSERT_EQ(lines.size(), 12U);
  double total = 0;
  for (const Line& line : lines) total += glm::length(line.b - line.a);
  EXPECT_DOUBLE_EQ(total, 4 * (1 + 2 + 3));
}

TEST(LineArt, ALineIsAStripAroundItsPlaceOnTheScreen) {
  const Line line{{-0.5, 0, 0}, {0.5, 0, 0}, {1, 2, 3, 255}};
  const auto vertices = line_triangles({&line, 1}, camera_at_two(), {200, 100}, 2);
  ASSERT_EQ(vertices.size(), 6U);
  // A unit has 50 pixels: from -25.5 to 25.5, 2 pixels to either side.
  for (const LineVertex& v : vertices) {
    EXPECT_NEAR(std::abs(v.x), 25.5 / 100, 1e-6);
    EXPECT_NEAR(std::abs(v.y), 2.0 / 50, 1e-6);
    EXPECT_NEAR(v.across, v.y * 50, 1e-4);
    EXPECT_NEAR(v.depth, 0.5, 1e-6);
    EXPECT_EQ(v.colour, (Rgba8{1, 2, 3, 255}));
  }
}

TEST(LineArt, ParallelProjectionKeepsDistances) {
  render::Camera camera = camera_at_two();
  camera.projection = render::Projection::orthographic;
  camera.view_height = 4;
  const Line line{{0, 0, 0}, {0, 1, -1}, {}};
  const auto vertices = line_triangles({&line, 1}, camera, {100, 100}, 1);
  ASSERT_EQ(vertices.size(), 6U);
  EXPECT_NEAR(vertices.front().depth, 2, 1e-6);
  EXPECT_NEAR(vertices.back().depth, 3, 1e-6);
  EXPECT_NEAR(vertices.back().y, 0.5 + 0.5 / 50, 1e-6);
}

TEST(LineArt, WhatIsBehindTheCameraIsCutOff) {
  const Line behind{{0, 0, 3}, {1, 0, 4}, {}};
  const Line half{{0.1, 0, 5}, {0.1, 0, 1}, {}};
  EXPECT_TRUE(line_triangles({&behind, 1}, camera_at_two(), {100, 100}, 1).empty());
  const auto vertices = line_triangles({&half, 1}, camera_at_two(), {100, 100}, 1);
  ASSERT_EQ(vertices.size(), 6U);
  for (const LineVertex& v : vertices) {
    EXPECT_GT(v.depth, 0);
    EXPECT_GT(v.x, 0);
  }
}

TEST(LineArt, AFrustumStandsAtItsCameraAndPointsAhead) {
  ReferenceCamera camera;
  camera.position = {0, 0, 5};
  camera.half_view = {0.25, 0.5};
  std::vector<Line> lines;
  add_frustum(camera, 2, {}, lines);
  ASSERT_EQ(lines.size(), 10U);
  int from_eye = 0;
  for (const Line& line : lines) {
    if (line.a == camera.position) {
      ++from_eye;
      EXPECT_DOUBLE_EQ(line.b.z, 3);
      EXPECT_DOUBLE_EQ(std::abs(line.b.x), 0.5);
      EXPECT_DOUBLE_EQ(std::abs(line.b.y), 1);
    }
  }
  EXPECT_EQ(from_eye, 4);
  lines.clear();
  camera.orthographic = true;
  camera.half_view = {10, 5};  // shrunk to the length
  add_frustum(camera, 2, {}, lines);
  EXPECT_EQ(lines.size(), 14U);
  for (const Line& line : lines) EXPECT_LE(std::abs(line.a.x), 1);
}

}  // namespace
}  // namespace afx::tools
