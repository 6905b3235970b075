// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/render_camera.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <span>
#include <utility>

#include "tools/revolution.h"
#include "tools/scene_viewpoints.h"

namespace afx::tools {
namespace {

/// "1,2.5,-3": finite numbers, as many as there is room for.
bool parse_numbers(const std::string& text, std::span<double> numbers) {
  const char* at = text.data();
  const char* const end = at + text.size();
  for (size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0 && (at == end || *at++ != ',')) return false;
    const auto parsed = std::from_chars(at, end, numbers[i]);
    if (parsed.ec != std::errc() || !std::isfinite(numbers[i])) return false;
    at = parsed.ptr;
  }
  return at == end;
}

/// 0, 0, 0 where it is not given.
glm::dvec3 vector_of(const std::string& text) {
  double numbers[3] = {};
  parse_numbers(text, numbers);
  return {numbers[0], numbers[1], numbers[2]};
}

glm::dvec3 up_of(const CameraOptions& options) {
  return options.up.empty() ? glm::dvec3(0, 1, 0) : vector_of(options.up);
}

/// Whether a camera at one point can look at another with that way up.
bool can_look(const glm::dvec3& from, const glm::dvec3& at, const glm::dvec3& up) {
  const double ahead = glm::length(at - from), across = glm::length(glm::cross(at - from, up));
  return ahead > 0 && across > 1e-9 * ahead * glm::length(up);
}

glm::dquat look(const glm::dvec3& from, const glm::dvec3& at, const glm::dvec3& up) {
  const glm::dvec3 back = glm::normalize(from - at);
  const glm::dvec3 right = glm::normalize(glm::cross(up, back));
  return glm::quat_cast(glm::dmat3(right, glm::cross(back, right), back));
}

/// The first option that has a value without effect beside another; empty: none.
std::string useless_beside(const CameraOptions& options) {
  const bool by_number = !options.position.empty(), by_name = !options.viewpoint.empty();
  const std::string way = by_number ? "--position" : by_name ? "--viewpoint" : "";
  if (!way.empty()) {
    if (options.azimuth) return "--azimuth has no effect beside " + way;
    if (options.elevation) return "--elevation has no effect beside " + way;
    if (options.margin) return "--margin has no effect beside " + way;
  }
  if (by_number && by_name) return "--position and --viewpoint exclude each other";
  if (by_name && options.orthographic) return "--orthographic has no effect beside --viewpoint";
  if (!by_number) {
    if (!options.look_at.empty()) return "--look-at needs --position";
    if (!options.orientation.empty()) return "--orientation needs --position";
    if (!options.up.empty()) return "--up needs --position";
    if (options.view_height) return "--view-height needs --position";
  }
  if (!options.orientation.empty()) {
    if (!options.look_at.empty()) return "--look-at and --orientation exclude each other";
    if (!options.up.empty()) return "--up has no effect beside --orientation";
  }
  return {};
}

std::string wrong_vector(const char* name, const std::string& text, size_t count,
                         const char* expected) {
  double numbers[4] = {};
  if (text.empty() || parse_numbers(text, {numbers, count})) return {};
  return std::string(name) + " is " + text + " (expected " + expected + ")";
}

std::string wrong_projection(const CameraOptions& options) {
  if (options.orthographic && options.field_of_view)
    return "--fov has no effect beside --orthographic";
  if (!options.orthographic && options.view_height) return "--view-height needs --orthographic";
  if (options.orthographic && !options.position.empty() && !options.view_height)
    return "--orthographic by --position needs --view-height";
  return {};
}

/// Whether --look-at and --up leave the camera's directions open.
std::string wrong_directions(const CameraOptions& options) {
  const glm::dvec3 up = up_of(options);
  if (!(glm::length(up) > 0)) return "--up is 0,0,0 (expected a direction)";
  if (!options.look_at.empty() &&
      !can_look(vector_of(options.position), vector_of(options.look_at), up))
    return "--look-at is straight above or below --position, or is that point (expected another "
           "--up or --look-at)";
  return {};
}

render::View view_of(const CameraOptions& options) {
  render::View view;
  if (options.azimuth) view.azimuth = glm::radians(*options.azimuth);
  if (options.elevation) view.elevation = glm::radians(*options.elevation);
  if (options.field_of_view) view.field_of_view = glm::radians(*options.field_of_view);
  if (options.margin) view.margin = *options.margin;
  if (options.orthographic) view.projection = render::Projection::orthographic;
  return view;
}

glm::dvec3 middle_of(const std::vector<glm::dvec3>& outline) {
  if (outline.empty()) return glm::dvec3(0);
  glm::dvec3 low = outline[0], high = outline[0];
  for (const glm::dvec3& point : outline) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  return (low + high) / 2.0;
}

/// A hundredth of the nearest point's distance, as fit_camera takes; something small if the camera
/// stands in between.
double fitting_near_plane(const std::vector<glm::dvec3>& outline, const render::Camera& camera) {
  constexpr double kLeast = 1e-5;  // of the farthest point's distance
  const glm::dvec3 ahead = camera.orientation * glm::dvec3(0, 0, -1);
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
  for (const glm::dvec3& point : outline) {
    const double distance = glm::dot(point - camera.position, ahead);
    nearest = std::min(nearest, distance);
    farthest = std::max(farthest, distance);
  }
  if (!(farthest > 0)) return render::Camera().near_plane;
  return std::max(nearest / 100, farthest * kLeast);
}

/// From a Viewpoint, whose angle is that of the picture's shorter side.
void place_at(const Viewpoint& viewpoint, double aspect, render::Camera& camera) {
  camera.position = viewpoint.position;
  camera.orientation = viewpoint.orientation;
  const double slope = std::tan(viewpoint.field_of_view / 2);
  camera.field_of_view = 2 * std::atan(aspect < 1 ? slope / aspect : slope);
}

int place_by_numbers(const CameraOptions& options, const Sight& sight, const Session& session,
                     render::Camera& camera) {
  camera.position = vector_of(options.position);
  if (options.orthographic) camera.projection = render::Projection::orthographic;
  if (options.view_height) camera.view_height = *options.view_height;
  if (!options.orientation.empty()) {
    double numbers[4] = {};
    parse_numbers(options.orientation, numbers);
    const glm::dvec3 axis(numbers[0], numbers[1], numbers[2]);
    camera.orientation = glm::length(axis) > 0 ? glm::angleAxis(numbers[3], glm::normalize(axis))
                                               : glm::dquat(1, 0, 0, 0);
    return kDone;
  }
  const glm::dvec3 at = turning_point(options, sight);
  if (!can_look(camera.position, at, up_of(options)))
    return session.usage(
        "--position is straight above or below the model's middle, or there "
        "(expected --look-at, --up or --orientation)");
  camera.orientation = look(camera.position, at, up_of(options));
  return kDone;
}

/// Fitted to all that turns; from the front, where its outline is the same to the left and right,
/// so that the camera looks straight at the axis.
Result<render::Camera> fit_ring(const CameraOptions& options, const Sight& sight, double aspect) {
  const glm::dvec3 around = turning_point(options, sight);
  render::View view = view_of(options);
  const double azimuth = std::exchange(view.azimuth, 0);
  const auto camera = render::fit_camera(revolution_outline(sight.outline, around), view, aspect);
  if (!camera.ok()) return camera.error();
  return turned_camera(camera.value(), around, azimuth);
}

}  // namespace

