// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/viewer/orbit_camera.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

namespace afx::tools {
namespace {

constexpr double kPole = std::numbers::pi / 2;
constexpr double kLeastDistance = 1e-4;  // in radii of the scene
constexpr double kMostDistance = 1e3;

const glm::dvec3 kRight(1, 0, 0), kUp(0, 1, 0), kBack(0, 0, 1);

double slope(const OrbitCamera& camera) { return std::tan(camera.field_of_view / 2); }

double within_limits(double distance, const Ball& scene) {
  return std::clamp(distance, kLeastDistance * scene.radius, kMostDistance * scene.radius);
}

/// Adds to the angles; the more is turned the less is left of a roll.
void turn(OrbitCamera& camera, double azimuth, double elevation) {
  camera.azimuth = std::remainder(camera.azimuth + azimuth, 2 * std::numbers::pi);
  camera.elevation = std::clamp(camera.elevation + elevation, -kPole, kPole);
  camera.roll *= std::exp(-3 * (std::abs(azimuth) + std::abs(elevation)));
  if (std::abs(camera.roll) < 1e-3) camera.roll = 0;
}

/// The angles of an orientation. At a pole, where a turn and a roll are the same, it is a turn.
void set_orientation(OrbitCamera& camera, const glm::dquat& orientation) {
  const glm::dquat q = glm::normalize(orientation);
  const glm::dvec3 back = q * kBack;
  const glm::dvec3 right = q * kRight;
  camera.elevation = std::asin(std::clamp(back.y, -1.0, 1.0));
  camera.roll = 0;
  if (std::abs(back.y) > 1 - 1e-9) {
    camera.azimuth = std::atan2(-right.z, right.x);
    return;
  }
  camera.azimuth = std::atan2(back.x, back.z);
  const glm::dvec3 rolled = glm::conjugate(orientation_of(camera)) * right;
  camera.roll = std::atan2(rolled.y, rolled.x);
}

}  // namespace

Ball ball_of(std::span<const glm::dvec3> points) {
  if (points.empty()) return {};
  glm::dvec3 least = points.front(), most = points.front();
  for (const glm::dvec3& point : points) {
    least = glm::min(least, point);
    most = glm::max(most, point);
  }
  const double size = glm::length(most - least);
  return {(least + most) / 2.0, std::max(size / 2, 1e-9)};
}

glm::dquat orientation_of(const OrbitCamera& camera) {
  return glm::angleAxis(camera.azimuth, kUp) * glm::angleAxis(-camera.elevation, kRight) *
         glm::angleAxis(camera.roll, kBack);
}

glm::dvec3 eye_of(const OrbitCamera& camera) {
  return camera.target + orientation_of(camera) * (kBack * camera.distance);
}

double unit_per_pixel(const OrbitCamera& camera, double height) {
  return 2 * camera.distance * slope(camera) / height;
}

render::Camera camera_for_drawing(const OrbitCamera& camera, const Ball& scene) {
  render::Camera result;
  result.orientation = orientation_of(camera);
  result.projection = camera.projection;
  result.field_of_view = camera.field_of_view;
  result.view_height = 2 * camera.distance * slope(camera);
  const glm::dvec3 back = result.orientation * kBack;
  result.position = eye_of(camera);
  double nearest = glm::dot(result.position - scene.centre, back) - scene.radius;
  if (camera.projection == render::Projection::orthographic) {
    result.position += back * (scene.radius - nearest);
    nearest = scene.radius;
  }
  result.near_plane = std::max(nearest * 0.9, std::min(scene.radius, camera.distance) * 1e-3);
  return result;
}

glm::dvec3 point_under(const OrbitCamera& camera, const glm::dvec2& at, const glm::dvec2& size,
                       double distance) {
  const bool perspective = camera.projection == render::Projection::perspective;
  const double scale =
      unit_per_pixel(camera, size.y) * (perspective ? distance / camera.distance : 1);
  const glm::dvec2 off = (at - size / 2.0) * scale;
  return eye_of(camera) + orientation_of(camera) * glm::dvec3(off.x, -off.y, -distance);
}

void orbit(OrbitCamera& camera, const glm::dvec2& pixels, double height) {
  const double angle = std::numbers::pi / height;
  turn(camera, -pixels.x * angle, pixels.y * angle);
}

void pan(OrbitCamera& camera, const glm::dvec2& pixels, double height) {
  const double unit = unit_per_pixel(camera, height);
  camera.target += orientation_of(camera) * glm::dvec3(-pixels.x * unit, pixels.y * unit, 0);
}

void zoom(OrbitCamera& camera, double factor, const glm::dvec3& point, const Ball& scene) {
  const double distance = within_limits(camera.distance * factor, scene);
  camera.target = point + (camera.target - point) * (distance / camera.distance);
  camera.distance = distance;
}

void fly(OrbitCamera& camera, const glm::dvec3& step) {
  camera.target += orientation_of(camera) * glm::dvec3(step.x, step.y, -step.z);
}

void look(OrbitCamera& camera, const glm::dvec2& pixels, double height) {
  const glm::dvec3 eye = eye_of(camera);
  const double angle = 2 * slope(camera) / height;  // of a pixel in the middle
  // Towards a pole the circles of equal elevation become small.
  turn(camera, pixels.x * angle / std::max(std::cos(camera.elevation), 0.1), -pixels.y * angle);
  camera.target += eye - eye_of(camera);
}

void centre_on(OrbitCamera& camera, const glm::dvec3& point) {
  const glm::dvec3 back = orientation_of(camera) * kBack;
  const double ahead = glm::dot(eye_of(camera) - point, back);
  camera.target = point;
  // In parallel projection the distance is the height of the picture, which is to stay.
  if (camera.projection == render::Projection::perspective && ahead > 0) camera.distance = ahead;
}

void place(OrbitCamera& camera, const glm::dvec3& eye, const glm::dquat& orientation,
           const Ball& scene) {
  set_orientation(camera, orientation);
  const glm::dvec3 back = orientation_of(camera) * kBack;
  const double ahead = glm::dot(eye - scene.centre, back);
  camera.distance = within_limits(std::max(ahead, scene.radius * 0.05), scene);
  camera.target = eye - back * camera.distance;
}

void fit(OrbitCamera& camera, std::span<const glm::dvec3> points, double aspect) {
  camera.roll = 0;
  render::View view;
  view.azimuth = camera.azimuth;
  view.elevation = camera.elevation;
  view.projection = camera.projection;
  view.field_of_view = camera.field_of_view;
  const auto fitted = render::fit_camera(points, view, aspect);
  if (!fitted.ok()) return;  // a window without extent
  const Ball scene = ball_of(points);
  const glm::dvec3 back = orientation_of(camera) * kBack;
  const double ahead = glm::dot(fitted.value().position - scene.centre, back);
  camera.target = fitted.value().position - back * ahead;
  camera.distance = camera.projection == render::Projection::perspective
                        ? ahead
                        : fitted.value().view_height / (2 * slope(camera));
}

}  // namespace afx::tools
