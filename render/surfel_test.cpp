// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// How surfels are drawn. The expectations are geometry: where lines of sight meet a plane.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "render/renderer.h"
#include "render/software/surfel_splats.h"
#include "render/test_drawing.h"
#include "render/test_surfels.h"

namespace afx::render {
namespace {

/// The camera, of a square picture, in both projections, so that about two units are seen.
std::array<Camera, 2> both(const glm::dvec3& direction, double distance) {
  Camera camera = looking_at_origin(direction, distance);
  camera.field_of_view = 2 * std::atan(1.25 / distance);
  Camera parallel = camera;
  parallel.projection = Projection::orthographic;
  parallel.view_height = 2.5;
  return {camera, parallel};
}

/// A line of sight: through the point (x, y) of a picture of that side in pixels. `along` goes one
/// unit deeper.
struct Sight {
  glm::dvec3 start, along;
};
Sight sight(const Camera& camera, double side, double x, double y) {
  const double right = x / side * 2 - 1, up = 1 - y / side * 2;
  if (camera.projection == Projection::perspective) {
    const double t = std::tan(camera.field_of_view / 2);
    return {camera.position, camera.orientation * glm::dvec3(right * t, up * t, -1)};
  }
  const double h = camera.view_height / 2;
  return {camera.position + camera.orientation * glm::dvec3(right * h, up * h, 0),
          camera.orientation * glm::dvec3(0, 0, -1)};
}

/// Where it meets the plane z = 0: (x, y, depth).
glm::dvec3 on_plane(const Sight& s) {
  const double depth = -s.start.z / s.along.z;
  return {s.start.x + depth * s.along.x, s.start.y + depth * s.along.y, depth};
}

/// The corners of a pixel, made larger by `more` on each side, on the plane z = 0.
std::array<glm::dvec3, 4> pixel_on_plane(const Camera& camera, double side, uint32_t x, uint32_t y,
                                         double more) {
  const double x0 = x - more, x1 = x + 1 + more, y0 = y - more, y1 = y + 1 + more;
  return {on_plane(sight(camera, side, x0, y0)), on_plane(sight(camera, side, x1, y0)),
          on_plane(sight(camera, side, x0, y1)), on_plane(sight(camera, side, x1, y1))};
}

bool all_inside(const std::array<glm::dvec3, 4>& corners, double half) {
  return std::all_of(corners.begin(), corners.end(), [&](const glm::dvec3& p) {
    return std::abs(p.x) <= half && std::abs(p.y) <= half;
  });
}

/// Whether they lie beyond one and the same side of the square.
bool all_beyond(const std::array<glm::dvec3, 4>& corners, double half) {
  const auto every = [&](const auto& test) {
    return std::all_of(corners.begin(), corners.end(), test);
  };
  return every([&](const glm::dvec3& p) { return p.x > half; }) ||
         every([&](const glm::dvec3& p) { return p.x < -half; }) ||
         every([&](const glm::dvec3& p) { return p.y > half; }) ||
         every([&](const glm::dvec3& p) { return p.y < -half; });
}

/// Pixels wholly inside the square |x|, |y| <= half at z = 0 that are not covered, and pixels that
/// are touched though they are more than a pixel off it.
struct Faults {
  int holes = 0, strays = 0, inside = 0;
};
Faults faults(const RenderedImage& image, const Camera& camera, double half) {
  Faults found;
  const uint32_t side = image.picture.width;
  for (uint32_t y = 0; y < side; ++y) {
    for (uint32_t x = 0; x < side; ++x) {
      const int alpha = at(image, x, y).a;
      if (all_inside(pixel_on_plane(camera, side, x, y, 0), half)) {
        ++found.inside;
        found.holes += alpha != 255 ? 1 : 0;
      }
      if (all_beyond(pixel_on_plane(camera, side, x, y, 1), half)) found.strays += alpha != 0;
    }
  }
  return found;
}

TEST(Surfels, OnePieceIsItsParallelogramAndATenthMore) {
  Surfels surfels;
  add_square(surfels, 0.6, 0, 1, kRed);
  const RenderOptions options{.width = 150, .height = 150, .splat_scale = 1, .samples = 4};
  for (const glm::dvec3& direction : directions(30)) {
    for (const Camera& camera : both(direction, 3)) {
      const RenderedImage image = drawn(scene_of(surfels), camera, options);
      const Faults found = faults(image, camera, 0.6 * kSurfelMargin);
      EXPECT_EQ(found.holes, 0) << direction.z;
      EXPECT_EQ(found.strays, 0) << direction.z;
      EXPECT_GT(found.inside, 5000 * std::abs(direction.z) - 500);  // it is not all about nothing
    }
  }
}

TEST(Surfels, TheDepthIsThatOfThePlane) {
  Surfels surfels;
  add_square(surfels, 0.7, 0, 1, kRed);
  const RenderOptions options{
      .width = 60, .height = 60, .splat_scale = 1, .samples = 1, .depth = true};
  for (const glm::dvec3& direction : directions(12)) {
    for (const Camera& camera : both(direction, 3)) {
      const RenderedImage image = drawn(scene_of(surfels), camera, options);
      for (uint32_t y = 0; y < 60; ++y) {
        for (uint32_t x = 0; x < 60; ++x) {
          if (!all_inside(pixel_on_plane(camera, 60, x, y, 0), 0.7)) continue;
          const double expected = on_plane(sight(camera, 60, x + 0.5, y + 0.5)).z;
          ASSERT_NEAR(image.depth[y * 60 + x], expected, 1e-5);
        }
      }
    }
  }
}

TEST(Surfels, APlaneOfPiecesIsClosedAndNoLargerFromEveryAngle) {
  for (const int n : {12, 100, 600}) {  // pieces of 5 pixels, of less than one and of a quarter
    Surfels surfels;
    add_square(surfels, 0.5, 0, n, kRed);
    for (const double degrees : {0.0, 30.0, 45.0, 60.0, 80.0, 87.0, 150.0}) {
      for (const double around : {0.0, 0.3}) {
        const double a = degrees / 180 * 3.141592653589793;
        const glm::dvec3 direction(std::sin(a) * std::cos(around), std::sin(a) * std::sin(around),
                                   std::cos(a));
        for (const Camera& camera : both(direction, 3)) {
          const RenderedImage image =
              drawn(scene_of(surfels), camera, {.width = 150, .height = 150});
          const Faults found = faults(image, camera, 0.5);
          EXPECT_EQ(found.holes, 0) << n << ' ' << degrees << ' ' << around;
          EXPECT_EQ(found.strays, 0) << n << ' ' << degrees << ' ' << around;
        }
      }
    }
  }
}

TEST(Surfels, APlaneSeenFromItsEdgeIsALine) {
  Surfels surfels;
  add_square(surfels, 0.5, 0, 50, kRed);
  for (const Camera& camera : both({0, 1, 0}, 3)) {
    const RenderedImage image = drawn(scene_of(surfels), camera, {.width = 150, .height = 150});
    EXPECT_GT(covered_area(image.picture), 60 * 1.0 / 3);  // 60 pixels long, a sample high
    EXPECT_LT(covered_area(image.picture), 75);
  }
}

TEST(Surfels, TheNearerPlaneHidesTheOther) {
  Surfels surfels;
  add_square(surfels, 0.5, 0, 20, kRed);
  add_square(surfels, 0.5, 0.1, 20, kBlue);
  for (const double lean : {0.0, 0.5, 1.0}) {
    const glm::dvec3 direction(std::sin(lean), 0, std::cos(lean));
    for (const Camera& camera : both(direction, 3)) {
      EXPECT_EQ(at(drawn(scene_of(surfels), camera, {.width = 99, .height = 99}), 49, 49), kBlue);
    }
    for (const Camera& camera : both(-direction, 3)) {
      EXPECT_EQ(at(drawn(scene_of(surfels), camera, {.width = 99, .height = 99}), 49, 49), kRed);
    }
  }
}

TEST(Surfels, PiecesOfTheSameSurfaceAreMixedInLinearLight) {
  Surfels surfels;
  add_square(surfels, 0.5, 0, 1, kRed);
  add_square(surfels, 0.5, 0.39, 1, kBlue);  // its side is 1: 0.4 of it belong together
  const Camera camera = front(1);
  EXPECT_EQ(at(drawn(scene_of(surfels), camera, {.width = 9, .height = 9}), 4, 4),
            (Rgba8{188, 0, 188, 255}));
  surfels.centres[1].z = 0.41;
  EXPECT_EQ(at(drawn(scene_of(surfels), camera, {.width = 9, .height = 9}), 4, 4), kBlue);
}

TEST(Surfels, StretchedPiecesCountForLess) {
  Surfels surfels;
  surfels.push_back({0, 0, 0}, {0.5F, 0, 0}, {0, 0.5F, 0}, kRed);
  surfels.push_back({0, 0, 0}, {0.5F, 0, 0}, {0, 2, 0}, kBlue);  // by four: 4 parts red, 1 blue
  EXPECT_EQ(at(drawn(scene_of(surfels), front(1), {.width = 9, .height = 9, .samples = 1}), 4, 4),
            (Rgba8{231, 0, 124, 255}));  // sRGB of 0.8 and 0.2
}

TEST(Surfels, TheyShareTheDepthBufferWithVoxels) {
  Surfels surfels;
  add_square(surfels, 1, 0, 10, kBlue);
  TestModelMaker maker(3);
  for (uint32_t z = 0; z < 8; ++z) maker.add({2, 4, z}, kRed);
  const TestModel model = maker.make();
  Scene scene = scene_of(surfels);
  scene.voxels.push_back(model.cloud());
  // A column of voxels from z = -1/2 to 1/2, cut by the plane at `height`. It is at x = -3/16.
  for (const double height : {-0.6, 0.6}) {
    scene.surfels[0].local_to_world[3].z = height;
    const RenderedImage image = drawn(scene, front(1), {.width = 64, .height = 64, .depth = true});
    EXPECT_EQ(at(image, 20, 28), height < 0 ? kRed : kBlue);
    EXPECT_EQ(at(image, 50, 28), kBlue);
    EXPECT_NEAR(image.depth[28 * 64 + 50], 10 - height, 1e-5);
  }
}

TEST(Surfels, MatricesPlaceAndTurnThem) {
  Surfels surfels;
  add_square(surfels, 0.5, 0, 4, kRed);
  Scene scene = scene_of(surfels);
  glm::dmat4& m = scene.surfels[0].local_to_world;
  m[0] = {0, 2, 0, 0};  // x to y, twice as long
  m[1] = {1, 0, 0, 0};
  m[3] = {1, 0, 0, 1};
  const RenderOptions options{.width = 40, .height = 40, .splat_scale = 1, .samples = 4};
  const RenderedImage image = drawn(scene, front(4), options);  // 10 pixels a unit
  EXPECT_NEAR(covered_area(image.picture), (10 + 0.25) * (20 + 0.5), 6);
  EXPECT_EQ(at(image, 26, 11), kRed);
  EXPECT_EQ(at(image, 33, 28), kRed);
  EXPECT_EQ(at(image, 23, 20).a, 0);
}

TEST(Surfels, HalfTransparentOnesAreLeftOut) {
  for (const int a : {0, 127, 128, 255}) {
    Surfels surfels;
    add_square(surfels, 0.5, 0, 1, {9, 8, 7, static_cast<uint8_t>(a)});
    const RenderedImage image = drawn(scene_of(surfels), front(2), {.width = 9, .height = 9});
    EXPECT_EQ(at(image, 4, 4), a < 128 ? (Rgba8{0, 0, 0, 0}) : (Rgba8{9, 8, 7, 255}));
  }
}

TEST(Surfels, ThePictureIsTheSameForAnyNumberOfThreads) {
  Surfels surfels;
  add_surfel_sphere(surfels, 0.45, 150, kRed);
  add_surfel_sphere(surfels, 0.4495, 140, {20, 240, 90, 255});  // between those
  ASSERT_GT(surfels.size(), size_t{3} * 16384);                 // several chunks
  TestModelMaker maker(6);
  add_sphere(maker, 6, 0.449, kBlue);
  const TestModel model = maker.make();
  Scene scene = scene_of(surfels);
  scene.voxels.push_back(model.cloud());
  RenderOptions options{.width = 333, .height = 217, .depth = true, .threads = 1};
  const Camera camera = looking_at_origin({1, 0.4, 1}, 0.8);  // part of it beyond the borders
  const RenderedImage one = drawn(scene, camera, options);
  for (const unsigned threads : {2U, 3U, 8U}) {
    options.threads = threads;
    const RenderedImage many = drawn(scene, camera, options);
    EXPECT_EQ(many.picture.samples, one.picture.samples);
    EXPECT_EQ(many.depth, one.depth);
  }
}

TEST(Surfels, WhatIsBehindOrBeforeTheNearPlaneIsNotDrawn) {
  Surfels surfels;
  add_square(surfels, 0.05, 0, 1, kRed);
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    for (const double z : {-1.0, 0.09, 0.11}) {
      const Camera camera{.position = {0, 0, z}, .projection = projection, .near_plane = 0.1};
      const RenderedImage image = drawn(scene_of(surfels), camera, {.width = 50, .height = 50});
      EXPECT_EQ(covered_area(image.picture) > 0, z == 0.11) << z;
    }
  }
}

// A floor that begins behind the eye and ends far before it: of what is seen of its plane, all
// below the horizon, nothing above.
TEST(Surfels, OnePieceThatReachesBehindTheEyeIsSeenUpToItsHorizon) {
  Surfels surfels;
  surfels.push_back({0, -1, -50}, {1000, 0, 0}, {0, 0, 900}, kRed);
  const Camera camera{.position = {0, 0, 0}, .field_of_view = 1.5};
  const RenderedImage image =
      drawn(scene_of(surfels), camera, {.width = 100, .height = 100, .depth = true});
  for (uint32_t x = 0; x < 100; ++x) {
    for (uint32_t y = 0; y < 50; ++y) ASSERT_EQ(at(image, x, y).a, 0) << x << ' ' << y;
    for (uint32_t y = 51; y < 100; ++y) ASSERT_EQ(at(image, x, y), kRed) << x << ' ' << y;
  }
  // The lowest of the three samples of the last row, at 299.5 of 300.
  EXPECT_NEAR(image.depth[99 * 100 + 50], 1 / (std::tan(0.75) * (299.5 / 150 - 1)), 1e-4);
}

TEST(Surfels, AnAbsurdCloseUpIsFilledInBoundedTime) {
  Surfels surfels;
  add_square(surfels, 0.5, 0, 50, kRed);
  for (const double height : {1e-2, 1e-6, 1e-12}) {
    Camera camera = looking_at_origin({0.3, 0.2, 1}, 3);
    camera.projection = Projection::orthographic;
    camera.view_height = height;
    const RenderedImage image = drawn(scene_of(surfels), camera, {.width = 100, .height = 100});
    EXPECT_NEAR(covered_area(image.picture), 10000, 1e-6) << height;
  }
}

TEST(Surfels, NoneIsSoSmallThatItIsNotSeen) {
  Surfels surfels;  // without extent, a line, and far away
  surfels.push_back({0, 0, 0}, {0, 0, 0}, {0, 0, 0}, kRed);
  surfels.push_back({-0.31, 0, 0}, {0, 0, 0.1F}, {0, 0, 0.2F}, kRed);
  surfels.push_back({0.31, 0, 0}, {1e-6F, 2e-6F, 0}, {1e-6F, 0, 3e-6F}, kRed);
  for (const glm::dvec3& direction : directions(40)) {
    for (const Camera& camera : both(direction, 3)) {
      const RenderedImage image =
          drawn(scene_of(surfels), camera, {.width = 30, .height = 30, .samples = 1});
      EXPECT_GE(covered_area(image.picture), 2) << direction.z;
      EXPECT_LE(covered_area(image.picture), 16);
    }
  }
}

TEST(Surfels, NumbersThatAreNoneAreNotDrawn) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr float kHuge = std::numeric_limits<float>::infinity();
  Surfels surfels;
  surfels.push_back({kNan, 0, 0}, {1, 0, 0}, {0, 1, 0}, kRed);
  surfels.push_back({0, 0, kNan}, {1, 0, 0}, {0, 1, 0}, kRed);
  surfels.push_back({0, 0, 0}, {kHuge, 0, 0}, {0, 1, 0}, kRed);
  surfels.push_back({0, 0, 0}, {1, 0, 0}, {0, static_cast<float>(kNan), 0}, kRed);
  for (const Camera& camera : both({0, 0, 1}, 3)) {
    const RenderedImage image = drawn(scene_of(surfels), camera, {.width = 30, .height = 30});
    EXPECT_EQ(covered_area(image.picture), 0);
  }
  EXPECT_TRUE(outline(scene_of(surfels)).empty());
}

