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
  /// Lays the depths of the nodes to be drawn into `tile`, and appends those to `seen` that are
  /// seen so far.
  void run(const OctreeView& view, TileSamples& tile, std::vector<TileDisc>& seen);

 private:
  /// A node and its bound; see EightBounds.
  struct Entry {
    glm::dvec3 centre;
    float x, y, reach, depth;
    uint32_t number;
    uint32_t level;
  };

  void begin(const OctreeView& view, const TileSamples& tile);
  /// Puts the children of a node that may touch the tile onto the stack.
  void push_children(const OctreeView& view, const Entry& node, VoxelTree::Branch branch);
  [[nodiscard]] bool touches(float x, float y, float reach) const {
    return std::abs(x - middle_x_) <= reach + half_ && std::abs(y - middle_y_) <= reach + half_;
  }

  void visit(const OctreeView& view, const Entry& node, std::vector<TileDisc>& seen);
  void lay_disc(const OctreeView& view, unsigned level, unsigned i, uint32_t number,
                std::vector<TileDisc>& seen);
  void lay_root(const OctreeView& view, std::vector<TileDisc>& seen);

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

  const SplatPainter& painter_ = SplatPainter::best();
  TileSamples* tile_ = nullptr;
  std::vector<Entry> stack_;
  EightDiscs discs_;
  EightRectangles boxes_;
  EightBounds bounds_;
  OctreeView::SideWeights weights_{};
  unsigned nearest_ = 0;
  float middle_x_ = 0, middle_y_ = 0, half_ = 0;  // of the tile, in samples
};

}  // namespace afx::render
