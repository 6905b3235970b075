// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Source: ISO/IEC 14772-1:1997 (VRML97), Viewpoint (clause not checked).
#include "tools/scene_viewpoints.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include "afx/node_rotation.h"
#include "nodes/nearest_name.h"
#include "nodes/traversal.h"

namespace afx::tools {
namespace {

/// The rotation that looks the way that a matrix turns another one; scales and shears go.
glm::dquat turned(const glm::dmat4& to_world, const glm::dquat& orientation) {
  const glm::dmat3 matrix(to_world);
  const glm::dvec3 back = matrix * (orientation * glm::dvec3(0, 0, 1));
  const glm::dvec3 up = matrix * (orientation * glm::dvec3(0, 1, 0));
  const glm::dvec3 right = glm::cross(up, back);
  if (!(glm::length(back) > 0) || !(glm::length(right) > 0)) return orientation;
  const glm::dvec3 x = glm::normalize(right), z = glm::normalize(back);
  return glm::quat_cast(glm::dmat3(x, glm::cross(z, x), z));
}

class Walk {
 public:
  Status visit(const nodes::NodeView& node, const glm::dmat4& to_world, uint32_t depth) {
    const nodes::TraversalOptions limits;
    if (depth > limits.max_depth || ++visits_ > limits.max_visits)
      return Error{Errc::limit_exceeded, Place::none(),
                   "the scene is nested too deep or has too many places of nodes"};
    if (!node.valid()) return {};
    if (node.type() == "Viewpoint") add(node, to_world);
    if (node.type() == "Switch") return visit_choice(node, to_world, depth);
    if (node.type() == "LOD") return visit(node.child_at("level", 0), to_world, depth + 1);
    const glm::dmat4 inside =
        node.type() == "Transform" ? to_world * nodes::transform_matrix(node) : to_world;
    for (const nodes::NodeView& child : node.children("children"))
      if (Status visited = visit(child, inside, depth + 1); !visited.ok()) return visited;
    return {};
  }

  std::vector<Viewpoint> found;

 private:
  Status visit_choice(const nodes::NodeView& node, const glm::dmat4& to_world, uint32_t depth) {
    const int32_t choice = node.get<int32_t>("whichChoice");
    if (choice < 0) return {};
    return visit(node.child_at("choice", static_cast<size_t>(choice)), to_world, depth + 1);
  }

  void add(const nodes::NodeView& node, const glm::dmat4& to_world) {
    Viewpoint viewpoint;
    viewpoint.name = node.node().name;
    viewpoint.description = node.get<std::string>("description");
    viewpoint.position =
        glm::dvec3(to_world * glm::dvec4(glm::dvec3(node.get<glm::vec3>("position")), 1));
    viewpoint.orientation =
        turned(to_world, quaternion_of<double>(node.get<nodes::Rotation>("orientation")));
    viewpoint.field_of_view = static_cast<double>(node.get<float>("fieldOfView"));
    found.push_back(std::move(viewpoint));
  }

  uint64_t visits_ = 0;
};

/// "'front' and 'From the side'"; the first few.
std::string listed(const std::vector<Viewpoint>& viewpoints) {
  constexpr size_t kMost = 12;
  std::string list;
  for (size_t i = 0; i < std::min(viewpoints.size(), kMost); ++i) {
    const Viewpoint& one = viewpoints[i];
    const std::string& name = one.name.empty() ? one.description : one.name;
    list += (i == 0 ? "" : ", ") + (name.empty() ? std::to_string(i + 1) : "'" + name + "'");
  }
  return viewpoints.size() > kMost ? list + ", ..." : list;
}

}  // namespace

Result<std::vector<Viewpoint>> find_viewpoints(const nodes::Scene& scene) {
  Walk walk;
  for (const nodes::NodeId root : scene.roots()) {
    const Status visited = walk.visit(nodes::NodeView(scene, root), glm::dmat4(1), 1);
    if (!visited.ok()) return visited.error();
  }
  return std::move(walk.found);
}

Result<Viewpoint> pick_viewpoint(const std::vector<Viewpoint>& viewpoints,
                                 const std::string& name) {
  for (const Viewpoint& one : viewpoints)
    if (!one.name.empty() && one.name == name) return one;
  for (const Viewpoint& one : viewpoints)
    if (!one.description.empty() && one.description == name) return one;
  for (size_t i = 0; i < viewpoints.size(); ++i)
    if (std::to_string(i + 1) == name) return viewpoints[i];
  if (viewpoints.empty())
    return Error{Errc::bad_argument, Place::none(),
                 "there is no viewpoint '" + name + "' (the scene has none)"};
  nodes::NearestName nearest(name);
  for (const Viewpoint& one : viewpoints) {
    nearest.offer(one.name);
    nearest.offer(one.description);
  }
  return Error{Errc::bad_argument, Place::none(),
               "there is no viewpoint '" + name + "'" + nearest.hint() + " (expected " +
                   listed(viewpoints) + ", or a number from 1 to " +
                   std::to_string(viewpoints.size()) + ")"};
}

}  // namespace afx::tools