TEST(Surfels, CloudsThatDoNotFitAreRefused) {
  Surfels surfels;
  add_square(surfels, 0.5, 0, 1, kRed);
  const auto text = [](const SurfelCloud& cloud) {
    const auto image = render({.surfels = {cloud}}, Camera{}, {.width = 4, .height = 4});
    return image.ok() ? std::string("ok") : image.error().text;
  };
  SurfelCloud cloud{.surfels = std::make_shared<Surfels>(surfels)};
  EXPECT_EQ(text(cloud), "ok");
  cloud.local_to_world[1][2] = NAN;
  EXPECT_EQ(text(cloud), "the matrix of a surfel cloud is not affine or not finite");
  EXPECT_EQ(text({}), "a surfel cloud without surfels");
  surfels.v.clear();
  EXPECT_EQ(text({.surfels = std::make_shared<Surfels>(surfels)}),
            "1 surfels with 1 and 0 sides and 1 colours (expected as many)");
}

TEST(Surfels, LimitsAreKept) {
  Surfels surfels;
  add_square(surfels, 0.5, 0, 1, kRed);
  Limits limits;
  limits.memory = 503;  // 4 bytes a pixel and 104 for the surfel
  const RenderOptions options{.width = 10, .height = 10};
  const auto image = render(scene_of(surfels), Camera{}, options, limits);
  ASSERT_FALSE(image.ok());
  EXPECT_EQ(image.error().code, Errc::limit_exceeded);
  EXPECT_EQ(image.error().text,
            "drawing 1 surfels and 0 shapes into 100 pixels needs more than the limits allow");
  limits.memory = 504;
  EXPECT_TRUE(render(scene_of(surfels), Camera{}, options, limits).ok());
}

