// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What a splat covers, and how deep it lies there. Places are offsets from the splat's, in samples.
#pragma once

#include <algorithm>
#include <cmath>

#include "render/splats.h"

namespace afx::render {

/// The part of a row that a splat covers; none if last < first.
struct Run {
  float first, last;
};

/// A splat at a sample.
struct Hit {
  float depth;
  float out;  ///< 0 in the centre, 1 at the rim
};

/// The disc of a voxel, which bulges towards the viewer.
struct Disc {
  explicit Disc(const Splat& s)
      : splat(s), inverse(1 / (s.radius * s.radius)), bend(s.bulge * inverse) {}

  [[nodiscard]] Run run(float dy) const {
    const float half = std::sqrt(std::max(0.0F, splat.radius * splat.radius - dy * dy));
    return {-half, half};
  }
  [[nodiscard]] Hit at(float dx, float dy) const {
    const float d2 = dx * dx + dy * dy;
    return {splat.depth + bend * d2, d2 * inverse};
  }

  const Splat& splat;
  float inverse;  // of the square of the radius
  float bend;
};

}  // namespace afx::render
