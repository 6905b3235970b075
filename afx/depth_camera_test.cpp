// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/depth_camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <limits>

namespace afx {
namespace {

DepthCamera orthographic() { return {{1, 2, 3}, {1, 0, 0, 0}, true, {4, 2}, 1, 5}; }

// A quarter turn about +y: the camera looks along -x, its right hand is -z.
DepthCamera turned() {
  DepthCamera camera = orthographic();
  camera.orientation = glm::angleAxis(glm::half_pi<double>(), glm::dvec3(0, 1, 0));
  return camera;
}

TEST(DepthCamera, AnOrthographicPixelIsOffsetByItsPartOfTheViewBox) {
  const glm::dvec3 p = CameraProjection(orthographic()).point({0.75, 0.25, 2});
  EXPECT_NEAR(glm::distance(p, glm::dvec3(1 + 0.25 * 4, 2 - 0.25 * 2, 3 - 2)), 0, 1e-12);
}

TEST(DepthCamera, APerspectivePixelLiesOnItsRayAtTheDistanceToThePlane) {
  DepthCamera camera = orthographic();
  camera.orthographic = false;
  camera.field_of_view = {glm::half_pi<double>(), 2 * std::atan(0.5)};  // half widths 1 and 0.5
  const glm::dvec3 p = CameraProjection(camera).point({1, 1, 2});
  EXPECT_NEAR(glm::distance(p, glm::dvec3(1 + 2, 2 + 1, 3 - 2)), 0, 1e-12);
}

TEST(DepthCamera, OrientationTurnsTheView) {
  const glm::dvec3 p = CameraProjection(turned()).point({1, 0.5, 2});  // 2 to the right: -z
  EXPECT_NEAR(glm::distance(p, glm::dvec3(1 - 2, 2, 3 - 2)), 0, 1e-12);
  EXPECT_NEAR(glm::distance(CameraProjection(turned()).towards_viewer(p), glm::dvec3(1, 0, 0)), 0,
              1e-12);
}

TEST(DepthCamera, ProjectingAPointGivesItsPixelBack) {
  DepthCamera camera = turned();
  for (const bool parallel : {true, false}) {
    camera.orthographic = parallel;
    camera.field_of_view = {0.9, 1.3};
    const CameraProjection projection(camera);
    const ScreenPoint seen = projection.project(projection.point({0.3, 0.9, 3.5}));
    EXPECT_NEAR(seen.u, 0.3, 1e-12);
    EXPECT_NEAR(seen.v, 0.9, 1e-12);
    EXPECT_NEAR(seen.distance, 3.5, 1e-12);
  }
}

TEST(DepthCamera, DepthOneIsTheFarPlaneAndTheLargestTheNearPlane) {
  const DepthCamera camera = orthographic();
  EXPECT_DOUBLE_EQ(depth_to_distance(1, 255, camera), 5);
  EXPECT_DOUBLE_EQ(depth_to_distance(255, 255, camera), 1);
  EXPECT_DOUBLE_EQ(depth_to_distance(128, 255, camera), 3);  // (128 - 1)/254 = 1/2
  EXPECT_DOUBLE_EQ(depth_to_distance(1, 1, camera), 1);      // one bit: the near plane
}

TEST(DepthCamera, EveryDepthComesBackFromItsDistance) {
  const DepthCamera camera = as_in_node(orthographic());
  for (const uint64_t dmax : {uint64_t{1}, uint64_t{3}, uint64_t{255}, uint64_t{65535}})
    for (uint64_t d = 1; d <= dmax; ++d)
      ASSERT_EQ(distance_to_depth(depth_to_distance(d, dmax, camera), dmax, camera), d) << dmax;
  const uint64_t most = 0xFFFFFFFF;
  for (const uint64_t d : {uint64_t{1}, uint64_t{2}, most / 3, most - 1, most})
    EXPECT_EQ(distance_to_depth(depth_to_distance(d, most, camera), most, camera), d);
}

TEST(DepthCamera, DistancesOutsideThePlanesHaveNoDepth) {
  const DepthCamera camera = orthographic();  // one step is 4/254
  EXPECT_EQ(distance_to_depth(1 - 0.4 * 4 / 254, 255, camera), 255U);
  EXPECT_EQ(distance_to_depth(1 - 0.6 * 4 / 254, 255, camera), 0U);
  EXPECT_EQ(distance_to_depth(5 + 0.4 * 4 / 254, 255, camera), 1U);
  EXPECT_EQ(distance_to_depth(5 + 0.6 * 4 / 254, 255, camera), 0U);
  EXPECT_EQ(distance_to_depth(std::nan(""), 255, camera), 0U);
}

TEST(DepthCamera, ANodeHoldsTheCameraInSinglePrecision) {
  DepthCamera camera = orthographic();
  camera.orientation = glm::angleAxis(1.1, glm::normalize(glm::dvec3(1, 2, 3)));
  camera.position = {0.1, 0.2, 0.3};
  const DepthCamera once = as_in_node(camera);
  EXPECT_EQ(once.position, glm::dvec3(0.1F, 0.2F, 0.3F));
  EXPECT_NEAR(glm::dot(once.orientation, camera.orientation), 1, 1e-12);
}

TEST(DepthCamera, ErrorsNameTheField) {
  const auto text_of = [](const DepthCamera& camera) {
    const Status status = check_depth_camera(camera);
    return status.ok() ? std::string("ok") : status.error().text;
  };
  EXPECT_EQ(text_of(orthographic()), "ok");
  DepthCamera camera = orthographic();
  camera.field_of_view.y = 0;
  EXPECT_EQ(text_of(camera), "field fieldOfView is 0 (expected more than 0)");
  camera = orthographic();
  camera.orthographic = false;
  camera.field_of_view.x = 4;
  EXPECT_EQ(text_of(camera), "field fieldOfView is 4 (expected less than pi in perspective)");
  camera.field_of_view.x = 1;
  camera.near_plane = 0;
  EXPECT_EQ(text_of(camera), "field nearPlane is 0 (expected more than 0 in perspective)");
  camera = orthographic();
  camera.far_plane = camera.near_plane;
  EXPECT_EQ(text_of(camera), "field farPlane is 1 (expected more than nearPlane)");
  camera = orthographic();
  camera.orientation = {0, 0, 0, 0};
  EXPECT_EQ(text_of(camera), "field orientation is not a rotation");
  camera = orthographic();
  camera.position.z = std::numeric_limits<double>::infinity();
  EXPECT_EQ(text_of(camera), "field position is not finite");
}

}  // namespace
}  // namespace afx
