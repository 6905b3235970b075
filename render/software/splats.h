// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <glm/vec3.hpp>

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
  glm::vec3 light;  ///< the colour, linear
};

/// The smallest radius: with it every disc holds the centre of a sample, however far away it is.
inline constexpr float kLeastRadius = 0.7072F;
/// The largest: its square is a float still.
inline constexpr double kMostRadius = 1e18;
/// The tolerance of a splat, as a part of the shortest side of its voxel or surfel; see renderer.h.
inline constexpr double kTolerance = 0.4;

}  // namespace afx::render
