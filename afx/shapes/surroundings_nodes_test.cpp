// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/shapes/surroundings_nodes.h"

#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "afx/shapes/shape_test_support.h"
#include "nodes/traversal.h"

namespace afx {
namespace {

template <class Read>
auto read_in(const std::string& node, const std::string& transform, Read read) {
  const auto scene = scene_of("Transform { " + transform + " children " + node + " }");
  const auto found = nodes::find_scene_objects(*scene);
  const auto& object = found.value().objects.at(0);
  return read(object.nodes.front(), object.to_world);
}

Result<Backdrop> backdrop_from(const std::string& fields, Diagnostics& diagnostics,
                               const std::string& folder = "/nowhere") {
  return read_in("DEF B " + fields, "", [&](const auto& node, const auto&) {
    return read_backdrop(node, UrlBase(folder), {}, diagnostics);
  });
}

TEST(Background, HasSkyAndGround) {
  Diagnostics diagnostics;
  const auto sky = backdrop_from(
      "Background { skyColor [ 0 0 1 0 1 1 2 0 0 ] skyAngle [ 1 3.1416 ] groundColor [ 0 1 0 1 1 1 "
      "] "
      "groundAngle 1.571 }",
      diagnostics);
  ASSERT_TRUE(sky.ok());
  EXPECT_EQ(diagnostics.count(), 0U);
  EXPECT_EQ(sky.value().sky_colours.size(), 3U);
  EXPECT_EQ(sky.value().sky_colours[2], glm::vec3(1, 0, 0));
  EXPECT_EQ(sky.value().sky_angles[0], 1);
  EXPECT_NEAR(sky.value().sky_angles[1], 3.14159265, 1e-6);
  EXPECT_EQ(sky.value().ground_colours.size(), 2U);
  EXPECT_NEAR(sky.value().ground_angles.at(0), 1.5707963, 1e-6);
  const auto plain = backdrop_from("Background {}", diagnostics);
  EXPECT_EQ(plain.value().sky_colours, std::vector<glm::vec3>{glm::vec3(0)});
  EXPECT_EQ(backdrop_from("Background { skyColor [] }", diagnostics).value().sky_colours.size(),
            1U);
}

TEST(Background, WhatDoesNotFitIsMadeToFit) {
  Diagnostics diagnostics;
  const auto sky = backdrop_from(
      "Background { skyColor [ 0 0 1 0 1 1 1 0 0 ] skyAngle 2 groundColor 1 1 1 groundAngle [ 1 ] "
      "}",
      diagnostics);
  EXPECT_EQ(sky.value().sky_colours.size(), 2U);
  EXPECT_EQ(sky.value().ground_angles.size(), 0U);
  ASSERT_EQ(diagnostics.count(), 2U);
  EXPECT_EQ(diagnostics.warnings()[0].text,
            "Background \"B\": field skyAngle has 1 angles for 3 colours (expected 2)");
  Diagnostics falling;
  const auto raised =
      backdrop_from("Background { skyColor [ 0 0 1 0 1 1 1 0 0 ] skyAngle [ 2 1 ] }", falling);
  EXPECT_EQ(raised.value().sky_angles, (std::vector<float>{2, 2}));
  EXPECT_EQ(falling.warnings().at(0).text,
            "Background \"B\": field skyAngle: 1 (expected 2 to 3.14159)");
  EXPECT_EQ(backdrop_from("Background { skyAngle nan }", falling).error().text,
            "Background \"B\": field skyAngle has a nan (expected numbers)");
}

TEST(Background, APictureThatIsNotThereIsAWarning) {
  Diagnostics diagnostics;
  const auto sky = backdrop_from("Background { topUrl \"no.png\" }", diagnostics);
  ASSERT_TRUE(sky.ok());
  for (const auto& picture : sky.value().pictures) EXPECT_EQ(picture, nullptr);
  ASSERT_EQ(diagnostics.count(), 1U);
  EXPECT_EQ(diagnostics.warnings()[0].code, "background_picture");
  EXPECT_NE(diagnostics.warnings()[0].text.find("field topUrl: "), std::string::npos);
}

TEST(Background, ABackground2DIsItsColour) {
  Diagnostics diagnostics;
  const auto sky = backdrop_from("Background2D { backColor 0 0.5 0 }", diagnostics);
  EXPECT_EQ(sky.value().sky_colours, std::vector<glm::vec3>{glm::vec3(0, 0.5F, 0)});
  EXPECT_EQ(diagnostics.count(), 0U);
}

TEST(FogNode, ItsRangeGrowsWithTheScale) {
  const auto fog = read_in("Fog { color 0 0 1 fogType \"EXPONENTIAL\" visibilityRange 5 }",
                           "scale 2 2 2", read_fog);
  ASSERT_TRUE(fog.ok() && fog.value().has_value());
  EXPECT_TRUE(fog.value()->exponential);
  EXPECT_EQ(fog.value()->colour, glm::vec3(0, 0, 1));
  EXPECT_NEAR(fog.value()->visibility_range, 10, 1e-9);
  EXPECT_FALSE(read_in("Fog {}", "", read_fog).value().has_value());
  EXPECT_EQ(read_in("Fog { visibilityRange -1 }", "", read_fog).error().text,
            "Fog: field visibilityRange is -1 (expected 0 or more)");
}

TEST(ViewpointNode, StandsInTheWorldWithoutItsScale) {
  // Looking along -z, turned by a quarter about y: along -x.
  const auto view =
      read_in("DEF V Viewpoint { position 0 0 10 fieldOfView 0.5 description \"here\" }",
              "translation 1 0 0 rotation 0 1 0 1.5707963267948966 scale 2 2 2", read_viewpoint);
  ASSERT_TRUE(view.ok());
  EXPECT_EQ(view.value().name, "V");
  EXPECT_EQ(view.value().description, "here");
  expect_near(view.value().position, {21, 0, 0});
  expect_near(view.value().orientation * glm::dvec3(0, 0, -1), {-1, 0, 0});
  expect_near(view.value().orientation * glm::dvec3(0, 1, 0), {0, 1, 0});
  EXPECT_EQ(view.value().field_of_view, 0.5);
}

TEST(ViewpointNode, ItsOwnTurnComesFirst) {
  // A quarter about x: along +y; then the quarter about z takes +y to -x.
  const auto view = read_in("Viewpoint { orientation 1 0 0 1.5707963267948966 }",
                            "rotation 0 0 1 1.5707963267948966", read_viewpoint);
  expect_near(view.value().orientation * glm::dvec3(0, 0, -1), {-1, 0, 0});
  EXPECT_EQ(read_in("Viewpoint { fieldOfView 4 }", "", read_viewpoint).error().text,
            "Viewpoint: field fieldOfView is 4 (expected above 0, below pi)");
  EXPECT_EQ(read_in("Viewpoint { orientation 0 1 0 inf }", "", read_viewpoint).error().text,
            "Viewpoint: field orientation is not finite (expected finite numbers)");
}

TEST(NavigationInfoNode, IsReadAsItIs) {
  const auto read = [](const nodes::NodeView& node, const glm::dmat4&) {
    return read_navigation(node);
  };
  const auto navigation =
      read_in("NavigationInfo { headlight FALSE speed 3 visibilityLimit 9 type [ \"EXAMINE\" ] }",
              "", read);
  EXPECT_FALSE(navigation.value().headlight);
  EXPECT_EQ(navigation.value().speed, 3);
  EXPECT_EQ(navigation.value().visibility_limit, 9);
  EXPECT_EQ(navigation.value().types, std::vector<std::string>{"EXAMINE"});
  EXPECT_EQ(read_in("NavigationInfo { speed nan }", "", read).error().text,
            "NavigationInfo: field speed is nan (expected 0 or more)");
}

}  // namespace
}  // namespace afx
