// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Source: ISO/IEC 14772-1:1997 (VRML97), Transform, Billboard, LOD, Switch, DirectionalLight,
// PointLight, SpotLight (clauses not checked).
#include "nodes/traversal.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <string>
#include <utility>

namespace afx::nodes {

namespace {

constexpr size_t kNoGroup = static_cast<size_t>(-1);

/// A coordinate system met on the way, and where its DepthImages are collected.
struct Frame {
  glm::dmat4 to_world{1};
  size_t group = kNoGroup;
};

glm::dvec3 vector_of(const NodeView& node, std::string_view field, glm::dvec3 otherwise) {
  const auto* value = node.find<glm::vec3>(field);
  return value != nullptr ? glm::dvec3(*value) : otherwise;
}

glm::dmat4 rotation_of(const NodeView& node, std::string_view field) {
  const auto* r = node.find<Rotation>(field);
  const glm::dvec3 axis = r != nullptr ? glm::dvec3(r->x, r->y, r->z) : glm::dvec3(0);
  if (r == nullptr || !(glm::length(axis) > 0)) return glm::dmat4(1);
  return glm::rotate(glm::dmat4(1), static_cast<double>(r->angle), axis);
}

glm::dmat4 transform_2d_matrix(const NodeView& node) {
  const glm::dvec2 translation(node.get<glm::vec2>("translation")),
      center(node.get<glm::vec2>("center"));
  const glm::dvec2 scale(node.get<glm::vec2>("scale"));
  const double angle = node.get<float>("rotationAngle"),
               orientation = node.get<float>("scaleOrientation");
  const glm::dvec3 z(0, 0, 1);
  glm::dmat4 m = glm::translate(glm::dmat4(1), glm::dvec3(translation + center, 0));
  m = glm::rotate(m, angle + orientation, z);
  m = glm::scale(m, glm::dvec3(scale, 1));
  m = glm::rotate(m, -orientation, z);
  return glm::translate(m, glm::dvec3(-center, 0));
}

glm::dmat4 matrix_2d_matrix(const NodeView& node) {
  glm::dmat4 m(1);  // columns
  m[0][0] = node.get<float>("mxx");
  m[1][0] = node.get<float>("mxy");
  m[3][0] = node.get<float>("tx");
  m[0][1] = node.get<float>("myx");
  m[1][1] = node.get<float>("myy");
  m[3][1] = node.get<float>("ty");
  return m;
}

/// Turns the local z axis towards the viewer, about an axis; about no axis: y is the viewer's up
/// too.
glm::dmat4 billboard_matrix(const NodeView& node, const glm::dmat4& to_world,
                            const Viewer& viewer) {
  const glm::dmat4 to_local = glm::inverse(to_world);
  const glm::dvec3 toward(to_local * glm::dvec4(viewer.position, 1));
  const glm::dvec3 axis_field = vector_of(node, "axisOfRotation", {0, 1, 0});
  if (!(glm::length(toward) > 0)) return glm::dmat4(1);
  if (glm::length(axis_field) > 0) {
    const glm::dvec3 axis = glm::normalize(axis_field);
    const glm::dvec3 z(-axis * axis.z + glm::dvec3(0, 0, 1));
    const glm::dvec3 v = toward - axis * glm::dot(axis, toward);
    return glm::rotate(glm::dmat4(1), std::atan2(glm::dot(axis, glm::cross(z, v)), glm::dot(z, v)),
                       axis);
  }
  const glm::dvec3 z = glm::normalize(toward);
  const glm::dvec3 side = glm::cross(glm::dvec3(to_local * glm::dvec4(viewer.up, 0)), z);
  if (!(glm::length(side) > 0)) return glm::dmat4(1);
  const glm::dvec3 x = glm::normalize(side);
  return glm::dmat4(glm::dvec4(x, 0), glm::dvec4(glm::cross(z, x), 0), glm::dvec4(z, 0),
                    glm::dvec4(0, 0, 0, 1));
}

/// The index that LOD chooses, not yet held against the number of levels.
size_t lod_level(const NodeView& node, const glm::dmat4& to_world,
                 const std::optional<Viewer>& viewer) {
  const auto* range = node.find<std::vector<float>>("range");
  if (range == nullptr || !viewer) return 0;
  const glm::dvec3 local(glm::inverse(to_world) * glm::dvec4(viewer->position, 1));
  const double distance = glm::distance(local, vector_of(node, "center", glm::dvec3(0)));
  size_t level = 0;
  while (level < range->size() && distance >= static_cast<double>((*range)[level])) ++level;
  return level;
}

/// The nodes that are not simply groups with `children`.
struct GroupRule {
  std::string_view type;
  glm::dmat4 (*matrix)(const NodeView&);
};
constexpr GroupRule kMatrixRules[] = {
    {"Transform", transform_matrix},
    {"SBBone", transform_matrix},
    {"SBSite", transform_matrix},
    {"Transform2D", transform_2d_matrix},
    {"TransformMatrix2D", matrix_2d_matrix},
};

bool is_depth_image(const NodeView& node) {
  return node.type() == "DepthImage" || node.type() == "DepthImageV2";
}

using Kind = SceneObject::Kind;

/// The nodes that are handed out as they are.
struct ObjectRule {
  std::string_view type;
  Kind kind;
};
constexpr ObjectRule kObjectRules[] = {
    {"DirectionalLight", Kind::light},  {"PointLight", Kind::light},
    {"SpotLight", Kind::light},         {"Background", Kind::background},
    {"Background2D", Kind::background}, {"Fog", Kind::fog},
    {"Viewpoint", Kind::viewpoint},     {"NavigationInfo", Kind::navigation_info},
    {"Inline", Kind::inline_scene},
};
constexpr std::string_view kBoundInLayer[] = {"background", "fog", "navigationInfo", "viewpoint"};

bool is_dibr(Kind kind) { return kind == Kind::depth_images || kind == Kind::octree_image; }

class Walk {
 public:
  /// dibr_only   everything else is left out
  Walk(const Scene& scene, const TraversalOptions& options, bool dibr_only)
      : scene_(scene), options_(options), dibr_only_(dibr_only) {}

