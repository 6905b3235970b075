// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// An octree made ready to be drawn: its breadth-first bytes with a colour for every node.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "afx/picture.h"
#include "afx/voxel_surface.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx::render {

/// The nodes of an octree over the cube of side 1 around the origin, level by level in
/// breadth-first order (codec/octree.h): level 0 is the root, a node of level n has side 2^-n,
/// those of the last level are the voxels. It does not change, so any number of threads and scenes
/// may share it.
class VoxelTree {
 public:
  /// A node that has children.
  struct Branch {
    uint32_t first_child;  ///< number of its first child in the next level; siblings follow it
    uint8_t symbol;        ///< bit i: child i is there, i = x + 2y + 4z, the same as in `octree`
  };

  /// The colours of a node from six sides: +x, -x, +y, -y, +z, -z. Each is the mean, in linear
  /// light, of what is seen of the node from that side, its voxels hiding each other: so the inside
  /// of a thin wall does not shine through when it is drawn from afar. Cf. the anisotropic voxels
  /// of Crassin et al., "Interactive Indirect Illumination Using Voxel Cone Tracing" (2011).
  struct Sides {
    Rgba8 from[6];
  };

  /// The piece of surface in a node: a disc around a point in it. Numbers are parts of 127.
  struct Facet {
    int8_t
        normal[3];    ///< outwards, of length 1; (0, 0, 0): it has none and always faces the viewer
    int8_t shift[3];  ///< from the node's centre, in halves of its side
  };

  /// The tree of a set of voxels.
  ///
  /// level    of the voxels, at most codec::kMortonLevels
  /// codes    Morton codes (codec/octree_voxels.h), ascending, no doubles; fewer than 2^31
  /// colours  sRGB, one for each code; drawn opaque, a is not looked at
  /// surface  of the voxels (afx/voxel_surface.h), whose `seen` says whose colour each has; null:
  /// all facets lie in the middle of their nodes
  ///          and have no normal
  /// Errors   bad_argument: one of these does not hold (the text says which); limit_exceeded: the
  /// tree
  ///          and what making it takes need more than limits.memory
  static Result<std::shared_ptr<const VoxelTree>> make(unsigned level,
                                                       std::span<const uint64_t> codes,
                                                       std::span<const Rgba8> colours,
                                                       const VoxelSurface* surface = nullptr,
                                                       const Limits& limits = {});

  /// The level of the voxels.
  [[nodiscard]] unsigned level() const { return static_cast<unsigned>(branches_.size()); }
  [[nodiscard]] size_t voxels() const { return colours_.size(); }
  /// How many nodes a level has.
  [[nodiscard]] size_t nodes(unsigned at) const {
    return at == level() ? voxels() : branches_[at].size();
  }
  /// Of a level above the last; as many as it has nodes. None at all in a tree without voxels.
  [[nodiscard]] std::span<const Branch> branches(unsigned level) const { return branches_[level]; }
  /// Of the voxels; a is 255.
  [[nodiscard]] std::span<const Rgba8> colours() const { return colours_; }
  /// Of the nodes of a level above the last.
  [[nodiscard]] std::span<const Sides> sides(unsigned level) const { return sides_[level]; }
  /// Of any level, one for each of its nodes.
  [[nodiscard]] std::span<const Facet> facets(unsigned at) const { return facets_[at]; }
  /// The nodes of a level, not beyond the last, as Morton codes, ascending. Eight bytes a node,
  /// made anew each time.
  [[nodiscard]] std::vector<uint64_t> codes(unsigned level) const;
  /// Memory that it holds.
  [[nodiscard]] uint64_t bytes() const;

 private:
  VoxelTree() = default;

  std::vector<std::vector<Branch>> branches_;  // by level, without the last
  std::vector<std::vector<Sides>> sides_;      // likewise
  std::vector<std::vector<Facet>> facets_;     // by level
  std::vector<Rgba8> colours_;
};

}  // namespace afx::render
