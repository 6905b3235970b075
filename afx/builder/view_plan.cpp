// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/view_plan.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>
#include <utility>

#include "afx/builder/reference_cameras.h"

namespace afx {
namespace {

constexpr unsigned kDirections = 128;  // that are looked from, the six of the box among them
constexpr size_t kSamples = 100000;    // points on the surface
constexpr uint32_t kMeterResolution = 384;
constexpr double kWorthIt = 1.0 / 2000;  // of the visible points, for one more view
constexpr double kFlattest = 0.17;       // sine of 10 degrees
constexpr double kCameraDistance = 2;    // in perspective, from the middle, in longest sides
constexpr double kPad = 1.0 / 4096;      // of the depths: room for rounding to single precision

// The camera's right, up and back for a direction to the camera.
glm::dmat3 axes_towards(const glm::dvec3& direction) {
  const glm::dvec3 back = glm::normalize(direction);
  const double steep = std::abs(back.y);
  const glm::dvec3 up =
      steep < 0.9999 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, back.y > 0 ? -1 : 1);
  const glm::dvec3 right = glm::normalize(glm::cross(up, back));
  return {right, glm::cross(back, right), back};
}

uint32_t pixels_for(double length, double pixel) {
  return static_cast<uint32_t>(std::max(1.0, std::ceil(length / pixel - 1e-6)));
}

// The view box in the camera's system is `size` wide and high, around the middle of `box`.
Shot parallel_view(const Bounds& box, const glm::dmat3& axes, double side, double pixel) {
  const glm::dvec3 size = box.high - box.low;
  Shot shot;
  shot.width = pixels_for(size.x, pixel);
  shot.height = pixels_for(size.y, pixel);
  DepthCamera& camera = shot.camera;
  camera.orthographic = true;
  camera.field_of_view = {shot.width * pixel, shot.height * pixel};
  const double pad = std::max(size.z, pixel) * kPad;
  const glm::dvec3 middle = (box.low + box.high) / 2.0;
  camera.position = axes * glm::dvec3(middle.x, middle.y, box.high.z + side);
  camera.near_plane = side - pad;
  camera.far_plane = side + size.z + pad;
  return shot;
}

Shot perspective_view(const Bounds& box, const glm::dmat3& axes, double side, double pixel) {
  const glm::dvec3 size = box.high - box.low;
  const glm::dvec3 middle = (box.low + box.high) / 2.0;
  const double distance = size.z / 2 + kCameraDistance * side;  // of the middle
  const double nearest = distance - size.z / 2;
  Shot shot;
  DepthCamera& camera = shot.camera;
  camera.orthographic = false;
  // The front face of the box is seen under the widest angle.
  const glm::dvec2 slope = glm::dvec2(size) / 2.0 / nearest;
  shot.width = pixels_for(2 * slope.x * distance, pixel);
  shot.height = pixels_for(2 * slope.y * distance, pixel);
  camera.field_of_view = {2 * std::atan(shot.width * pixel / 2 / distance),
                          2 * std::atan(shot.height * pixel / 2 / distance)};
  const double pad = std::max(size.z, pixel) * kPad;
  camera.position = axes * (middle + glm::dvec3(0, 0, distance));
  camera.near_plane = nearest - pad;
  camera.far_plane = nearest + size.z + pad;
  return shot;
}

void add_to(std::vector<bool>& sum, const std::vector<bool>& more) {
  for (size_t i = 0; i < sum.size(); ++i)
    if (more[i]) sum[i] = true;
}

}  // namespace

double longest_side(const ViewSource& source) {
  return source.bounds_along(glm::dmat3(1)).longest_side();
}

