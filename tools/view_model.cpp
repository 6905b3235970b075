// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/view_model.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <utility>

#include "tools/drawing.h"
#include "tools/input.h"
#include "tools/model_input.h"
#include "tools/scene_viewpoints.h"

namespace afx::tools {
namespace {

bool is_finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Three axes at right angles that are nearest to what a matrix makes of a camera's; false where it
/// flattens them.
bool make_axes(const glm::dmat3& matrix, const glm::dquat& orientation, glm::dvec3& right,
               glm::dvec3& up, glm::dvec3& ahead) {
  ahead = matrix * (orientation * glm::dvec3(0, 0, -1));
  up = matrix * (orientation * glm::dvec3(0, 1, 0));
  ahead /= glm::length(ahead);
  up -= ahead * glm::dot(up, ahead);
  up /= glm::length(up);
  right = glm::cross(ahead, up);
  return is_finite(ahead) && is_finite(up) && is_finite(right);
}

/// position, orientation, half_view   in the coordinates of the model
void add_camera(const glm::dmat4& to_world, const glm::dvec3& position,
                const glm::dquat& orientation, bool orthographic, const glm::dvec2& half_view,
                std::vector<ReferenceCamera>& cameras) {
  ReferenceCamera camera;
  const glm::dmat3 matrix(to_world);
  const bool seen = make_axes(matrix, orientation, camera.right, camera.up, camera.ahead);
  camera.position = glm::dvec3(to_world * glm::dvec4(position, 1));
  camera.orthographic = orthographic;
  camera.half_view = half_view;
  if (orthographic) {
    camera.half_view *= glm::dvec2(glm::length(matrix * (orientation * glm::dvec3(1, 0, 0))),
                                   glm::length(matrix * (orientation * glm::dvec3(0, 1, 0))));
  }
  const bool wide = camera.half_view.x > 0 && camera.half_view.y > 0 && camera.half_view.x < 1e30 &&
                    camera.half_view.y < 1e30;
  if (seen && wide && is_finite(camera.position)) cameras.push_back(camera);
}

/// Reads the input into `drawing`; errors with the file.
Status read_into(Input input, ViewQuery& query, const Session& session, Diagnostics& diagnostics,
                 Drawing& drawing) {
  if (is_scene(input.kind)) return drawing.add_scene(std::move(input));
  OctreeQuery octree{.node = {}, .resolution = query.resolution, .frame = query.frame};
  auto model = read_model_input(input, octree, session, diagnostics);
  query.is_usage = octree.missing_is_usage;
  if (!model.ok()) return std::move(model).error();
  return drawing.add(std::move(model).value(), Shade::automatic);
}

std::string file_name(const std::string& path) { return path.substr(path.find_last_of('/') + 1); }

}  // namespace

std::vector<ReferenceCamera> reference_cameras(const std::vector<render::ModelCamera>& of_models) {
  std::vector<ReferenceCamera> cameras;
  for (const render::ModelCamera& one : of_models) {
    const DepthCamera& c = one.camera;
    const glm::dvec2 half = c.field_of_view / 2.0;
    add_camera(one.to_world, c.position, c.orientation, c.orthographic,
               c.orthographic ? half : glm::dvec2(std::tan(half.x), std::tan(half.y)), cameras);
  }
  return cameras;
}

Result<std::shared_ptr<const ViewerModel>> load_view_model(
    const std::string& path, ViewQuery& query, const Session& session, Diagnostics& diagnostics,
    const std::function<void(const std::string&)>& doing) {
  doing("reading " + file_name(path));
  auto input = open_model_input(path, query.input_format, session.limits, diagnostics);
  if (!input.ok()) return input.error();
  auto out = std::make_shared<ViewerModel>();
  out->file = path;
  Drawing drawing(session, diagnostics);
  const Status read = read_into(std::move(input).value(), query, session, diagnostics, drawing);
  if (!read.ok()) return in_file(read.error(), path);
  out->viewpoints = drawing.viewpoints();
  out->cameras = reference_cameras(drawing.cameras());
  if (!query.viewpoint.empty()) {
    const auto found = pick_viewpoint(out->viewpoints, query.viewpoint);
    query.is_usage = !found.ok();
    if (!found.ok()) return found.error();
    out->first_viewpoint = found.value() + 1;
  } else if (!out->viewpoints.empty()) {
    out->first_viewpoint = 1;
  }
  out->viewpoints.resize(
      std::min(out->viewpoints.size(), std::max(kMostViewpoints, out->first_viewpoint)));
  doing("making " + file_name(path) + " ready to be drawn");
  auto scene = drawing.scene();
  if (!scene.ok()) return in_file(std::move(scene).error(), path);
  out->scene = std::move(scene).value();
  if (Status right = render::check_scene(out->scene); !right.ok()) return right.error();
  out->size = drawing.size();
  out->outline = render::outline(out->scene);
  for (const render::VoxelCloud& cloud : out->scene.voxels)
    out->levels = std::max(out->levels, cloud.tree->level());
  out->warnings = diagnostics.count();
  return std::shared_ptr<const ViewerModel>(std::move(out));
}

}  // namespace afx::tools
