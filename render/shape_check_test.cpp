// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/shape_check.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/renderer.h"
#include "render/test_shapes.h"

namespace afx::render {
namespace {

std::string text(const Status& status) { return status.ok() ? "ok" : status.error().text; }

std::string text(const Scene& scene) { return text(check_scene(scene)); }

std::string text_of_geometry(const Geometry& geometry) {
  return text(check_shape(shape_of(geometry, {}), 0));
}

std::string text_of_look(const Look& look) {
  return text(check_shape(shape_of(square(1, 0), look), 0));
}

TEST(ShapeCheck, GeometryThatDoesNotFitIsRefused) {
  EXPECT_EQ(text_of_geometry(square(1, 0)), "ok");
  EXPECT_EQ(text(check_shape({}, 0)), "a shape without geometry or look");
  Geometry geometry = square(1, 0);
  geometry.indices[1] = 4;
  EXPECT_EQ(text_of_geometry(geometry), "a shape names corner 4 (expected below 4)");
  geometry.indices.pop_back();
  EXPECT_EQ(text_of_geometry(geometry), "a shape whose indices end inside of a primitive");
  geometry = square(1, 0);
  geometry.positions[2].y = NAN;
  EXPECT_EQ(text_of_geometry(geometry), "a shape with a position that is not finite");
  geometry = square(1, 0);
  geometry.texture_coordinates[2].y = INFINITY;
  EXPECT_EQ(text_of_geometry(geometry),
            "a shape with a normal, texture coordinate or colour that is not finite");
  geometry.normals.clear();
  EXPECT_EQ(text_of_geometry(geometry), "triangles without normals");
}

TEST(ShapeCheck, LooksOutOfRangeAreRefused) {
  EXPECT_EQ(text_of_look({}), "ok");
  EXPECT_EQ(text_of_look({.transparency = 1.5F}),
            "the transparency of a look is 1.500000 (expected 0 to 1)");
  EXPECT_EQ(text_of_look({.shininess = NAN}), "the shininess of a look is nan (expected 0 to 1)");
  EXPECT_EQ(text_of_look({.diffuse = glm::vec3(NAN)}), "a look with a colour that is not finite");
  auto picture = std::make_shared<Picture>(2, 2, 3);
  EXPECT_EQ(text_of_look({.texture = picture}), "ok");
  picture->samples.pop_back();
  EXPECT_EQ(text_of_look({.texture = picture}),
            "the picture of a look has 11 samples for 2 x 2 pixels of 3 components");
  *picture = Picture();
  EXPECT_NE(text_of_look({.texture = picture}), "ok");
}

TEST(ShapeCheck, LightsOutOfRangeAreRefused) {
  Scene scene{.lights = {Light{}}};
  EXPECT_EQ(text(scene), "ok");
  scene.lights[0].direction = glm::dvec3(0);
  EXPECT_EQ(text(scene), "a light without a direction");
  scene.lights[0] = {.intensity = 2};
  EXPECT_EQ(text(scene), "the intensity of a light is 2.000000 (expected 0 to 1)");
  scene.lights[0] = {.radius = -1};
  EXPECT_EQ(text(scene), "a light whose radius is less than 0");
  scene.lights[0] = {.location = glm::dvec3(INFINITY)};
  EXPECT_NE(text(scene), "ok");
  scene.lights.clear();
  scene.shapes = {shape_of(square(1, 0), {})};
  scene.shapes[0].lights = {0};
  EXPECT_EQ(text(scene), "a shape names light 0 (expected below 0)");
}

TEST(ShapeCheck, FogMustBeSeenThrough) {
  Scene scene{.fog = Fog{.visibility_range = 1}};
  EXPECT_EQ(text(scene), "ok");
  scene.fog->visibility_range = 0;
  EXPECT_EQ(text(scene), "the visibility range of the fog is 0.000000 (expected more than 0)");
}

TEST(ShapeCheck, BackdropsThatDoNotFitAreRefused) {
  Scene scene{.backdrop = Backdrop{}};
  EXPECT_EQ(text(scene), "ok");
  scene.backdrop->sky_angles = {1};
  EXPECT_EQ(text(scene), "1 colours of the sky for 1 angles (expected one more)");
  scene.backdrop->sky_colours.assign(3, glm::vec3(0));
  scene.backdrop->sky_angles = {1, 0.5F};
  EXPECT_EQ(text(scene), "the angles of the sky do not rise from 0 to at most pi");
  scene.backdrop->sky_angles = {1, std::acos(-1.0F)};
  EXPECT_EQ(text(scene), "ok");
  scene.backdrop->ground_angles = {1};
  EXPECT_EQ(text(scene), "0 colours of the ground for 1 angles (expected one more)");
  scene.backdrop = Backdrop{.to_world = glm::dmat3(2)};
  EXPECT_EQ(text(scene), "the matrix of the backdrop is not a rotation");
  scene.backdrop = Backdrop{};
  scene.backdrop->pictures[5] = std::make_shared<Picture>();
  EXPECT_NE(text(scene), "ok");
}

}  // namespace
}  // namespace afx::render
