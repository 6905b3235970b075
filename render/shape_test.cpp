// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Where triangles, lines and points lie in the picture, and what hides what.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "render/test_drawing.h"
#include "render/test_scenes.h"
#include "render/test_shapes.h"

namespace afx::render {
namespace {

const glm::vec3 kRedLight(1, 0, 0), kGreenLight(0, 1, 0), kBlueLight(0, 0, 1);

Scene scene_of(std::vector<Shape> shapes) { return {.shapes = std::move(shapes)}; }

TEST(Shapes, ASquareHasItsExactAreaColourAndDepth) {
  const Scene scene = scene_of({shape_of(square(1, 0.5), glowing(kRedLight))});
  for (const unsigned samples : {1U, 3U, 8U}) {
    const RenderOptions options{.width = 200, .height = 200, .samples = samples, .depth = true};
    const RenderedImage image = drawn(scene, front(4), options);
    EXPECT_EQ(covered_area(image.picture), 100 * 100);
    for (uint32_t y = 50; y < 150; ++y)
      for (uint32_t x = 50; x < 150; ++x) ASSERT_EQ(at(image, x, y), kRed);
    EXPECT_EQ(image.depth[100 * 200 + 100], 9.5F);
    EXPECT_TRUE(std::isinf(image.depth[0]));
  }
}

TEST(Shapes, EdgesAreSmoothByTheSamplesTheyCover) {
  // The right edge at 0.7 pixels of a column: two of three samples, at 1/6 and 1/2.
  Geometry geometry = square(1, 0);
  for (glm::vec3& p : geometry.positions) p.x *= p.x > 0 ? 1.014F : 1.0F;
  const Scene scene = scene_of({shape_of(geometry, glowing(kRedLight))});
  const RenderedImage image = drawn(scene, front(4), {.width = 200, .height = 200});
  EXPECT_EQ(at(image, 150, 100), (Rgba8{255, 0, 0, 170}));
}

/// The depth of the cube |x|, |y|, |z| <= half along a ray, infinite beside it.
double cube_depth(double half, const glm::dvec3& eye, const glm::dvec3& ray) {
  double enter = 0, leave = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const double a = (-half - eye[k]) / ray[k], b = (half - eye[k]) / ray[k];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter < leave ? enter : std::numeric_limits<double>::infinity();
}

/// The line of sight through the middle of a pixel of a square picture; depths go with its length.
struct Sight {
  glm::dvec3 eye, ray;
};

Sight sight(const Camera& camera, uint32_t side, uint32_t x, uint32_t y) {
  const glm::dvec3 place((x + 0.5) / side * 2 - 1, 1 - (y + 0.5) / side * 2, 0), ahead(0, 0, -1);
  if (camera.projection == Projection::orthographic) {
    const glm::dvec3 moved = camera.orientation * (place * camera.view_height / 2.0);
    return {camera.position + moved, camera.orientation * ahead};
  }
  const double half = std::tan(camera.field_of_view / 2);
  return {camera.position, camera.orientation * (place * half + ahead)};
}

TEST(Shapes, ACubeHasNoGapsAndExactDepthsFromAnywhere) {
  const Scene scene = scene_of({shape_of(cube(0.5), glowing(kRedLight))});
  constexpr uint32_t kSide = 121;
  size_t seen = 0, inexact = 0;
  for (const glm::dvec3& direction : directions(50)) {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
      Camera camera = looking_at_origin(direction, 3);
      camera.projection = projection;
      camera.view_height = 2;
      const RenderedImage image =
          drawn(scene, camera, {.width = kSide, .height = kSide, .samples = 1, .depth = true});
      for (uint32_t y = 0; y < kSide; ++y) {
        for (uint32_t x = 0; x < kSide; ++x) {
          const Sight s = sight(camera, kSide, x, y);
          const auto got = static_cast<double>(image.depth[y * kSide + x]);
          // Edges may be off by 1/512 sample, that is 1/30000: the cube is a little larger or less.
          ASSERT_GE(got, cube_depth(0.5001, s.eye, s.ray)) << x << " " << y;
          ASSERT_LE(got, cube_depth(0.4999, s.eye, s.ray)) << x << " " << y;
          if (std::isinf(got)) continue;
          ++seen;
          if (!(std::abs(got - cube_depth(0.5, s.eye, s.ray)) < 4e-6)) ++inexact;
        }
      }
    }
  }
  EXPECT_GT(seen, 200000U);
  EXPECT_LT(inexact, seen / 2000);
}

TEST(Shapes, NeighboursShareNoSampleAndLeaveNone) {
  // A fan of 97 thin triangles around the middle of a sample, each half transparent: where two met,
  // or none did, alpha would differ from one half.
  Geometry fan;
  fan.positions.push_back(glm::vec3(0.01F, -0.01F, 0));
  constexpr uint32_t kCount = 97;
  for (uint32_t k = 0; k < kCount; ++k) {
    const float angle = 6.2831853F * static_cast<float>(k) / kCount;
    fan.positions.push_back(10.0F * glm::vec3(std::cos(angle), std::sin(angle), 0));
    for (const uint32_t corner : {0U, k + 1, (k + 1) % kCount + 1}) fan.indices.push_back(corner);
  }
  fan.normals.assign(fan.positions.size(), glm::vec3(0, 0, 1));
  Shape shape = shape_of(fan, glowing(kRedLight, 0.5F));
  for (const double turn : {0.0, 0.7}) {
    shape.to_world[0] = {std::cos(turn), 0, std::sin(turn), 0};
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
      Camera camera{.position = {0, 0, 10}, .projection = projection, .view_height = 4};
      camera.field_of_view = 2 * std::atan(0.2);
      const RenderedImage image = drawn(scene_of({shape}), camera, {.width = 200, .height = 200});
      for (uint32_t y = 0; y < 200; ++y)
        for (uint32_t x = 0; x < 200; ++x) ASSERT_EQ(at(image, x, y).a, 128) << x << " " << y;
    }
  }
}

