// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/shading.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "afx/srgb.h"

namespace afx::render {
namespace {

/// A direction that leans from the z axis towards x by an angle in degrees.
glm::vec3 leaning(double degrees) {
  const double angle = degrees * std::acos(-1.0) / 180;
  return {std::sin(angle), 0, std::cos(angle)};
}

const Material kMatt{.diffuse = glm::vec3(1, 0.5F, 0), .ambient_intensity = 0};

TEST(Shading, DiffuseLightGoesWithTheCosine) {
  ViewLight light;
  light.intensity = 0.5F;
  for (const double degrees : {0.0, 30.0, 60.0, 90.0, 120.0}) {
    light.direction = -leaning(degrees);
    const glm::vec3 sent = reflected(light, kMatt, {});
    const double expected = 0.5 * std::max(0.0, std::cos(degrees * std::acos(-1.0) / 180));
    EXPECT_NEAR(sent.r, expected, 1e-6);
    EXPECT_NEAR(sent.g, expected / 2, 1e-6);
    EXPECT_EQ(sent.b, 0);
  }
}

TEST(Shading, AmbientLightComesFromEverywhere) {
  ViewLight light;
  light.ambient_intensity = 0.5F;
  light.direction = {0, 0, 1};  // from behind
  const Material material{.diffuse = glm::vec3(0.8F), .ambient_intensity = 0.25F};
  EXPECT_FLOAT_EQ(reflected(light, material, {}).r, 0.5F * 0.25F * 0.8F);
}

TEST(Shading, SpecularLightIsBrightestInTheMirror) {
  // The eye at 20 degrees on one side; the half way direction leans by (light - 20) / 2.
  const Material shiny{.diffuse = glm::vec3(0), .specular = glm::vec3(0.5F), .shininess = 0.25F};
  SurfacePoint point;
  point.to_eye = leaning(-20);
  ViewLight light;
  for (const double degrees : {20.0, 30.0, 60.0}) {
    light.direction = -leaning(degrees);
    const double half = (degrees - 20) / 2 * std::acos(-1.0) / 180;
    EXPECT_NEAR(reflected(light, shiny, point).r, 0.5 * std::pow(std::cos(half), 32), 1e-5);
  }
  light.direction = -leaning(100);  // behind the surface
  EXPECT_EQ(reflected(light, shiny, point).r, 0);
}

TEST(Shading, LightGetsWeakerByTheDistance) {
  ViewLight light;
  light.kind = Light::Kind::point;
  light.radius = 10;
  light.attenuation = {0, 0.5F, 0.25F};
  EXPECT_EQ(arriving(light, {1, 0, 0}), 1);  // 0.75: not more than all
  EXPECT_FLOAT_EQ(arriving(light, {0, 4, 0}), 1.0F / 6);
  EXPECT_FLOAT_EQ(arriving(light, {0, 0, 10}), 1.0F / 30);
  EXPECT_EQ(arriving(light, {0, 0, 10.001F}), 0);
}

TEST(Shading, SpotsHaveAnEdge) {
  ViewLight light;
  light.kind = Light::Kind::spot;
  light.radius = 10;
  light.direction = {0, 0, 1};
  light.beam_width = 0.2F;
  light.cut_off_angle = 0.6F;
  const auto part = [&](double angle) {
    return arriving(light, leaning(angle * 180 / std::acos(-1.0)));
  };
  EXPECT_EQ(part(0), 1);
  EXPECT_EQ(part(0.19), 1);
  EXPECT_NEAR(part(0.3), 0.75, 1e-5);
  EXPECT_NEAR(part(0.5), 0.25, 1e-5);
  EXPECT_EQ(part(0.61), 0);
  EXPECT_EQ(part(3), 0);
  light.beam_width = 1.5F;  // wider than the spot: a sharp edge
  EXPECT_EQ(part(0.59), 1);
  EXPECT_EQ(part(0.61), 0);
}

TEST(Shading, LightsAreTakenToTheCamerasSystem) {
  // The camera at (1, 2, 3) looks along -x.
  Camera camera{.position = {1, 2, 3}};
  camera.orientation = glm::angleAxis(std::acos(0.0), glm::dvec3(0, 1, 0));
  const Lens lens(camera, {});
  const ViewLight view = view_light(
      {.kind = Light::Kind::spot, .location = {-4, 2, 3}, .direction = {0, 0, -1}}, lens);
  EXPECT_NEAR(glm::distance(view.location, glm::vec3(0, 0, -5)), 0, 1e-6);
  EXPECT_NEAR(glm::distance(view.direction, glm::vec3(1, 0, 0)), 0, 1e-6);
}

TEST(Shading, ColoursFollowTheTablesOfTheStandard) {
  using enum Geometry::Kind;
  const glm::vec3 corner(0.2F, 0.4F, 0.6F);
  const glm::vec4 texel(0.5F, 0.5F, 0.5F, 0.25F);
  Look look{.diffuse = glm::vec3(0.8F), .emissive = glm::vec3(0.1F), .transparency = 0.125F};
  EXPECT_EQ(surface_colour(look, triangles, nullptr, nullptr, 0).colour, glm::vec3(0.8F));
  EXPECT_EQ(surface_colour(look, triangles, &corner, nullptr, 0).colour, corner);
  EXPECT_EQ(surface_colour(look, triangles, &corner, &texel, 1).colour, corner * 0.5F);
  EXPECT_EQ(surface_colour(look, triangles, &corner, &texel, 3).colour, glm::vec3(0.5F));
  EXPECT_EQ(surface_colour(look, triangles, nullptr, &texel, 3).opacity, 0.875F);
  EXPECT_EQ(surface_colour(look, triangles, nullptr, &texel, 2).opacity, 0.25F);
  EXPECT_EQ(surface_colour(look, lines, nullptr, nullptr, 0).colour, glm::vec3(0.1F));
  EXPECT_EQ(surface_colour(look, points, &corner, nullptr, 0).colour, corner);
  look.lit = false;
  EXPECT_EQ(surface_colour(look, triangles, nullptr, nullptr, 0).colour, glm::vec3(0.8F));
  EXPECT_EQ(surface_colour(look, triangles, nullptr, &texel, 1).colour, glm::vec3(0.8F) * 0.5F);
}

TEST(Shading, FogLeavesLessTheFartherAway) {
  Fog fog{.visibility_range = 10};
  EXPECT_EQ(fog_leaves(fog, 0), 1);
  EXPECT_FLOAT_EQ(fog_leaves(fog, 2.5F), 0.75F);
  EXPECT_EQ(fog_leaves(fog, 10), 0);
  fog.exponential = true;
  EXPECT_EQ(fog_leaves(fog, 0), 1);
  EXPECT_FLOAT_EQ(fog_leaves(fog, 5), std::exp(-1.0F));
  EXPECT_EQ(fog_leaves(fog, 11), 0);
}

TEST(Shading, LinearLightIsThatOfSrgb) {
  for (int k = -10; k <= 10010; ++k) {
    const float value = static_cast<float>(k) / 10000;
    ASSERT_NEAR(linear_light(glm::vec3(value)).g, srgb_to_linear(value), 1e-6) << value;
  }
  EXPECT_EQ(linear_light(glm::vec3(NAN)).r, 0);
}

}  // namespace
}  // namespace afx::render
