// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/view_model.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <utility>

#include "nodes/node_view.h"
#include "nodes/traversal.h"
#include "tools/drawing.h"
#include "tools/input.h"
#include "tools/model_input.h"
#include "tools/scene_input.h"

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

/// Walks down to the Viewpoints.
class ViewpointSearch {
 public:
  std::vector<Viewpoint> found;

  void walk(const nodes::NodeView& node, const glm::dmat4& to_world, unsigned depth) {
    // Shared nodes are met in each of their places: both limits are needed.
    if (!node.valid() || depth > kMostDepth || visits_++ > kMostVisits) return;
    if (node.type() == "Viewpoint") return add(node, to_world);
    const bool moves = node.type() == "Transform";
    const glm::dmat4 inside = moves ? to_world * nodes::transform_matrix(node) : to_world;
    const size_t count = node.child_count("children");
    for (size_t i = 0; i < count; ++i) walk(node.child_at("children", i), inside, depth + 1);
  }

 private:
  static constexpr unsigned kMostDepth = 512;
  static constexpr uint64_t kMostVisits = 1U << 20U;

  void add(const nodes::NodeView& node, const glm::dmat4& to_world) {
    Viewpoint viewpoint;
    viewpoint.name = node.node().name;
    if (const auto* text = node.find<std::string>("description")) viewpoint.description = *text;
    if (const auto* at = node.find<glm::vec3>("position"))
      viewpoint.position = glm::dvec3(to_world * glm::dvec4(glm::dvec3(*at), 1));
    glm::dquat turned(1, 0, 0, 0);
    if (const auto* r = node.find<nodes::Rotation>("orientation")) {
      const glm::dvec3 axis(r->x, r->y, r->z);
      if (glm::length(axis) > 0) turned = glm::angleAxis<double>(r->angle, glm::normalize(axis));
    }
    glm::dvec3 right, up, ahead;
    const bool seen = make_axes(glm::dmat3(to_world), turned, right, up, ahead);
    viewpoint.orientation = glm::quat_cast(glm::dmat3(right, up, -ahead));
    if (const auto* angle = node.find<float>("fieldOfView")) viewpoint.field_of_view = *angle;
    if (!seen || !is_finite(viewpoint.position) || !(viewpoint.field_of_view > 0)) return;
    if (found.size() < kMostViewpoints) found.push_back(std::move(viewpoint));
  }

  uint64_t visits_ = 0;
};

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

Result<size_t> find_viewpoint(const std::vector<Viewpoint>& viewpoints, const std::string& wanted) {
  size_t number = 0;
  const auto parsed = std::from_chars(wanted.data(), wanted.data() + wanted.size(), number);
  const bool is_number = parsed.ec == std::errc() && parsed.ptr == wanted.data() + wanted.size();
  if (is_number && number >= 1 && number <= viewpoints.size()) return number;
  for (size_t i = 0; i < viewpoints.size(); ++i)
    if (viewpoints[i].name == wanted || viewpoints[i].description == wanted) return i + 1;
  std::string expected =
      viewpoints.empty() ? "a scene with viewpoints" : "1 to " + std::to_string(viewpoints.size());
  for (const Viewpoint& viewpoint : viewpoints)
    if (!viewpoint.name.empty() && expected.size() < 200) expected += ", " + viewpoint.name;
  return Error{Errc::bad_argument, Place::none(),
               "there is no viewpoint '" + wanted + "' (expected " + expected + ")"};
}

/// The models of a scene; its viewpoints and cameras go into `out`.
Result<ModelInput> read_scene_part(const Input& input, const Session& session,
                                   Diagnostics& diagnostics, ViewerModel& out) {
  const auto scene = read_scene(input, session.limits, diagnostics);
  if (!scene.ok()) return scene.error();
  out.viewpoints = viewpoints_of(scene.value().scene);
  warn_of_left_out(scene.value().scene, diagnostics);
  auto models =
      read_dibr_models(scene.value().scene, scene.value().base(), session.limits, diagnostics);
  if (!models.ok()) return in_file(std::move(models).error(), input.path);
  return ModelInput(std::move(models).value());
}

