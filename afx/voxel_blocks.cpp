// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/voxel_blocks.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>

#include "codec/octree_voxels.h"
#include "codec/parallel.h"

namespace afx {
namespace {

constexpr uint32_t kEmpty = ~uint32_t{0};
constexpr uint32_t kBlocksAlongSide = uint32_t{1} << (codec::kMortonLevels - 2);
constexpr size_t kChunk = 1024;  // blocks that one task does

/// A block and a border of one voxel around it: numbers of voxels, x fastest, kEmpty where none is.
using Patch = std::array<uint32_t, 6 * 6 * 6>;

constexpr size_t patch_place(int x, int y, int z) {
  return static_cast<size_t>((x + 1) + 6 * (y + 1) + 36 * (z + 1));
}

/// Coordinates 0..3 of each of the 64 bits of a mask.
struct Local {
  int8_t x, y, z;
};
constexpr std::array<Local, 64> make_locals() {
  std::array<Local, 64> locals{};
  for (int bit = 0; bit < 64; ++bit) {
    locals[static_cast<size_t>(bit)] = {static_cast<int8_t>((bit & 1) | (bit >> 2 & 2)),
                                        static_cast<int8_t>((bit >> 1 & 1) | (bit >> 3 & 2)),
                                        static_cast<int8_t>((bit >> 2 & 1) | (bit >> 4 & 2))};
  }
  return locals;
}
constexpr std::array<Local, 64> kLocals = make_locals();

/// Enters the voxels of `block`, which lies (dx, dy, dz) blocks away from the patch's own.
void enter_block(const VoxelBlocks::Block& block, int dx, int dy, int dz, Patch& patch) {
  uint32_t number = block.first;
  for (uint64_t mask = block.mask; mask != 0; mask &= mask - 1, ++number) {
    const Local local = kLocals[static_cast<size_t>(std::countr_zero(mask))];
    const int x = local.x + 4 * dx, y = local.y + 4 * dy, z = local.z + 4 * dz;
    if (std::min({x, y, z}) < -1 || std::max({x, y, z}) > 4) continue;
    patch[patch_place(x, y, z)] = number;
  }
}

void fill_patch(const VoxelBlocks& blocks, size_t number, Patch& patch) {
  patch.fill(kEmpty);
  const Voxel at = codec::morton_decode(blocks.blocks()[number].key);
  for (int dz = -1; dz <= 1; ++dz) {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        // Below zero wraps around and is out of range as well.
        const Voxel there{at.x + static_cast<uint32_t>(dx), at.y + static_cast<uint32_t>(dy),
                          at.z + static_cast<uint32_t>(dz)};
        if (std::max({there.x, there.y, there.z}) >= kBlocksAlongSide) continue;
        const bool self = dx == 0 && dy == 0 && dz == 0;
        const size_t found = self ? number : blocks.find_block(codec::morton_code(there));
        if (found != VoxelBlocks::kNone) enter_block(blocks.blocks()[found], dx, dy, dz, patch);
      }
    }
  }
}

/// Calls visit(number of the voxel, its place in the patch, patch) for every voxel, in parallel.
template <class Visit>
void for_each_neighbourhood(const VoxelBlocks& blocks, unsigned threads, const Visit& visit) {
  const size_t count = blocks.blocks().size();
  parallel_for((count + kChunk - 1) / kChunk, threads, [&](size_t chunk) {
    Patch patch;
    for (size_t b = chunk * kChunk; b < std::min(count, (chunk + 1) * kChunk); ++b) {
      fill_patch(blocks, b, patch);
      uint32_t number = blocks.blocks()[b].first;
      for (uint64_t mask = blocks.blocks()[b].mask; mask != 0; mask &= mask - 1, ++number) {
        const Local local = kLocals[static_cast<size_t>(std::countr_zero(mask))];
        visit(number, patch_place(local.x, local.y, local.z), patch);
      }
    }
  });
}

