// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// OpenGL draws what the software renderer draws, which other tests hold to geometry.
#include "render/gl/gl_renderer.h"

#include <glm/gtc/matrix_transform.hpp>

#include "render/gl/test_gl.h"
#include "render/test_surfels.h"

namespace afx::render {

namespace {

/// A sphere with colours that change from voxel to voxel and from region to region.
TestModel voxel_sphere(unsigned level, double radius) {
  TestModelMaker maker(level);
  add_sphere(maker, level, radius, kRed);
  TestModel model = maker.make();
  for (size_t i = 0; i < model.colours.size(); ++i) {
    const Voxel v = codec::morton_decode(model.codes[i]);
    const auto part = [&](uint32_t at) { return static_cast<uint8_t>((at << 8) >> level); };
    model.colours[i] = {part(v.x), part(v.y), static_cast<uint8_t>((v.x + v.y + v.z) % 2 * 200),
                        255};
  }
  return model;
}

Surfels surfel_sphere(double radius, int n) {
  Surfels surfels;
  add_surfel_sphere(surfels, radius, n, kRed);
  for (size_t i = 0; i < surfels.size(); ++i) {
    const glm::dvec3 at = (surfels.centres[i] / radius + 1.0) * 127.0;
    surfels.colours[i] = {
        static_cast<uint8_t>(at.x), static_cast<uint8_t>(at.y),
        static_cast<uint8_t>((static_cast<int>(at.x / 9) + static_cast<int>(at.z / 9)) % 2 * 200),
        255};
  }
  return surfels;
}

Camera parallel(Camera camera, double view_height) {
  camera.projection = Projection::orthographic;
  camera.view_height = view_height;
  return camera;
}

constexpr RenderOptions kSmall{.width = 301, .height = 203};
const glm::dvec3 kAside(0.4, 0.3, 1);

TEST_F(GlTest, VoxelsLookTheSameFromNearAndFar) {
  const Scene scene = voxel_sphere(7, 0.4).scene();
  for (const double distance : {0.42, 0.6, 1.0, 2.0, 4.0}) {
    Camera camera = looking_at_origin(kAside, distance);
    expect_same("voxels-at-" + std::to_string(distance), scene, camera, kSmall);
  }
}

TEST_F(GlTest, CoarserLevelsLookTheSame) {
  const Scene scene = voxel_sphere(8, 0.4).scene();
  for (const double coarseness : {0.0, 1.0, 4.0, 8.0}) {
    RenderOptions options = kSmall;
    options.coarseness = coarseness;
    expect_same("coarse-" + std::to_string(coarseness), scene, looking_at_origin(kAside, 2.5),
                options);
  }
  for (const unsigned level : {0U, 1U, 3U, 6U}) {
    RenderOptions options = kSmall;
    options.finest_level = level;
    expect_same("finest-" + std::to_string(level), scene, looking_at_origin(kAside, 1.5), options);
  }
}

TEST_F(GlTest, TiltedDiscsLookTheSameFromNearAndFar) {
  const Scene scene{.voxels = {voxel_sphere(7, 0.4).smooth_cloud()}};
  for (const double distance : {0.2, 0.401, 0.42, 0.6, 1.0, 2.0, 4.0}) {
    const Camera camera = looking_at_origin(kAside, distance);
    expect_same("tilted-at-" + std::to_string(distance), scene, camera, kSmall);
    expect_same("tilted-parallel-" + std::to_string(distance), scene,
                parallel(looking_at_origin(kAside, 3), distance), kSmall);
  }
}

TEST_F(GlTest, TiltedDiscsOfStretchedAndMirroredCloudsLookTheSame) {
  Scene scene{.voxels = {voxel_sphere(6, 0.4).smooth_cloud()}};
  glm::dmat4& matrix = scene.voxels[0].local_to_world;
  matrix = glm::scale(matrix, glm::dvec3(-1, 0.4, 1.7));
  expect_same("tilted-stretched", scene, looking_at_origin(kAside, 2), kSmall);
  matrix[0] = glm::dvec4(0);  // flat: no normals
  expect_same("tilted-flat", scene, looking_at_origin(kAside, 2), kSmall);
}

// A long plane into the distance: each part by its own level.
TEST_F(GlTest, LevelsChangeWithTheDistance) {
  TestModelMaker maker(9);
  for (uint32_t z = 0; z < 512; ++z) {
    for (uint32_t x = 0; x < 512; ++x) {
      maker.add({x, 250, z}, {static_cast<uint8_t>(x / 2), static_cast<uint8_t>(z / 2),
                              static_cast<uint8_t>((x / 16 + z / 16) % 2 * 200), 255});
    }
  }
  Camera camera{.position = {0, 0.03, 0.5}, .field_of_view = 1.2};
  expect_same("plane", maker.make().scene(), camera, kSmall);
}

TEST_F(GlTest, VoxelsLookTheSameFromInside) {
  const Scene scene = voxel_sphere(6, 0.4).scene();
  for (const double angle : {0.3, 1.0, 2.0}) {
    Camera camera = looking_at_origin(kAside, 0.2);
    camera.field_of_view = angle;
    expect_same("inside-" + std::to_string(angle), scene, camera, kSmall);
  }
}

TEST_F(GlTest, VoxelsLookTheSameInParallelProjection) {
  const Scene scene = voxel_sphere(7, 0.4).scene();
  for (const double height : {0.1, 0.9, 3.0})
    expect_same("parallel-" + std::to_string(height), scene,
                parallel(looking_at_origin(kAside, 3), height), kSmall);
}

TEST_F(GlTest, LargeVoxelsAreDrawnToTheirRims) {
  TestModelMaker maker(2);
  for (const uint32_t x : {0U, 1U, 3U})
    maker.add({x, x, 2}, {90, 200, static_cast<uint8_t>(x * 80), 255});
  for (const double distance : {0.7, 1.5}) {
    expect_same("large-" + std::to_string(distance), maker.make().scene(),
                looking_at_origin(kAside, distance), {.width = 640, .height = 480});
  }
}

TEST_F(GlTest, SurfelsLookTheSameFromNearAndFar) {
  for (const int n : {12, 100}) {
    const Scene scene = scene_of(surfel_sphere(0.4, n));
    const std::string what = "surfels-" + std::to_string(n) + "-at-";
    for (const double distance : {0.42, 0.8, 2.0, 6.0}) {
      const Camera camera = looking_at_origin(kAside, distance);
      expect_same(what + std::to_string(distance), scene, camera, kSmall);
    }
    expect_same(what + "parallel", scene, parallel(looking_at_origin(kAside, 3), 0.9), kSmall);
    Camera camera = looking_at_origin(kAside, 0.2);
    camera.field_of_view = 2;
    expect_same(what + "inside", scene, camera, kSmall);
  }
}

TEST_F(GlTest, ASurfelThatReachesBehindTheEyeIsDrawnToItsHorizon) {
  Surfels surfels;
  surfels.push_back({0, -1, -50}, {1000, 0, 0}, {0, 0, 900}, kRed);
  expect_same("horizon", scene_of(surfels), {.position = {0, 0, 0}, .field_of_view = 1.5}, kSmall);
}

TEST_F(GlTest, TransparentAndBrokenSurfelsAreLeftOut) {
  Surfels surfels;
  surfels.push_back({-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {255, 0, 0, kLeastOpacity});
  surfels.push_back({0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 255, kLeastOpacity - 1});
  surfels.push_back({NAN, 0, 1}, {1, 0, 0}, {0, 1, 0}, kBlue);
  surfels.push_back({0, 0, 1}, {1, 0, 0}, {0, INFINITY, 0}, kBlue);
  expect_same("left-out", scene_of(surfels), {.position = {0, 0, 10}}, kSmall);
}

/// Spheres of both kinds that go through each other, some clouds sharing what they show.
Scene mixed_scene() {
  Scene scene = scene_of(surfel_sphere(0.4, 60));
  scene.voxels.push_back(voxel_sphere(6, 0.4).cloud());
  scene.voxels[0].local_to_world[3] = {0.15, 0.1, 0.05, 1};
  scene.voxels.push_back(scene.voxels[0]);
  scene.voxels[1].local_to_world =
      glm::rotate(glm::scale(glm::translate(glm::dmat4(1), {-0.4, 0.2, -0.2}), {1, 0.5, 0.8}), 0.7,
                  {0, 0.6, 0.8});
  scene.surfels.push_back(scene.surfels[0]);
  scene.surfels[1].local_to_world =
      glm::rotate(glm::scale(glm::translate(glm::dmat4(1), {0.1, -0.3, 0.2}), {0.8, 1.2, 0.3}), 0.7,
                  {0, 0.6, 0.8});
  return scene;
}

TEST_F(GlTest, AMixtureLooksTheSameInEachKindOfSplats) {
  for (const auto& [kind, name] :
       {std::pair(SplatKind::smooth, "mixed-smooth"), std::pair(SplatKind::flat, "mixed-flat"),
        std::pair(SplatKind::points, "mixed-points")}) {
    RenderOptions options = kSmall;
    options.splats = kind;
    expect_same(name, mixed_scene(), looking_at_origin(kAside, 3), options);
  }
}

TEST_F(GlTest, NumbersOfSamplesScalesAndBackgroundsLookTheSame) {
  const Scene scene = mixed_scene();
  const Camera camera = looking_at_origin(kAside, 3);
  for (const unsigned samples : {1U, 2U, 8U}) {
    expect_same("samples-" + std::to_string(samples), scene, camera,
                {.width = 150, .height = 99, .samples = samples});
  }
  expect_same("scale", scene, camera, {.width = 150, .height = 99, .splat_scale = 3});
  expect_same("opaque", scene, camera,
              {.width = 150, .height = 99, .background = {9, 80, 200, 255}});
  expect_same("half", scene, camera, {.width = 150, .height = 99, .background = {9, 80, 200, 100}});
}

// At eight samples a tile is 256 pixels wide.
TEST_F(GlTest, PicturesLargerThanATileHaveNoSeams) {
  RenderOptions options{.width = 301, .height = 270, .samples = 8};
  expect_same("tiles", mixed_scene(), looking_at_origin(kAside, 2), options);
  options = {.width = 270, .height = 517, .samples = 8};
  expect_same("tiles-near", voxel_sphere(4, 0.4).scene(), looking_at_origin(kAside, 0.8), options);
}

TEST_F(GlTest, FarFromTheOriginOfTheWorldItLooksTheSame) {
  Scene scene = mixed_scene();
  const glm::dvec3 away(4e6, 5e6, -3e5);
  for (VoxelCloud& cloud : scene.voxels) cloud.local_to_world[3] += glm::dvec4(away, 0);
  Surfels surfels = *scene.surfels[0].surfels;  // these by their own coordinates
  for (glm::dvec3& centre : surfels.centres) centre += away;
  scene.surfels = scene_of(surfels).surfels;
  Camera camera = looking_at_origin(kAside, 1.1);
  camera.position += away;
  expect_same("away", scene, camera, kSmall);
}

TEST_F(GlTest, FineVoxelsRightBeforeTheEyeLookTheSame) {
  TestModelMaker maker(20);
  for (uint32_t y = 0; y < 64; ++y) {
    for (uint32_t x = 0; x < 64; ++x)
      maker.add({700000 + x, 300000 + y, 600000 + x / 2},
                {static_cast<uint8_t>(4 * x), static_cast<uint8_t>(4 * y), 100, 255});
  }
  const double side = std::ldexp(1.0, -20);
  Camera camera{.near_plane = side};
  camera.position = glm::dvec3(700032, 300032, 600016) * side - 0.5 + glm::dvec3(0, 0, 100 * side);
  expect_same("fine", maker.make().scene(), camera, kSmall);
}

TEST_F(GlTest, TheSameIsDrawnTwiceToTheByte) {
  const RenderOptions options{.width = 301, .height = 203, .depth = true};
  const Camera camera = looking_at_origin(kAside, 3);
  const RenderedImage first = gl_drawn(mixed_scene(), camera, options);
  gl_drawn(voxel_sphere(5, 0.3).scene(), camera, options);
  const RenderedImage again = gl_drawn(mixed_scene(), camera, options);
  EXPECT_EQ(first.picture.samples, again.picture.samples);
  EXPECT_EQ(first.depth, again.depth);
}

TEST_F(GlTest, AnEmptySceneIsTheBackground) {
  const RenderedImage image = gl_drawn(
      {}, Camera{}, {.width = 5, .height = 3, .background = {9, 80, 200, 0}, .depth = true});
  for (uint32_t x = 0; x < 5; ++x) {
    EXPECT_EQ(colour_at(image.picture, x, 2), (Rgba8{9, 80, 200, 0}));
    EXPECT_EQ(image.depth[x], std::numeric_limits<float>::infinity());
  }
}

TEST_F(GlTest, WhatIsWrongIsRefusedAsElsewhere) {
  RenderedImage image;
  EXPECT_EQ(renderer_->draw(Camera{}, {.width = 0}, image).error().code, Errc::bad_argument);
  EXPECT_EQ(renderer_->draw({.near_plane = -1}, {}, image).error().code, Errc::bad_argument);
  EXPECT_EQ(renderer_->set_scene({.voxels = {{}}}).error().code, Errc::bad_argument);
  Limits limits;
  limits.memory = 1000;
  auto renderer = make_gl_renderer(limits);
  ASSERT_TRUE(renderer.ok());
  EXPECT_EQ(renderer.value()->set_scene(voxel_sphere(5, 0.4).scene()).error().code,
            Errc::limit_exceeded);
  EXPECT_EQ(renderer.value()->draw(Camera{}, {}, image).error().code, Errc::limit_exceeded);
}

}  // namespace
}  // namespace afx::render
