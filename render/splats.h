// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// From voxels in the world to discs on the grid of samples.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "render/lens.h"
#include "render/renderer.h"
#include "render/scene.h"

namespace afx::render {

/// A round splat facing the viewer, or with a Slant (surfel_splats.h) a parallelogram. Lengths on
/// the screen in samples, (0, 0) the upper left corner of the picture; lengths along the viewing
/// direction in scene units.
struct Splat {
  float x, y, radius;
  float depth;  ///< of its centre
  float bulge;  ///< how much deeper a disc's rim lies; between, the depth goes with the square
  /// What lies this much behind the nearest one still belongs to the same surface.
  float tolerance;
  Rgba8 colour;
};

/// The smallest radius: with it every disc holds the centre of a sample, however far away it is.
inline constexpr float kLeastRadius = 0.7072F;
/// The largest: its square is a float still.
inline constexpr double kMostRadius = 1e18;
/// The tolerance of a splat, as a part of the shortest side of its voxel or surfel; see renderer.h.
inline constexpr double kTolerance = 0.4;

/// Projects the voxels of one cloud for one camera and size of picture.
///
/// The radius is half the longest of the voxel's four space diagonals as projected, with the depth
/// of the voxel's nearest corner, so that the disc holds the whole projection of the voxel; times
/// RenderOptions::splat_scale. A voxel nearer than its own size is drawn as its enclosing sphere.
/// This is the paper's rule (section VI) for every voxel by itself instead of for cells.
class SplatProjection {
 public:
  /// cloud, options   checked
  SplatProjection(const VoxelCloud& cloud, const Lens& lens, const RenderOptions& options);

  /// Projects voxels [first, first + out.size()), leaves out those that touch no sample or lie
  /// before the near plane, and writes the others to the beginning of `out`, in order. Returns how
  /// many.
  size_t project(size_t first, std::span<Splat> out) const;

 private:
  /// Fills all but the colour; false if nothing is to be drawn.
  bool project_voxel(uint64_t code, Splat& splat) const;
  [[nodiscard]] double radius(const glm::dvec3& centre) const;

  const VoxelCloud& cloud_;
  const Lens& lens_;
  double scale_;
  glm::dmat3 axes_;          // voxel coordinates to the camera's system
  glm::dvec3 origin_;        // the centre of voxel (0, 0, 0) in the camera's system
  glm::dvec3 diagonals_[4];  // from the centre to a corner
  double reach_;             // the longest of them
  double half_depth_;        // the largest part of them along z
  double flat_radius_;       // orthographic: of every voxel
  float bulge_, tolerance_;
};

}  // namespace afx::render