TEST(Shapes, ThoseThatPassThroughEachOtherMeetOnALine) {
  // The red one lies in z = 0, the blue one in z = x: it is nearer where x > 0.
  Geometry slanted = square(1, 0);
  for (glm::vec3& p : slanted.positions) p.z = p.x;
  const Scene scene = scene_of(
      {shape_of(square(1, 0), glowing(kRedLight)), shape_of(slanted, glowing(kBlueLight))});
  const RenderedImage image = drawn(scene, front(4), {.width = 200, .height = 200});
  for (uint32_t y = 50; y < 150; ++y) {
    ASSERT_EQ(at(image, 99, y), kRed);
    ASSERT_EQ(at(image, 100, y), kBlue);
  }
}

TEST(Shapes, BackFacesOfSolidsAreNotDrawn) {
  const Geometry solid = square(1, 0);
  Geometry sheet = solid;
  sheet.solid = false;
  const RenderOptions options{.width = 40, .height = 40, .samples = 1};
  Camera behind = front(4);
  behind.position = {0, 0, -10};
  behind.orientation = {0, 0, 1, 0};
  const auto area = [&](const Shape& shape, const Camera& camera) {
    return covered_area(drawn(scene_of({shape}), camera, options).picture);
  };
  Shape mirrored = shape_of(solid, glowing(kRedLight));
  mirrored.to_world[0][0] = -1;
  EXPECT_EQ(area(shape_of(solid, glowing(kRedLight)), front(4)), 400);
  EXPECT_EQ(area(shape_of(solid, glowing(kRedLight)), behind), 0);
  EXPECT_EQ(area(shape_of(sheet, glowing(kRedLight)), behind), 400);
  EXPECT_EQ(area(mirrored, front(4)), 400);
  EXPECT_EQ(area(mirrored, behind), 0);
}

TEST(Shapes, LinesAndPointsAreOnePixelWide) {
  Geometry line{.kind = Geometry::Kind::lines};
  line.positions = {{-1, 0.01F, 0}, {1, 0.01F, 0}};  // the middle of row 99
  line.indices = {0, 1};
  Geometry point{.kind = Geometry::Kind::points};
  point.positions = {{0.51F, 0.51F, 0}};  // the middle of pixel (125, 74)
  point.indices = {0};
  for (const unsigned samples : {1U, 3U, 4U}) {
    const RenderOptions options{.width = 200, .height = 200, .samples = samples};
    const RenderedImage image =
        drawn(scene_of({shape_of(line, glowing(kRedLight)), shape_of(point, glowing(kBlueLight))}),
              front(4), options);
    EXPECT_EQ(covered_area(image.picture), 101) << samples;
    for (uint32_t x = 50; x < 150; ++x) ASSERT_EQ(at(image, x, 99), kRed);
    EXPECT_EQ(at(image, 125, 74), kBlue);
  }
}

