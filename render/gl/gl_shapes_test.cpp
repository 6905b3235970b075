// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Shapes, lights, fog and backdrop look as the software renderer draws them.
#include <glm/gtc/matrix_transform.hpp>

#include "render/gl/test_gl.h"
#include "render/test_shapes.h"
#include "render/test_surfels.h"

namespace afx::render {
namespace {

constexpr RenderOptions kSmall{.width = 211, .height = 163};
const glm::dvec3 kAside(0.4, 0.3, 1);

/// A ball of n x 2n pieces with smooth normals, texture coordinates and colours.
Geometry ball(float radius, int n) {
  Geometry g;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= 2 * n; ++i) {
      const float s = static_cast<float>(i) / static_cast<float>(2 * n);
      const float t = static_cast<float>(j) / static_cast<float>(n);
      const float around = s * 6.2831853F, up = (t - 0.5F) * 3.1415927F;
      const glm::vec3 normal(std::cos(up) * std::sin(around), std::sin(up),
                             std::cos(up) * std::cos(around));
      g.positions.push_back(radius * normal);
      g.normals.push_back(normal);
      g.texture_coordinates.emplace_back(s, t);
    }
  }
  const auto at = [&](int i, int j) { return static_cast<uint32_t>(j * (2 * n + 1) + i); };
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < 2 * n; ++i) {
      for (const uint32_t k :
           {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1)})
        g.indices.push_back(k);
    }
  }
  return g;
}

Geometry coloured(Geometry g) {
  for (const glm::vec3& p : g.positions) g.colours.push_back(glm::abs(glm::normalize(p)));
  return g;
}

std::shared_ptr<const Picture> checks(uint32_t side, uint32_t components) {
  auto picture = std::make_shared<Picture>(side, side, components);
  for (uint32_t y = 0; y < side; ++y) {
    for (uint32_t x = 0; x < side; ++x) {
      for (uint32_t k = 0; k < components; ++k)
        picture->pixel(x, y)[k] =
            static_cast<uint8_t>((x / 8 + y / 8) % 2 * 150 + 30 * k + x * 10 / side);
    }
  }
  return picture;
}

Shape at(Shape shape, const glm::dvec3& place) {
  shape.to_world[3] = glm::dvec4(place, 1);
  return shape;
}

Scene lit(Scene scene) {
  scene.lights = {{.kind = Light::Kind::directional,
                   .colour = {1, 0.8F, 0.7F},
                   .ambient_intensity = 0.3F,
                   .direction = glm::normalize(glm::dvec3(-1, -1, -0.5))},
                  {.kind = Light::Kind::point,
                   .colour = {0.2F, 1, 0.2F},
                   .location = {-1, 0.5, 1},
                   .attenuation = {0.5, 0.3, 0.2},
                   .radius = 2.5},
                  {.kind = Light::Kind::spot,
                   .colour = {0.5F, 0.5F, 1},
                   .location = {0, 2, 1},
                   .direction = glm::normalize(glm::dvec3(0, -2, -1)),
                   .radius = 50,
                   .beam_width = 0.1,
                   .cut_off_angle = 0.4}};
  for (Shape& shape : scene.shapes) shape.lights = {0, 1, 2};
  return scene;
}

Scene shapes_scene() {
  Scene scene;
  const Look shiny{.specular = glm::vec3(0.7F), .shininess = 0.3F};
  scene.shapes.push_back(at(shape_of(ball(0.4F, 24), shiny), {-0.3, 0, 0}));
  scene.shapes.push_back(at(shape_of(cube(0.25F), {.diffuse = {0.9F, 0.3F, 0.2F}}), {0.4, 0.1, 0}));
  scene.shapes.push_back(at(shape_of(coloured(cube(0.15F)), {}), {0.1, -0.35, 0.3}));
  scene.shapes[1].to_world =
      glm::rotate(glm::scale(scene.shapes[1].to_world, {-1, 1.4, 0.6}), 0.7, {0, 0.6, 0.8});
  return scene;
}

TEST_F(GlTest, LightFallsOnShapesTheSame) {
  Scene scene = lit(shapes_scene());
  for (const double distance : {1.0, 2.5, 9.0})
    expect_same("shapes-" + std::to_string(distance), scene, looking_at_origin(kAside, distance),
                kSmall);
  scene.headlight = true;
  Camera camera = looking_at_origin({-1, 0.4, 0.4}, 2.5);
  camera.projection = Projection::orthographic;
  camera.view_height = 1.4;
  expect_same("shapes-parallel", scene, camera, kSmall);
  Scene inside;
  inside.headlight = true;
  Geometry open = cube(1);
  open.solid = false;
  inside.shapes = {shape_of(open, {})};
  expect_same("inside-cube", lit(inside), {.position = {0.2, 0.1, 0.3}, .field_of_view = 1.5},
              kSmall, kDrawnOnShapes);
}

