// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The eight children of a node at once, in lanes: the loops are what compilers make vectors of.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "render/lanes.h"
#include "render/octree_view.h"

namespace afx::render {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();
constexpr float kLeastStretch = 0.25F;  // a disc nearer to the eye is not bounded closely
constexpr double kMargin = 0.25;        // of bounds, in samples: more than floats are wrong

/// For each symbol, the place of each child among those that are there; for one that is not, that
/// of another.
constexpr std::array<std::array<uint8_t, 8>, 256> kRanks = [] {
  std::array<std::array<uint8_t, 8>, 256> ranks{};
  for (unsigned symbol = 1; symbol < 256; ++symbol) {
    for (unsigned i = 0; i < 8; ++i) {
      const int before = std::popcount(symbol & ((1U << i) - 1));
      ranks[symbol][i] = static_cast<uint8_t>(std::min(before, std::popcount(symbol) - 1));
    }
  }
  return ranks;
}();

/// Four numbers in one, the first in its lowest byte.
AFX_PART_OF_CALLER uint32_t packed(int8_t a, int8_t b, int8_t c, int8_t d) {
  const auto byte = [](int8_t n) { return uint32_t{static_cast<uint8_t>(n)}; };
  return byte(a) | byte(b) << 8 | byte(c) << 16 | byte(d) << 24;
}

template <int kByte>
AFX_PART_OF_CALLER float unpacked(uint32_t numbers) {
  return static_cast<float>(static_cast<int32_t>(numbers << (24 - 8 * kByte)) >> 24);
}

}  // namespace

AFX_PART_OF_CALLER void OctreeView::gather(VoxelTree::Branch branch, unsigned level,
                                           EightFacets& facets) const {
  const VoxelTree::Facet* const first = tree_->facets(level).data() + branch.first_child;
  const std::array<uint8_t, 8>& ranks = kRanks[branch.symbol];
  uint32_t normals[8], shifts[8];
  for (int i = 0; i < 8; ++i) {
    const VoxelTree::Facet& facet = first[ranks[static_cast<size_t>(i)]];
    normals[i] = packed(facet.normal[0], facet.normal[1], facet.normal[2], facet.shift[0]);
    shifts[i] = packed(facet.shift[1], facet.shift[2], 0, 0);
  }
  const float tilted = all_face_ ? 0 : 1;
  uint32_t flat = all_face_ ? 1 : 0;
  for (int i = 0; i < 8; ++i) {
    facets.nx[i] = tilted * unpacked<0>(normals[i]);
    facets.ny[i] = tilted * unpacked<1>(normals[i]);
    facets.nz[i] = tilted * unpacked<2>(normals[i]);
    facets.sx[i] = unpacked<3>(normals[i]);
    facets.sy[i] = unpacked<0>(shifts[i]);
    facets.sz[i] = unpacked<1>(shifts[i]);
    flat |= (normals[i] & 0xffffffU) == 0 ? 1U : 0U;
  }
  facets.all_tilted = flat == 0;
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
    float reach = radius * zoom;
    if (kPerspective)
      reach *=
          (1 + (slope_x[i] * slope_x[i] + slope_y[i] * slope_y[i]) / 2) / (1 - radius * inverse[i]);
    out.reach_x[i] = out.reach_y[i] = reach;
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
    out.reach_x[i] = out.reach_y[i] = tilted ? out.reach_x[i] : disc;
    out.nearest[i] = tilted ? out.nearest[i] : out.depth[i];
  }
}

/// The ray through a sample is r = r0 + w (x, -y, 0) / d, r0 that through the centre at depth d, w
/// the scene units of a sample there. It meets the plane n . (p - c) = 0 at the depth
/// d (n . r0) / (n . r), which is d + k e of Tilt with e = -w (n.x x - n.y y) / (n . r0). There
/// p - c = k (e r0 + w (x, -y, 0)), whose square is `out` times that of the radius. In parallel
/// projection r0 = (0, 0, -1). A disc seen so much from the side that it would be narrower than
/// kLeastRadius is turned a little.
///
/// Besides, the rectangles that hold the discs become closer.
template <bool kPerspective>
AFX_PART_OF_CALLER void OctreeView::tilt_all(unsigned level, EightDiscs& discs) const {
  const float bulge = sizes_[level].bulge;
  const auto focal = static_cast<float>(lens_.focal);
  const glm::vec2 middle(lens_.middle);
  for (int i = 0; i < 8; ++i) {
    const float depth = discs.depth[i], radius = discs.radius[i];
    const float nx = discs.nx[i], ny = discs.ny[i], nz = discs.nz[i];
    const bool faces = (nx == 0) & (ny == 0) & (nz == 0);
    const float inverse = 1 / (radius * radius);
    const float w = (kPerspective ? depth : 1) / focal;
    const float ray_x = kPerspective ? (discs.x[i] - middle.x) / focal : 0;
    const float ray_y = kPerspective ? (middle.y - discs.y[i]) / focal : 0;
    const float square = ray_x * ray_x + ray_y * ray_y + 1;
    const float least = kLeastRadius * w / radius * ((1 + square) / 2);  // >= the root
    const float straight = nx * ray_x + ny * ray_y - nz;
    const float facing = std::copysign(std::max(std::abs(straight), least), straight);
    const float turned = w / facing, e_x = -turned * nx, e_y = turned * ny;
    const float xx = e_x * ray_x + w, xy = e_x * ray_y;  // along x; the third is -e_x
    const float yx = e_y * ray_x, yy = e_y * ray_y - w;
    const float a = (xx * xx + xy * xy + e_x * e_x) * inverse;
    const float b = (xx * yx + xy * yy + e_x * e_y) * inverse;
    const float c = (yx * yx + yy * yy + e_y * e_y) * inverse;
    const float nearness = kPerspective ? 1 / depth : 0;
    discs.depth_x[i] = faces ? 0 : e_x;
    discs.depth_y[i] = faces ? 0 : e_y;
    discs.nearness[i] = faces ? 0 : nearness;
    discs.a[i] = faces ? inverse : a;
    discs.b[i] = faces ? 0 : b;
    discs.c[i] = faces ? inverse : c;
    discs.bulge[i] = faces ? bulge : 0;
    const float ball = depth - radius * (1 + kRounding);  // no part of a turned one is nearer
    const float edge = std::abs(straight) < least ? ball : discs.nearest[i];
    const float nearest = faces ? discs.nearest[i] : edge;
    discs.nearest[i] = nearest;
    const float part_in_front = std::max(kLeastStretch, 1 - nearness * (depth - nearest));
    const float stretch = part_in_front >= 2 * kLeastStretch ? 1 / part_in_front : kFar;
    const float limit = faces ? kFar : stretch;
    const float area = a * c - b * b, part = 1 / area;
    const float reach_x = std::min(discs.reach_x[i], std::sqrt(c * part) * limit);
    const float reach_y = std::min(discs.reach_y[i], std::sqrt(a * part) * limit);
    discs.reach_x[i] = area > 0 ? reach_x : discs.reach_x[i];
    discs.reach_y[i] = area > 0 ? reach_y : discs.reach_y[i];
  }
}

