// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/depth_camera.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <sstream>
#include <string>

#include "afx/node_rotation.h"

namespace afx {
namespace {

Error bad_field(const char* field, double value, const std::string& expected) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "field " << field << " is " << value << " (expected " << expected << ")";
  return {Errc::bad_argument, Place::none(), text.str()};
}

bool is_finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Rounds to single precision. By way of memory: g++ 12 leaves the rounding of two neighbours out
// where it sees both conversions (at -O2, by its superword vectorizer).
double as_float(double value) {
  const volatile auto rounded = static_cast<float>(value);
  return static_cast<double>(rounded);
}

nodes::Rotation as_float(nodes::Rotation r) {
  for (float* part : {&r.x, &r.y, &r.z, &r.angle})
    *part = static_cast<float>(as_float(static_cast<double>(*part)));
  return r;
}

}  // namespace

Status check_depth_camera(const DepthCamera& camera) {
  if (!is_finite(camera.position))
    return Error{Errc::bad_argument, Place::none(), "field position is not finite"};
  const double length = glm::dot(camera.orientation, camera.orientation);
  if (!std::isfinite(length) || !(length > 0))
    return Error{Errc::bad_argument, Place::none(), "field orientation is not a rotation"};
  for (const double side : {camera.field_of_view.x, camera.field_of_view.y}) {
    if (!std::isfinite(side) || !(side > 0)) return bad_field("fieldOfView", side, "more than 0");
    if (!camera.orthographic && !(side < glm::pi<double>()))
      return bad_field("fieldOfView", side, "less than pi in perspective");
  }
  const double near = camera.near_plane, far = camera.far_plane;
  if (!std::isfinite(near) || near < 0) return bad_field("nearPlane", near, "0 or more");
  if (!camera.orthographic && near == 0)
    return bad_field("nearPlane", near, "more than 0 in perspective");
  if (!std::isfinite(far) || !(far > near))
    return bad_field("farPlane", far, "more than nearPlane");
  return {};
}

DepthCamera as_in_node(const DepthCamera& camera) {
  DepthCamera written = camera;
  for (int axis = 0; axis < 3; ++axis) written.position[axis] = as_float(camera.position[axis]);
  written.orientation = quaternion_of<double>(as_float(rotation_of(camera.orientation)));
  written.field_of_view = {as_float(camera.field_of_view.x), as_float(camera.field_of_view.y)};
  written.near_plane = as_float(camera.near_plane);
  written.far_plane = as_float(camera.far_plane);
  return written;
}

CameraProjection::CameraProjection(const DepthCamera& camera)
    : orthographic_(camera.orthographic),
      position_(camera.position),
      axes_(glm::mat3_cast(glm::normalize(camera.orientation))),
      extent_(camera.orthographic ? camera.field_of_view
                                  : 2.0 * glm::dvec2(std::tan(camera.field_of_view.x / 2),
                                                     std::tan(camera.field_of_view.y / 2))) {}

glm::dvec3 CameraProjection::point(const ScreenPoint& at) const {
  const glm::dvec2 size = extent(at.distance);
  return axes_ * glm::dvec3((at.u - 0.5) * size.x, (at.v - 0.5) * size.y, -at.distance) + position_;
}

glm::dvec3 CameraProjection::to_camera(const glm::dvec3& point) const {
  return (point - position_) * axes_;  // the transposed axes times the vector
}

ScreenPoint CameraProjection::project(const glm::dvec3& point) const {
  const glm::dvec3 seen = to_camera(point);
  const glm::dvec2 size = extent(-seen.z);
  return {seen.x / size.x + 0.5, seen.y / size.y + 0.5, -seen.z};
}

glm::dvec3 CameraProjection::towards_viewer(const glm::dvec3& point) const {
  return orthographic_ ? axes_[2] : glm::normalize(position_ - point);
}

double depth_to_distance(uint64_t depth, uint64_t dmax, const DepthCamera& camera) {
  if (dmax <= 1) return camera.near_plane;
  const double part =
      static_cast<double>(std::max<uint64_t>(depth, 1) - 1) / static_cast<double>(dmax - 1);
  return camera.near_plane + (1 - part) * (camera.far_plane - camera.near_plane);
}

uint64_t distance_to_depth(double distance, uint64_t dmax, const DepthCamera& camera) {
  const double range = camera.far_plane - camera.near_plane;
  const double part = 1 - (distance - camera.near_plane) / range;  // 0 far .. 1 near
  if (dmax <= 1) return part >= 0 && part <= 1 ? 1 : 0;
  const double step = std::round(part * static_cast<double>(dmax - 1));
  if (!(step >= 0) || step > static_cast<double>(dmax - 1)) return 0;
  return static_cast<uint64_t>(step) + 1;
}

}  // namespace afx
