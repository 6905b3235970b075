// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Where a model is built: placed as the options say, then near the origin.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

#include "afx/builder/placement.h"
#include "tools/build.h"

namespace afx::tools {
namespace {

/// A model that lies more than so many times its size from the origin is moved there: of the 24
/// bits that fields of nodes have, 18 are left for the model.
constexpr double kFar = 64;

Placement placement_of(const BuildCommand& command) {
  Placement placement;
  placement.up = command.up == "z" ? UpAxis::z : UpAxis::y;
  placement.scale = command.scale;
  placement.fit = command.fit.value_or(0);
  return placement;
}

/// Points that hold all that a camera shows.
void add_corners(const DepthCamera& camera, std::vector<glm::dvec3>& corners) {
  const CameraProjection projection(camera);
  for (const double distance : {camera.near_plane, camera.far_plane})
    for (const double u : {0.0, 1.0})
      for (const double v : {0.0, 1.0}) corners.push_back(projection.point({u, v, distance}));
}

/// Points that hold an object, in the coordinates of its nodes.
std::vector<glm::dvec3> corners_of(const DibrModel& model) {
  std::vector<glm::dvec3> corners;
  if (const auto* images = model.depth_images()) {
    for (const DepthImage& image : *images) add_corners(image.camera, corners);
    return corners;
  }
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5})
      for (const double z : {-0.5, 0.5}) corners.emplace_back(x, y, z);
  return corners;
}

Bounds bounds_of_objects(const std::vector<DibrModel>& models) {
  std::vector<glm::dvec3> corners;
  for (const DibrModel& model : models)
    for (const glm::dvec3& corner : corners_of(model))
      corners.emplace_back(model.to_world * glm::dvec4(corner, 1));
  if (corners.empty()) return {};
  Bounds bounds{corners.front(), corners.front()};
  for (const glm::dvec3& corner : corners) {
    bounds.low = glm::min(bounds.low, corner);
    bounds.high = glm::max(bounds.high, corner);
  }
  return bounds;
}

Bounds bounds_of_input(const ModelInput& model) {
  if (const auto* mesh = std::get_if<Mesh>(&model)) return bounds_of(*mesh);
  if (const auto* surfels = std::get_if<Surfels>(&model)) return bounds_of(*surfels);
  if (const auto* models = std::get_if<std::vector<DibrModel>>(&model))
    return bounds_of_objects(*models);
  const auto& cloud = std::get<PointCloud>(model);
  Bounds bounds = bounds_of(cloud.positions);
  bounds.low += cloud.origin;
  bounds.high += cloud.origin;
  return bounds;
}

void move_input(ModelInput& model, const glm::dvec3& offset) {
  if (auto* mesh = std::get_if<Mesh>(&model)) return move_by(*mesh, offset);
  if (auto* cloud = std::get_if<PointCloud>(&model)) return move_by(*cloud, offset);
  if (auto* surfels = std::get_if<Surfels>(&model)) return move_by(*surfels, offset);
  for (DibrModel& one : std::get<std::vector<DibrModel>>(model))
    one.to_world[3] += glm::dvec4(offset, 0);
}

double longest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

/// A place near another that floats hold: a multiple of the step that they have at its greatest
/// coordinate. (Not by conversion to float and back: g++ 12 leaves that of vectors out.)
glm::dvec3 place_in_floats(const glm::dvec3& place) {
  const double step = std::ldexp(1.0, std::ilogb(longest(glm::abs(place))) - 23);
  return glm::round(place / step) * step + 0.0;  // no -0
}

}  // namespace

Status place_input(ModelInput& model, const BuildJob& job) {
  const Placement placement = placement_of(job.command);
  if (placement == Placement()) return {};
  if (std::holds_alternative<std::vector<DibrModel>>(model)) {
    auto surfels = surfels_of_input(std::move(model), job.session, job.diagnostics);
    if (!surfels.ok()) return surfels.error();
    model = std::move(surfels).value();
  }
  if (auto* mesh = std::get_if<Mesh>(&model)) return place(*mesh, placement);
  if (auto* cloud = std::get_if<PointCloud>(&model)) return place(*cloud, placement);
  return place(std::get<Surfels>(model), placement);
}

glm::dvec3 take_offset(ModelInput& model) {
  const Bounds bounds = bounds_of_input(model);
  const glm::dvec3 middle = 0.5 * (bounds.low + bounds.high);
  const double side = longest(bounds.high - bounds.low);
  if (!(longest(glm::abs(middle)) > kFar * (side > 0 ? side : 1))) return {0, 0, 0};
  const glm::dvec3 offset = place_in_floats(middle);
  move_input(model, -offset);
  return offset;
}

}  // namespace afx::tools
