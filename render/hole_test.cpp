// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Closed surfaces have no holes, and nothing behind them shines through: from any direction, at any
// distance. The expectation is geometry: lines of sight that hit a sphere.
#include <gtest/gtest.h>

#include <cmath>

#include "render/renderer.h"
#include "render/test_surfels.h"

namespace afx::render {
namespace {

constexpr uint32_t kSide = 96;

/// The distance of the line of sight through the middle of a pixel from the origin.
double miss(const Camera& camera, uint32_t px, uint32_t py) {
  const double x = (px + 0.5) / kSide * 2 - 1, y = 1 - (py + 0.5) / kSide * 2;
  glm::dvec3 start = camera.position;
  glm::dvec3 along;
  if (camera.projection == Projection::perspective) {
    const double t = std::tan(camera.field_of_view / 2);
    along = camera.orientation * glm::normalize(glm::dvec3(x * t, y * t, -1));
  } else {
    const double h = camera.view_height / 2;
    start += camera.orientation * glm::dvec3(x * h, y * h, 0);
    along = camera.orientation * glm::dvec3(0, 0, -1);
  }
  return glm::length(glm::cross(start, along));
}

/// Counts pixels whose lines of sight come within `radius` of the origin and are not pure red.
int faults(const Scene& scene, const Camera& camera, double radius, const RenderOptions& options) {
  const auto image = render(scene, camera, options);
  EXPECT_TRUE(image.ok());
  if (!image.ok()) return -1;
  int count = 0, inside = 0;
  for (uint32_t y = 0; y < kSide; ++y) {
    for (uint32_t x = 0; x < kSide; ++x) {
      if (miss(camera, x, y) > radius) continue;
      ++inside;
      const uint8_t* p = image.value().picture.pixel(x, y);
      if (p[0] != 255 || p[1] != 0 || p[2] != 0 || p[3] != 255) ++count;
    }
  }
  EXPECT_GT(inside, 0);
  return count;
}

TEST(Holes, ASphereIsClosedFromEveryDirectionAndDistance) {
  TestModelMaker maker(6);
  add_sphere(maker, 6, 0.4, kRed);
  add_sphere(maker, 6, 0.3, kBlue);  // must never be seen
  const TestModel model = maker.make();
  RenderOptions options{.width = kSide, .height = kSide, .splat_scale = 1, .samples = 1};
  options.coarseness = 0;  // from afar, nodes hold parts of both spheres
  for (const glm::dvec3& direction : directions(50)) {
    for (const double distance : {0.43, 0.5, 0.8, 1.6, 5.0, 20.0}) {
      Camera camera = looking_at_origin(direction, distance);
      EXPECT_EQ(faults(model.scene(), camera, 0.395, options), 0) << distance;
      camera.projection = Projection::orthographic;
      camera.view_height = distance;
      camera.position *= 10 / distance;
      EXPECT_EQ(faults(model.scene(), camera, 0.395, options), 0) << distance;
    }
  }
}

TEST(Holes, ASphereOfTiltedDiscsIsClosedFromEveryDirectionAndDistance) {
  TestModelMaker maker(6);
  add_sphere(maker, 6, 0.4, kRed);
  TestModelMaker inner(6);
  add_sphere(inner, 6, 0.3, kBlue);  // must never be seen
  const Scene scene{.voxels = {maker.make().smooth_cloud(), inner.make().smooth_cloud()}};
  RenderOptions options{.width = kSide, .height = kSide, .splat_scale = 1, .samples = 1};
  options.coarseness = 0;
  for (const glm::dvec3& direction : directions(50)) {
    for (const double distance : {0.43, 0.5, 0.8, 1.6, 5.0, 20.0}) {
      Camera camera = looking_at_origin(direction, distance);
      EXPECT_EQ(faults(scene, camera, 0.395, options), 0) << distance;
      camera.projection = Projection::orthographic;
      camera.view_height = distance;
      camera.position *= 10 / distance;
      EXPECT_EQ(faults(scene, camera, 0.395, options), 0) << distance;
    }
  }
}

TEST(Holes, ASphereOfSurfelsIsClosedFromEveryDirectionAndDistance) {
  for (const int n : {20, 60}) {
    Surfels surfels;
    add_surfel_sphere(surfels, 0.4, n, kRed);
    add_surfel_sphere(surfels, 0.3, n, kBlue);  // must never be seen
    const RenderOptions options{.width = kSide, .height = kSide, .splat_scale = 1, .samples = 1};
    for (const glm::dvec3& direction : directions(20)) {
      for (const double distance : {0.43, 0.5, 0.8, 1.6, 5.0, 20.0}) {
        Camera camera = looking_at_origin(direction, distance);
        EXPECT_EQ(faults(scene_of(surfels), camera, 0.399, options), 0) << distance;
        camera.projection = Projection::orthographic;
        camera.view_height = distance;
        camera.position *= 10 / distance;
        EXPECT_EQ(faults(scene_of(surfels), camera, 0.399, options), 0) << distance;
      }
    }
  }
}

TEST(Holes, ASphereSeenFromInsideIsClosedToo) {
  TestModelMaker maker(6);
  add_sphere(maker, 6, 0.4, kRed);
  add_sphere(maker, 6, 0.47, kBlue);
  const TestModel model = maker.make();
  const RenderOptions options{.width = kSide, .height = kSide, .splat_scale = 1, .samples = 2};
  for (const glm::dvec3& direction : directions(20)) {
    for (const double angle : {0.3, 1.0, 1.5, 2.0}) {
      Camera camera = looking_at_origin(direction, 0.2);
      camera.field_of_view = angle;
      EXPECT_EQ(faults(model.scene(), camera, 10, options), 0) << angle;
    }
  }
}

TEST(Holes, ASphereOfSurfelsSeenFromInsideIsClosedToo) {
  Surfels surfels;
  add_surfel_sphere(surfels, 0.4, 60, kRed);
  add_surfel_sphere(surfels, 0.47, 60, kBlue);
  const RenderOptions options{.width = kSide, .height = kSide, .splat_scale = 1, .samples = 2};
  for (const glm::dvec3& direction : directions(20)) {
    for (const double angle : {0.3, 1.0, 1.5, 2.0}) {
      Camera camera = looking_at_origin(direction, 0.2);
      camera.field_of_view = angle;
      EXPECT_EQ(faults(scene_of(surfels), camera, 10, options), 0) << angle;
    }
  }
}

TEST(Holes, TheLayerRightBehindAWallDoesNotShineThrough) {
  TestModelMaker maker(5);
  for (uint32_t y = 0; y < 32; ++y) {
    for (uint32_t x = 0; x < 32; ++x) {
      maker.add({x, y, 16}, kRed);
      maker.add({x, y, 15}, kBlue);
    }
  }
  const TestModel model = maker.make();
  for (const double scale : {1.0, 1.3}) {
    const RenderOptions options{.width = kSide, .height = kSide, .splat_scale = scale};
    for (double lean = 0; lean < 1.3; lean += 0.1) {
      for (const double around : {0.0, 0.4, 0.785}) {
        Camera camera = looking_at_origin(
            {std::sin(lean) * std::cos(around), std::sin(lean) * std::sin(around), std::cos(lean)},
            3);
        camera.projection = Projection::orthographic;
        camera.view_height = 1;
        // Lines near the middle meet the wall well inside its borders.
        EXPECT_EQ(faults(model.scene(), camera, 0.3 * std::cos(lean), options), 0)
            << lean << " " << around << " " << scale;
      }
    }
  }
}

}  // namespace
}  // namespace afx::render