Result<ModelInput> read_part(const Input& input, ViewQuery& query, const Session& session,
                             Diagnostics& diagnostics, ViewerModel& out) {
  if (is_scene(input.kind)) return read_scene_part(input, session, diagnostics, out);
  OctreeQuery octree{.node = {}, .resolution = query.resolution, .frame = query.frame};
  auto model = read_model_input(input, octree, session, diagnostics);
  query.is_usage = octree.missing_is_usage;
  return model;
}

std::string file_name(const std::string& path) { return path.substr(path.find_last_of('/') + 1); }

}  // namespace

std::vector<Viewpoint> viewpoints_of(const nodes::Scene& scene) {
  ViewpointSearch search;
  for (const nodes::NodeId root : scene.roots())
    search.walk(nodes::NodeView(scene, root), glm::dmat4(1), 0);
  return std::move(search.found);
}

std::vector<ReferenceCamera> reference_cameras(const std::vector<DibrModel>& models) {
  std::vector<ReferenceCamera> cameras;
  for (const DibrModel& model : models) {
    if (const OctreeModel* octree = model.octree()) {
      for (const ReferenceImage& image : octree->images)
        add_camera(model.to_world, image.position, image.orientation, true,
                   glm::dvec2(image.field_of_view) / 2.0, cameras);
      continue;
    }
    for (const DepthImage& image : *model.depth_images()) {
      const DepthCamera& c = image.camera;
      const glm::dvec2 half = c.field_of_view / 2.0;
      add_camera(model.to_world, c.position, c.orientation, c.orthographic,
                 c.orthographic ? half : glm::dvec2(std::tan(half.x), std::tan(half.y)), cameras);
    }
  }
  return cameras;
}

Result<std::shared_ptr<const ViewerModel>> load_view_model(
    const std::string& path, ViewQuery& query, const Session& session, Diagnostics& diagnostics,
    const std::function<void(const std::string&)>& doing) {
  doing("reading " + file_name(path));
  const auto input = open_model_input(path, query.input_format, session.limits, diagnostics);
  if (!input.ok()) return input.error();
  auto out = std::make_shared<ViewerModel>();
  out->file = path;
  auto model = read_part(input.value(), query, session, diagnostics, *out);
  if (!model.ok()) return std::move(model).error();
  if (std::holds_alternative<Mesh>(model.value()))
    return Error{Errc::unsupported, Place::none(),
                 "is a mesh (expected a model: 'afx build' makes one of it)"};
  if (const auto* models = std::get_if<std::vector<DibrModel>>(&model.value()))
    out->cameras = reference_cameras(*models);
  if (!query.viewpoint.empty()) {
    const auto found = find_viewpoint(out->viewpoints, query.viewpoint);
    query.is_usage = !found.ok();
    if (!found.ok()) return found.error();
    out->first_viewpoint = found.value();
  } else if (!out->viewpoints.empty()) {
    out->first_viewpoint = 1;
  }
  doing("making " + file_name(path) + " ready to be drawn");
  Drawing drawing(session, diagnostics);
  if (Status added = drawing.add(std::move(model).value(), Shade::automatic); !added.ok())
    return added.error();
  out->scene = drawing.scene();
  if (out->scene.voxels.empty() && out->scene.surfels.empty() && out->scene.shapes.empty())
    return Error{Errc::malformed, Place::none(),
                 "the scene shows nothing to draw (expected a DepthImage or an OctreeImage)"};
  if (Status right = render::check_scene(out->scene); !right.ok()) return right.error();
  out->size = drawing.size();
  out->outline = render::outline(out->scene);
  for (const render::VoxelCloud& cloud : out->scene.voxels)
    out->levels = std::max(out->levels, cloud.tree->level());
  out->warnings = diagnostics.count();
  return std::shared_ptr<const ViewerModel>(std::move(out));
}

}  // namespace afx::tools
