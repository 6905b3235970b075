// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/software/octree_view.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "afx/srgb.h"
#include "render/software/splats.h"

namespace afx::render {
namespace {

constexpr double kBulge = 0.5;  // a part of the node's shortest side; see renderer.h
constexpr double kFarAway = 8;  // nodes so many of their reaches away are reckoned in floats
constexpr double kMostFloat = 1e12, kLeastFloat = 1e-12;  // these and their squares are floats

OctreeView::Size size_of(const glm::dmat3& cube, unsigned level, const Lens& lens, SplatKind kind) {
  OctreeView::Size size{};
  const double part = std::ldexp(1.0, -static_cast<int>(level));
  const glm::dmat3 axes(cube[0] * part, cube[1] * part, cube[2] * part);
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 to_child((i & 1) != 0 ? 0.5 : -0.5, (i & 2) != 0 ? 0.5 : -0.5,
                              (i & 4) != 0 ? 0.5 : -0.5);
    size.offsets[i] = axes * to_child;
    size.x[i] = static_cast<float>(size.offsets[i].x);
    size.y[i] = static_cast<float>(size.offsets[i].y);
    size.z[i] = static_cast<float>(size.offsets[i].z);
  }
  for (int k = 0; k < 4; ++k) {
    const glm::dvec3 h =
        axes * glm::dvec3(k == 1 ? -0.5 : 0.5, k == 2 ? -0.5 : 0.5, k == 3 ? -0.5 : 0.5);
    size.diagonals[k] = h;
    size.dx[k] = static_cast<float>(h.x);
    size.dy[k] = static_cast<float>(h.y);
    size.dz[k] = static_cast<float>(h.z);
    size.reach = std::max(size.reach, glm::length(h));
    size.half_depth = std::max(size.half_depth, std::abs(h.z));
    size.flat_radius = std::max(size.flat_radius, glm::length(glm::dvec2(h)) * lens.focal);
  }
  const double sides[] = {glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2])};
  size.side = std::max({sides[0], sides[1], sides[2]});
  const double shortest = std::min({sides[0], sides[1], sides[2]});
  size.bulge = static_cast<float>(kBulge * shortest);
  size.tolerance = kind == SplatKind::smooth ? static_cast<float>(kTolerance * shortest) : 0;
  return size;
}

}  // namespace

OctreeView::OctreeView(const VoxelCloud& cloud, const Lens& lens, const RenderOptions& options)
    : tree_(cloud.tree.get()),
      lens_(lens),
      linear_(srgb_to_linear()),
      last_(std::min(cloud.tree->level(), options.finest_level)),
      scale_(options.splat_scale),
      points_(options.splats == SplatKind::points),
      coarseness_(options.coarseness),
      axes_(lens.to_view * glm::dmat3(cloud.local_to_world)),
      to_cube_(glm::inverse(axes_)),
      root_(lens.to_view * (glm::dvec3(cloud.local_to_world[3]) - lens.position)) {
  for (unsigned level = 0; level <= last_; ++level)
    sizes_.push_back(size_of(axes_, level, lens, options.splats));
}

bool OctreeView::is_last(unsigned level, const glm::dvec3& parent) const {
  if (level == last_) return true;
  const double distance = -parent.z;
  const double side = sizes_[level].side;
  if (lens_.perspective && !(distance > kFarAway * side)) return false;
  return lens_.zoom_at(distance) * side <= coarseness_;
}

unsigned OctreeView::nearest_child(const glm::dvec3& ray) const {
  unsigned child = 0;
  for (int k = 0; k < 3; ++k)
    if (glm::dot(axes_[k], ray) < 0) child |= 1U << k;
  return child;
}

/// Before scaling. A corner c + h projects to (c.x + h.x)/(c.d + h.d), which is off the centre's
/// place by (h.x - c.x/c.d h.d)/(c.d + h.d); c.d + h.d is least at the nearest corner.
double OctreeView::radius(const glm::dvec3& centre, const Size& size) const {
  if (!lens_.perspective) return size.flat_radius;
  const double distance = -centre.z;
  if (distance < 2 * size.half_depth) return lens_.focal * size.reach / distance;
  const double x = centre.x / distance, y = centre.y / distance;
  double longest = 0;
  for (const glm::dvec3& h : size.diagonals) {
    const double dx = h.x + x * h.z, dy = h.y + y * h.z;  // h.d = -h.z
    longest = std::max(longest, dx * dx + dy * dy);
  }
  return lens_.focal * std::sqrt(longest) / (distance - size.half_depth);
}

void OctreeView::project_exactly(const glm::dvec3& centre, unsigned level, int child,
                                 EightDiscs& out) const {
  const Size& size = sizes_[level];
  out.x[child] = out.y[child] = out.depth[child] = 0;
  out.radius[child] = -1;
  if (!lens_.in_view(centre, scale_ * size.reach)) return;
  const glm::dvec2 at = lens_.place(centre);
  const double wanted = points_ ? 0 : radius(centre, size) * scale_;
  const double r = std::clamp(wanted, double{kLeastRadius}, kMostRadius);
  if (!lens_.on_screen(at, r)) return;
  out.x[child] = static_cast<float>(at.x);
  out.y[child] = static_cast<float>(at.y);
  out.depth[child] = static_cast<float>(-centre.z);
  out.radius[child] = static_cast<float>(r);
}

