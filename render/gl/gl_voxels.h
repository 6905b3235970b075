// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Octrees in the memory of the graphics system, and how they are drawn.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "render/gl/gl_objects.h"
#include "render/gl/gl_view.h"
#include "render/gl/voxel_ranges.h"
#include "render/scene.h"

namespace afx::render {

/// The nodes of an octree, each level uploaded when it is first drawn: 18 bytes a voxel, 38 a node
/// of the levels above.
class GlTree {
 public:
  explicit GlTree(std::shared_ptr<const VoxelTree> tree)
      : tree_(std::move(tree)), levels_(tree_->level() + 1) {}

  [[nodiscard]] const std::shared_ptr<const VoxelTree>& tree() const { return tree_; }
  /// Memory that it takes once all levels are uploaded.
  [[nodiscard]] static uint64_t bytes(const VoxelTree& tree);
  /// Makes a level the current vertex array, a vertex for each node.
  void bind_points(unsigned level);
  /// The same with an instance for each node from number `first` on.
  void bind_quads(unsigned level, int32_t first);

 private:
  struct Level {
    GlBuffer cells, facets, colours;
    GlArray points, quads;
  };
  Level& uploaded(unsigned level);
  void point_at(const Level& level, bool sides, int32_t first, GLuint divisor) const;

  std::shared_ptr<const VoxelTree> tree_;
  std::vector<Level> levels_;
};

/// One cloud as it is drawn into one tile.
class GlVoxelCloud {
 public:
  /// All must outlive it.
  GlVoxelCloud(const VoxelCloud& cloud, GlTree& tree, const Lens& lens,
               const RenderOptions& options)
      : octree_(cloud, lens, options), options_(options), tree_(tree) {}

  [[nodiscard]] unsigned levels() const { return octree_.last_level() + 1; }
  /// How far away its farthest corner is.
  [[nodiscard]] double farthest() const { return -octree_.root().z + 2 * octree_.size(0).reach; }
  /// Finds what is to be drawn in the view's tile.
  void look(const GlView& view) { ranges_ = std::make_unique<VoxelRanges>(octree_, view); }
  /// Draws a level's points or quadrilaterals with the program in use, whose other uniforms are
  /// set.
  void draw_points(const GlProgram& program, unsigned level, bool es);
  void draw_quads(const GlProgram& program, unsigned level);
  [[nodiscard]] bool has_sides(unsigned level) const { return level < octree_.tree().level(); }
  /// Whether a level has anything to be drawn as quadrilaterals or as points.
  [[nodiscard]] bool has_any(unsigned level, bool quads) const {
    return !(quads ? ranges_->quads(level) : ranges_->points(level)).first.empty();
  }

 private:
  void set_uniforms(const GlProgram& program, unsigned level) const;

  OctreeView octree_;
  const RenderOptions& options_;
  GlTree& tree_;
  std::unique_ptr<VoxelRanges> ranges_;
};

}  // namespace afx::render
