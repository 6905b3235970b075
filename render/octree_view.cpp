// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/octree_view.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "afx/srgb.h"
#include "render/lanes.h"

namespace afx::render {
namespace {

constexpr double kBulge = 0.5;  // a part of the node's shortest side; see renderer.h
constexpr double kMostFloat = 1e12, kLeastFloat = 1e-12;  // these and their squares are floats

OctreeView::Size size_of(const glm::dmat3& cube, unsigned level, const Lens& lens, double scale,
                         SplatKind kind) {
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
  size.shift = glm::dmat3(axes[0] / 254.0, axes[1] / 254.0, axes[2] / 254.0);
  const double sides[] = {glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2])};
  size.side = std::max({sides[0], sides[1], sides[2]});
  const double shortest = std::min({sides[0], sides[1], sides[2]});
  size.radius = OctreeView::kFacetRadius * scale * size.side;
  size.bulge = static_cast<float>(kBulge * shortest);
  size.tolerance = kind == SplatKind::smooth ? static_cast<float>(kVoxelTolerance * shortest) : 0;
  return size;
}

/// Up to a factor; normals are made unit vectors afterwards.
glm::dmat3 normal_matrix(const glm::dmat3& axes, const glm::dmat3& inverse) {
  const double side = std::max({glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2])});
  const glm::dmat3 normals = glm::transpose(inverse) * side;
  for (int k = 0; k < 3; ++k) {
    const double length = glm::length(normals[k]);
    if (!(length > kLeastFloat && length < kMostFloat)) return glm::dmat3(0);
  }
  return normals;
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
      normals_(normal_matrix(axes_, to_cube_)),
      root_(lens.to_view * (glm::dvec3(cloud.local_to_world[3]) - lens.position)),
      all_face_(points_ || normals_ == glm::dmat3(0)) {
  for (unsigned level = 0; level <= last_; ++level)
    sizes_.push_back(size_of(axes_, level, lens, scale_, options.splats));
}

unsigned OctreeView::nearest_child(const glm::dvec3& ray) const {
  unsigned child = 0;
  for (int k = 0; k < 3; ++k)
    if (glm::dot(axes_[k], ray) < 0) child |= 1U << k;
  return child;
}

/// Before scaling. A corner c + h projects to (c.x + h.x)/(c.d + h.d), which is off the centre's
/// place by (h.x - c.x/c.d h.d)/(c.d + h.d); c.d + h.d is least at the nearest corner.
double OctreeView::facing_radius(const glm::dvec3& centre, const Size& size) const {
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

void OctreeView::project_tilted(const glm::dvec3& centre, const glm::dvec3& normal, unsigned level,
                                unsigned i, EightDiscs& out) const {
  const double distance = -centre.z;
  const double zoom = lens_.zoom_at(distance);
  const double radius = std::max(sizes_[level].radius, double{kLeastRadius} / zoom);
  double reach = radius * zoom;
  if (lens_.perspective) {
    const double x = centre.x / distance, y = centre.y / distance;
    const double part = 1 - radius / distance;
    reach = part > 0.25 ? reach * (1 + (x * x + y * y) / 2) / part : kMostRadius;
  }
  if (!lens_.on_screen(lens_.place(centre), std::min(reach, kMostRadius))) return;
  out.reach_x[i] = out.reach_y[i] = static_cast<float>(std::min(reach, kMostRadius));
  out.radius[i] = static_cast<float>(radius);
  out.nx[i] = static_cast<float>(normal.x);
  out.ny[i] = static_cast<float>(normal.y);
  out.nz[i] = static_cast<float>(normal.z);
  const double steep = std::max(0.0, 1 - normal.z * normal.z);
  out.nearest[i] = static_cast<float>(distance - radius * (std::sqrt(steep) + double{kRounding}));
}

void OctreeView::project_exactly(const glm::dvec3& centre, const VoxelTree::Facet& facet,
                                 unsigned level, unsigned i, EightDiscs& out) const {
  const Size& size = sizes_[level];
  const glm::dvec3 point =
      centre + size.shift * glm::dvec3(facet.shift[0], facet.shift[1], facet.shift[2]);
  out.reach_x[i] = out.reach_y[i] = out.radius[i] = -1;
  if (!lens_.in_view(point, disc_reach(level))) return;
  const glm::dvec2 at = lens_.place(point);
  out.x[i] = static_cast<float>(at.x);
  out.y[i] = static_cast<float>(at.y);
  out.depth[i] = out.nearest[i] = static_cast<float>(-point.z);
  const glm::dvec3 normal =
      normals_ * glm::dvec3(facet.normal[0], facet.normal[1], facet.normal[2]);
  const double length = glm::length(normal);
  if (length > 0 && !all_face_) return project_tilted(point, normal / length, level, i, out);
  const double wanted = points_ ? 0 : facing_radius(point, size) * scale_;
  const double r = std::clamp(wanted, double{kLeastRadius}, kMostRadius);
  if (lens_.on_screen(at, r))
    out.reach_x[i] = out.reach_y[i] = out.radius[i] = static_cast<float>(r);
}

/// Whether the children of a node lie clearly before the eye, and all numbers are ordinary ones.
bool OctreeView::is_far(const glm::dvec3& parent, unsigned level) const {
  const Size& size = sizes_[level];
  const double distance = -parent.z;
  return distance > kFarAway * std::max(size.reach, disc_reach(level)) &&
         distance - 4 * size.reach > lens_.near_plane && distance < kMostFloat &&
         distance > kLeastFloat && size.reach > kLeastFloat &&
         std::abs(parent.x) + std::abs(parent.y) < kMostFloat && lens_.focal < kMostFloat &&
         lens_.focal > kLeastFloat;
}

void OctreeView::project(const glm::dvec3& centre, VoxelTree::Branch branch, unsigned level,
                         EightDiscs& out) const {
  if (is_far(centre, level)) {
    return has_avx2() ? project_far_avx2(centre, branch, level, out)
                      : project_far_plain(centre, branch, level, out);
  }
  out = {};
  uint32_t number = branch.first_child;
  for (unsigned i = 0; i < 8; ++i) {
    if ((branch.symbol >> i & 1U) == 0) continue;
    project_exactly(centre + sizes_[level].offsets[i], tree_->facets(level)[number++], level, i,
                    out);
  }
  tilt_plain(level, out);
}

void OctreeView::project_root(EightDiscs& out) const {
  out = {};
  project_exactly(root_, tree_->facets(0)[0], 0, 0, out);
  tilt_plain(0, out);
}

void OctreeView::bounds(const glm::dvec3& centre, unsigned level, EightBounds& out) const {
  has_avx2() ? bounds_avx2(centre, level, out) : bounds_plain(centre, level, out);
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

}  // namespace afx::render
