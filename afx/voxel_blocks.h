// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Finding the neighbours of voxels fast, and the normals that follow from them.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace afx {

/// An index over voxels given as ascending Morton codes: blocks of 4 x 4 x 4, each a mask of 64
/// bits. 24 bytes a block. Keeps nothing of the list it is made from.
class VoxelBlocks {
 public:
  /// codes   ascending, no doubles, fewer than 2^32 of them
  explicit VoxelBlocks(std::span<const uint64_t> codes);

  /// One block. Voxel number `first` + k has the k-th set bit of `mask`; a bit is the low six bits
  /// of the voxel's code.
  struct Block {
    uint64_t key = 0;  ///< the Morton code of the block among blocks
    uint64_t mask = 0;
    uint32_t first = 0;
  };
  static constexpr size_t kNone = ~size_t{0};

  [[nodiscard]] std::span<const Block> blocks() const { return blocks_; }
  [[nodiscard]] size_t voxel_count() const {
    if (blocks_.empty()) return 0;
    return blocks_.back().first + static_cast<size_t>(std::popcount(blocks_.back().mask));
  }
  /// The number of the block with that key, or kNone.
  [[nodiscard]] size_t find_block(uint64_t key) const;
  /// The place of a voxel in the list, or kNone.
  [[nodiscard]] size_t find(uint64_t code) const;

 private:
  std::vector<Block> blocks_;
};

/// The normal of each voxel, in the order of the list: minus the sum of the unit offsets to the
/// occupied ones of its 26 neighbours, made a unit vector; exactly zero where that sum is zero.
/// Source: the project's rules for the choice of images (octree_image_choice.h).
std::vector<glm::vec3> voxel_normals(const VoxelBlocks& blocks, unsigned threads);

/// The mean of a vector over each voxel and its neighbours, taken `rounds` times: the grid shows
/// less.
std::vector<glm::vec3> smooth(const VoxelBlocks& blocks, std::vector<glm::vec3> vectors,
                              unsigned rounds, unsigned threads);

}  // namespace afx
