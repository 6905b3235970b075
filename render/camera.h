// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "codec/error.h"

namespace afx::render {

enum class Projection { perspective, orthographic };

/// From where and how a scene is seen. World coordinates are right-handed, y up.
struct Camera {
  glm::dvec3 position{0, 0, 10};
  glm::dquat orientation{1, 0, 0, 0};  ///< (w, x, y, z); identity looks along -z with +y up
  Projection projection = Projection::perspective;
  double field_of_view = 0.6;  ///< perspective: full vertical angle in radians, in (0, pi)
  double view_height = 1;      ///< orthographic: height of the view box in scene units, > 0
  double near_plane = 1e-3;    ///< what is nearer, along the viewing direction, is not drawn; > 0
};

/// Checks that all is finite and in range, the orientation not of length 0.
/// Errors  bad_argument, naming the field
[[nodiscard]] Status check_camera(const Camera& camera);

/// The direction a camera is wanted from, and how it projects; what fit_camera starts from.
/// The default is a three-quarter view from the front right and slightly above, as products and
/// statues are usually shown: both the front (+z) and a side are seen, and a bit of the top.
struct View {
  double azimuth = 0.5;    ///< radians: 0 = from the front (+z), positive = from the right (+x)
  double elevation = 0.3;  ///< radians above the horizon, -pi/2..pi/2
  Projection projection = Projection::perspective;
  double field_of_view = 0.6;  ///< perspective only: full vertical angle
  double margin = 0.05;  ///< free border, as a part of the picture's width and height, 0..0.45
};

/// The camera of that view from which `points` (such as the corners of bounding boxes) just fill a
/// picture of width/height `aspect`, less the margin, centred. No points: the cube of side 1 around
/// the origin is taken. The near plane is a hundredth of the nearest point's distance.
/// Errors  bad_argument: a value of `view` or `aspect` out of range, points that are not finite
[[nodiscard]] Result<Camera> fit_camera(std::span<const glm::dvec3> points, const View& view,
                                        double aspect);

}  // namespace afx::render