/// Whether the children of a node lie clearly before the eye, and all numbers are ordinary ones.
bool OctreeView::is_far(const glm::dvec3& parent, unsigned level) const {
  const Size& size = sizes_[level];
  const double distance = -parent.z;
  return distance > kFarAway * size.reach && distance - 4 * size.reach > lens_.near_plane &&
         distance < kMostFloat && distance > kLeastFloat && size.reach > kLeastFloat &&
         std::abs(parent.x) + std::abs(parent.y) < kMostFloat && lens_.focal < kMostFloat &&
         lens_.focal > kLeastFloat;
}

void OctreeView::project(const glm::dvec3& parent, unsigned level, EightDiscs& out) const {
  const Size& size = sizes_[level];
  if (!is_far(parent, level)) {
    for (int i = 0; i < 8; ++i) project_exactly(parent + size.offsets[i], level, i, out);
    return;
  }
  const auto px = static_cast<float>(parent.x), py = static_cast<float>(parent.y);
  const auto distance = static_cast<float>(-parent.z), focal = static_cast<float>(lens_.focal);
  const auto middle_x = static_cast<float>(lens_.middle.x);
  const auto middle_y = static_cast<float>(lens_.middle.y);
  const auto scale = static_cast<float>(points_ ? 0 : scale_);
  const auto half_depth = static_cast<float>(size.half_depth);
  if (!lens_.perspective) {
    const float radius = std::max(static_cast<float>(size.flat_radius) * scale, kLeastRadius);
    for (int i = 0; i < 8; ++i) {
      out.depth[i] = distance - size.z[i];
      out.x[i] = middle_x + (px + size.x[i]) * focal;
      out.y[i] = middle_y - (py + size.y[i]) * focal;
      out.radius[i] = radius;
    }
    return;
  }
  for (int i = 0; i < 8; ++i) {
    const float depth = distance - size.z[i];
    const float x = (px + size.x[i]) / depth, y = (py + size.y[i]) / depth;
    float longest = 0;
    for (int k = 0; k < 4; ++k) {
      const float dx = size.dx[k] + x * size.dz[k], dy = size.dy[k] + y * size.dz[k];
      longest = std::max(longest, dx * dx + dy * dy);
    }
    out.depth[i] = depth;
    out.x[i] = middle_x + x * focal;
    out.y[i] = middle_y - y * focal;
    out.radius[i] =
        std::max(focal * std::sqrt(longest) / (depth - half_depth) * scale, kLeastRadius);
  }
}

OctreeView::SideWeights OctreeView::side_weights(const glm::dvec3& centre) const {
  const glm::dvec3 to_eye = to_cube_ * (lens_.perspective ? -centre : glm::dvec3(0, 0, 1));
  const double square = glm::dot(to_eye, to_eye);
  SideWeights weights{};
  if (!(square > 0) || !std::isfinite(square)) return {{1, 0, 0, 0, 0, 0}};
  for (int k = 0; k < 3; ++k)
    weights.of[2 * k + (to_eye[k] < 0 ? 1 : 0)] =
        static_cast<float>(to_eye[k] * to_eye[k] / square);
  return weights;
}

glm::vec3 OctreeView::light(unsigned level, uint32_t number, const SideWeights& weights) const {
  const auto light_of = [this](Rgba8 c) {
    return glm::vec3(linear_[c.r], linear_[c.g], linear_[c.b]);
  };
  if (level == tree_->level()) return light_of(tree_->colours()[number]);
  const VoxelTree::Sides& sides = tree_->sides(level)[number];
  glm::vec3 light(0);
  for (int side = 0; side < 6; ++side)
    if (weights.of[side] > 0) light += weights.of[side] * light_of(sides.from[side]);
  return light;
}

/// Descendants have their centres in the node, and discs not larger than their enclosing spheres
/// times the scale. A ball of radius r at distance d, its nearest point d - r away, reaches on the
/// screen at most r sqrt(1 + x^2 + y^2) / (d - r) from its centre at the slopes x, y.
OctreeView::Bound OctreeView::bound(const glm::dvec3& centre, unsigned level) const {
  const Size& size = sizes_[level];
  constexpr float kNoBound = std::numeric_limits<float>::infinity();
  const double distance = -centre.z;
  const double reach = size.reach * (1 + (scale_ - 1) / 2) * 1.001;
  const auto depth = static_cast<float>(
      (distance - size.half_depth - static_cast<double>(size.tolerance)) * (1 - 1e-6));
  if (distance + size.half_depth < lens_.near_plane) return {0, 0, -kNoBound, kNoBound};
  if (!lens_.perspective) {
    const glm::dvec2 at = lens_.place(centre);
    return {static_cast<float>(at.x), static_cast<float>(at.y),
            static_cast<float>(reach * lens_.focal) + 1, depth};
  }
  const double nearest = distance - reach;
  if (!(nearest > reach) || !(nearest > lens_.near_plane)) return {0, 0, kNoBound, -kNoBound};
  const double x = centre.x / distance, y = centre.y / distance;
  const double slant = 1 + (x * x + y * y) / 2;  // at least the root
  return {static_cast<float>(lens_.middle.x + x * lens_.focal),
          static_cast<float>(lens_.middle.y - y * lens_.focal),
          static_cast<float>(lens_.focal * reach * slant / nearest) + 1, depth};
}

}  // namespace afx::render