TEST(Outline, HoldsTheSurfelsClosely) {
  Surfels surfels;
  surfels.push_back({1, 2, 3}, {0.5F, 0, 0.25F}, {0, 0.5F, 0}, kRed);
  surfels.push_back({9, 9, 9}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0, 127});  // not drawn
  Scene scene = scene_of(surfels);
  scene.surfels[0].local_to_world[3] = {10, 0, 0, 1};
  glm::dvec3 low(1e9), high(-1e9);
  for (const glm::dvec3& p : outline(scene)) low = glm::min(low, p), high = glm::max(high, p);
  EXPECT_EQ(low, glm::dvec3(10.5, 1.5, 2.75));
  EXPECT_EQ(high, glm::dvec3(11.5, 2.5, 3.25));
}

// Seen along a diagonal the box around a sphere is much larger than it; so a camera that is fitted
// to the outline tells whether that is close.
TEST(Outline, OfASphereOfSurfelsFillsThePicture) {
  Surfels surfels;
  add_surfel_sphere(surfels, 3, 100, kRed);
  const std::vector<glm::dvec3> points = outline(scene_of(surfels));
  EXPECT_LT(points.size(), 8U * 6 * 32 * 32);
  for (const glm::dvec3& direction : directions(20)) {
    double farthest = 0;
    for (const glm::dvec3& p : points) farthest = std::max(farthest, glm::dot(p, direction));
    EXPECT_GT(farthest, 2.999);
    EXPECT_LT(farthest, 3 + 6 / 32.0);
  }
}

}  // namespace
}  // namespace afx::render
