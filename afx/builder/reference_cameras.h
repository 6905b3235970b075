// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The cameras of the reference images that the builder makes: one from each side of the cube, and
// any others.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>

#include "afx/octree_model.h"

namespace afx {

/// The views from the sides of the cube; those beyond look from anywhere else.
inline constexpr unsigned kSideViews = 6;

/// Distance of all cameras from the plane through the centre of the cube, and planes that enclose
/// the cube however it is turned, in lengths of the cube's side.
inline constexpr float kReferenceDistance = 1.0F;
inline constexpr float kReferenceNearPlane = 0.125F;
inline constexpr float kReferenceFarPlane = 1.875F;

/// The name of a view for people and files: "front", "back", "right", "left", "top", "bottom", then
/// "view07", "view08" and so on, the number counted from 1.
std::string reference_name(unsigned view);

/// A camera and the size of its picture.
struct ReferenceCamera {
  ReferenceImage image;  ///< without picture
  uint32_t width = 1;
  uint32_t height = 1;
};

/// The camera of view 0..5: +z, -z, +x, -x, +y, -y of the cube, each looking at its centre; y is up
/// in the first four, -z in the image from the top, +z in the one from the bottom. Its picture just
/// holds the cube.
/// size   pixels along a side of the cube
ReferenceCamera side_camera(unsigned view, uint32_t size);

/// A camera that looks at the centre of the cube from anywhere, y as far up as can be, its picture
/// as large as holds the whole cube.
/// to_camera   the direction from the cube to the camera, a unit vector, not along y
/// size        pixels along a length of the cube's side
ReferenceCamera slanting_camera(const glm::dvec3& to_camera, uint32_t size);

/// The part of a camera's picture that begins `left` pixels from the left and `top` from the top:
/// the same pixels, but for the rounding of the fields to single precision.
ReferenceCamera cropped(const ReferenceCamera& camera, uint32_t left, uint32_t top, uint32_t width,
                        uint32_t height);

}  // namespace afx
