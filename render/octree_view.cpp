// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/octree_view.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "afx/srgb.h"
#include "render/lanes.h"

namespace afx::render {
namespace {

constexpr double kBulge = 0.5;          // a part of the node's shortest side; see renderer.h
constexpr float kRounding = 1e-3F;      // of depths, as a part of a radius
constexpr float kLeastStretch = 0.25F;  // a disc nearer to the eye is not bounded closely
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
  out.reach[i] = static_cast<float>(std::min(reach, kMostRadius));
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
  const glm::dvec2 at = lens_.place(point);
  out.x[i] = static_cast<float>(at.x);
  out.y[i] = static_cast<float>(at.y);
  out.depth[i] = static_cast<float>(-point.z);
  out.nearest[i] = out.depth[i];
  out.nx[i] = out.ny[i] = out.nz[i] = 0;
  out.reach[i] = out.radius[i] = -1;
  if (!lens_.in_view(point, disc_reach(level))) return;
  const glm::dvec3 normal =
      normals_ * glm::dvec3(facet.normal[0], facet.normal[1], facet.normal[2]);
  const double length = glm::length(normal);
  if (length > 0 && !all_face_) return project_tilted(point, normal / length, level, i, out);
  const double wanted = points_ ? 0 : facing_radius(point, size) * scale_;
  const double r = std::clamp(wanted, double{kLeastRadius}, kMostRadius);
  if (lens_.on_screen(at, r)) out.reach[i] = out.radius[i] = static_cast<float>(r);
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

void OctreeView::gather(VoxelTree::Branch branch, unsigned level, EightFacets& facets) const {
  const VoxelTree::Facet* next = tree_->facets(level).data() + branch.first_child;
  facets.all_tilted = !all_face_;
  for (unsigned i = 0; i < 8; ++i) {
    const bool is_there = (branch.symbol >> i & 1U) != 0;
    const VoxelTree::Facet facet = is_there ? *next++ : VoxelTree::Facet{{0, 0, 1}, {0, 0, 0}};
    facets.sx[i] = facet.shift[0];
    facets.sy[i] = facet.shift[1];
    facets.sz[i] = facet.shift[2];
    const float tilted = all_face_ ? 0 : 1;
    facets.nx[i] = tilted * facet.normal[0];
    facets.ny[i] = tilted * facet.normal[1];
    facets.nz[i] = tilted * facet.normal[2];
    facets.all_tilted =
        facets.all_tilted && (facet.normal[0] | facet.normal[1] | facet.normal[2]) != 0;
  }
}

/// project_exactly for eight at once, in floats.
template <bool kPerspective>
AFX_PART_OF_CALLER void OctreeView::project_far(const glm::dvec3& centre, const EightFacets& facets,
                                                unsigned level, EightDiscs& out) const {
  const Size& size = sizes_[level];
  const glm::mat3 shift(size.shift), turn(normals_);
  const glm::vec3 c(centre);
  const auto focal = static_cast<float>(lens_.focal);
  const glm::vec2 middle(lens_.middle);
  float slope_x[8], slope_y[8], inverse[8];
  for (int i = 0; i < 8; ++i) {
    const float sx = facets.sx[i], sy = facets.sy[i], sz = facets.sz[i];
    const float px = c.x + size.x[i] + (shift[0].x * sx + shift[1].x * sy + shift[2].x * sz);
    const float py = c.y + size.y[i] + (shift[0].y * sx + shift[1].y * sy + shift[2].y * sz);
    const float pz = c.z + size.z[i] + (shift[0].z * sx + shift[1].z * sy + shift[2].z * sz);
    out.depth[i] = -pz;
    inverse[i] = kPerspective ? 1 / -pz : 1.0F;
    slope_x[i] = px * inverse[i];
    slope_y[i] = py * inverse[i];
    out.x[i] = middle.x + slope_x[i] * focal;
    out.y[i] = middle.y - slope_y[i] * focal;
  }
  const auto facet_radius = static_cast<float>(size.radius);
  for (int i = 0; i < 8; ++i) {
    const float lx = facets.nx[i], ly = facets.ny[i], lz = facets.nz[i];
    const float nx = turn[0].x * lx + turn[1].x * ly + turn[2].x * lz;
    const float ny = turn[0].y * lx + turn[1].y * ly + turn[2].y * lz;
    const float nz = turn[0].z * lx + turn[1].z * ly + turn[2].z * lz;
    const float square = nx * nx + ny * ny + nz * nz;
    const float unit = 1 / std::sqrt(square > 0 ? square : 1.0F);
    out.nx[i] = nx * unit;
    out.ny[i] = ny * unit;
    out.nz[i] = nz * unit;
    const float zoom = focal * inverse[i];
    const float radius = std::max(facet_radius, kLeastRadius / zoom);
    const float steep = std::max(0.0F, 1 - out.nz[i] * out.nz[i]);
    out.radius[i] = radius;
    out.nearest[i] = out.depth[i] - radius * (std::sqrt(steep) + kRounding);
    out.reach[i] = radius * zoom;
    if (kPerspective)
      out.reach[i] *=
          (1 + (slope_x[i] * slope_x[i] + slope_y[i] * slope_y[i]) / 2) / (1 - radius * inverse[i]);
  }
  if (facets.all_tilted) return;
  const auto scale = static_cast<float>(points_ ? 0 : scale_);
  const auto half_depth = static_cast<float>(size.half_depth);
  const auto flat_radius = static_cast<float>(size.flat_radius);
  for (int i = 0; i < 8; ++i) {
    float longest = 0;
    for (int k = 0; k < 4; ++k) {
      const float dx = size.dx[k] + slope_x[i] * size.dz[k];
      const float dy = size.dy[k] + slope_y[i] * size.dz[k];
      longest = std::max(longest, dx * dx + dy * dy);
    }
    const float facing =
        kPerspective ? focal * std::sqrt(longest) / (out.depth[i] - half_depth) : flat_radius;
    const float disc = std::max(facing * scale, kLeastRadius);
    const bool tilted = out.nx[i] != 0 || out.ny[i] != 0 || out.nz[i] != 0;
    out.radius[i] = tilted ? out.radius[i] : disc;
    out.reach[i] = tilted ? out.reach[i] : disc;
    out.nearest[i] = tilted ? out.nearest[i] : out.depth[i];
  }
}

void OctreeView::project_far_plain(const glm::dvec3& centre, const EightFacets& facets,
                                   unsigned level, EightDiscs& out) const {
  if (lens_.perspective) return project_far<true>(centre, facets, level, out);
  project_far<false>(centre, facets, level, out);
}

#if defined(__x86_64__)
__attribute__((target("avx2")))
#endif
void OctreeView::project_far_avx2(const glm::dvec3& centre, const EightFacets& facets,
                                  unsigned level, EightDiscs& out) const {
  if (lens_.perspective) return project_far<true>(centre, facets, level, out);
  project_far<false>(centre, facets, level, out);
}

void OctreeView::project(const glm::dvec3& centre, VoxelTree::Branch branch, unsigned level,
                         EightDiscs& out) const {
  if (is_far(centre, level)) {
    EightFacets facets;
    gather(branch, level, facets);
    return has_avx2() ? project_far_avx2(centre, facets, level, out)
                      : project_far_plain(centre, facets, level, out);
  }
  uint32_t number = branch.first_child;
  for (unsigned i = 0; i < 8; ++i) {
    if ((branch.symbol >> i & 1U) == 0) continue;
    project_exactly(centre + sizes_[level].offsets[i], tree_->facets(level)[number++], level, i,
                    out);
  }
}

void OctreeView::project_root(EightDiscs& out) const {
  project_exactly(root_, tree_->facets(0)[0], 0, 0, out);
}

/// The ray through a sample is r = r0 + w (x, -y, 0) / d, r0 that through the centre at depth d, w
/// the scene units of a sample there. It meets the plane n . (p - c) = 0 at the depth
/// d (n . r0) / (n . r), which is d + k e of Tilt with e = -w (n.x x - n.y y) / (n . r0). There
/// p - c = k (e r0 + w (x, -y, 0)), whose square is `out` times that of the radius. In parallel
/// projection r0 = (0, 0, -1). A disc seen so much from the side that it would be narrower than
/// kLeastRadius is turned a little.
Tilt OctreeView::tilt(const EightDiscs& discs, unsigned i, unsigned level, Splat& outline) const {
  const float depth = discs.depth[i], radius = discs.radius[i];
  const float inverse = 1 / (radius * radius);
  const glm::vec3 n(discs.nx[i], discs.ny[i], discs.nz[i]);
  if (n.x == 0 && n.y == 0 && n.z == 0) return {0, 0, 0, inverse, 0, inverse, sizes_[level].bulge};
  const auto focal = static_cast<float>(lens_.focal);
  const float w = (lens_.perspective ? depth : 1) / focal;
  glm::vec3 ray(0, 0, -1);
  if (lens_.perspective) {
    ray.x = (outline.x - static_cast<float>(lens_.middle.x)) / focal;
    ray.y = (static_cast<float>(lens_.middle.y) - outline.y) / focal;
  }
  const float least = kLeastRadius * w / radius * ((1 + glm::dot(ray, ray)) / 2);  // >= the root
  const float straight = glm::dot(n, ray);
  const float facing = std::copysign(std::max(std::abs(straight), least), straight);
  const float turned = w / facing, e_x = -turned * n.x, e_y = turned * n.y;
  const glm::vec3 along_x = e_x * ray + glm::vec3(w, 0, 0);
  const glm::vec3 along_y = e_y * ray - glm::vec3(0, w, 0);
  const float a = glm::dot(along_x, along_x) * inverse, b = glm::dot(along_x, along_y) * inverse,
              c = glm::dot(along_y, along_y) * inverse;
  const float nearness = lens_.perspective ? 1 / depth : 0;
  const Tilt tilt{e_x, e_y, nearness, a, b, c, 0};
  const float area = a * c - b * b;
  const float stretch = 1 / std::max(kLeastStretch, 1 - nearness * (depth - outline.nearest));
  if (!(area > 0) || stretch > 1 / (2 * kLeastStretch)) return tilt;
  const float part = 1 / area;
  outline.reach_x = std::min(outline.reach_x, std::sqrt(c * part) * stretch);
  outline.reach_y = std::min(outline.reach_y, std::sqrt(a * part) * stretch);
  return tilt;
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

/// Discs of descendants have their centres in the node, and are not larger than those of the level
/// after next, if the next is not drawn itself. A ball of radius r at distance d, its nearest point
/// d - r away, reaches on the screen at most r sqrt(1 + x^2 + y^2) / (d - r) from its centre at the
/// slopes x, y. No disc is smaller than kLeastRadius.
OctreeView::Bound OctreeView::bound(const glm::dvec3& centre, unsigned level) const {
  const Size& size = sizes_[level];
  const unsigned finer = is_last(level + 1, centre) ? level + 1 : level + 2;
  const Size& next = sizes_[finer];
  constexpr float kNoBound = std::numeric_limits<float>::infinity();
  const double distance = -centre.z;
  const double least = double{kLeastRadius} / lens_.zoom_at(std::max(distance + size.reach, 0.0));
  const double reach = (size.reach + std::max(disc_reach(finer), least)) * 1.001;
  const auto depth = static_cast<float>((distance - size.half_depth - std::max(next.radius, least) -
                                         static_cast<double>(next.tolerance)) *
                                        (1 - 1e-6));
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
