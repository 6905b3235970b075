// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// From the world to the grid of samples.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/camera.h"
#include "render/renderer.h"

namespace afx::render {

/// How a camera puts the world onto the samples of a picture. Places on the screen are counted in
/// samples, right and down from the upper left corner of the picture. A point in the camera's
/// system has the distance -z to the plane through the camera.
struct Lens {
  /// camera, options   checked
  Lens(const Camera& camera, const RenderOptions& options);

  /// Whether a ball touches the view; by its centre, whether it lies behind the near plane. In
  /// parallel projection the sides are not looked at: the screen decides.
  [[nodiscard]] bool in_view(const glm::dvec3& centre, double radius) const;
  /// Where a point behind the near plane is seen.
  [[nodiscard]] glm::dvec2 place(const glm::dvec3& point) const {
    const double zoom = zoom_at(-point.z);
    return {middle.x + point.x * zoom, middle.y - point.y * zoom};
  }
  /// Samples for each unit of length at a distance.
  [[nodiscard]] double zoom_at(double distance) const {
    return perspective ? focal / distance : focal;
  }
  /// Whether a square on the screen, of half side `reach`, touches the picture; not if it is NaN.
  [[nodiscard]] bool on_screen(const glm::dvec2& at, double reach) const {
    return at.x + reach > 0 && at.y + reach > 0 && at.x - reach < 2 * middle.x &&
           at.y - reach < 2 * middle.y;
  }

  glm::dmat3 to_view;  ///< directions in the world to the camera's system
  glm::dvec3 position;
  bool perspective;
  double near_plane;
  double focal;       ///< samples for each unit of length, in perspective at distance 1
  glm::dvec2 middle;  ///< of the picture
  glm::dvec2 slope;   ///< perspective: of the sides of the view
  /// sqrt(1 + slope^2): how far beyond a side a ball's centre may lie, for each radius.
  glm::dvec2 secant;
};

}  // namespace afx::render
