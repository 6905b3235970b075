// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/software/octree_walk.h"

namespace afx::render {

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

void OctreeWalk::push(const OctreeView& view, unsigned level, uint32_t number,
                      const glm::dvec3& centre) {
  const OctreeView::Bound bound = view.bound(centre, level);
  if (!touches(bound.x, bound.y, bound.reach)) return;
  stack_.push_back({centre, bound, number, level});
}

bool OctreeWalk::is_hidden(const Entry& node, TileSamples& tile) {
  const float x = node.bound.x - tile.left, y = node.bound.y - tile.top;
  return tile.hides(x - node.bound.reach, y - node.bound.reach, x + node.bound.reach,
                    y + node.bound.reach, node.bound.depth);
}

}  // namespace afx::render
