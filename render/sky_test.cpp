// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/sky.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace afx::render {
namespace {

/// So many radians from the zenith.
glm::dvec3 below_zenith(double angle) { return {3 * std::sin(angle), 3 * std::cos(angle), 0}; }

Backdrop striped() {
  Backdrop backdrop;
  backdrop.sky_colours = {{0, 0, 1}, {0, 1, 0}, {1, 1, 1}};
  backdrop.sky_angles = {1.0F, 1.5F};
  backdrop.ground_colours = {{0, 0, 0}, {1, 0, 0}};
  backdrop.ground_angles = {0.5F};
  return backdrop;
}

void expect_colour(const glm::vec3& got, const glm::vec3& expected) {
  EXPECT_NEAR(glm::distance(got, expected), 0, 1e-5) << got.r << " " << got.g << " " << got.b;
}

TEST(Sky, ColoursAreMixedByTheAngle) {
  const Backdrop b = striped();
  expect_colour(sky_colour(b, {0, 5, 0}), {0, 0, 1});
  expect_colour(sky_colour(b, below_zenith(0.25)), {0, 0.25F, 0.75F});
  expect_colour(sky_colour(b, below_zenith(1.0)), {0, 1, 0});
  expect_colour(sky_colour(b, below_zenith(1.25)), {0.5F, 1, 0.5F});
  expect_colour(sky_colour(b, {1, 0, 0}), {1, 1, 1});
  expect_colour(sky_colour(b, below_zenith(2.6)), {1, 1, 1});  // the last colour goes on
  expect_colour(sky_colour(b, {0, -1, 0}), {0, 0, 0});
  expect_colour(sky_colour(b, below_zenith(std::acos(-1.0) - 0.25)), {0.5F, 0, 0});
  expect_colour(sky_colour({}, {1, 2, 3}), {0, 0, 0});
}

TEST(Sky, TheCubeIsSeenFromInside) {
  struct Case {
    glm::dvec3 direction;
    size_t face;
    glm::vec2 place;
  };
  // Each looks half way to the right and a quarter up as one turns to the face.
  for (const Case& c :
       {Case{{0.5, 0.25, -1}, 0, {0.75F, 0.625F}}, Case{{-0.5, 0.25, 1}, 1, {0.75F, 0.625F}},
        Case{{-1, 0.25, -0.5}, 2, {0.75F, 0.625F}}, Case{{1, 0.25, 0.5}, 3, {0.75F, 0.625F}},
        Case{{0.5, 1, 0.25}, 4, {0.75F, 0.625F}}, Case{{0.5, -1, -0.25}, 5, {0.75F, 0.625F}}}) {
    const CubePlace got = cube_place(2.0 * c.direction);
    EXPECT_EQ(got.face, c.face);
    EXPECT_NEAR(glm::distance(got.place, c.place), 0, 1e-6) << c.face;
  }
}

TEST(Sky, RaysTurnWithTheCameraAndTheBackdrop) {
  RenderOptions options{.width = 100, .height = 100, .samples = 2};
  Camera camera{.field_of_view = std::acos(0.0)};
  Backdrop backdrop;
  const auto ray = [&](glm::dvec2 at) { return SkyRays(backdrop, Lens(camera, options)).at(at); };
  EXPECT_NEAR(glm::distance(ray({100, 100}), glm::dvec3(0, 0, -1)), 0, 1e-12);
  EXPECT_NEAR(glm::distance(ray({200, 0}), glm::dvec3(1, 1, -1)), 0, 1e-12);
  camera.projection = Projection::orthographic;  // as at 45 degrees
  const double slope = std::tan(std::acos(0.0) / 4);
  EXPECT_NEAR(glm::distance(ray({200, 0}), glm::dvec3(slope, slope, -1)), 0, 1e-12);
  // The camera turns to its left, to -x. The backdrop's right, its x, lies at -z in the world.
  camera.orientation = glm::angleAxis(std::acos(0.0), glm::dvec3(0, 1, 0));
  EXPECT_NEAR(glm::distance(ray({100, 100}), glm::dvec3(-1, 0, 0)), 0, 1e-12);
  backdrop.to_world = glm::dmat3(glm::dvec3(0, 0, -1), glm::dvec3(0, 1, 0), glm::dvec3(1, 0, 0));
  EXPECT_NEAR(glm::distance(ray({100, 100}), glm::dvec3(0, 0, -1)), 0, 1e-12);
}

}  // namespace
}  // namespace afx::render