TEST_F(GlTest, TexturesLookTheSameAtAllSizes) {
  for (const uint32_t components : {1U, 3U}) {
    Scene scene;
    Look look{.diffuse = {1, 0.9F, 0.5F}};
    look.texture = checks(200, components);
    look.texture_transform = glm::mat3(2, 0.3F, 0, 0, 3, 0, 0.1F, 0.2F, 1);
    scene.shapes = {shape_of(ball(0.4F, 24), look)};
    scene.headlight = true;
    for (const double distance : {0.6, 2.0, 9.0})
      expect_same("texture-" + std::to_string(components) + "-" + std::to_string(distance), scene,
                  looking_at_origin(kAside, distance), kSmall, kDrawnOnShapes);
    look.repeat_s = look.repeat_t = look.lit = false;
    scene.shapes = {shape_of(square(0.5F, 0), look)};
    expect_same("texture-edges-" + std::to_string(components), scene,
                looking_at_origin({0, -1, 0.3}, 1), kSmall, kDrawnOnShapes);
  }
}

TEST_F(GlTest, LinesAndPointsLookTheSame) {
  Geometry lines{.kind = Geometry::Kind::lines};
  Geometry points{.kind = Geometry::Kind::points};
  for (uint32_t k = 0; k < 60; ++k) {
    const double a = k * 0.7;
    lines.positions.emplace_back(0.6 * std::cos(a), 0.5 * std::sin(1.3 * a), 0.5 * std::sin(a));
    lines.colours.emplace_back(k / 60.0, 1 - k / 60.0, 0.5);
    lines.indices.push_back(k);
    if (k > 0 && k < 59) lines.indices.push_back(k);
    points.positions.emplace_back(0.5 * std::sin(a), 0.4 * std::cos(2 * a), 0.3 * std::cos(a));
    points.indices.push_back(k);
  }
  Scene scene;
  scene.shapes = {shape_of(lines, {}), shape_of(points, glowing({1, 1, 0}))};
  expect_same("lines", scene, looking_at_origin(kAside, 1.6), kSmall);
  expect_same("lines-cut", scene, {.position = {0, 0, 0.3}, .field_of_view = 1, .near_plane = 0.1},
              kSmall);
}

TEST_F(GlTest, WallsHideSplatsTheSame) {
  Scene scene = lit(shapes_scene());
  TestModelMaker maker(6);
  add_sphere(maker, 6, 0.35, {200, 180, 40, 255});
  scene.voxels = {maker.make().cloud()};
  Surfels surfels;
  add_square(surfels, 0.5, 0.1, 30, {40, 90, 200, 255});
  scene.surfels = scene_of(surfels).surfels;
  expect_same("walls-and-splats", scene, looking_at_origin(kAside, 2), kSmall);
}

TEST_F(GlTest, TransparentShapesLookTheSame) {
  Scene scene = lit(shapes_scene());
  scene.shapes.push_back(
      shape_of(ball(0.55F, 12), {.diffuse = {0.3F, 0.5F, 1}, .transparency = 0.6F}));
  Geometry both = square(0.6F, 0.62F);
  both.solid = false;
  Look glass;
  glass.texture = checks(64, 4);
  glass.lit = false;
  scene.shapes.push_back(shape_of(both, glass));
  expect_same("glass", scene, looking_at_origin(kAside, 2.5), kSmall, kDrawnOnShapes);
  expect_same("glass-opaque", scene, looking_at_origin({1, 0.1, -0.2}, 2.5),
              {.width = 211, .height = 163, .background = {9, 80, 200, 255}}, kDrawnOnShapes);
}

TEST_F(GlTest, FogLooksTheSame) {
  Scene scene = lit(shapes_scene());
  TestModelMaker maker(6);
  add_sphere(maker, 6, 0.35, {200, 180, 40, 255});
  scene.voxels = {maker.make().cloud()};
  scene.shapes.push_back(shape_of(square(0.6F, 0.5F), {.transparency = 0.6F}));
  for (const bool exponential : {false, true}) {
    scene.fog =
        Fog{.exponential = exponential, .colour = {0.7F, 0.8F, 0.9F}, .visibility_range = 4};
    expect_same(exponential ? "fog-exponential" : "fog", scene, looking_at_origin(kAside, 2),
                kSmall);
  }
}

TEST_F(GlTest, TheBackdropLooksTheSame) {
  Scene scene = shapes_scene();
  scene.headlight = true;
  Backdrop backdrop;
  backdrop.sky_colours = {{0.1F, 0.2F, 0.9F}, {0.6F, 0.7F, 1}, {1, 0.9F, 0.8F}};
  backdrop.sky_angles = {0.9F, 1.5F};
  backdrop.ground_colours = {{0.3F, 0.2F, 0.1F}, {0.2F, 0.5F, 0.1F}};
  backdrop.ground_angles = {1.4F};
  backdrop.to_world = glm::dmat3(glm::rotate(glm::dmat4(1), 0.2, {0, 0, 1}));
  scene.backdrop = backdrop;
  Camera camera = looking_at_origin(kAside, 2);
  camera.field_of_view = 1.2;
  expect_same("sky", scene, camera, kSmall);
  for (size_t k = 0; k < 6; ++k) scene.backdrop->pictures[k] = checks(96, k % 2 == 0 ? 4 : 3);
  for (const glm::dvec3& direction : directions(6)) {
    camera = looking_at_origin(direction, 2);
    camera.field_of_view = 1.5;
    expect_same("cube-" + std::to_string(direction.z), scene, camera, kSmall);
  }
  camera.projection = Projection::orthographic;
  camera.view_height = 2;
  expect_same("cube-parallel", scene, camera, kSmall);
}

}  // namespace
}  // namespace afx::render
