// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/viewer/orbit_camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

namespace afx::tools {
namespace {

constexpr double kPi = std::numbers::pi;
const glm::dvec2 kSize(800, 600);
const Ball kScene{{1, 2, 3}, 2};

OrbitCamera some_camera(render::Projection projection = render::Projection::perspective) {
  OrbitCamera camera;
  camera.target = {1, 2, 3};
  camera.distance = 5;
  camera.azimuth = 0.7;
  camera.elevation = 0.4;
  camera.projection = projection;
  return camera;
}

/// Where a point is seen, by the definition of the camera.
glm::dvec2 place_of(const OrbitCamera& camera, const glm::dvec3& point) {
  const render::Camera c = camera_for_drawing(camera, kScene);
  const glm::dvec3 p = glm::conjugate(c.orientation) * (point - c.position);
  const double half = c.projection == render::Projection::perspective
                          ? -p.z * std::tan(c.field_of_view / 2)
                          : c.view_height / 2;
  return kSize / 2.0 + glm::dvec2(p.x, -p.y) / half * (kSize.y / 2);
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double error = 1e-9) {
  EXPECT_LT(glm::length(a - b), error)
      << a.x << ' ' << a.y << ' ' << a.z << " instead of " << b.x << ' ' << b.y << ' ' << b.z;
}

void expect_near(const glm::dvec2& a, const glm::dvec2& b, double error = 1e-6) {
  expect_near(glm::dvec3(a, 0), glm::dvec3(b, 0), error);
}

constexpr auto kBoth = {render::Projection::perspective, render::Projection::orthographic};

TEST(OrbitCamera, StandsWhereItsAnglesSay) {
  OrbitCamera camera;
  camera.distance = 2;
  camera.azimuth = kPi / 2;
  camera.elevation = 0;
  expect_near(eye_of(camera), {2, 0, 0});
  camera.azimuth = 0;
  camera.elevation = kPi / 6;
  expect_near(eye_of(camera), {0, 1, std::sqrt(3.0)});
}

TEST(OrbitCamera, OrbitKeepsTheDistanceAndTheTargetInTheMiddle) {
  for (const auto projection : kBoth) {
    OrbitCamera camera = some_camera(projection);
    for (const glm::dvec2 drag : {glm::dvec2(30, 10), glm::dvec2(-200, 44), glm::dvec2(5, -300)}) {
      orbit(camera, drag, kSize.y);
      EXPECT_NEAR(glm::length(eye_of(camera) - camera.target), 5, 1e-9);
      expect_near(place_of(camera, {1, 2, 3}), kSize / 2.0);
    }
  }
}

TEST(OrbitCamera, DraggingRightShowsTheLeftSideDraggingDownTheTop) {
  OrbitCamera camera = some_camera();
  const OrbitCamera before = camera;
  orbit(camera, {60, 30}, kSize.y);
  EXPECT_NEAR(camera.azimuth, before.azimuth - kPi / 10, 1e-12);
  EXPECT_NEAR(camera.elevation, before.elevation + kPi / 20, 1e-12);
  // What is in front of the target moves with the mouse.
  const glm::dvec3 front = before.target + (eye_of(before) - before.target) * 0.2;
  EXPECT_GT(place_of(camera, front).x, place_of(before, front).x);
  EXPECT_GT(place_of(camera, front).y, place_of(before, front).y);
}

TEST(OrbitCamera, StopsAtThePoles) {
  OrbitCamera camera = some_camera();
  orbit(camera, {0, 5000}, kSize.y);
  EXPECT_DOUBLE_EQ(camera.elevation, kPi / 2);
  expect_near(eye_of(camera), {1, 7, 3});
  orbit(camera, {0, -50000}, kSize.y);
  EXPECT_DOUBLE_EQ(camera.elevation, -kPi / 2);
  expect_near(eye_of(camera), {1, -3, 3});
  expect_near(place_of(camera, camera.target), kSize / 2.0);
}

TEST(OrbitCamera, PanMovesThePictureByThePixelsDragged) {
  for (const auto projection : kBoth) {
    OrbitCamera camera = some_camera(projection);
    const glm::dvec3 aside = point_under(camera, {100, 450}, kSize, 5);
    expect_near(place_of(camera, aside), {100, 450});
    pan(camera, {37, -21}, kSize.y);
    expect_near(place_of(camera, {1, 2, 3}), {437, 279});
    expect_near(place_of(camera, aside), {137, 429});
  }
}

TEST(OrbitCamera, ZoomKeepsThePointUnderTheCursor) {
  for (const auto projection : kBoth) {
    for (const double distance : {5.0, 3.2}) {  // the target's, and nearer
      OrbitCamera camera = some_camera(projection);
      const glm::dvec3 point = point_under(camera, {610, 90}, kSize, distance);
      expect_near(place_of(camera, point), {610, 90});
      zoom(camera, 0.6, point, kScene);
      EXPECT_NEAR(camera.distance, 3, 1e-12);
      expect_near(place_of(camera, point), {610, 90});
    }
  }
}

TEST(OrbitCamera, ZoomEndsAtItsLimits) {
  OrbitCamera camera = some_camera();
  for (int i = 0; i < 100; ++i) zoom(camera, 0.1, {1, 2, 3}, kScene);
  EXPECT_NEAR(camera.distance, 2e-4, 1e-12);
  for (int i = 0; i < 100; ++i) zoom(camera, 10, {1, 2, 3}, kScene);
  EXPECT_NEAR(camera.distance, 2e3, 1e-6);
  expect_near(camera.target, {1, 2, 3});
}

TEST(OrbitCamera, FlyMovesAlongTheView) {
  OrbitCamera camera = some_camera();
  const glm::dvec3 eye = eye_of(camera);
  const glm::dvec3 ahead = glm::normalize(camera.target - eye);
  fly(camera, {0, 0, 1.5});
  expect_near(eye_of(camera), eye + ahead * 1.5);
  EXPECT_DOUBLE_EQ(camera.distance, 5);
  fly(camera, {0.5, 0, 0});
  EXPECT_NEAR(glm::dot(eye_of(camera) - eye, ahead), 1.5, 1e-9);
  EXPECT_NEAR(eye_of(camera).y, eye.y + ahead.y * 1.5, 1e-9);  // right is level
}

TEST(OrbitCamera, LookTurnsTheHeadAndThePictureFollowsTheMouse) {
  OrbitCamera camera = some_camera();
  const glm::dvec3 eye = eye_of(camera);
  look(camera, {3, -2}, kSize.y);
  expect_near(eye_of(camera), eye);
  expect_near(place_of(camera, {1, 2, 3}), {403, 298}, 0.1);
}

TEST(OrbitCamera, BothProjectionsShowTheTargetAtTheSameSize) {
  const OrbitCamera perspective = some_camera();
  const OrbitCamera parallel = some_camera(render::Projection::orthographic);
  const glm::dvec3 aside = point_under(perspective, {700, 50}, kSize, 5);
  expect_near(place_of(perspective, aside), {700, 50});
  expect_near(place_of(parallel, aside), {700, 50});
}

TEST(OrbitCamera, TakesAnyPlaceAndOrientation) {
  const glm::dquat rolled = glm::angleAxis(2.0, glm::normalize(glm::dvec3(3, -1, 2)));
  const glm::dquat down =
      glm::angleAxis(0.9, glm::dvec3(0, 1, 0)) * glm::angleAxis(-kPi / 2, glm::dvec3(1, 0, 0));
  for (const glm::dquat& orientation : {rolled, down}) {
    OrbitCamera camera;
    place(camera, {4, 5, 6}, orientation, kScene);
    expect_near(eye_of(camera), {4, 5, 6});
    for (const glm::dvec3 axis : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)})
      expect_near(orientation_of(camera) * axis, orientation * axis, 1e-6);
  }
}