  Result<SceneObjects> run() {
    Frame world{options_.to_world};
    for (const NodeId root : scene_.roots()) visit(NodeView(scene_, root), world, 1);
    end_group(0, 0);
    if (failed_) return Error{Errc::limit_exceeded, {}, text_, {}, {}};
    for (SceneObject& object : found_.objects)
      if (object.kind == Kind::light && object.nodes.front().type() != "DirectionalLight") {
        object.lit_begin = 0;
        object.lit_end = found_.objects.size();
      }
    return std::move(found_);
  }

 private:
  void visit(const NodeView& node, Frame& frame, uint32_t depth) {
    if (!count(depth) || !node.valid()) return;
    const std::string_view type = node.type();
    if (is_depth_image(node)) return add_depth_image(node, frame);
    if (type == "OctreeImage") return add(Kind::octree_image, node, frame);
    if (type == "BitWrapper") return static_cast<void>(visit_wrapper(node, frame));
    if (type == "Shape") return visit_shape(node, frame);
    for (const ObjectRule& rule : kObjectRules)
      if (rule.type == type) return add(rule.kind, node, frame);
    visit_group(node, frame, depth);
  }

  void visit_group(const NodeView& node, Frame& frame, uint32_t depth) {
    const std::string_view type = node.type();
    if (type == "Switch") return visit_choice(node, "choice", switch_index(node), frame, depth);
    if (type == "LOD") return visit_level(node, frame, depth);
    if (type == "Billboard") return visit_billboard(node, frame, depth);
    if (type == "Layer3D")
      for (const std::string_view field : kBoundInLayer)
        if (const NodeView bound = node.child(field); bound.valid()) visit(bound, frame, depth + 1);
    for (const GroupRule& rule : kMatrixRules)
      if (rule.type == type) return visit_inside(node, rule.matrix(node), frame, depth);
    visit_children(node, frame, depth);
  }

  void visit_billboard(const NodeView& node, Frame& frame, uint32_t depth) {
    found_.depends_on_viewer = true;
    if (!options_.viewer) return visit_children(node, frame, depth);
    visit_inside(node, billboard_matrix(node, frame.to_world, *options_.viewer), frame, depth);
  }

  /// Whether one more node may be met. A scene that uses each group twice in the next has few nodes
  /// and exponentially many places: that is what the limit is for.
  bool count(uint32_t depth) {
    if (failed_) return false;
    failed_ = depth > options_.max_depth || ++found_.visits > options_.max_visits;
    if (failed_)
      text_ = depth > options_.max_depth
                  ? "the scene is nested deeper than " + std::to_string(options_.max_depth)
                  : "the scene has more than " + std::to_string(options_.max_visits) +
                        " places of nodes";
    return !failed_;
  }

  void visit_inside(const NodeView& node, const glm::dmat4& matrix, const Frame& outer,
                    uint32_t depth) {
    Frame frame{outer.to_world * matrix, kNoGroup};
    visit_children(node, frame, depth);
  }

