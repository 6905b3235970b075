// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The camera of a DepthImage: how a pixel and a distance become a point, and a point a pixel.
// Source: ISO/IEC 14496-16, DepthImage (clause not checked); the paper, section III.
#pragma once

#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "codec/error.h"

namespace afx {

/// The fields of a DepthImage that place its picture, in the coordinates that the node stands in.
/// The defaults are the node's.
struct DepthCamera {
  glm::dvec3 position{0, 0, 10};
  glm::dquat orientation{1, 0, 0, 0};  ///< (w, x, y, z); identity looks along -z with +y up
  bool orthographic = true;
  /// Orthographic: width and height of the view box in scene units. Perspective: the full
  /// horizontal and vertical angle in radians.
  glm::dvec2 field_of_view{0.785398F, 0.785398F};
  double near_plane = 10;  ///< distances along the viewing direction between which depths lie
  double far_plane = 100;

  bool operator==(const DepthCamera&) const = default;
};

/// Whether points can be had from a camera.
/// Errors  bad_argument, naming the field as in the node: a value that is not finite; fieldOfView
///         not above 0 or, in perspective, not below pi; nearPlane below 0 or, in perspective, 0;
///         farPlane not above nearPlane; an orientation of length 0
[[nodiscard]] Status check_depth_camera(const DepthCamera& camera);

/// The camera as the fields of a node can hold it: single precision, the orientation as axis and
/// angle. What is drawn with it fits what a reader of the scene gets.
[[nodiscard]] DepthCamera as_in_node(const DepthCamera& camera);

/// A place on the picture, and how far away it is.
struct ScreenPoint {
  double u = 0, v = 0;  ///< 0..1 from the lower left corner, inside the picture
  double distance = 0;  ///< to the plane through the camera parallel to the picture
};

/// Points to the picture and back, for one camera.
class CameraProjection {
 public:
  /// camera   checked
  explicit CameraProjection(const DepthCamera& camera);

  /// The point seen at a place of the picture at a distance.
  [[nodiscard]] glm::dvec3 point(const ScreenPoint& at) const;
  /// Where a point is seen. Perspective: u and v mean something only where distance > 0.
  [[nodiscard]] ScreenPoint project(const glm::dvec3& point) const;
  /// A point in the system of the camera: x right, y up, z towards the viewer.
  [[nodiscard]] glm::dvec3 to_camera(const glm::dvec3& point) const;
  /// A unit vector from a point towards the viewer.
  [[nodiscard]] glm::dvec3 towards_viewer(const glm::dvec3& point) const;
  /// Width and height that the picture has at a distance, in scene units.
  [[nodiscard]] glm::dvec2 extent(double distance) const {
    return orthographic_ ? extent_ : extent_ * distance;
  }

 private:
  bool orthographic_;
  glm::dvec3 position_;
  glm::dmat3 axes_;    // columns: right, up, towards the viewer
  glm::dvec2 extent_;  // of the view; perspective: at distance 1
};

/// The distance that a depth value stands for: 1 the far plane, `dmax` the near plane, evenly
/// between. dmax = 1: the near plane.
/// depth   1..dmax; 0 is taken as 1
[[nodiscard]] double depth_to_distance(uint64_t depth, uint64_t dmax, const DepthCamera& camera);

/// The depth value nearest to a distance, 1..dmax; 0 for one more than half a step before the near
/// or behind the far plane.
[[nodiscard]] uint64_t distance_to_depth(double distance, uint64_t dmax, const DepthCamera& camera);

}  // namespace afx
