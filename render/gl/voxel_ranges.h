// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Which nodes of an octree are drawn, in runs. The nodes below one node are neighbours in each
// level, so whole subtrees that lie out of view are passed over, and those that are far away are
// drawn by few of their levels. Which of the nodes in a run are drawn the vertex shader decides.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "render/gl/gl_view.h"
#include "render/octree_view.h"

namespace afx::render {

/// Runs of nodes of one level, ascending, as glMultiDrawArrays takes them.
struct NodeRuns {
  std::vector<int32_t> first, count;

  void add(uint32_t from, uint32_t to);
  void clear() { first.clear(), count.clear(); }
};

/// The nodes of one octree that can be seen in a tile.
class VoxelRanges {
 public:
  VoxelRanges(const OctreeView& octree, const GlView& view);

  /// Nodes of a level whose discs may be small enough for points; and those that may be larger.
  [[nodiscard]] const NodeRuns& points(unsigned level) const { return points_[level]; }
  [[nodiscard]] const NodeRuns& quads(unsigned level) const { return quads_[level]; }
  /// Nodes of a level are drawn as they are where their parents are at least so far away, or
  /// farther (see OctreeView::is_last), infinite: nowhere. For level 0 that of a tree that is drawn
  /// by its root.
  [[nodiscard]] double last_from(unsigned level) const { return last_from_[level]; }

 private:
  struct Node {
    unsigned level;
    uint32_t number;
    glm::dvec3 centre;
  };

  /// Adds what is to be drawn of what is below a node.
  void visit(Node node);
  /// Adds the nodes of levels [coarsest, finest] below a node, or itself.
  void add(Node node, unsigned coarsest, unsigned finest);
  [[nodiscard]] bool is_small(Node node, unsigned finest) const;
  /// The first child of a node or of those after it.
  [[nodiscard]] uint32_t below(unsigned level, uint32_t number) const;
  /// The largest radius that a disc of a level in the ball can have.
  [[nodiscard]] double largest(unsigned level, const glm::dvec3& centre, double ball) const;

  const OctreeView& octree_;
  const GlView& view_;
  double scale_;
  std::vector<double> last_from_;
  std::vector<NodeRuns> points_, quads_;  // by level
};

}  // namespace afx::render