  void visit_children(const NodeView& node, Frame& frame, uint32_t depth) {
    const size_t objects = found_.objects.size(), lights = group_lights_.size();
    for (const NodeView& child : node.children("children")) visit(child, frame, depth + 1);
    end_group(objects, lights);
  }

  void visit_choice(const NodeView& node, std::string_view field, size_t index, Frame& frame,
                    uint32_t depth) {
    const NodeView chosen = node.child_at(field, index);
    if (!chosen.valid()) return;
    const size_t objects = found_.objects.size(), lights = group_lights_.size();
    visit(chosen, frame, depth + 1);
    end_group(objects, lights);
  }

  static size_t switch_index(const NodeView& node) {
    const int32_t choice = node.get<int32_t>("whichChoice");
    return choice < 0 ? kNoGroup : static_cast<size_t>(choice);
  }

  void visit_level(const NodeView& node, Frame& frame, uint32_t depth) {
    found_.depends_on_viewer = true;
    const size_t levels = node.child_count("level");
    if (levels == 0) return;
    const size_t level = lod_level(node, frame.to_world, options_.viewer);
    visit_choice(node, "level", std::min(level, levels - 1), frame, depth);
  }

  void visit_shape(const NodeView& node, Frame& frame) {
    const NodeView geometry = node.child("geometry");
    if (!geometry.valid()) return;
    if (geometry.type() == "BitWrapper" && visit_wrapper(geometry, frame)) return;
    add(Kind::shape, node, frame);
  }

  /// Whether it holds a DIBR node, which is handed out then.
  bool visit_wrapper(const NodeView& node, Frame& frame) {
    const NodeView wrapped = node.child("node");
    if (!wrapped.valid()) return false;
    const bool octree = wrapped.type() == "OctreeImage";
    if (octree) add(Kind::octree_image, node, frame);
    if (is_depth_image(wrapped)) add_depth_image(node, frame);
    return octree || is_depth_image(wrapped);
  }

  void add_depth_image(const NodeView& node, Frame& frame) {
    if (frame.group == kNoGroup) {
      frame.group = found_.objects.size();
      found_.objects.push_back({Kind::depth_images, frame.to_world, {}});
    }
    found_.objects[frame.group].nodes.push_back(node);
  }

  void add(Kind kind, const NodeView& node, const Frame& frame) {
    if (dibr_only_ && !is_dibr(kind)) return;
    if (kind == Kind::light) {
      if (!node.get<bool>("on")) return;
      group_lights_.push_back(found_.objects.size());
    }
    found_.objects.push_back({kind, frame.to_world, {node}});
  }

  /// At the end of a group: its lights fall on all that stands in it, also on what came before
  /// them.
  void end_group(size_t first_object, size_t first_light) {
    for (; group_lights_.size() > first_light; group_lights_.pop_back()) {
      SceneObject& light = found_.objects[group_lights_.back()];
      light.lit_begin = first_object;
      light.lit_end = found_.objects.size();
    }
  }

  const Scene& scene_;
  const TraversalOptions& options_;
  bool dibr_only_;
  SceneObjects found_;
  std::vector<size_t> group_lights_;  // those met in groups that have not ended
  bool failed_ = false;
  std::string text_;
};

}  // namespace

glm::dmat4 transform_matrix(const NodeView& node) {
  const glm::dvec3 center = vector_of(node, "center", glm::dvec3(0));
  const glm::dmat4 orientation = rotation_of(node, "scaleOrientation");
  glm::dmat4 m =
      glm::translate(glm::dmat4(1), vector_of(node, "translation", glm::dvec3(0)) + center);
  m = m * rotation_of(node, "rotation") * orientation;
  m = glm::scale(m, vector_of(node, "scale", glm::dvec3(1))) * glm::transpose(orientation);
  return glm::translate(m, -center);
}

Result<SceneObjects> find_scene_objects(const Scene& scene, const TraversalOptions& options) {
  return Walk(scene, options, false).run();
}

std::optional<DibrObject> dibr_object(const SceneObject& object) {
  if (!is_dibr(object.kind)) return std::nullopt;
  const auto kind = object.kind == Kind::octree_image ? DibrObject::Kind::octree_image
                                                      : DibrObject::Kind::depth_images;
  return DibrObject{kind, object.to_world, object.nodes};
}

Result<std::vector<DibrObject>> find_dibr_objects(const Scene& scene,
                                                  const TraversalOptions& options) {
  const auto found = Walk(scene, options, true).run();
  if (!found.ok()) return found.error();
  std::vector<DibrObject> objects;
  for (const SceneObject& object : found.value().objects)
    if (auto dibr = dibr_object(object)) objects.push_back(*std::move(dibr));
  return objects;
}

}  // namespace afx::nodes
