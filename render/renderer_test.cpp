// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/renderer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include "render/test_drawing.h"
#include "render/test_scenes.h"

namespace afx::render {
namespace {

TestModel one_voxel(unsigned level = 0, Voxel v = {0, 0, 0}) {
  TestModelMaker maker(level);
  maker.add(v, kRed);
  return maker.make();
}

TEST(Render, OneVoxelIsADiscOfItsProjectedDiagonal) {
  RenderOptions options{.width = 200, .height = 200, .splat_scale = 1, .samples = 4, .depth = true};
  // 50 pixels a unit; seen from the front the diagonals of the unit cube project to sqrt 2.
  const TestModel model = one_voxel();
  const RenderedImage image = drawn(model.scene(), front(4), options);
  const double radius = std::sqrt(2.0) / 2 * 50;
  EXPECT_NEAR(covered_area(image.picture) / (std::numbers::pi * radius * radius), 1, 0.003);
  EXPECT_EQ(at(image, 100, 100), kRed);
  EXPECT_EQ(at(image, 10, 10), (Rgba8{0, 0, 0, 0}));
  EXPECT_NEAR(image.depth[100 * 200 + 100], 10, 1e-3);
  EXPECT_TRUE(std::isinf(image.depth[0]));
  // The disc holds the square of side 50 that is the voxel's own projection.
  for (uint32_t y = 75; y < 125; ++y) {
    for (uint32_t x = 75; x < 125; ++x) ASSERT_EQ(at(image, x, y).a, 255);
  }
}

TEST(Render, ADiscGrowsAsTheVoxelComesNearer) {
  RenderOptions options{.width = 400, .height = 400, .splat_scale = 1, .samples = 2};
  const TestModel model = one_voxel();
  for (const double distance : {20.0, 5.0}) {
    Camera camera{.position = {0, 0, distance}, .field_of_view = 2 * std::atan(0.5)};
    const double area = covered_area(drawn(model.scene(), camera, options).picture);
    // Half a picture is half a unit high at distance 1; the nearest corners are 1/2 nearer.
    const double radius = std::sqrt(2.0) / 2 * 400 / (distance - 0.5);
    EXPECT_NEAR(area / (std::numbers::pi * radius * radius), 1, 0.02) << distance;
  }
}

TEST(Render, RightIsRightAndUpIsUp) {
  TestModelMaker maker(1);
  maker.add({1, 1, 0}, kRed);   // right above
  maker.add({0, 0, 0}, kBlue);  // left below
  const TestModel model = maker.make();
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    Camera camera = front(2);
    camera.projection = projection;
    camera.field_of_view = 0.2;
    const RenderedImage image = drawn(model.scene(), camera, {.width = 80, .height = 80});
    EXPECT_EQ(at(image, 50, 30), kRed);
    EXPECT_EQ(at(image, 30, 50), kBlue);
    EXPECT_EQ(at(image, 60, 60).a, 0);
  }
}

TEST(Render, ASphereHasTheAreaOfItsDisc) {
  TestModelMaker maker(6);
  add_sphere(maker, 6, 0.4, kRed);
  const TestModel model = maker.make();
  const double voxel = 1.0 / 64;
  for (const glm::dvec3& direction : directions(12)) {
    Camera camera = looking_at_origin(direction, 3);
    camera.projection = Projection::orthographic;
    camera.view_height = 1;
    const RenderedImage image =
        drawn(model.scene(), camera, {.width = 256, .height = 256, .splat_scale = 1});
    const double area = covered_area(image.picture) / (256 * 256);
    // Centres of the voxels are at most half a diagonal off the sphere, and so is a disc's rim.
    const double most = 0.4 + std::sqrt(3.0) * voxel;
    EXPECT_GT(area, std::numbers::pi * 0.4 * 0.4);
    EXPECT_LT(area, std::numbers::pi * most * most);
  }
}

TEST(Render, TheNearerVoxelHidesTheOther) {
  TestModelMaker maker(3);
  maker.add({4, 4, 1}, kBlue);
  maker.add({4, 4, 6}, kRed);
  const TestModel model = maker.make();
  Camera camera = front(1);
  EXPECT_EQ(at(drawn(model.scene(), camera, {.width = 64, .height = 64}), 36, 28), kRed);
  camera = looking_at_origin({0, 0, -1}, 10);
  camera.projection = Projection::orthographic;
  EXPECT_EQ(at(drawn(model.scene(), camera, {.width = 64, .height = 64}), 28, 28), kBlue);
}

TEST(Render, CloudsShareOneDepthBufferAndHaveMatrices) {
  const TestModel red = one_voxel();
  TestModel blue = one_voxel();
  blue.colours[0] = kBlue;
  Scene scene{.voxels = {red.cloud(), blue.cloud()}};
  scene.voxels[1].local_to_world[3] = {1.2, 0, 5, 1};  // to the right and nearer
  const RenderedImage image = drawn(scene, front(4), {.width = 80, .height = 80, .splat_scale = 1});
  EXPECT_EQ(at(image, 40, 40), kRed);
  EXPECT_EQ(at(image, 70, 40), kBlue);
  EXPECT_EQ(at(image, 52, 40), kBlue);  // discs of radius 14.1 around 40 and 64
  scene.voxels[1].local_to_world[3].z = -5;
  EXPECT_EQ(at(drawn(scene, front(4), {.width = 80, .height = 80}), 52, 40), kRed);
}

TEST(Render, EdgesAreMixedWithTheBackgroundInLinearLight) {
  TestModel model = one_voxel();
  model.colours[0] = {255, 255, 255, 255};
  RenderOptions options{.width = 40, .height = 40, .background = {0, 0, 0, 255}, .samples = 2};
  options.splat_scale = 1.05;
  const RenderedImage image = drawn(model.scene(), front(4), options);
  std::set<int> seen;
  for (size_t i = 0; i < image.picture.samples.size(); i += 4) {
    EXPECT_EQ(image.picture.samples[i + 3], 255);
    seen.insert(image.picture.samples[i]);
  }
  // sRGB of 0, 1/4, 1/2, 3/4, 1
  EXPECT_EQ(seen, (std::set<int>{0, 137, 188, 225, 255}));
}

TEST(Render, TheBackgroundIsKeptWhereNothingIs) {
  const Scene empty;
  for (const Rgba8 colour : {Rgba8{10, 200, 30, 255}, Rgba8{0, 0, 0, 0}, Rgba8{9, 8, 7, 100}}) {
    const RenderedImage image =
        drawn(empty, Camera{}, {.width = 33, .height = 65, .background = colour});
    for (uint32_t y = 0; y < 65; ++y) {
      for (uint32_t x = 0; x < 33; ++x) ASSERT_EQ(at(image, x, y), colour);
    }
  }
}

TEST(Render, ThePictureIsTheSameForAnyNumberOfThreads) {
  TestModelMaker maker(7);
  add_sphere(maker, 7, 0.45, kRed);
  add_sphere(maker, 7, 0.44, {20, 240, 90, 255});
  const TestModel model = maker.make();
  ASSERT_GT(model.codes.size(), size_t{3} * 16384);  // several chunks
  RenderOptions options{.width = 333, .height = 217, .depth = true, .threads = 1};
  const Camera camera = looking_at_origin({1, 0.4, 1}, 0.8);  // part of it beyond the borders
  const RenderedImage one = drawn(model.scene(), camera, options);
  for (const unsigned threads : {2U, 3U, 8U}) {
    options.threads = threads;
    const RenderedImage many = drawn(model.scene(), camera, options);
    EXPECT_EQ(many.picture.samples, one.picture.samples);
    EXPECT_EQ(many.depth, one.depth);
  }
}

TEST(Render, WhatIsBehindOrBeforeTheNearPlaneIsNotDrawn) {
  const TestModel model = one_voxel(4, {8, 8, 8});  // centre at 1/32 each
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    Camera camera{.projection = projection, .near_plane = 0.1};
    camera.position = {0, 0, -1};
    EXPECT_EQ(covered_area(drawn(model.scene(), camera, {.width = 50, .height = 50}).picture), 0);
    camera.position = {0, 0, 1.0 / 32 + 0.09};
    EXPECT_EQ(covered_area(drawn(model.scene(), camera, {.width = 50, .height = 50}).picture), 0);
    camera.position = {0, 0, 1.0 / 32 + 0.11};
    EXPECT_GT(covered_area(drawn(model.scene(), camera, {.width = 50, .height = 50}).picture), 0);
  }
}

