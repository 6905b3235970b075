// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "codec/octree_walk.h"

#include <algorithm>
#include <bit>
#include <span>

namespace afx::codec {

// The recursion is as deep as the octree, at most 31.
OctreeWalk::Run OctreeWalk::next_run(unsigned level) {  // NOLINT(misc-no-recursion)
  if (level == 0) return {1, textured_};
  Cursor& cursor = cursor_[level];
  while (cursor.parents.nodes == 0) cursor.parents = next_run(level - 1);
  const size_t parents = cursor.parents.textured ? 1 : static_cast<size_t>(cursor.parents.nodes);
  const uint64_t children = count_children(std::span(fields_.octree).subspan(cursor.node, parents));
  cursor.node += parents;
  cursor.parents.nodes -= parents;
  return {children, cursor.parents.textured && next_is_open(cursor)};
}

OctreeWalk::Run OctreeWalk::next_run() {
  Run run{0, false};
  while (run.nodes == 0) run = next_run(level_);
  remaining_ -= run.nodes;
  return run;
}

/// Appends the contexts of the children of the parents at hand, as far as they fit. Returns the new
/// count.
size_t OctreeWalk::add_contexts(size_t count, Cursor& cursor) {
  const size_t parents = std::min(static_cast<size_t>(cursor.parents.nodes), (kBatch - count) / 8);
  for (size_t i = 0; i < parents; ++i) {
    const uint8_t symbol = fields_.octree[cursor.node + i];
    const bool textured = cursor.parents.textured && next_is_open(cursor);
    const NodeContext flag = textured ? kTextured : NodeContext{0};
    for (unsigned k = 0; k < 8; ++k) {
      contexts_[count + k] = static_cast<NodeContext>(kChildContexts[symbol][k] | flag);
    }
    count += static_cast<unsigned>(std::popcount(symbol));
  }
  cursor.node += parents;
  cursor.parents.nodes -= parents;
  return count;
}

OctreeWalk::Batch OctreeWalk::next_contexts() {
  size_t count = 0;
  if (level_ == 0) {
    contexts_[count++] = textured_ ? kTextured : NodeContext{0};
  } else {
    Cursor& cursor = cursor_[level_];
    while (count + 8 <= kBatch && count < remaining_) {
      if (cursor.parents.nodes == 0) cursor.parents = next_run(level_ - 1);
      count = add_contexts(count, cursor);
    }
  }
  remaining_ -= count;
  return {contexts_.data(), count};
}

void OctreeWalk::descend(uint64_t children, size_t texture_symbols) {
  node_start_[level_ + 1] = node_start_[level_] + nodes_;
  texture_start_[level_ + 1] = texture_symbols;
  ++level_;
  nodes_ = remaining_ = children;
  for (unsigned l = 1; l <= level_; ++l) {
    cursor_[l] = {};
    cursor_[l].node = node_start_[l - 1];
    cursor_[l].texture = texture_start_[l - 1];
  }
}

}  // namespace afx::codec