TEST(OrbitCamera, ARollDiesAwayByOrbiting) {
  OrbitCamera camera = some_camera();
  camera.roll = 1;
  orbit(camera, {kSize.y, 0}, kSize.y);
  EXPECT_NEAR(camera.roll, std::exp(-3 * kPi), 1e-3);
}

TEST(OrbitCamera, ANewCentreIsInTheMiddleAsLargeAsBefore) {
  OrbitCamera camera = some_camera();
  const glm::dvec3 point = point_under(camera, {200, 200}, kSize, 4);
  centre_on(camera, point);
  expect_near(place_of(camera, point), kSize / 2.0);
  EXPECT_NEAR(camera.distance, 4, 1e-9);
}

TEST(OrbitCamera, FitShowsAllPointsAndTouchesTheMargin) {
  std::vector<glm::dvec3> corners;
  for (unsigned k = 0; k < 8; ++k)
    corners.emplace_back(k & 1U, 1 + 2.0 * (k >> 1U & 1U), 2.0 + (k >> 2U));
  for (const auto projection : kBoth) {
    OrbitCamera camera = some_camera(projection);
    fit(camera, corners, kSize.x / kSize.y);
    double top = kSize.y, bottom = 0;
    for (const glm::dvec3& corner : corners) {
      const glm::dvec2 at = place_of(camera, corner);
      EXPECT_GT(at.x, 0);
      EXPECT_LT(at.x, kSize.x);
      top = std::min(top, at.y);
      bottom = std::max(bottom, at.y);
    }
    EXPECT_NEAR(top, 0.05 * kSize.y, 0.5);
    EXPECT_NEAR(bottom, 0.95 * kSize.y, 0.5);
    EXPECT_DOUBLE_EQ(camera.azimuth, 0.7);
  }
}

TEST(OrbitCamera, NothingOfTheSceneIsNearerThanTheNearPlane) {
  for (const auto projection : kBoth) {
    OrbitCamera camera = some_camera(projection);
    for (const double distance : {0.01, 1.0, 2.5, 50.0}) {
      camera.distance = distance;
      const render::Camera drawn = camera_for_drawing(camera, kScene);
      EXPECT_TRUE(render::check_camera(drawn).ok());
      const double nearest = glm::length(drawn.position - kScene.centre) - kScene.radius;
      const bool outside = nearest > 0;
      EXPECT_TRUE(!outside || drawn.near_plane <= nearest) << distance;
      EXPECT_TRUE(outside || projection == render::Projection::perspective) << distance;
    }
  }
}

}  // namespace
}  // namespace afx::tools
