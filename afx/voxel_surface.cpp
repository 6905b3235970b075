// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/voxel_surface.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "afx/voxel_shading.h"
#include "codec/octree_voxels.h"

namespace afx {
namespace {

constexpr float kInsideVoxel = 0.45F;  // of a voxel's side, how far from its centre is inside

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
  for (size_t n = 0; n < codes.size(); ++n) {
    const glm::vec3 a = glm::abs(normals[n]);
    const float inside = kInsideVoxel / std::max({a.x, a.y, a.z, 0.5F});
    heights[n] = std::clamp(glm::dot(means[n] - centres[n], normals[n]), -inside, inside);
  }
  return heights;
}

}  // namespace

VoxelSurface voxel_surface(std::span<const uint64_t> codes, unsigned level,
                           const VoxelBlocks& blocks, unsigned threads) {
  VoxelSurface surface;
  surface.normals = surface_normals(codes, level, blocks, threads);
  surface.heights = surface_heights(codes, surface.normals, blocks, threads);
  return surface;
}

}  // namespace afx