/// The neighbour (dx, dy, dz) of the voxel at `place`.
uint32_t neighbour(const Patch& patch, size_t place, int dx, int dy, int dz) {
  return patch[static_cast<size_t>(static_cast<int>(place) + dx + 6 * dy + 36 * dz)];
}

/// Offsets to neighbours across faces, edges and corners are summed apart, in integers: the whole
/// sum is zero only if all three are, since 1, sqrt 2 and sqrt 3 have no rational relation.
glm::vec3 normal_at(const Patch& patch, size_t place) {
  std::array<std::array<int, 3>, 4> sums{};
  for (int dz = -1; dz <= 1; ++dz) {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        if (neighbour(patch, place, dx, dy, dz) == kEmpty) continue;
        std::array<int, 3>& sum = sums[static_cast<size_t>(dx * dx + dy * dy + dz * dz)];
        sum[0] += dx;
        sum[1] += dy;
        sum[2] += dz;
      }
    }
  }
  std::array<double, 3> n{};
  for (size_t k = 0; k < 3; ++k) {
    n[k] = -(sums[1][k] + sums[2][k] / std::sqrt(2.0) + sums[3][k] / std::sqrt(3.0));
  }
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  if (length == 0) return glm::vec3{0};
  return {static_cast<float>(n[0] / length), static_cast<float>(n[1] / length),
          static_cast<float>(n[2] / length)};
}

}  // namespace

VoxelBlocks::VoxelBlocks(std::span<const uint64_t> codes) {
  for (size_t i = 0; i < codes.size(); ++i) {
    const uint64_t key = codes[i] >> 6;
    if (blocks_.empty() || blocks_.back().key != key) {
      blocks_.push_back({key, 0, static_cast<uint32_t>(i)});
    }
    blocks_.back().mask |= uint64_t{1} << (codes[i] & 63);
  }
}

size_t VoxelBlocks::find_block(uint64_t key) const {
  const auto less = [](const Block& block, uint64_t wanted) { return block.key < wanted; };
  const auto found = std::lower_bound(blocks_.begin(), blocks_.end(), key, less);
  if (found == blocks_.end() || found->key != key) return kNone;
  return static_cast<size_t>(found - blocks_.begin());
}

size_t VoxelBlocks::find(uint64_t code) const {
  const size_t number = find_block(code >> 6);
  if (number == kNone) return kNone;
  const uint64_t bit = uint64_t{1} << (code & 63);
  const Block& block = blocks_[number];
  if ((block.mask & bit) == 0) return kNone;
  return block.first + static_cast<size_t>(std::popcount(block.mask & (bit - 1)));
}

std::vector<glm::vec3> voxel_normals(const VoxelBlocks& blocks, unsigned threads) {
  std::vector<glm::vec3> normals(blocks.voxel_count());
  for_each_neighbourhood(blocks, threads, [&](uint32_t number, size_t place, const Patch& patch) {
    normals[number] = normal_at(patch, place);
  });
  return normals;
}

std::vector<glm::vec3> smooth(const VoxelBlocks& blocks, std::vector<glm::vec3> vectors,
                              unsigned rounds, unsigned threads) {
  std::vector<glm::vec3> next(vectors.size());
  for (unsigned round = 0; round < rounds; ++round) {
    for_each_neighbourhood(blocks, threads, [&](uint32_t number, size_t place, const Patch& patch) {
      glm::vec3 sum{0};
      float count = 0;
      for (int dz = -1; dz <= 1; ++dz) {
        for (int dy = -1; dy <= 1; ++dy) {
          for (int dx = -1; dx <= 1; ++dx) {
            const uint32_t other = neighbour(patch, place, dx, dy, dz);
            if (other == kEmpty) continue;
            sum += vectors[other];
            count += 1;
          }
        }
      }
      next[number] = sum / count;
    });
    vectors.swap(next);
  }
  return vectors;
}

}  // namespace afx
