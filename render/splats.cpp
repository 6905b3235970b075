// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/splats.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "codec/octree_voxels.h"

namespace afx::render {
namespace {

constexpr double kBulge = 0.5;  // a part of the voxel's shortest side; see renderer.h

}  // namespace

SplatProjection::SplatProjection(const VoxelCloud& cloud, const Lens& lens,
                                 const RenderOptions& options)
    : cloud_(cloud), lens_(lens), scale_(options.splat_scale) {
  const double side = std::ldexp(1.0, -static_cast<int>(cloud.level));
  const glm::dmat3 turn = lens.to_view * glm::dmat3(cloud.local_to_world);
  axes_ = glm::dmat3(turn[0] * side, turn[1] * side, turn[2] * side);
  const glm::dvec3 moved(cloud.local_to_world[3]);
  origin_ = lens.to_view * (moved - lens.position) + turn * glm::dvec3(side / 2 - 0.5);

  reach_ = half_depth_ = flat_radius_ = 0;
  for (int k = 0; k < 4; ++k) {
    const glm::dvec3 corner(k == 1 ? -0.5 : 0.5, k == 2 ? -0.5 : 0.5, k == 3 ? -0.5 : 0.5);
    diagonals_[k] = axes_ * corner;
    reach_ = std::max(reach_, glm::length(diagonals_[k]));
    half_depth_ = std::max(half_depth_, std::abs(diagonals_[k].z));
    flat_radius_ = std::max(flat_radius_, glm::length(glm::dvec2(diagonals_[k])) * lens.focal);
  }
  const double shortest =
      std::min({glm::length(axes_[0]), glm::length(axes_[1]), glm::length(axes_[2])});
  bulge_ = static_cast<float>(kBulge * shortest);
  tolerance_ = static_cast<float>(kTolerance * shortest);
}

/// Before scaling. A corner c + h projects to (c.x + h.x)/(c.d + h.d), which is off the centre's
/// place by (h.x - c.x/c.d h.d)/(c.d + h.d); c.d + h.d is least at the nearest corner.
double SplatProjection::radius(const glm::dvec3& centre) const {
  if (!lens_.perspective) return flat_radius_;
  const double distance = -centre.z;
  if (distance < 2 * half_depth_) return lens_.focal * reach_ / distance;
  const double x = centre.x / distance, y = centre.y / distance;
  double longest = 0;
  for (const glm::dvec3& h : diagonals_) {
    const double dx = h.x + x * h.z, dy = h.y + y * h.z;  // h.d = -h.z
    longest = std::max(longest, dx * dx + dy * dy);
  }
  return lens_.focal * std::sqrt(longest) / (distance - half_depth_);
}

bool SplatProjection::project_voxel(uint64_t code, Splat& splat) const {
  const Voxel v = codec::morton_decode(code);
  const glm::dvec3 centre = axes_ * glm::dvec3(v.x, v.y, v.z) + origin_;
  if (!lens_.in_view(centre, scale_ * reach_)) return false;
  const glm::dvec2 at = lens_.place(centre);
  const double r = std::clamp(radius(centre) * scale_, double{kLeastRadius}, kMostRadius);
  if (!lens_.on_screen(at, r)) return false;
  splat.x = static_cast<float>(at.x);
  splat.y = static_cast<float>(at.y);
  splat.radius = static_cast<float>(r);
  splat.depth = static_cast<float>(-centre.z);
  splat.bulge = bulge_;
  splat.tolerance = tolerance_;
  return true;
}

size_t SplatProjection::project(size_t first, std::span<Splat> out) const {
  size_t count = 0;
  for (size_t i = first; i < first + out.size(); ++i) {
    Splat splat;
    if (!project_voxel(cloud_.codes[i], splat)) continue;
    splat.colour = cloud_.colours[i];
    out[count++] = splat;
  }
  return count;
}

}  // namespace afx::render