TEST(Render, AVoxelBesideTheEyeDoesNotCoverThePicture) {
  // Just before the plane of the eye, one unit to the right: outside any sane view.
  const TestModel model = one_voxel(3, {7, 4, 4});
  Camera camera{.position = {-0.6, 1.0 / 16, 0.07}, .near_plane = 1e-3};
  EXPECT_EQ(covered_area(drawn(model.scene(), camera, {.width = 64, .height = 64}).picture), 0);
}

TEST(Render, FarAwayAModelIsAFewPixelsWithoutEnd) {
  TestModelMaker maker(7);
  add_sphere(maker, 7, 0.45, kRed);
  const TestModel model = maker.make();
  const Camera camera = looking_at_origin({1, 1, 1}, 1000);
  const RenderedImage image = drawn(model.scene(), camera, {.width = 101, .height = 101});
  EXPECT_EQ(at(image, 50, 50).r, 255);
  EXPECT_LT(covered_area(image.picture), 1.1);
  const RenderedImage tiny = drawn(model.scene(), camera, {.width = 1, .height = 1, .samples = 1});
  EXPECT_EQ(tiny.picture.samples.size(), 4U);
}

TEST(Render, AnAbsurdCloseUpIsFilledInBoundedTime) {
  TestModelMaker maker(7);
  add_sphere(maker, 7, 0.45, kRed);
  const TestModel model = maker.make();
  for (const double height : {1e-2, 1e-6, 1e-12}) {
    Camera camera = looking_at_origin({0.3, 0.2, 1}, 3);
    camera.projection = Projection::orthographic;
    camera.view_height = height;
    const RenderedImage image = drawn(model.scene(), camera, {.width = 100, .height = 100});
    EXPECT_NEAR(covered_area(image.picture), 10000, 1e-6) << height;
  }
}

