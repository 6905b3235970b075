// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The nodes of an octree that can be seen in a tile, from its breadth-first bytes, near to far.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <glm/vec3.hpp>
#include <vector>

#include "render/octree_view.h"
#include "render/software/splat_painter.h"
#include "render/software/tile_samples.h"
#include "render/splats.h"

namespace afx::render {

/// How many bits each byte has. (std::popcount is a call on processors without the instruction.)
inline constexpr std::array<uint8_t, 256> kOnes = [] {
  std::array<uint8_t, 256> ones{};
  for (unsigned byte = 0; byte < 256; ++byte)
    ones[byte] = static_cast<uint8_t>(std::popcount(byte));
  return ones;
}();

/// Walks one octree after another. Subtrees that lie beside the tile are passed over, and those
/// that are hidden by what the tile already shows: so the nearer halves of each node come first.
/// What is passed over cannot change the picture.
class OctreeWalk {
 public:
  /// Calls emit(splat, tilt) for the nodes to be drawn. It may draw them into `tile` at once.
  template <class Emit>
  void run(const OctreeView& view, TileSamples& tile, const Emit& emit) {
    tile_ = &tile;
    if (view.tree().voxels() == 0) return;
    begin(view, tile);
    if (view.last_level() == 0) return emit_root(view, emit);
    push(view, 0, 0, view.root());
    while (!stack_.empty()) {
      const Entry node = stack_.back();
      stack_.pop_back();
      if (is_hidden(node, tile)) continue;
      visit(view, node, emit);
    }
  }

 private:
  struct Entry {
    glm::dvec3 centre;
    OctreeView::Bound bound;
    uint32_t number;
    uint32_t level;
  };

  void begin(const OctreeView& view, const TileSamples& tile);
  /// Puts a node onto the stack if its discs may touch the tile.
  void push(const OctreeView& view, unsigned level, uint32_t number, const glm::dvec3& centre);
  static bool is_hidden(const Entry& node, TileSamples& tile);
  [[nodiscard]] bool touches(float x, float y, float reach) const {
    return std::abs(x - middle_x_) <= reach + half_ && std::abs(y - middle_y_) <= reach + half_;
  }

  template <class Emit>
  void visit(const OctreeView& view, const Entry& node, const Emit& emit) {
    const VoxelTree::Branch branch = view.tree().branches(node.level)[node.number];
    const unsigned level = node.level + 1;
    if (view.is_last(level, node.centre)) {
      view.project(node.centre, branch, level, discs_);
      if (level < view.tree().level()) weights_ = view.side_weights(node.centre);
      return for_children(branch, 0, [&](unsigned i, uint32_t number) {
        this->emit_disc(view, level, i, number, emit);
      });
    }
    const OctreeView::Size& size = view.size(level);
    for_children(branch, 7, [&](unsigned i, uint32_t number) {
      this->push(view, level, number, node.centre + size.offsets[i]);
    });
  }

  /// Visits the children that are there with their numbers, those nearest to the viewer first, or
  /// with flip = 7 last.
  template <class Visit>
  void for_children(VoxelTree::Branch branch, unsigned flip, const Visit& visit) const {
    for (unsigned k = 0; k < 8; ++k) {
      const unsigned i = nearest_ ^ flip ^ k;
      const unsigned bit = 1U << i;
      if ((branch.symbol & bit) == 0) continue;
      visit(i, branch.first_child + kOnes[branch.symbol & (bit - 1)]);
    }
  }

  template <class Emit>
  void emit_disc(const OctreeView& view, unsigned level, unsigned i, uint32_t number,
                 const Emit& emit) const {
    if (discs_.reach[i] < 0 || !touches(discs_.x[i], discs_.y[i], discs_.reach[i])) return;
    Splat splat = view.outline(discs_, i, level);
    if (painter_.is_hidden(splat, *tile_)) return;
    const Tilt tilt = view.tilt(discs_, i, level, splat);
    splat.light = view.light(level, number, weights_);
    emit(splat, tilt);
  }

  template <class Emit>
  void emit_root(const OctreeView& view, const Emit& emit) {
    view.project_root(discs_);
    weights_ = view.side_weights(view.root());
    emit_disc(view, 0, 0, 0, emit);
  }

  const SplatPainter& painter_ = SplatPainter::best();
  const TileSamples* tile_ = nullptr;
  std::vector<Entry> stack_;
  EightDiscs discs_;
  OctreeView::SideWeights weights_{};
  unsigned nearest_ = 0;
  float middle_x_ = 0, middle_y_ = 0, half_ = 0;  // of the tile, in samples
};

}  // namespace afx::render
