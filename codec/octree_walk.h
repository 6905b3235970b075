// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The breadth-first walk that encoder and decoder of an octree frame share. It needs no memory that
// grows with the octree: the levels above, which are complete, tell what each node of a level is.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "codec/octree.h"
#include "codec/octree_contexts.h"

namespace afx::codec {

/// Walks the levels of `fields` from the root down. The fields may grow while a level is walked (a
/// decoder appends the symbols of that level), but what stands for the levels above must not
/// change.
class OctreeWalk {
 public:
  /// textured: whether texture symbols are coded at all (numOfTextures > 0).
  OctreeWalk(const OctreeFields& fields, bool textured) : fields_(fields), textured_(textured) {}

  [[nodiscard]] unsigned level() const { return level_; }
  /// Nodes of this level, and those of them whose contexts have not been handed out.
  [[nodiscard]] uint64_t nodes() const { return nodes_; }
  [[nodiscard]] uint64_t remaining() const { return remaining_; }

  /// Hands out the contexts of the next nodes of this level, up to kBatch, in order.
  /// The result is valid until the next call.
  struct Batch {
    const NodeContext* contexts;
    size_t count;
  };
  static constexpr size_t kBatch = 2048;
  Batch next_contexts();

  /// Like next_contexts(), where only the texture symbols matter (the voxels): the next nodes, one
  /// or more, that either all have a texture symbol or all have none. Call while remaining() > 0.
  struct Run {
    uint64_t nodes;
    bool textured;
  };
  Run next_run();

  /// Goes down a level, which has `children` nodes; `texture_symbols` of the frame belong to the
  /// levels above.
  void descend(uint64_t children, size_t texture_symbols);

 private:
  /// Walks the parents of the nodes of one level, in step with them: the run of parents at hand.
  struct Cursor {
    size_t node = 0;     // in octree: the next parent
    size_t texture = 0;  // in voxel_image_index: the symbol of the next parent that has one
    Run parents{0, false};
  };

  /// The next run of nodes of a level, which may be empty. A node has a texture symbol if its
  /// parent has one, and that is 0.
  Run next_run(unsigned level);
  /// Whether the children of the next parent have texture symbols; the run at hand is of parents
  /// that have one.
  bool next_is_open(Cursor& cursor) { return fields_.voxel_image_index[cursor.texture++] == 0; }
  size_t add_contexts(size_t count, Cursor& cursor);

  const OctreeFields& fields_;
  const bool textured_;
  unsigned level_ = 0;
  uint64_t nodes_ = 1;
  uint64_t remaining_ = 1;
  // Where each level's symbols begin, and for each level down to this one the cursor over its
  // nodes' parents (level l - 1); those above follow at the pace of the ones below.
  std::array<size_t, 34> node_start_{};
  std::array<size_t, 34> texture_start_{};
  std::array<Cursor, 34> cursor_{};
  std::array<NodeContext, kBatch + 8> contexts_;
};

}  // namespace afx::codec