TEST(Shapes, LinesShowTheirCornersColoursAndEndAtTheNearPlane) {
  Geometry line{.kind = Geometry::Kind::lines};
  line.positions = {{-1, 0.01F, 0}, {1, 0.01F, 0}};
  line.colours = {kRedLight, kBlueLight};
  line.indices = {0, 1};
  const RenderOptions options{.width = 200, .height = 200, .samples = 1};
  const RenderedImage image = drawn(scene_of({shape_of(line, {})}), front(4), options);
  const int red = at(image, 75, 99).r, blue = at(image, 75, 99).b;
  EXPECT_NEAR(red, 255 * 0.745, 1);  // the middle of pixel 75 is a quarter and a half pixel along
  EXPECT_NEAR(blue, 255 * 0.255, 1);
  // From the middle of the picture, behind the eye, towards the right and away: seen from x = 1 on,
  // where it has gone half way.
  line.positions = {{0, 0, 2}, {2, 0, 0}};
  const Camera camera{.position = {0, 0, 2}, .field_of_view = 2 * std::atan(2), .near_plane = 1};
  const RenderedImage cut = drawn(scene_of({shape_of(line, {})}), camera, options);
  EXPECT_EQ(at(cut, 160, 100).a | at(cut, 160, 99).a, 0);  // x / depth is 1 at least, at z = 0
  EXPECT_EQ(at(cut, 140, 100).a, 0);
}

TEST(Shapes, AWallHidesWhatLiesBehindItAndNoMore) {
  // Voxels of side 1/8; their centres lie in z = -1/16, their backs in z = -1/8.
  TestModelMaker maker(3);
  for (uint32_t y = 0; y < 8; ++y)
    for (uint32_t x = 0; x < 8; ++x) maker.add({x, y, 3}, kRed);
  const TestModel model = maker.make();
  const double tenth = 0.1 / 8;
  const auto picture = [&](double z) {
    Scene scene = model.scene();
    scene.shapes = {shape_of(square(0.4F, static_cast<float>(z)), glowing(kBlueLight))};
    return drawn(scene, front(1), {.width = 100, .height = 100, .samples = 1});
  };
  const RenderedImage before = picture(-1.0 / 16 + tenth);
  const RenderedImage between = picture(-1.0 / 16 - tenth);
  const RenderedImage behind = picture(-1.0 / 8 - tenth);
  int red = 0, blue = 0;
  for (uint32_t y = 10; y < 90; ++y) {
    for (uint32_t x = 10; x < 90; ++x) {
      ASSERT_EQ(at(before, x, y), kBlue);
      ASSERT_EQ(at(behind, x, y), kRed);
      const Rgba8 colour = at(between, x, y);  // their rims bulge through the wall; nothing mixes
      red += colour == kRed ? 1 : 0;
      blue += colour == kBlue ? 1 : 0;
    }
  }
  EXPECT_EQ(red + blue, 80 * 80);
  EXPECT_GT(red, 1000);
  EXPECT_GT(blue, 1000);
}

TEST(Shapes, TransparentOnesAreMixedInLinearLight) {
  // Blue, before it red that lets 3/4 of the light through, before all a green that lets half
  // through: the light is 0.5 green + 0.5 (0.25 red + 0.75 blue).
  const Scene scene = scene_of({shape_of(square(1, 2), glowing(kGreenLight, 0.5F)),
                                shape_of(square(1, 1), glowing(kRedLight, 0.75F)),
                                shape_of(square(1, 0), glowing(kBlueLight))});
  const RenderOptions options{.width = 40, .height = 40, .depth = true};
  const RenderedImage image = drawn(scene, front(4), options);
  // 0.125, 0.5 and 0.375 on the sRGB scale: 255 (1.055 v^(1 / 2.4) - 0.055).
  EXPECT_EQ(at(image, 20, 20), (Rgba8{99, 188, 165, 255}));
  EXPECT_EQ(image.depth[20 * 40 + 20], 10);
  // By itself a shape is as opaque as it is, and has its own colour.
  const Scene alone = scene_of({shape_of(square(1, 1), glowing(kRedLight, 0.75F))});
  EXPECT_EQ(at(drawn(alone, front(4), options), 20, 20), (Rgba8{255, 0, 0, 64}));
}

TEST(Shapes, TransparentOnesAreHiddenByWhatIsNearer) {
  Scene scene = scene_of({shape_of(square(1, 0), glowing(kRedLight)),
                          shape_of(square(1, -1), glowing(kBlueLight, 0.5F))});
  EXPECT_EQ(at(drawn(scene, front(4), {.width = 40, .height = 40}), 20, 20), kRed);
  TestModelMaker maker(0);
  maker.add({0, 0, 0}, kRed);
  scene = maker.make().scene();
  scene.shapes = {shape_of(square(1, -1), glowing(kBlueLight, 0.5F))};
  EXPECT_EQ(at(drawn(scene, front(4), {.width = 40, .height = 40}), 20, 20), kRed);
}

TEST(Shapes, FromInsideABoxFillsThePicture) {
  Geometry box = cube(100);
  box.solid = false;
  const Scene scene = scene_of({shape_of(box, glowing(kRedLight))});
  for (const glm::dvec3& direction : directions(20)) {
    for (const double distance : {0.0, 60.0, -99.0}) {
      Camera camera = looking_at_origin(direction, 1);
      camera.position = distance / 100 * glm::dvec3(99, 98, 97);
      camera.field_of_view = 2;
      const RenderedImage image = drawn(scene, camera, {.width = 100, .height = 80});
      EXPECT_EQ(covered_area(image.picture), 100 * 80);
    }
  }
}

