// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/software/surfel_splats.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "afx/srgb.h"

namespace afx::render {
namespace {

constexpr double kLeastSquareness = 1e-3;

struct Proportions {
  double shorter;     ///< the height over the longer side; of a rectangle, the shorter side
  double squareness;  ///< that as a part of the longer side
};

Proportions proportions_of(const glm::dvec3& u, const glm::dvec3& v) {
  const double longer = std::max(glm::length(u), glm::length(v));
  if (!(longer > 0)) return {0, 0};
  const double shorter = glm::length(glm::cross(u, v)) / longer;
  return {2 * shorter, shorter / longer};
}

/// Makes the parallelogram so wide that the disc of radius kLeastRadius fits in (nearly so, if both
/// sides are as short as that), by moving the sides apart.
void widen(glm::dvec2& u, glm::dvec2& v) {
  if (glm::dot(u, u) < glm::dot(v, v)) return widen(v, u);
  const double length = glm::length(u);
  const glm::dvec2 along = length > 0 ? u / length : glm::dvec2(1, 0);
  const glm::dvec2 across(-along.y, along.x);
  const double height = glm::dot(v, across);
  u = along * std::max<double>(length, kLeastRadius);
  v += across * (std::copysign(std::max<double>(std::abs(height), kLeastRadius), height) - height);
}

}  // namespace

SurfelProjection::SurfelProjection(const SurfelCloud& cloud, const Lens& lens,
                                   const RenderOptions& options)
    : surfels_(*cloud.surfels),
      lens_(lens),
      scale_(options.splats == SplatKind::points ? 0 : options.splat_scale * kSurfelMargin),
      tolerance_(options.splats == SplatKind::smooth ? kSurfelTolerance : 0),
      axes_(lens.to_view * glm::dmat3(cloud.local_to_world)),
      origin_(lens.to_view * (glm::dvec3(cloud.local_to_world[3]) - lens.position)) {}

SurfelProjection::Half SurfelProjection::half(const glm::dvec3& centre,
                                              const glm::dvec3& side) const {
  glm::dvec2 offset(side);
  if (lens_.perspective) offset -= glm::dvec2(centre) * (side.z / centre.z);
  return {glm::dvec2(offset.x, -offset.y) * lens_.zoom_at(-centre.z), -side.z};
}

/// How far the corners are from the centre on the screen. A point that lies e deeper than the
/// centre is nearer to it by depth / (depth + e).
glm::dvec2 SurfelProjection::reach(const Half& u, const Half& v, double depth) const {
  glm::dvec2 farthest(0);
  for (const double s : {-1.0, 1.0}) {
    for (const double t : {-1.0, 1.0}) {
      double zoom = 1;
      if (lens_.perspective) {
        const double part = 1 + (s * u.depth + t * v.depth) / depth;
        if (part < 1e-6) return glm::dvec2(kMostRadius);  // beside or behind the eye
        zoom = 1 / part;
      }
      farthest = glm::max(farthest, zoom * glm::abs(s * u.offset + t * v.offset));
    }
  }
  return glm::min(farthest, glm::dvec2(kMostRadius));
}

bool SurfelProjection::project_surfel(size_t number, Splat& splat, Slant& slant) const {
  const glm::dvec3 centre = axes_ * surfels_.centres[number] + origin_;
  const glm::dvec3 side_u = axes_ * glm::dvec3(surfels_.u[number]);
  const glm::dvec3 side_v = axes_ * glm::dvec3(surfels_.v[number]);
  if (!lens_.in_view(centre, scale_ * (glm::length(side_u) + glm::length(side_v)))) return false;
  const double depth = -centre.z;
  Half u = half(centre, scale_ * side_u);
  Half v = half(centre, scale_ * side_v);
  widen(u.offset, v.offset);
  const glm::dvec2 at = lens_.place(centre);
  const glm::dvec2 reached = reach(u, v, depth);
  const double area = u.offset.x * v.offset.y - u.offset.y * v.offset.x;
  if (!lens_.on_screen(at, std::max(reached.x, reached.y)) || !std::isfinite(area)) return false;

  splat.x = static_cast<float>(at.x);
  splat.y = static_cast<float>(at.y);
  splat.reach_x = static_cast<float>(reached.x);
  splat.reach_y = static_cast<float>(reached.y);
  splat.depth = static_cast<float>(depth);
  splat.nearest = static_cast<float>(depth - std::abs(u.depth) - std::abs(v.depth));
  const Proportions proportions = proportions_of(side_u, side_v);
  splat.tolerance = static_cast<float>(tolerance_ * proportions.shorter);
  slant.weight = static_cast<float>(std::max(proportions.squareness, kLeastSquareness));
  const glm::dvec2 s(v.offset.y / area, -v.offset.x / area);
  const glm::dvec2 t(-u.offset.y / area, u.offset.x / area);
  const glm::dvec2 deeper = s * u.depth + t * v.depth;
  slant.s_x = static_cast<float>(s.x);
  slant.s_y = static_cast<float>(s.y);
  slant.t_x = static_cast<float>(t.x);
  slant.t_y = static_cast<float>(t.y);
  slant.depth_x = static_cast<float>(deeper.x);
  slant.depth_y = static_cast<float>(deeper.y);
  slant.nearness = lens_.perspective ? static_cast<float>(1 / depth) : 0;
  return true;
}

size_t SurfelProjection::project(size_t first, std::span<Splat> out,
                                 std::span<Slant> slants) const {
  size_t count = 0;
  for (size_t i = first; i < first + out.size(); ++i) {
    Splat splat;
    if (surfels_.colours[i].a < kLeastOpacity) continue;
    if (!project_surfel(i, splat, slants[count])) continue;
    splat.light = glm::vec3(linear_light(surfels_.colours[i]));
    out[count++] = splat;
  }
  return count;
}

}  // namespace afx::render
