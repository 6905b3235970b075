// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The words that everything about octrees shares.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace afx {

/// ceil(log2(resolution)), the number of levels of internal nodes: 1 -> 0, 256 -> 8, 257 -> 9.
/// resolution >= 1; 0 gives 0.
constexpr unsigned octree_levels(uint32_t resolution) {
  unsigned levels = 0;
  while ((uint64_t{1} << levels) < resolution) ++levels;
  return levels;
}

/// An integer voxel position, each coordinate in [0, 2^levels).
struct Voxel {
  uint32_t x = 0, y = 0, z = 0;
  bool operator==(const Voxel&) const = default;
};

/// The coded fields of one OctreeImage, or of one frame of an animated one, exactly as in the node.
struct OctreeFields {
  /// A byte for each internal node, breadth first, root first; bit i is set when child i exists,
  /// i = x + 2y + 4z, each term 1 for the half with the larger coordinate. Nodes of a level stand
  /// in the order of their parents, siblings by child index.
  std::vector<uint8_t> octree;
  /// Image numbers in octree fashion: a symbol for each node (voxels included) whose parent's image
  /// is undefined; 0 = still undefined, k = images[k-1] colours everything below.
  std::vector<uint8_t> voxel_image_index;

  bool operator==(const OctreeFields&) const = default;
};

/// The children of all the nodes whose symbols are given: the set bits.
inline uint64_t count_children(std::span<const uint8_t> symbols) {
  uint64_t count = 0;
  size_t i = 0;
  for (; i + 8 <= symbols.size(); i += 8) {
    uint64_t word;
    std::memcpy(&word, symbols.data() + i, 8);
    count += static_cast<unsigned>(std::popcount(word));
  }
  for (; i < symbols.size(); ++i) count += static_cast<unsigned>(std::popcount(symbols[i]));
  return count;
}

}  // namespace afx
