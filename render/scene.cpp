// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/scene.h"

#include <algorithm>
#include <cmath>
#include <glm/vec4.hpp>

#include "codec/octree_voxels.h"

namespace afx::render {
namespace {

constexpr unsigned kOutlineLevel = 5;

void add_cell(const VoxelCloud& cloud, uint64_t cell, unsigned level,
              std::vector<glm::dvec3>& points) {
  const Voxel v = codec::morton_decode(cell);
  const double side = std::ldexp(1.0, -static_cast<int>(level));
  for (uint32_t k = 0; k < 8; ++k) {
    const glm::dvec4 corner((v.x + (k & 1U)) * side - 0.5, (v.y + (k >> 1U & 1U)) * side - 0.5,
                            (v.z + (k >> 2U)) * side - 0.5, 1);
    points.emplace_back(cloud.local_to_world * corner);
  }
}

}  // namespace

std::vector<glm::dvec3> outline(const Scene& scene) {
  std::vector<glm::dvec3> points;
  for (const VoxelCloud& cloud : scene.voxels) {
    const unsigned level = std::min(cloud.level, kOutlineLevel);
    const unsigned shift = 3 * (cloud.level - level);
    for (size_t i = 0; i < cloud.codes.size(); ++i) {
      const uint64_t cell = cloud.codes[i] >> shift;
      if (i > 0 && cloud.codes[i - 1] >> shift == cell) continue;
      add_cell(cloud, cell, level, points);
    }
  }
  return points;
}

}  // namespace afx::render
