// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Numbers that all renderers draw splats by.
#pragma once

#include <glm/vec3.hpp>

namespace afx::render {

/// What every splat has. Lengths on the screen in samples, (0, 0) the upper left corner of the
/// picture; lengths along the viewing direction in scene units.
struct Splat {
  float x, y;
  float reach_x, reach_y;  ///< half the sides of a rectangle around it that holds it
  float depth;             ///< of its centre
  float nearest;           ///< no part of it is nearer
  /// What lies this much behind the nearest one still belongs to the same surface.
  float tolerance;
  glm::vec3 light;  ///< the colour, linear
};

/// What makes a splat a disc in space. At an offset (x, y) from its place, in samples, with
///   e = depth_x x + depth_y y   and   k = 1 / (1 - nearness e)
/// the square of the distance from its centre, as a part of that of its radius, is
/// out = k^2 (a x^2 + 2 b x y + c y^2); its depth is that of the centre + k e + bulge out.
struct Tilt {
  float depth_x, depth_y;
  float nearness;  ///< 1 / the depth of the centre in perspective, 0 in parallel projection
  float a, b, c;
  float bulge;  ///< how much deeper the rim of a disc that faces the viewer lies
};

/// The smallest radius: with it every disc holds the centre of a sample, however far away it is.
inline constexpr float kLeastRadius = 0.7072F;
/// The largest: its square is a float still.
inline constexpr double kMostRadius = 1e18;
/// The tolerance of a splat, as a part of the shortest side of its voxel or surfel; see renderer.h.
inline constexpr double kVoxelTolerance = 0.25;
inline constexpr double kSurfelTolerance = 0.4;

/// How much longer the sides of a surfel are drawn than they are, at splat scale 1: so neighbours
/// that do not quite meet leave no gap.
inline constexpr double kSurfelMargin = 1.1;

}  // namespace afx::render
