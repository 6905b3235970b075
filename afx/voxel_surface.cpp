// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/voxel_surface.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "afx/voxel_shading.h"
#include "codec/octree_voxels.h"
#include "codec/parallel.h"

namespace afx {
namespace {

constexpr float kInsideVoxel = 0.45F;  // of a voxel's side, how far from its centre is inside

/// The voxel in the cell that a normal points to, of the 26 around; kNone if there is none.
size_t next_along(uint64_t code, const glm::vec3& normal, uint32_t side,
                  const VoxelBlocks& blocks) {
  const glm::vec3 a = glm::abs(normal);
  const float most = std::max({a.x, a.y, a.z});
  if (!(most > 0)) return VoxelBlocks::kNone;
  const Voxel v = codec::morton_decode(code);
  const glm::ivec3 step(glm::round(normal / most));
  const glm::ivec3 cell = glm::ivec3(glm::uvec3(v.x, v.y, v.z)) + step;
  for (int k = 0; k < 3; ++k)
    if (cell[k] < 0 || cell[k] >= static_cast<int>(side)) return VoxelBlocks::kNone;
  const glm::uvec3 at(cell);
  return blocks.find(codec::morton_code({at.x, at.y, at.z}));
}

/// Calls task(n) for all numbers below `count`, many at a time.
template <class Task>
void for_each(size_t count, unsigned threads, const Task& task) {
  constexpr size_t kAtOnce = 16384;
  parallel_for((count + kAtOnce - 1) / kAtOnce, threads, [&](size_t part) {
    for (size_t n = part * kAtOnce; n < std::min(count, (part + 1) * kAtOnce); ++n) task(n);
  });
}

std::vector<float> surface_heights(std::span<const uint64_t> codes,
                                   std::span<const glm::vec3> normals, const VoxelBlocks& blocks,
                                   unsigned threads) {
  std::vector<glm::vec3> centres(codes.size());
  for (size_t n = 0; n < codes.size(); ++n) {
    const Voxel v = codec::morton_decode(codes[n]);
    centres[n] = glm::vec3(glm::uvec3(v.x, v.y, v.z));
  }
  const std::vector<glm::vec3> means = smooth(blocks, centres, 1, threads);
  std::vector<float> heights(codes.size());
  for_each(codes.size(), threads, [&](size_t n) {
    const glm::vec3 a = glm::abs(normals[n]);
    const float inside = kInsideVoxel / std::max({a.x, a.y, a.z, 0.5F});
    heights[n] = std::clamp(glm::dot(means[n] - centres[n], normals[n]), -inside, inside);
  });
  return heights;
}

/// Two steps up at most.
std::vector<uint32_t> seen_instead(std::span<const uint64_t> codes,
                                   std::span<const glm::vec3> normals, unsigned level,
                                   const VoxelBlocks& blocks, unsigned threads) {
  std::vector<uint32_t> above(codes.size());
  for_each(codes.size(), threads, [&](size_t n) {
    const size_t next = next_along(codes[n], normals[n], uint32_t{1} << level, blocks);
    above[n] = static_cast<uint32_t>(next == VoxelBlocks::kNone ? n : next);
  });
  std::vector<uint32_t> seen(codes.size());
  for_each(codes.size(), threads, [&](size_t n) { seen[n] = above[above[n]]; });
  return seen;
}

}  // namespace

VoxelSurface voxel_surface(std::span<const uint64_t> codes, unsigned level,
                           const VoxelBlocks& blocks, unsigned threads) {
  VoxelSurface surface;
  surface.normals = surface_normals(codes, level, blocks, threads);
  surface.heights = surface_heights(codes, surface.normals, blocks, threads);
  surface.seen = seen_instead(codes, surface.normals, level, blocks, threads);
  return surface;
}

}  // namespace afx
