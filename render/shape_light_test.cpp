// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// How shapes look in the picture: light, textures, fog, backdrop.
#include <gtest/gtest.h>

#include <cmath>

#include "render/test_drawing.h"
#include "render/test_scenes.h"
#include "render/test_shapes.h"

namespace afx::render {
namespace {

const RenderOptions kSmall{.width = 40, .height = 40};

/// A picture of 2 x 2 pixels: upper row red, green, lower row blue, white.
std::shared_ptr<Picture> four_colours() {
  auto picture = std::make_shared<Picture>(2, 2, 3);
  picture->samples = {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255};
  return picture;
}

TEST(ShapeLight, TheHeadlightFallsAlongTheView) {
  // Turned away by 60 degrees a white surface has half the display value, from both sides.
  Geometry geometry = square(1, 0);
  geometry.solid = false;
  for (const double angle : {0.0, std::acos(0.5), std::acos(-0.5)}) {
    Shape shape = shape_of(geometry, {.diffuse = glm::vec3(1)});
    shape.to_world[0] = {std::cos(angle), 0, -std::sin(angle), 0};
    shape.to_world[2] = {std::sin(angle), 0, std::cos(angle), 0};
    const Scene scene{.shapes = {shape}, .headlight = true};
    const uint8_t value = at(drawn(scene, front(4), kSmall), 20, 20).r;
    EXPECT_NEAR(value, angle == 0 ? 255 : 127.5, 0.6);
  }
  const Scene dark{.shapes = {shape_of(geometry, {.diffuse = glm::vec3(1)})}};
  EXPECT_EQ(at(drawn(dark, front(4), kSmall), 20, 20), (Rgba8{0, 0, 0, 255}));
}

TEST(ShapeLight, NormalsStandUprightOnStretchedSurfaces) {
  // A slope of 45 degrees, made four times as long along z: its normal leans from z by atan 4.
  Geometry geometry;
  add_quad(geometry, {{-1, -1, 1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, 1}});
  Shape shape = shape_of(geometry, {.diffuse = glm::vec3(1)});
  shape.to_world[2][2] = 4;
  const Scene scene{.shapes = {shape}, .headlight = true};
  EXPECT_EQ(at(drawn(scene, front(4), kSmall), 20, 20).r, std::lround(255 / std::sqrt(17.0)));
}

TEST(ShapeLight, MirroredSurfacesAreLitFromTheirOutside) {
  Shape shape = shape_of(square(1, 0), {.diffuse = glm::vec3(1)});
  for (int axis = 0; axis < 2; ++axis) {
    shape.to_world = glm::dmat4(1);
    shape.to_world[axis][axis] = -1;
    const Scene scene{.shapes = {shape}, .headlight = true};
    EXPECT_EQ(at(drawn(scene, front(4), kSmall), 20, 20), (Rgba8{255, 255, 255, 255}));
  }
}

TEST(ShapeLight, OnlyTheLightsOfAShapeFallOnIt) {
  Shape shape = shape_of(square(1, 0), {.diffuse = glm::vec3(1)});
  Scene scene{.lights = {{.colour = {1, 0, 0}}, {.colour = {0, 0, 1}}}};
  shape.lights = {1};
  scene.shapes = {shape};
  EXPECT_EQ(at(drawn(scene, front(4), kSmall), 20, 20), kBlue);
}

TEST(ShapeLight, LightsStandWhereTheyAreInTheWorld) {
  // A point light one unit before the middle: the square's normal and the way to the light make
  // 45 degrees one unit beside it.
  Shape shape = shape_of(square(2, 0), {.diffuse = glm::vec3(1)});
  shape.lights = {0};
  const Scene scene{.shapes = {shape},
                    .lights = {{.kind = Light::Kind::point, .location = {0, 0, 1}}}};
  const RenderedImage image = drawn(scene, front(4), {.width = 201, .height = 201});
  EXPECT_EQ(at(image, 100, 100).r, 255);
  EXPECT_NEAR(at(image, 150, 100).r, 255 * std::sqrt(0.5), 1);
  EXPECT_NEAR(at(image, 100, 50).r, 255 * std::sqrt(0.5), 1);
}

TEST(ShapeLight, TexturesBeginAtTheLowerLeft) {
  Look look{.lit = false,
            .diffuse = glm::vec3(1),
            .texture = four_colours(),
            .repeat_s = false,
            .repeat_t = false};
  const Scene scene{.shapes = {shape_of(square(1, 0), look)}};
  // Places a quarter from the corners: the middles of the four pixels, with 10 pixels each.
  const RenderedImage image = drawn(scene, front(4), {.width = 81, .height = 81, .samples = 1});
  EXPECT_EQ(at(image, 25, 25), (Rgba8{255, 0, 0, 255}));
  EXPECT_EQ(at(image, 55, 25), (Rgba8{0, 255, 0, 255}));
  EXPECT_EQ(at(image, 25, 55), (Rgba8{0, 0, 255, 255}));
  EXPECT_EQ(at(image, 55, 55), (Rgba8{255, 255, 255, 255}));
}

TEST(ShapeLight, TextureTransformsAreApplied) {
  // Moved by half the picture to the right and repeated: the colours change places.
  Look look{.lit = false, .diffuse = glm::vec3(1), .texture = four_colours()};
  look.texture_transform[2] = {0.5F, 0, 1};
  const Scene scene{.shapes = {shape_of(square(1, 0), look)}};
  // The square is half as wide as the picture; 3/8 and 5/8 of that are the middles of pixels.
  const RenderedImage image = drawn(scene, front(4), {.width = 28, .height = 28, .samples = 1});
  EXPECT_EQ(at(image, 10, 10), (Rgba8{0, 255, 0, 255}));
  EXPECT_EQ(at(image, 17, 10), (Rgba8{255, 0, 0, 255}));
}

TEST(ShapeLight, TexturesAreSeenInPerspective) {
  // A floor from 1 to 3 below the eye, of black and white halves: they meet at distance 2, on the
  // screen at slope 1 / 2. Affine mixing would put them at (1 + 1 / 3) / 2.
  auto picture = std::make_shared<Picture>(1, 64, 1);
  for (size_t k = 0; k < 32; ++k) picture->samples[k] = 255;
  Geometry floor;
  add_quad(floor, {{-5, -1, -1}, {5, -1, -1}, {5, -1, -3}, {-5, -1, -3}});
  floor.texture_coordinates = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const Look look{.lit = false,
                  .diffuse = glm::vec3(1),
                  .texture = picture,
                  .repeat_s = false,
                  .repeat_t = false};
  const Camera camera{.position = {0, 0, 0}, .field_of_view = std::acos(0.0)};
  const RenderedImage image = drawn({.shapes = {shape_of(floor, look)}}, camera,
                                    {.width = 200, .height = 200, .samples = 1});
  EXPECT_EQ(at(image, 30, 100 + 47), (Rgba8{255, 255, 255, 255}));
  EXPECT_EQ(at(image, 170, 100 + 53), (Rgba8{0, 0, 0, 255}));
}

TEST(ShapeLight, ATextureFromFarIsItsMeanLight) {
  auto picture = std::make_shared<Picture>(64, 64, 1);
  for (size_t k = 0; k < 64 * 64; ++k) picture->samples[k] = (k + k / 64) % 2 == 0 ? 255 : 0;
  Geometry geometry = square(1, 0);
  for (glm::vec2& place : geometry.texture_coordinates) place *= 50;
  const Look look{.lit = false, .diffuse = glm::vec3(1), .texture = picture};
  const RenderedImage image = drawn({.shapes = {shape_of(geometry, look)}}, front(4), kSmall);
  EXPECT_EQ(at(image, 20, 20), (Rgba8{188, 188, 188, 255}));  // half the light
}

TEST(ShapeLight, GreyTexturesMultiplyAndColouredOnesReplace) {
  auto grey = std::make_shared<Picture>(1, 1, 1);
  grey->samples = {128};
  auto coloured = std::make_shared<Picture>(1, 1, 4);
  coloured->samples = {0, 0, 255, 128};
  const auto colour = [](const std::shared_ptr<Picture>& texture) {
    const Look look{.diffuse = {1, 0.5F, 0}, .texture = texture};
    const Scene scene{.shapes = {shape_of(square(1, 0), look)}, .headlight = true};
    return at(drawn(scene, front(4), kSmall), 20, 20);
  };
  EXPECT_EQ(colour(grey), (Rgba8{128, 64, 0, 255}));
  EXPECT_EQ(colour(coloured), (Rgba8{0, 0, 255, 128}));
}

TEST(ShapeLight, FogIsMixedByTheDistanceFromTheEye) {
  // Half way into white fog: half the light of red is left, 188 on the sRGB scale.
  Scene scene{.shapes = {shape_of(square(30, 0), glowing({1, 0, 0}))}};
  scene.fog = Fog{.colour = glm::vec3(1), .visibility_range = 20};
  const Camera camera{.position = {0, 0, 10}, .field_of_view = 2 * std::atan(1)};
  const RenderedImage image = drawn(scene, camera, {.width = 201, .height = 201});
  EXPECT_EQ(at(image, 100, 100), (Rgba8{255, 188, 188, 255}));
  // At slope 0.99502 the distance is 10 sqrt(1 + 0.99502^2) = 14.1070, so 0.70535 is fog.
  EXPECT_NEAR(at(image, 200, 100).g, 255 * (1.055 * std::pow(0.70535, 1 / 2.4) - 0.055), 1);
  // Transparent ones are in the fog too; nothing is not.
  scene.shapes = {shape_of(square(1, 0), glowing({1, 0, 0}, 0.5F))};
  const RenderedImage glass = drawn(scene, camera, {.width = 201, .height = 201});
  EXPECT_EQ(at(glass, 100, 100), (Rgba8{255, 188, 188, 128}));
  EXPECT_EQ(at(glass, 10, 10), (Rgba8{0, 0, 0, 0}));
}

TEST(ShapeLight, FogCoversVoxelsToo) {
  TestModelMaker maker(0);
  maker.add({0, 0, 0}, kRed);
  Scene scene = maker.make().scene();
  scene.fog = Fog{.colour = {0, 0, 1}, .visibility_range = 20};
  EXPECT_EQ(at(drawn(scene, front(4), {.width = 41, .height = 41}), 20, 20),
            (Rgba8{188, 0, 188, 255}));
}

TEST(ShapeLight, TheBackdropTakesThePlaceOfTheBackground) {
  Scene scene{.shapes = {shape_of(square(1, 0), glowing({1, 0, 0}, 0.5F))}};
  scene.backdrop = Backdrop{.sky_colours = {{0, 0, 1}}};
  RenderOptions options = kSmall;
  options.background = {0, 255, 0, 255};
  EXPECT_EQ(at(drawn(scene, front(4), options), 0, 0), kBlue);
  EXPECT_EQ(at(drawn(scene, front(4), options), 20, 20), (Rgba8{188, 0, 188, 255}));
  options.backdrop = false;
  EXPECT_EQ(at(drawn(scene, front(4), options), 0, 0), (Rgba8{0, 255, 0, 255}));
}

TEST(ShapeLight, TheBackdropsPicturesLieAround) {
  Scene scene;
  scene.backdrop = Backdrop{};
  scene.backdrop->pictures[0] = four_colours();
  auto white = std::make_shared<Picture>(1, 1, 1);
  white->samples = {255};
  scene.backdrop->pictures[3] = white;
  // 90 degrees see just the front picture.
  Camera camera{.field_of_view = std::acos(0.0)};
  const RenderedImage ahead = drawn(scene, camera, {.width = 80, .height = 80});
  EXPECT_EQ(at(ahead, 5, 5), (Rgba8{255, 0, 0, 255}));
  EXPECT_EQ(at(ahead, 75, 5), (Rgba8{0, 255, 0, 255}));
  EXPECT_EQ(at(ahead, 5, 75), (Rgba8{0, 0, 255, 255}));
  camera.orientation = glm::angleAxis(-std::acos(0.0), glm::dvec3(0, 1, 0));  // to the right
  EXPECT_EQ(at(drawn(scene, camera, {.width = 80, .height = 80}), 40, 40),
            (Rgba8{255, 255, 255, 255}));
  camera.orientation = glm::angleAxis(std::acos(0.0), glm::dvec3(0, 1, 0));  // to the left: the sky
  EXPECT_EQ(at(drawn(scene, camera, {.width = 80, .height = 80}), 40, 40), (Rgba8{0, 0, 0, 255}));
}

}  // namespace
}  // namespace afx::render
