// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// From surfels in the world to parallelograms on the grid of samples.
#pragma once

#include <cstddef>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "render/lens.h"
#include "render/scene.h"
#include "render/splats.h"

namespace afx::render {

/// What makes a splat a parallelogram in space instead of a disc: s and t, which run from -1 to 1
/// over it, and its depth at an offset (x, y) from its place, in samples. With
///   e = depth_x x + depth_y y   and   k = 1 / (1 - nearness e)
/// that is s = k (s_x x + s_y y), t likewise, depth = depth of the centre + k e.
struct Slant {
  float s_x, s_y, t_x, t_y;
  float depth_x, depth_y;
  float nearness;  ///< 1 / the depth of the centre in perspective, 0 in parallel projection
  float weight;    ///< in mixing: 1 of a square, less the longer the surfel is stretched
};

/// Projects the surfels of one cloud for one camera and size of picture. Their sides are made
/// longer by kSurfelMargin and RenderOptions::splat_scale, and a parallelogram that is narrower on
/// the screen than a sample's diagonal is made as wide as that; its depths stay those of the
/// surfel. Of SplatKind::points all are as small as that.
class SurfelProjection {
 public:
  /// cloud, options   checked
  SurfelProjection(const SurfelCloud& cloud, const Lens& lens, const RenderOptions& options);

  /// Projects surfels [first, first + out.size()), leaves out those that are transparent, touch no
  /// sample or lie before the near plane, and writes the others to the beginning of `out` and
  /// `slants`, in order. Returns how many.
  /// slants   as many as `out`
  size_t project(size_t first, std::span<Splat> out, std::span<Slant> slants) const;

 private:
  /// From the centre to the middle of a side, as if all lay at the centre's distance.
  struct Half {
    glm::dvec2 offset;  // on the screen, in samples
    double depth;
  };

  /// Fills all but the colour; false if nothing is to be drawn.
  bool project_surfel(size_t number, Splat& splat, Slant& slant) const;
  [[nodiscard]] Half half(const glm::dvec3& centre, const glm::dvec3& side) const;
  [[nodiscard]] glm::dvec2 reach(const Half& u, const Half& v, double depth) const;

  const Surfels& surfels_;
  const Lens& lens_;
  double scale_;
  double tolerance_;
  glm::dmat3 axes_;    // local directions to the camera's system
  glm::dvec3 origin_;  // of the local system, in the camera's
};

}  // namespace afx::render
