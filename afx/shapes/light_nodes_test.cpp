// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/shapes/light_nodes.h"

#include "afx/shapes/shape_test_support.h"
#include "nodes/traversal.h"

namespace afx {
namespace {

/// A light in a Transform with these fields.
Result<Light> try_light(const std::string& light, const std::string& transform = "") {
  const auto scene = scene_of("Transform { " + transform + " children " + light + " }");
  const auto found = nodes::find_scene_objects(*scene);
  const auto& object = found.value().objects.at(0);
  return read_light(object.nodes.front(), object.to_world);
}
Light light_from(const std::string& text, const std::string& transform = "") {
  const auto light = try_light(text, transform);
  EXPECT_TRUE(light.ok()) << (light.ok() ? "" : light.error().text);
  return light.ok() ? light.value() : Light{};
}

TEST(Lights, ADirectionalLightTurnsWithItsMatrix) {
  const Light light = light_from(
      "DirectionalLight { direction 0 0 -5 color 1 0.5 9 intensity 0.5 ambientIntensity 2 }",
      "rotation 0 1 0 1.5707963267948966 scale 3 3 3 translation 7 7 7");
  EXPECT_EQ(light.kind, Light::Kind::directional);
  expect_near(light.direction, {-1, 0, 0});
  EXPECT_EQ(light.colour, glm::vec3(1, 0.5F, 1));
  EXPECT_EQ(light.intensity, 0.5F);
  EXPECT_EQ(light.ambient_intensity, 1);
  expect_near(light_from("DirectionalLight { direction 0 0 0 }").direction, {0, 0, -1});
}

TEST(Lights, RadiusAndAttenuationGoByTheMeanScale) {
  // Scaled by 1, 8, 1: lengths by 2 on average.
  const Light light = light_from("PointLight { location 1 1 1 radius 5 attenuation 1 4 8 }",
                                 "scale 1 8 1 translation 1 0 0");
  EXPECT_EQ(light.kind, Light::Kind::point);
  expect_near(light.location, {2, 8, 1});
  EXPECT_NEAR(light.radius, 10, 1e-9);
  expect_near(light.attenuation, {1, 2, 2});
  EXPECT_EQ(light_from("PointLight {}", "scale 0 1 1").radius, 0);
}

TEST(Lights, ASpotHasPlaceDirectionAndAngles) {
  const Light light =
      light_from("SpotLight { location 0 0 2 direction 1 0 0 beamWidth 0.25 cutOffAngle 9 }",
                 "rotation 0 0 1 1.5707963267948966");
  EXPECT_EQ(light.kind, Light::Kind::spot);
  expect_near(light.location, {0, 0, 2});
  expect_near(light.direction, {0, 1, 0});
  EXPECT_EQ(light.beam_width, 0.25);
  EXPECT_NEAR(light.cut_off_angle, 1.5707963, 1e-6);
}

TEST(Lights, BadFieldsAreErrors) {
  EXPECT_EQ(try_light("DEF P PointLight { radius -1 }").error().text,
            "PointLight \"P\": field radius is -1 (expected 0 or more)");
  EXPECT_EQ(try_light("PointLight { attenuation 0 -1 0 }").error().text,
            "PointLight: field attenuation is 0 -1 0 (expected finite numbers, 0 or more)");
  EXPECT_EQ(try_light("SpotLight { direction nan 0 0 }").error().text,
            "SpotLight: field direction is nan 0 0 (expected finite numbers)");
  EXPECT_EQ(try_light("DirectionalLight { intensity nan }").error().text,
            "DirectionalLight: field intensity is nan (expected 0 to 1)");
}

}  // namespace
}  // namespace afx