std::string wrong_camera_option(const CameraOptions& options) {
  constexpr const char* kPlace = "X,Y,Z";
  for (const std::string& wrong :
       {wrong_vector("--position", options.position, 3, kPlace),
        wrong_vector("--look-at", options.look_at, 3, kPlace),
        wrong_vector("--up", options.up, 3, kPlace),
        wrong_vector("--orientation", options.orientation, 4, "AX,AY,AZ,ANGLE"),
        useless_beside(options), wrong_projection(options), wrong_directions(options)})
    if (!wrong.empty()) return wrong;
  return {};
}

int choose_camera(const CameraOptions& options, const Sight& sight, double aspect, bool ring,
                  const Session& session, const std::string& input, render::Camera& camera) {
  if (options.is_fitted()) {
    const auto fitted = ring ? fit_ring(options, sight, aspect)
                             : render::fit_camera(sight.outline, view_of(options), aspect);
    if (!fitted.ok()) return session.fail(fitted.error(), input);
    camera = fitted.value();
  } else if (!options.viewpoint.empty()) {
    const auto viewpoint = pick_viewpoint(sight.viewpoints, options.viewpoint);
    if (!viewpoint.ok()) return session.usage(to_string(viewpoint.error(), input));
    place_at(sight.viewpoints[viewpoint.value()], aspect, camera);
  } else {
    camera.field_of_view = render::View().field_of_view;
    if (const int code = place_by_numbers(options, sight, session, camera); code != kDone)
      return code;
  }
  if (!options.is_fitted()) {
    if (options.field_of_view) camera.field_of_view = glm::radians(*options.field_of_view);
    camera.near_plane = fitting_near_plane(sight.outline, camera);
  }
  if (options.near_plane) camera.near_plane = *options.near_plane;
  const Status right = render::check_camera(camera);
  if (right.ok()) return kDone;
  const bool asked = !options.position.empty() || options.near_plane;
  return session.fail_query(right.error(), asked, input);
}

glm::dvec3 turning_point(const CameraOptions& options, const Sight& sight) {
  return options.look_at.empty() ? middle_of(sight.outline) : vector_of(options.look_at);
}

render::Camera turned_camera(const render::Camera& camera, const glm::dvec3& around, double angle) {
  const glm::dquat turn = glm::angleAxis(angle, glm::dvec3(0, 1, 0));
  render::Camera turned = camera;
  turned.position = around + turn * (camera.position - around);
  turned.orientation = turn * camera.orientation;
  return turned;
}

nlohmann::ordered_json json_of(const render::Camera& camera) {
  const glm::dvec3& at = camera.position;
  const glm::dvec3 axis = glm::axis(camera.orientation);
  nlohmann::ordered_json json;
  json["position"] = {at.x, at.y, at.z};
  json["orientation"] = {axis.x, axis.y, axis.z, glm::angle(camera.orientation)};
  if (camera.projection == render::Projection::orthographic) {
    json["viewHeight"] = camera.view_height;
  } else {
    json["fov"] = glm::degrees(camera.field_of_view);
  }
  json["near"] = camera.near_plane;
  return json;
}

}  // namespace afx::tools
