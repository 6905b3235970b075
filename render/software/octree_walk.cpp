// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/software/octree_walk.h"

namespace afx::render {

void OctreeWalk::run(const OctreeView& view, TileSamples& tile, std::vector<TileDisc>& seen) {
  tile_ = &tile;
  if (view.tree().voxels() == 0) return;
  begin(view, tile);
  if (view.last_level() == 0) return lay_root(view, seen);
  stack_.push_back({view.root(), 0, 0, kFar, -kFar, 0, 0});
  while (!stack_.empty()) {
    const Entry node = stack_.back();
    stack_.pop_back();
    if (painter_.is_hidden(node.x, node.y, node.reach, node.depth, tile)) continue;
    visit(view, node, seen);
  }
}

void OctreeWalk::begin(const OctreeView& view, const TileSamples& tile) {
  half_ = static_cast<float>(tile.side) / 2;
  middle_x_ = tile.left + half_;
  middle_y_ = tile.top + half_;
  const Lens& lens = view.lens();
  glm::dvec3 ray(0, 0, -1);
  if (lens.perspective) {
    ray.x = (static_cast<double>(middle_x_) - lens.middle.x) / lens.focal;
    ray.y = (lens.middle.y - static_cast<double>(middle_y_)) / lens.focal;
  }
  nearest_ = view.nearest_child(ray);
}

void OctreeWalk::push_children(const OctreeView& view, const Entry& node,
                               VoxelTree::Branch branch) {
  const unsigned level = node.level + 1;
  const OctreeView::Size& size = view.size(level);
  view.bounds(node.centre, level, bounds_);
  for_children(branch, 7, [&](unsigned i, uint32_t number) {
    const float x = bounds_.x[i], y = bounds_.y[i], reach = bounds_.reach[i];
    if (!touches(x, y, reach)) return;
    stack_.push_back({node.centre + size.offsets[i], x, y, reach, bounds_.depth[i], number, level});
  });
}

void OctreeWalk::visit(const OctreeView& view, const Entry& node, std::vector<TileDisc>& seen) {
  const VoxelTree::Branch branch = view.tree().branches(node.level)[node.number];
  const unsigned level = node.level + 1;
  if (!view.is_last(level, node.centre)) return push_children(view, node, branch);
  view.project(node.centre, branch, level, discs_);
  if (level < view.tree().level()) weights_ = view.side_weights(node.centre);
  painter_.place(discs_, *tile_, boxes_);
  for_children(branch, 0,
               [&](unsigned i, uint32_t number) { this->lay_disc(view, level, i, number, seen); });
}

void OctreeWalk::lay_disc(const OctreeView& view, unsigned level, unsigned i, uint32_t number,
                          std::vector<TileDisc>& seen) {
  if ((boxes_.filled >> i & 1U) == 0) return;
  seen.push_back({view.splat(discs_, i, level), OctreeView::tilt(discs_, i), boxes_.at(i)});
  TileDisc& disc = seen.back();
  if (painter_.lay_disc_depth(disc, *tile_)) {
    disc.splat.light = view.light(level, number, weights_);
  } else {
    seen.pop_back();
  }
}

void OctreeWalk::lay_root(const OctreeView& view, std::vector<TileDisc>& seen) {
  view.project_root(discs_);
  weights_ = view.side_weights(view.root());
  painter_.place(discs_, *tile_, boxes_);
  lay_disc(view, 0, 0, 0, seen);
}

}  // namespace afx::render
