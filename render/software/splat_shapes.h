// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What a splat covers, and how deep it lies there. Places are offsets from the splat's, in samples.
#pragma once

#include <algorithm>

#include "render/lanes.h"
#include "render/software/surfel_splats.h"
#include "render/splats.h"

namespace afx::render {

/// The part of a row that a splat covers; none if last < first.
struct Run {
  float first, last;
};

/// A splat at some samples of a row.
struct Hit {
  Lanes depth;
  Lanes out;        ///< 0 in the centre, 1 at the rim
  LaneMask inside;  ///< those that the splat covers, where it has no runs
};

constexpr float kLeastPart = 1e-6F;  // no depth is a million times the centre's

/// The disc of a voxel. In perspective it is exact, also where its plane reaches behind the eye.
struct Disc {
  static constexpr bool kHasRuns = false;  // in rows; else all its rectangle may be covered
  static constexpr float weight = 1;       // of its centre, in mixing

  /// dy   a float, or Lanes
  template <class Height>
  [[nodiscard]] AFX_PART_OF_CALLER Hit at(Lanes dx, Height dy) const {
    const Lanes deeper = tilt.depth_x * dx + tilt.depth_y * dy;
    const Lanes k = 1 / most(all(kLeastPart), 1 - tilt.nearness * deeper);
    const Lanes flat = dx * (tilt.a * dx + 2 * tilt.b * dy) + tilt.c * dy * dy;
    const Lanes out = k * k * flat;
    return {splat.depth + k * deeper + tilt.bulge * out, out, out <= 1};
  }

  const Splat splat;
  const Tilt tilt;
};

/// The parallelogram of a surfel. In perspective too it is exact, also where it reaches behind the
/// eye: what lies there is outside of all four edges.
class Parallelogram {
 public:
  static constexpr bool kHasRuns = true;

  AFX_PART_OF_CALLER Parallelogram(const Splat& s, const Slant& l)
      : splat(s), weight(l.weight), slant_(l) {
    const float near_x = l.nearness * l.depth_x, near_y = l.nearness * l.depth_y;
    edges_[0] = {near_x + l.s_x, near_y + l.s_y};  // s k <= 1
    edges_[1] = {near_x - l.s_x, near_y - l.s_y};
    edges_[2] = {near_x + l.t_x, near_y + l.t_y};
    edges_[3] = {near_x - l.t_x, near_y - l.t_y};
  }

  [[nodiscard]] AFX_PART_OF_CALLER Run run(float dy) const {
    Run run{-splat.reach_x, splat.reach_x};
    for (const Edge& edge : edges_) {
      const float inside = 1 - edge.y * dy;
      if (edge.x > 0) run.last = std::min(run.last, inside / edge.x);
      if (edge.x < 0) run.first = std::max(run.first, inside / edge.x);
      if (edge.x == 0 && inside < 0) run.last = -kNothing;
    }
    return run;
  }
  [[nodiscard]] AFX_PART_OF_CALLER Hit at(Lanes dx, float dy) const {
    const Lanes deeper = slant_.depth_x * dx + slant_.depth_y * dy;
    const Lanes k = 1 / most(all(kLeastPart), 1 - slant_.nearness * deeper);
    const Lanes s = k * (slant_.s_x * dx + slant_.s_y * dy);
    const Lanes t = k * (slant_.t_x * dx + slant_.t_y * dy);
    return {splat.depth + k * deeper, most(s * s, t * t), all_lanes()};
  }

  const Splat splat;
  const float weight;

 private:
  static constexpr float kNothing = 2e18F;  // ends a run before it begins
  /// Samples with x dx + y dy <= 1 are on its inner side.
  struct Edge {
    float x, y;
  };

  const Slant slant_;
  Edge edges_[4];
};

}  // namespace afx::render
