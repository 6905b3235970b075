// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/splats.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec4.hpp>

#include "codec/octree_voxels.h"

namespace afx::render {
namespace {

constexpr double kMostRadius = 1e18;  // its square is a float still
// Parts of the voxel's shortest side; see renderer.h.
constexpr double kBulge = 0.5;
constexpr double kTolerance = 0.4;

}  // namespace

SplatProjection::SplatProjection(const VoxelCloud& cloud, const Camera& camera,
                                 const RenderOptions& options)
    : cloud_(cloud),
      perspective_(camera.projection == Projection::perspective),
      near_(camera.near_plane),
      scale_(options.splat_scale) {
  const double columns = static_cast<double>(uint64_t{options.width} * options.samples);
  const double rows = static_cast<double>(uint64_t{options.height} * options.samples);
  const double half_height =
      perspective_ ? std::tan(camera.field_of_view / 2) : camera.view_height / 2;
  focal_ = rows / 2 / half_height;
  middle_x_ = columns / 2;
  middle_y_ = rows / 2;
  slope_x_ = half_height * columns / rows;
  slope_y_ = half_height;

  const double side = std::ldexp(1.0, -static_cast<int>(cloud.level));
  const glm::dmat3 to_view = glm::mat3_cast(glm::conjugate(glm::normalize(camera.orientation)));
  const glm::dmat3 turn = to_view * glm::dmat3(cloud.local_to_world);
  axes_ = glm::dmat3(turn[0] * side, turn[1] * side, turn[2] * side);
  const glm::dvec3 moved(cloud.local_to_world[3]);
  origin_ = to_view * (moved - camera.position) + turn * glm::dvec3(side / 2 - 0.5);

  reach_ = half_depth_ = flat_radius_ = 0;
  for (int k = 0; k < 4; ++k) {
    const glm::dvec3 corner(k == 1 ? -0.5 : 0.5, k == 2 ? -0.5 : 0.5, k == 3 ? -0.5 : 0.5);
    diagonals_[k] = axes_ * corner;
    reach_ = std::max(reach_, glm::length(diagonals_[k]));
    half_depth_ = std::max(half_depth_, std::abs(diagonals_[k].z));
    flat_radius_ = std::max(flat_radius_, glm::length(glm::dvec2(diagonals_[k])) * focal_);
  }
  const double shortest =
      std::min({glm::length(axes_[0]), glm::length(axes_[1]), glm::length(axes_[2])});
  bulge_ = static_cast<float>(kBulge * shortest);
  tolerance_ = static_cast<float>(kTolerance * shortest);
}

/// Whether the sphere around the voxel touches the view.
bool SplatProjection::in_view(const glm::dvec3& centre) const {
  const double distance = -centre.z;
  if (!(distance >= near_)) return false;
  if (!perspective_) return true;  // decided on the screen
  const double beyond_x = std::abs(centre.x) - slope_x_ * distance;
  const double beyond_y = std::abs(centre.y) - slope_y_ * distance;
  return beyond_x <= scale_ * reach_ * std::sqrt(1 + slope_x_ * slope_x_) &&
         beyond_y <= scale_ * reach_ * std::sqrt(1 + slope_y_ * slope_y_);
}

/// Before scaling. A corner c + h projects to (c.x + h.x)/(c.d + h.d), which is off the centre's
/// place by (h.x - c.x/c.d h.d)/(c.d + h.d); c.d + h.d is least at the nearest corner.
double SplatProjection::radius(const glm::dvec3& centre) const {
  if (!perspective_) return flat_radius_;
  const double distance = -centre.z;
  if (distance < 2 * half_depth_) return focal_ * reach_ / distance;
  const double x = centre.x / distance, y = centre.y / distance;
  double longest = 0;
  for (const glm::dvec3& h : diagonals_) {
    const double dx = h.x + x * h.z, dy = h.y + y * h.z;  // h.d = -h.z
    longest = std::max(longest, dx * dx + dy * dy);
  }
  return focal_ * std::sqrt(longest) / (distance - half_depth_);
}

bool SplatProjection::project_voxel(uint64_t code, Splat& splat) const {
  const Voxel v = codec::morton_decode(code);
  const glm::dvec3 centre = axes_ * glm::dvec3(v.x, v.y, v.z) + origin_;
  if (!in_view(centre)) return false;
  const double zoom = perspective_ ? focal_ / -centre.z : focal_;
  const double x = middle_x_ + centre.x * zoom;
  const double y = middle_y_ - centre.y * zoom;
  const double r = std::clamp(radius(centre) * scale_, double{kLeastRadius}, kMostRadius);
  // Written so that NaN is left out.
  if (!(x + r > 0 && y + r > 0 && x - r < 2 * middle_x_ && y - r < 2 * middle_y_)) return false;
  splat.x = static_cast<float>(x);
  splat.y = static_cast<float>(y);
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