TEST(Render, WhatIsOutOfRangeIsRefusedWithItsName) {
  const TestModel model = one_voxel();
  const auto text = [&](const RenderOptions& options) {
    const auto image = render(model.scene(), Camera{}, options);
    return image.ok() ? std::string("ok") : image.error().text;
  };
  EXPECT_EQ(text({.width = 0, .height = 5}),
            "a picture of 0 x 5 pixels (expected 1 to 16384 each way)");
  EXPECT_NE(text({.width = 16385}), "ok");
  EXPECT_EQ(text({.samples = 0}), "samples is 0 (expected 1 to 8)");
  EXPECT_NE(text({.samples = 9}), "ok");
  EXPECT_NE(text({.splat_scale = NAN}), "ok");
  EXPECT_NE(text({.splat_scale = 0.5}), "ok");
}

TEST(Render, CloudsThatDoNotFitAreRefused) {
  const TestModel model = one_voxel();
  const auto text = [](const VoxelCloud& cloud) {
    const auto image = render(Scene{.voxels = {cloud}}, Camera{}, {.width = 4, .height = 4});
    return image.ok() ? std::string("ok") : image.error().text;
  };
  VoxelCloud cloud = model.cloud();
  EXPECT_EQ(text(cloud), "ok");
  EXPECT_EQ(text({}), "a voxel cloud without voxels");
  cloud.local_to_world[1][2] = NAN;
  EXPECT_EQ(text(cloud), "the matrix of a voxel cloud is not affine or not finite");
  cloud.local_to_world = glm::dmat4(1);
  cloud.local_to_world[0][3] = 0.5;
  EXPECT_NE(text(cloud), "ok");
  cloud.local_to_world = glm::dmat4(0);  // affine but flat: a point
  cloud.local_to_world[3][3] = 1;
  EXPECT_EQ(text(cloud), "ok");
}

TEST(Render, AbsurdMatricesAndCamerasDrawSomethingOrNothing) {
  const TestModel model = one_voxel();
  for (const double scale : {1e-300, 1e-30, 1e30, 1e300}) {
    for (const double distance : {1e-200, 1.0, 1e200}) {
      for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        VoxelCloud cloud = model.cloud();
        cloud.local_to_world = glm::dmat4(scale);
        cloud.local_to_world[3] = {scale, 0, 0, 1};
        Camera camera = looking_at_origin({1, 2, 3}, distance);
        camera.projection = projection;
        camera.near_plane = distance / 10;
        const auto image = render(Scene{.voxels = {cloud}}, camera, {.width = 40, .height = 40});
        EXPECT_TRUE(image.ok());
      }
    }
  }
}

TEST(Render, LimitsAreKept) {
  const TestModel model = one_voxel();
  Limits limits;
  limits.picture_pixels = 99;
  const auto image = render(model.scene(), Camera{}, {.width = 10, .height = 10}, limits);
  ASSERT_FALSE(image.ok());
  EXPECT_EQ(image.error().code, Errc::limit_exceeded);
  limits = {.memory = 100000};  // some of it for the cloud
  EXPECT_FALSE(render(model.scene(), Camera{}, {.width = 160, .height = 160}, limits).ok());
  EXPECT_TRUE(render(model.scene(), Camera{}, {.width = 100, .height = 100}, limits).ok());
}

TEST(Outline, HoldsTheVoxelsClosely) {
  const TestModel model = one_voxel(8, {255, 0, 128});
  const std::vector<glm::dvec3> points = outline(model.scene());
  ASSERT_EQ(points.size(), 8U);  // the cell (31, 0, 16) of level 5
  EXPECT_EQ(points[0], glm::dvec3(31.0 / 32 - 0.5, -0.5, 0));
  EXPECT_EQ(points[7], glm::dvec3(0.5, 1.0 / 32 - 0.5, 1.0 / 32));
  EXPECT_TRUE(outline(Scene{}).empty());
}

}  // namespace
}  // namespace afx::render