TEST(Shapes, WhatIsBeforeTheNearPlaneIsCutOff) {
  // A floor one unit below the eye; of the picture's lower half, the rows whose rays meet it closer
  // than 4 stay empty: slope 1 / 4, where the picture ends at slope 1.
  Geometry floor;
  add_quad(floor, {{-1e4F, -1, 1e4F}, {1e4F, -1, 1e4F}, {1e4F, -1, -1e4F}, {-1e4F, -1, -1e4F}});
  const Camera camera{.position = {0, 0, 0}, .field_of_view = std::acos(0.0), .near_plane = 4};
  const RenderedImage image = drawn(scene_of({shape_of(floor, glowing(kRedLight))}), camera,
                                    {.width = 80, .height = 80, .samples = 1});
  for (uint32_t y = 0; y < 80; ++y) {
    const bool seen = y >= 40 && y < 50;
    for (uint32_t x = 0; x < 80; ++x) ASSERT_EQ(at(image, x, y).a, seen ? 255 : 0) << y;
  }
}

TEST(Shapes, AnyNumberOfThreadsDrawsTheSame) {
  Scene scene;
  for (int k = 0; k < 60; ++k) {
    Shape shape = shape_of(cube(0.3F), glowing(glm::vec3(0.5F), k % 3 == 0 ? 0.5F : 0));
    const glm::dvec3 place = directions(60)[static_cast<size_t>(k)];
    shape.to_world[3] = glm::dvec4(place * 1.5, 1);
    scene.shapes.push_back(shape);
  }
  scene.headlight = true;
  const Camera camera = looking_at_origin({1, 2, 3}, 6);
  const RenderedImage one = drawn(scene, camera, {.width = 300, .height = 200, .threads = 1});
  const RenderedImage five = drawn(scene, camera, {.width = 300, .height = 200, .threads = 5});
  EXPECT_EQ(one.picture.samples, five.picture.samples);
}

TEST(Shapes, AbsurdSizesDrawSomethingOrNothing) {
  for (const double scale : {1e-300, 1e-30, 1e-9, 1e9, 1e30, 1e150, 1e300}) {
    for (const Geometry::Kind kind :
         {Geometry::Kind::triangles, Geometry::Kind::lines, Geometry::Kind::points}) {
      for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        Geometry geometry = cube(0.5);
        geometry.kind = kind;
        geometry.solid = false;
        for (const float transparency : {0.0F, 0.5F}) {
          Shape shape = shape_of(geometry, glowing(kRedLight, transparency));
          shape.to_world = glm::dmat4(scale);
          shape.to_world[3] = {scale / 3, 0, 0, 1};
          Scene scene = scene_of({shape});
          scene.headlight = true;
          scene.fog = Fog{.visibility_range = 20};
          Camera camera = looking_at_origin({1, 2, 3}, 3);
          camera.projection = projection;
          EXPECT_TRUE(render(scene, camera, {.width = 70, .height = 70}).ok());
        }
      }
    }
  }
}

TEST(Shapes, InTheMiddleOfAHugeBoxThePictureIsFull) {
  Geometry box = cube(0.5);
  box.solid = false;
  Shape shape = shape_of(box, glowing(kRedLight));
  for (const double scale : {1.0, 1e6, 1e12, 1e30}) {
    shape.to_world = glm::dmat4(glm::dmat3(scale));
    Camera camera = looking_at_origin({1, 2, 3}, 0.1);
    const RenderedImage image = drawn(scene_of({shape}), camera, {.width = 70, .height = 70});
    EXPECT_EQ(covered_area(image.picture), 70 * 70) << scale;
  }
}

TEST(Shapes, MemoryForThemAndTexturesIsLimited) {
  // 24 bytes for each of four positions, 32 for each of two triangles, 4 for each pixel.
  Scene scene{.shapes = {shape_of(square(1, 0), {})}};
  Limits limits{.memory = 2000};
  const RenderOptions options{.width = 10, .height = 10};
  EXPECT_TRUE(render(scene, Camera{}, options, limits).ok());
  limits.memory = 500;
  const auto refused = render(scene, Camera{}, options, limits);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, Errc::limit_exceeded);
  scene.shapes = {shape_of(square(1, 0), {.texture = std::make_shared<Picture>(100, 100, 1)})};
  limits.memory = 50000;
  const auto texture = render(scene, Camera{}, options, limits);
  ASSERT_FALSE(texture.ok());
  EXPECT_EQ(texture.error().text, "textures of 10000 pixels need more than the limits allow");
}

}  // namespace
}  // namespace afx::render
