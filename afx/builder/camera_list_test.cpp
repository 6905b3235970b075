// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/camera_list.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <string>

namespace afx {
namespace {

Result<std::vector<Shot>> read(const std::string& json) {
  return read_camera_list({reinterpret_cast<const uint8_t*>(json.data()), json.size()}, {});
}

std::string camera(const std::string& more = "", const std::string& width = "64") {
  return R"({"cameras": [{"position": [1, 2, 3], "fieldOfView": [4, 2], "nearPlane": 1,
 "farPlane": 5, "width": )" +
         width + R"(, "height": 32)" + more + "}]}";
}

TEST(CameraList, ReadsTheFieldsOfDepthImages) {
  const auto shots = read(camera(R"(, "orientation": [0, 1, 0, 1.5], "orthographic": true)"));
  ASSERT_TRUE(shots.ok()) << shots.error().text;
  ASSERT_EQ(shots.value().size(), 1U);
  const Shot& shot = shots.value()[0];
  EXPECT_EQ(shot.width, 64U);
  EXPECT_EQ(shot.height, 32U);
  EXPECT_EQ(shot.camera.position, glm::dvec3(1, 2, 3));
  const glm::dquat turned = glm::angleAxis(1.5, glm::dvec3(0, 1, 0));
  EXPECT_NEAR(glm::dot(shot.camera.orientation, turned), 1, 1e-12);
  EXPECT_TRUE(shot.camera.orthographic);
  EXPECT_EQ(shot.camera.field_of_view, glm::dvec2(4, 2));
  EXPECT_EQ(shot.camera.far_plane, 5);
}

TEST(CameraList, OrientationAndOrthographicHaveTheNodesDefaults) {
  const auto shots = read(camera());
  ASSERT_TRUE(shots.ok()) << shots.error().text;
  EXPECT_EQ(shots.value()[0].camera.orientation, glm::dquat(1, 0, 0, 0));
  EXPECT_TRUE(shots.value()[0].camera.orthographic);
}

TEST(CameraList, ErrorsNameTheMember) {
  const auto error_of = [](const std::string& json) {
    const auto shots = read(json);
    return shots.ok() ? std::string("ok") : to_string(shots.error());
  };
  EXPECT_EQ(error_of("{\n  \"cameras\": [}"), "2:15: this is not JSON");
  EXPECT_EQ(error_of("[]"), "has no list named cameras");
  EXPECT_EQ(error_of(R"({"cameras": []})"), "has 0 cameras (expected 1 to 255)");
  EXPECT_EQ(error_of(R"({"cameras": [7]})"), "cameras[0] is not an object");
  EXPECT_EQ(error_of(R"({"cameras": [{}]})"), "cameras[0].position is missing");
  EXPECT_EQ(error_of(camera(R"(, "orientation": [0, 1, 0])")),
            "cameras[0].orientation is not a list of 4 numbers");
  EXPECT_EQ(error_of(camera(R"(, "ortographic": true)")), "cameras[0].ortographic is not known");
  EXPECT_EQ(error_of(camera("", "0")), "cameras[0].width is 0 (expected 1 to 65535)");
  EXPECT_EQ(error_of(camera("", "0.5")), "cameras[0].width is not a whole number");
  EXPECT_EQ(error_of(camera(R"(, "orthographic": false)")),
            "cameras[0]: field fieldOfView is 4 (expected less than pi in perspective)");
}

}  // namespace
}  // namespace afx
