// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/gl/voxel_ranges.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace afx::render {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr uint32_t kSmallRun = 1024;  // nodes that are not worth looking at more closely
constexpr double kRounding = 1e-5;    // of distances

double last_from_of(const OctreeView& octree, unsigned level, double coarseness) {
  if (level == octree.last_level()) return -kNever;
  if (level == 0) return kNever;
  const double side = octree.size(level).side;
  const Lens& lens = octree.lens();
  if (!lens.perspective) return lens.focal * side <= coarseness ? -kNever : kNever;
  return std::max(OctreeView::kFarAway * side, lens.focal * side / coarseness);
}

}  // namespace

void NodeRuns::add(uint32_t from, uint32_t to) {
  if (from == to) return;
  if (!first.empty() && static_cast<uint32_t>(first.back() + count.back()) == from) {
    count.back() += static_cast<int32_t>(to - from);
    return;
  }
  first.push_back(static_cast<int32_t>(from));
  count.push_back(static_cast<int32_t>(to - from));
}

VoxelRanges::VoxelRanges(const OctreeView& octree, const GlView& view)
    : octree_(octree), view_(view), scale_(view.options.splat_scale) {
  const unsigned levels = octree.last_level() + 1;
  points_.resize(levels);
  quads_.resize(levels);
  for (unsigned level = 0; level < levels; ++level)
    last_from_.push_back(last_from_of(octree, level, view.options.coarseness));
  if (octree.tree().voxels() == 0) return;
  const Node root{0, 0, octree.root()};
  if (octree.last_level() > 0) {
    visit(root);
  } else if (view.touches(root.centre, octree.disc_reach(0))) {
    add(root, 0, 0);
  }
}

double VoxelRanges::largest(unsigned level, const glm::dvec3& centre, double ball) const {
  const OctreeView::Size& size = octree_.size(level);
  if (view_.options.splats == SplatKind::points) return 0;
  const Lens& lens = view_.lens;
  if (!lens.perspective) return std::max(size.flat_radius * scale_, size.radius * lens.focal);
  const double nearest = -centre.z - ball;
  const double reach = octree_.disc_reach(level);
  if (!(nearest > 2 * reach)) return kNever;
  const double slopes = (std::abs(centre.x) + std::abs(centre.y) + 2 * ball) / nearest;
  return 1.01 * lens.focal * reach * (1 + slopes) / (nearest - reach);
}

uint32_t VoxelRanges::below(unsigned level, uint32_t number) const {
  const VoxelTree& tree = octree_.tree();
  return number < tree.nodes(level) ? tree.branches(level)[number].first_child
                                    : static_cast<uint32_t>(tree.nodes(level + 1));
}

void VoxelRanges::add(Node node, unsigned coarsest, unsigned finest) {
  const double ball = octree_.size(node.level).reach;
  uint32_t first = node.number, end = node.number + 1;
  for (unsigned level = node.level;; ++level) {
    if (level >= coarsest) {
      points_[level].add(first, end);
      if (largest(level, node.centre, ball) > static_cast<double>(view_.most_point))
        quads_[level].add(first, end);
    }
    if (level == finest) return;
    first = below(level, first);
    end = below(level, end);
  }
}

bool VoxelRanges::is_small(Node node, unsigned finest) const {
  uint32_t first = node.number, end = node.number + 1;
  for (unsigned level = node.level; level < finest; ++level) {
    first = below(level, first);
    end = below(level, end);
  }
  return end - first <= kSmallRun;
}

void VoxelRanges::visit(Node node) {
  const OctreeView::Size& size = octree_.size(node.level);
  if (!view_.touches(node.centre, (size.reach + octree_.disc_reach(node.level + 1)) * 1.001))
    return;
  // The parents of all that is below it have their centres in its ball.
  const double ball = size.reach + kRounding * (std::abs(node.centre.z) + size.reach);
  unsigned coarsest = node.level + 1;
  while (last_from_[coarsest] > -node.centre.z + ball) ++coarsest;
  unsigned finest = coarsest;
  while (last_from_[finest] > -node.centre.z - ball) ++finest;
  if (is_small(node, finest)) return add(node, coarsest, finest);
  if (coarsest == node.level + 1) add(node, coarsest, coarsest);
  if (finest == node.level + 1) return;
  const VoxelTree::Branch branch = octree_.tree().branches(node.level)[node.number];
  uint32_t child = branch.first_child;
  for (unsigned symbol = branch.symbol; symbol != 0; symbol &= symbol - 1) {
    const auto place = static_cast<size_t>(std::countr_zero(symbol));
    visit({node.level + 1, child++, node.centre + octree_.size(node.level + 1).offsets[place]});
  }
}

}  // namespace afx::render