/// Discs of descendants have their centres in the node, and are not larger than those of the level
/// after next, if the next is not drawn itself. A ball of radius r at distance d, its nearest point
/// d - r away, reaches on the screen at most r sqrt(1 + x^2 + y^2) / (d - r) from its centre at the
/// slopes x, y. No disc is smaller than kLeastRadius.
template <bool kPerspective>
AFX_PART_OF_CALLER void OctreeView::bound_all(const glm::dvec3& centre, unsigned level,
                                              EightBounds& out) const {
  constexpr double kUnknown = std::numeric_limits<double>::infinity();
  const Size& size = sizes_[level];
  const Size& next = sizes_[level + 1];
  const unsigned finest = std::min(level + 2, last_);
  const double next_reach = disc_reach(level + 1), finest_reach = disc_reach(finest);
  const double next_depth = next.radius + static_cast<double>(next.tolerance);
  const double finest_depth = sizes_[finest].radius + static_cast<double>(sizes_[finest].tolerance);
  const double focal = lens_.focal, near_plane = lens_.near_plane, coarseness = coarseness_;
  const glm::dvec2 middle = lens_.middle;
  for (int i = 0; i < 8; ++i) {
    const double x = centre.x + size.offsets[i].x, y = centre.y + size.offsets[i].y;
    const double distance = -(centre.z + size.offsets[i].z);
    const double zoom = kPerspective ? focal / distance : focal;
    const bool is_far_away = kPerspective ? distance > kFarAway * next.side : true;
    const bool is_next = is_far_away & (zoom * next.side <= coarseness);
    const double least =
        double{kLeastRadius} / focal * (kPerspective ? std::max(distance + size.reach, 0.0) : 1);
    const double reach =
        (size.reach + std::max(is_next ? next_reach : finest_reach, least)) * 1.001;
    const double before = size.half_depth + (is_next ? next_depth : finest_depth) + least;
    const double nearest = kPerspective ? distance - reach : 1;
    const double slope_x = x / distance, slope_y = y / distance;
    const double slant = kPerspective ? 1 + (slope_x * slope_x + slope_y * slope_y) / 2 : 1;
    const bool is_known = kPerspective ? (nearest > reach) & (nearest > near_plane) : true;
    const double around = is_known ? focal * reach * slant / nearest + kMargin : kUnknown;
    const bool is_behind = distance + size.half_depth < near_plane;
    out.x[i] = static_cast<float>(is_known ? middle.x + x * zoom : 0);
    out.y[i] = static_cast<float>(is_known ? middle.y - y * zoom : 0);
    out.reach[i] = static_cast<float>(is_behind ? -kUnknown : around);
    out.depth[i] = static_cast<float>(is_known ? (distance - before) * (1 - 1e-6) : -kUnknown);
  }
}

/// The functions for eight children. name   of the kind of processor; attributes   for it
#define AFX_DEFINE_EIGHT(name, attributes)                                                         \
  attributes void OctreeView::project_far_##name(                                                  \
      const glm::dvec3& centre, VoxelTree::Branch branch, unsigned level, EightDiscs& out) const { \
    EightFacets facets;                                                                            \
    gather(branch, level, facets);                                                                 \
    if (lens_.perspective) {                                                                       \
      project_far<true>(centre, facets, level, out);                                               \
      tilt_all<true>(level, out);                                                                  \
    } else {                                                                                       \
      project_far<false>(centre, facets, level, out);                                              \
      tilt_all<false>(level, out);                                                                 \
    }                                                                                              \
  }                                                                                                \
  attributes void OctreeView::bounds_##name(const glm::dvec3& centre, unsigned level,              \
                                            EightBounds& out) const {                              \
    if (lens_.perspective) return bound_all<true>(centre, level, out);                             \
    bound_all<false>(centre, level, out);                                                          \
  }

AFX_DEFINE_EIGHT(plain, )
#if defined(__x86_64__)
AFX_DEFINE_EIGHT(avx2, __attribute__((target("avx2"))))
#else
AFX_DEFINE_EIGHT(avx2, )  // has_avx2() says no
#endif
#undef AFX_DEFINE_EIGHT

void OctreeView::tilt_plain(unsigned level, EightDiscs& discs) const {
  lens_.perspective ? tilt_all<true>(level, discs) : tilt_all<false>(level, discs);
}

}  // namespace afx::render
