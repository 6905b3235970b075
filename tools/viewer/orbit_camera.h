// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// How the viewer's camera moves: plain functions of numbers, which know no window.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "render/camera.h"

namespace afx::tools {

/// A camera that looks at a point and circles around it. Angles in radians. The orientation is the
/// identity (along -z, +y up) rolled, then raised, then turned about the world's y axis.
struct OrbitCamera {
  glm::dvec3 target{0};    ///< in the middle of the picture
  double distance = 3;     ///< of the eye from it, > 0
  double azimuth = 0.5;    ///< 0 = from the front (+z), positive = from the right (+x)
  double elevation = 0.3;  ///< above the horizon, -pi/2..pi/2
  double roll = 0;         ///< counter-clockwise about the viewing direction
  render::Projection projection = render::Projection::perspective;
  /// Full vertical angle. In parallel projection the picture is as high as the perspective one is
  /// at the target, so that zooming is the same in both.
  double field_of_view = 0.6;
};

/// A ball that holds all that is seen.
struct Ball {
  glm::dvec3 centre{0};
  double radius = 1;  ///< > 0
};
/// The ball around the box of the points; of radius 1 around the origin without points.
[[nodiscard]] Ball ball_of(std::span<const glm::dvec3> points);

[[nodiscard]] glm::dquat orientation_of(const OrbitCamera& camera);
[[nodiscard]] glm::dvec3 eye_of(const OrbitCamera& camera);
/// Scene units that a pixel has at the distance of the target. height   of the picture in pixels
[[nodiscard]] double unit_per_pixel(const OrbitCamera& camera, double height);

/// The camera for the renderers. The near plane lies before everything in `scene`, or close to the
/// eye where that is inside; in parallel projection the eye steps back so that nothing is cut off.
[[nodiscard]] render::Camera camera_for_drawing(const OrbitCamera& camera, const Ball& scene);

/// The point at a place of the picture (pixels from the upper left corner) at a distance from the
/// eye, along the viewing direction.
[[nodiscard]] glm::dvec3 point_under(const OrbitCamera& camera, const glm::dvec2& at,
                                     const glm::dvec2& size, double distance);

/// Circles around the target as the mouse is dragged by so many pixels right and down: by half a
/// turn for the height of the picture. Stops at the poles. A roll dies away.
void orbit(OrbitCamera& camera, const glm::dvec2& pixels, double height);
/// Shifts the picture by so many pixels right and down, exactly at the distance of the target.
void pan(OrbitCamera& camera, const glm::dvec2& pixels, double height);
/// Comes `factor` times as near (above 1: away) to a point, which stays where it is in the picture.
/// The distance of the target stays between a ten-thousandth of the scene's radius and a thousand
/// times that.
void zoom(OrbitCamera& camera, double factor, const glm::dvec3& point, const Ball& scene);
/// Moves eye and target by scene units: right, up, ahead.
void fly(OrbitCamera& camera, const glm::dvec3& step);
/// Turns the head where it is: what is in the middle of the picture follows the mouse. A roll dies
/// away.
void look(OrbitCamera& camera, const glm::dvec2& pixels, double height);
/// Makes a point the target without turning: the camera shifts sideways until it is in the middle.
void centre_on(OrbitCamera& camera, const glm::dvec3& point);

/// Looks from a place in a direction. The target is the point ahead that is nearest to the middle
/// of the scene, or, where that lies behind, a little ahead.
void place(OrbitCamera& camera, const glm::dvec3& eye, const glm::dquat& orientation,
           const Ball& scene);
/// Moves until the points just fill a picture of width/height `aspect`, from the direction that it
/// has, upright.
void fit(OrbitCamera& camera, std::span<const glm::dvec3> points, double aspect);

}  // namespace afx::tools
