// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Source: ISO/IEC 14772-1:1997 (VRML97), Transform, Billboard, LOD, Switch (clauses not checked).
#include "nodes/traversal.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <string>

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

class Walk {
 public:
  Walk(const Scene& scene, const TraversalOptions& options) : scene_(scene), options_(options) {}

  Result<std::vector<DibrObject>> run() {
    Frame world;
    for (const NodeId root : scene_.roots()) visit(NodeView(scene_, root), world, 1);
    if (failed_) return Error{Errc::limit_exceeded, {}, text_, {}, {}};
    return std::move(objects_);
  }

 private:
  void visit(const NodeView& node, Frame& frame, uint32_t depth) {
    if (!count(depth) || !node.valid()) return;
    const std::string_view type = node.type();
    if (is_depth_image(node)) return add_depth_image(node, frame);
    if (type == "OctreeImage") return add_octree_image(node, frame);
    if (type == "BitWrapper") return visit_wrapper(node, frame);
    if (type == "Shape") return visit_shape(node, frame);
    if (type == "Switch") return visit_choice(node, "choice", switch_index(node), frame, depth);
    if (type == "LOD") return visit_level(node, frame, depth);
    for (const GroupRule& rule : kMatrixRules)
      if (rule.type == type) return visit_inside(node, rule.matrix(node), frame, depth);
    if (type == "Billboard" && options_.viewer)
      return visit_inside(node, billboard_matrix(node, frame.to_world, *options_.viewer), frame,
                          depth);
    visit_children(node, frame, depth);
  }

  /// Whether one more node may be met. A scene that uses each group twice in the next has few nodes
  /// and exponentially many places: that is what the limit is for.
  bool count(uint32_t depth) {
    if (failed_) return false;
    failed_ = depth > options_.max_depth || ++visits_ > options_.max_visits;
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
    for (const NodeView& child : node.children("children")) visit(child, frame, depth + 1);
  }

  void visit_choice(const NodeView& node, std::string_view field, size_t index, Frame& frame,
                    uint32_t depth) {
    if (const NodeView chosen = node.child_at(field, index); chosen.valid())
      visit(chosen, frame, depth + 1);
  }

  static size_t switch_index(const NodeView& node) {
    const int32_t choice = node.get<int32_t>("whichChoice");
    return choice < 0 ? kNoGroup : static_cast<size_t>(choice);
  }

  void visit_level(const NodeView& node, Frame& frame, uint32_t depth) {
    const size_t levels = node.child_count("level");
    if (levels == 0) return;
    const size_t level = lod_level(node, frame.to_world, options_.viewer);
    visit_choice(node, "level", std::min(level, levels - 1), frame, depth);
  }

  void visit_shape(const NodeView& node, Frame& frame) {
    const NodeView geometry = node.child("geometry");
    if (geometry.valid() && geometry.type() == "BitWrapper") visit_wrapper(geometry, frame);
  }

  void visit_wrapper(const NodeView& node, Frame& frame) {
    const NodeView wrapped = node.child("node");
    if (!wrapped.valid()) return;
    if (is_depth_image(wrapped)) add_depth_image(node, frame);
    if (wrapped.type() == "OctreeImage") add_octree_image(node, frame);
  }

  void add_depth_image(const NodeView& node, Frame& frame) {
    if (frame.group == kNoGroup) {
      frame.group = objects_.size();
      objects_.push_back({DibrObject::Kind::depth_images, frame.to_world, {}});
    }
    objects_[frame.group].nodes.push_back(node);
  }

  void add_octree_image(const NodeView& node, const Frame& frame) {
    objects_.push_back({DibrObject::Kind::octree_image, frame.to_world, {node}});
  }

  const Scene& scene_;
  const TraversalOptions& options_;
  std::vector<DibrObject> objects_;
  uint64_t visits_ = 0;
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

Result<std::vector<DibrObject>> find_dibr_objects(const Scene& scene,
                                                  const TraversalOptions& options) {
  return Walk(scene, options).run();
}

}  // namespace afx::nodes