std::vector<glm::dvec3> even_directions(unsigned count) {
  std::vector<glm::dvec3> directions;
  if (count == kSideViews)  // as in reference_cameras.h
    return {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  const double golden = glm::pi<double>() * (3 - std::sqrt(5.0));
  for (unsigned i = 0; i < count; ++i) {
    const double y = 1 - (2 * i + 1.0) / count;
    const double radius = std::sqrt(1 - y * y);
    directions.emplace_back(radius * std::sin(golden * i), y, radius * std::cos(golden * i));
  }
  return directions;
}

Shot view_from(const ViewSource& source, const glm::dvec3& direction, const ViewOptions& options) {
  const glm::dmat3 axes = axes_towards(direction);
  const double side = longest_side(source);
  const double pixel = side / options.resolution;
  const Bounds box = source.bounds_along(axes);
  Shot shot = options.orthographic ? parallel_view(box, axes, side, pixel)
                                   : perspective_view(box, axes, side, pixel);
  shot.camera.orientation = glm::quat_cast(axes);
  shot.camera = as_in_node(shot.camera);
  return shot;
}

Result<CoverageMeter> CoverageMeter::of(const ViewSource& source,
                                        const std::function<void(double)>& progress) {
  CoverageMeter meter(source);
  auto points = source.samples(kSamples);
  if (!points.ok()) return std::move(points).error();
  meter.points_ = std::move(points).value();
  meter.directions_ = even_directions(kSideViews);
  for (const glm::dvec3& more : even_directions(kDirections - kSideViews))
    meter.directions_.push_back(more);
  meter.visible_.resize(meter.points_.positions.size());
  for (const glm::dvec3& direction : meter.directions_) {
    auto shown = meter.shown(view_from(source, direction, {kMeterResolution, true}));
    if (!shown.ok()) return std::move(shown).error();
    add_to(meter.visible_, shown.value());
    meter.shown_.push_back(std::move(shown).value());
    if (progress) progress(static_cast<double>(meter.shown_.size()) / kDirections);
  }
  return meter;
}

Result<std::vector<bool>> CoverageMeter::shown(const Shot& shot) const {
  const auto distances = source_->distances(shot);
  if (!distances.ok()) return distances.error();
  const CameraProjection projection(shot.camera);
  std::vector<bool> shown(points_.positions.size());
  for (size_t i = 0; i < shown.size(); ++i) {
    const glm::dvec3 point = points_.origin + glm::dvec3(points_.positions[i]);
    const ScreenPoint at = projection.project(point);
    if (!(at.distance > 0) || at.u < 0 || at.u >= 1 || at.v < 0 || at.v >= 1) continue;
    const glm::dvec3 normal(points_.normals.empty() ? glm::vec3(0) : points_.normals[i]);
    const double length = glm::length(normal);
    const double facing =
        length > 0 ? std::abs(glm::dot(normal, projection.towards_viewer(point))) / length : 1;
    if (facing < kFlattest) continue;
    // The surface may rise this much within the pixel and its neighbour.
    const glm::dvec2 size = projection.extent(at.distance);
    const double pixel = std::max(size.x / shot.width, size.y / shot.height);
    const double slack = 1.5 * pixel * (1 + std::sqrt(1 - std::min(1.0, facing * facing)) / facing);
    const auto x = std::min(static_cast<uint32_t>(at.u * shot.width), shot.width - 1);
    const auto y = std::min(static_cast<uint32_t>((1 - at.v) * shot.height), shot.height - 1);
    const float front = distances.value()[size_t{y} * shot.width + x];
    shown[i] = std::isfinite(front) && at.distance <= static_cast<double>(front) + slack;
  }
  return shown;
}

Result<Coverage> CoverageMeter::measure(const std::vector<Shot>& views) const {
  std::vector<bool> seen(points_.positions.size());
  for (const Shot& view : views) {
    const auto more = shown(view);
    if (!more.ok()) return more.error();
    add_to(seen, more.value());
  }
  Coverage coverage;
  for (size_t i = 0; i < seen.size(); ++i) {
    if (!visible_[i]) continue;
    ++coverage.visible;
    if (seen[i]) ++coverage.covered;
  }
  return coverage;
}

std::vector<glm::dvec3> CoverageMeter::choose(unsigned most) const {
  std::vector<glm::dvec3> chosen;
  std::vector<bool> seen(visible_.size());
  const auto gain_of = [&](size_t direction) {
    size_t gain = 0;
    for (size_t i = 0; i < seen.size(); ++i)
      if (shown_[direction][i] && !seen[i]) ++gain;
    return gain;
  };
  const auto visible = static_cast<double>(std::count(visible_.begin(), visible_.end(), true));
  while (chosen.size() < std::min<size_t>(most, directions_.size())) {
    size_t best = chosen.size(), gain = 0;  // the box first, as it is
    if (chosen.size() >= kSideViews) {
      best = 0;
      for (size_t d = 0; d < directions_.size(); ++d)
        if (const size_t more = gain_of(d); more > gain) {
          best = d;
          gain = more;
        }
      if (static_cast<double>(gain) < visible * kWorthIt || gain == 0) break;
    }
    chosen.push_back(directions_[best]);
    add_to(seen, shown_[best]);
  }
  return chosen;
}

}  // namespace afx
