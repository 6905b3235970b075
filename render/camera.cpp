// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace afx::render {
namespace {

constexpr double kLeastAngle = 1e-6;  // of a field of view
constexpr double kMostAngle = std::numbers::pi - 1e-6;

Error bad(const std::string& what, double value, const std::string& expected) {
  return {Errc::bad_argument, Place::none(),
          what + " is " + std::to_string(value) + " (expected " + expected + ")"};
}

bool is_finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool in_range(double value, double least, double most) { return value >= least && value <= most; }

Status check_angle(double angle) {
  if (in_range(angle, kLeastAngle, kMostAngle)) return {};
  return bad("field of view", angle, "more than 0 and less than pi");
}

Status check_view(const View& view, double aspect) {
  if (!std::isfinite(view.azimuth)) return bad("azimuth", view.azimuth, "a finite angle");
  if (!in_range(view.elevation, -std::numbers::pi / 2, std::numbers::pi / 2)) {
    return bad("elevation", view.elevation, "-pi/2 to pi/2");
  }
  if (!in_range(view.margin, 0, 0.45)) return bad("margin", view.margin, "0 to 0.45");
  if (!in_range(aspect, 1e-5, 1e5)) return bad("aspect", aspect, "width / height of a picture");
  if (view.projection == Projection::perspective) return check_angle(view.field_of_view);
  return {};
}

/// Turned to the right by the azimuth, then up by the elevation.
glm::dquat orientation_of(const View& view) {
  return glm::angleAxis(view.azimuth, glm::dvec3(0, 1, 0)) *
         glm::angleAxis(-view.elevation, glm::dvec3(1, 0, 0));
}

std::vector<glm::dvec3> unit_cube() {
  std::vector<glm::dvec3> corners;
  for (unsigned k = 0; k < 8; ++k) {
    corners.emplace_back((k & 1U) - 0.5, (k >> 1U & 1U) - 0.5, (k >> 2U) - 0.5);
  }
  return corners;
}

/// The largest of points' x, y and z after a change, and so on: how far they reach.
struct Reach {
  double right = -std::numeric_limits<double>::infinity();
  double left = right, up = right, down = right, front = right, back = right;
};

/// Reaches of the points in the camera's axes; the sides lean by `tan_x`, `tan_y` (0: upright), so
/// that a plane of that slope which just touches all points meets the axis z = 0 at the reach.
Reach reach(std::span<const glm::dvec3> points, const glm::dquat& orientation, double tan_x,
            double tan_y) {
  Reach r;
  const glm::dquat to_view = glm::conjugate(orientation);
  for (const glm::dvec3& point : points) {
    const glm::dvec3 p = to_view * point;
    r.right = std::max(r.right, p.x + tan_x * p.z);
    r.left = std::max(r.left, -p.x + tan_x * p.z);
    r.up = std::max(r.up, p.y + tan_y * p.z);
    r.down = std::max(r.down, -p.y + tan_y * p.z);
    r.front = std::max(r.front, p.z);
    r.back = std::max(r.back, -p.z);
  }
  return r;
}

/// Two planes of slope 1 / tan that lean towards each other meet at z = (a + b) / (2 tan): the eye
/// may not be nearer, and is not further than the wider of both pairs asks.
void fit_perspective(std::span<const glm::dvec3> points, const View& view, double aspect,
                     Camera& camera) {
  const double tan_y = std::tan(view.field_of_view / 2) * (1 - 2 * view.margin);
  const double tan_x = tan_y * aspect;
  const Reach r = reach(points, camera.orientation, tan_x, tan_y);
  const double depth = r.front + r.back;
  // Points without extent would let the eye touch them.
  const double least = r.front + std::max(1e-3 * depth, 1e-9);
  const double z =
      std::max({(r.right + r.left) / (2 * tan_x), (r.up + r.down) / (2 * tan_y), least});
  camera.position = camera.orientation * glm::dvec3((r.right - r.left) / 2, (r.up - r.down) / 2, z);
  camera.near_plane = (z - r.front) / 100;
}

void fit_orthographic(std::span<const glm::dvec3> points, const View& view, double aspect,
                      Camera& camera) {
  const Reach r = reach(points, camera.orientation, 0, 0);
  const double height = std::max((r.up + r.down), (r.right + r.left) / aspect);
  camera.view_height = std::max(height, 1e-9) / (1 - 2 * view.margin);
  const double distance = std::max({r.front + r.back, camera.view_height, 1e-9});
  camera.position = camera.orientation *
                    glm::dvec3((r.right - r.left) / 2, (r.up - r.down) / 2, r.front + distance);
  camera.near_plane = distance / 100;
}

}  // namespace

Status check_camera(const Camera& camera) {
  if (!is_finite(camera.position)) return bad("camera position", NAN, "finite numbers");
  const double length = glm::dot(camera.orientation, camera.orientation);
  if (!std::isfinite(length) || !(length > 0)) {
    return bad("length of the camera's orientation", length, "a rotation");
  }
  if (!(camera.near_plane > 0) || !std::isfinite(camera.near_plane)) {
    return bad("near plane", camera.near_plane, "a distance > 0");
  }
  if (camera.projection == Projection::perspective) return check_angle(camera.field_of_view);
  if (!(camera.view_height > 0) || !std::isfinite(camera.view_height)) {
    return bad("view height", camera.view_height, "a length > 0");
  }
  return {};
}

Result<Camera> fit_camera(std::span<const glm::dvec3> points, const View& view, double aspect) {
  if (const Status s = check_view(view, aspect); !s.ok()) return s.error();
  if (!std::all_of(points.begin(), points.end(), is_finite)) {
    return bad("a point to fit the camera to", NAN, "finite numbers");
  }
  const std::vector<glm::dvec3> cube = unit_cube();
  if (points.empty()) points = cube;
  Camera camera;
  camera.orientation = orientation_of(view);
  camera.projection = view.projection;
  camera.field_of_view = view.field_of_view;
  if (view.projection == Projection::perspective) {
    fit_perspective(points, view, aspect, camera);
  } else {
    fit_orthographic(points, view, aspect, camera);
  }
  if (const Status s = check_camera(camera); !s.ok()) return s.error();  // absurdly far points
  return camera;
}

}  // namespace afx::render
