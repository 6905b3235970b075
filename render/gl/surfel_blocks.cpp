// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/gl/surfel_blocks.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <span>

#include "codec/octree_voxels.h"
#include "render/scene.h"

namespace afx::render {
namespace {

constexpr size_t kBlock = 2048;  // surfels
constexpr int kCellLevel = 10;   // 2^10 cells along a side of the cube around all

bool is_finite(const glm::dvec3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

bool is_drawn(const Surfels& s, size_t i) {
  return s.colours[i].a >= kLeastOpacity && is_finite(s.centres[i]) &&
         is_finite(glm::dvec3(s.u[i])) && is_finite(glm::dvec3(s.v[i]));
}

struct Placed {
  uint32_t cell;  // its Morton code
  uint32_t number;
  auto operator<=>(const Placed&) const = default;
};

/// The surfels that are drawn, by cells.
std::vector<Placed> sorted(const Surfels& surfels) {
  glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
  for (size_t i = 0; i < surfels.size(); ++i) {
    if (!is_drawn(surfels, i)) continue;
    low = glm::min(low, surfels.centres[i]);
    high = glm::max(high, surfels.centres[i]);
  }
  const glm::dvec3 extent = high - low;
  const double side = std::max({extent.x, extent.y, extent.z, 1e-300});
  const double cells = std::ldexp(1.0, kCellLevel);
  std::vector<Placed> placed;
  placed.reserve(surfels.size());
  for (size_t i = 0; i < surfels.size(); ++i) {
    if (!is_drawn(surfels, i)) continue;
    const glm::dvec3 at = glm::clamp((surfels.centres[i] - low) / side * cells, 0.0, cells - 1);
    const Voxel cell{static_cast<uint32_t>(at.x), static_cast<uint32_t>(at.y),
                     static_cast<uint32_t>(at.z)};
    placed.push_back({static_cast<uint32_t>(codec::morton_code(cell)), static_cast<uint32_t>(i)});
  }
  std::sort(placed.begin(), placed.end());
  return placed;
}

/// Parts a run, whose cells lie in one cell of `level`, until the parts are small enough.
template <class Emit>
void part(std::span<const Placed> run, int level, const Emit& emit) {
  if (run.empty()) return;
  if (level == kCellLevel) {  // many in one place
    for (; run.size() > kBlock; run = run.subspan(kBlock)) emit(run.first(kBlock));
  }
  if (run.size() <= kBlock) return emit(run);
  const int shift = 3 * (kCellLevel - 1 - level);
  while (!run.empty()) {
    const uint32_t cell = run.front().cell >> shift;
    const auto end = std::find_if(run.begin(), run.end(),
                                  [&](const Placed& p) { return p.cell >> shift != cell; });
    const auto count = static_cast<size_t>(end - run.begin());
    part(run.first(count), level + 1, emit);
    run = run.subspan(count);
  }
}

SurfelBlock block_around(const Surfels& surfels, std::span<const Placed> run) {
  glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
  for (const auto& [cell, i] : run) {
    low = glm::min(low, surfels.centres[i]);
    high = glm::max(high, surfels.centres[i]);
  }
  SurfelBlock block{low + (high - low) / 2.0, 0, 0, 0, static_cast<uint32_t>(run.size())};
  for (const auto& [cell, i] : run) {
    block.radius = std::max(block.radius, glm::length(surfels.centres[i] - block.centre));
    block.reach = std::max(
        block.reach, glm::length(glm::dvec3(surfels.u[i])) + glm::length(glm::dvec3(surfels.v[i])));
  }
  return block;
}

}  // namespace

std::vector<SurfelBlock> make_blocks(const Surfels& surfels, std::vector<SurfelVertex>& vertices) {
  const std::vector<Placed> placed = sorted(surfels);
  std::vector<SurfelBlock> blocks;
  vertices.clear();
  vertices.reserve(placed.size());
  part(std::span(placed), 0, [&](std::span<const Placed> run) {
    SurfelBlock block = block_around(surfels, run);
    block.first = static_cast<uint32_t>(vertices.size());
    for (const Placed& p : run) {
      const size_t i = p.number;
      vertices.push_back({glm::vec3(surfels.centres[i] - block.centre), surfels.u[i], surfels.v[i],
                          surfels.colours[i]});
    }
    blocks.push_back(block);
  });
  return blocks;
}

}  // namespace afx::render
