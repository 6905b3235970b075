// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Where voxels fall on the reference images of an OctreeImage.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "afx/octree_model.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx {

/// Checks cameras and pictures: the field of view finite and > 0, position and orientation finite,
/// the orientation not of length 0, 1..4 components and the samples that the size asks for.
/// Errors  bad_argument, naming image and field; limit_exceeded: more pixels than limits
[[nodiscard]] Status check_reference_images(std::span<const ReferenceImage> reference,
                                            const Limits& limits);

/// The orthographic camera of a reference image, which has been checked, and its grid of pixels.
/// All in double precision.
class ReferenceProjection {
 public:
  /// How far a place may be off, in pixels: keeps rounding noise from deciding.
  static constexpr double kSlack = 1.0 / 64;

  /// width, height   of the grid, >= 1; mostly the picture's
  ReferenceProjection(const ReferenceImage& image, uint32_t width, uint32_t height);

  /// A place on the picture in pixels, (0, 0) the lower left corner of the lower left pixel.
  struct Spot {
    double x = 0, y = 0;
  };
  [[nodiscard]] Spot project(const glm::dvec3& point) const;

  /// The distance along the viewing direction from the plane through the origin of the cube.
  [[nodiscard]] double depth(const glm::dvec3& point) const;

  /// The direction from the object to the camera: minus the viewing direction, a unit vector.
  [[nodiscard]] const glm::dvec3& to_camera() const { return back_; }

  /// A pixel, counted from the lower left.
  struct Pixel {
    uint32_t i = 0, j = 0;
    bool inside = true;  ///< false: the place lies outside and this is the nearest edge pixel
  };
  /// i = floor(x + 1/64), j = floor(y + 1/64); up to 1/64 beyond the far edge is the last pixel.
  [[nodiscard]] Pixel pixel_at(Spot place) const;

  /// The pixels i0 <= i < i1, j0 <= j < j1; none if the square lies wholly outside.
  struct Area {
    uint32_t i0 = 0, i1 = 0, j0 = 0, j1 = 0;
    [[nodiscard]] uint64_t count() const { return uint64_t{i1 - i0} * (j1 - j0); }
  };
  /// The pixels that an upright square of this side (in the cube's units) around the place overlaps
  /// by more than 1/64, and the pixel of the place itself.
  [[nodiscard]] Area square(Spot place, double side) const;

  [[nodiscard]] uint32_t width() const { return width_; }
  [[nodiscard]] uint32_t height() const { return height_; }

 private:
  glm::dvec3 position_, right_, up_, back_;
  double scale_x_, scale_y_;  // pixels for each unit
  uint32_t width_, height_;
};

/// The centre of a voxel in the cube of side 1 around the origin, given its Morton code.
glm::dvec3 voxel_centre(uint64_t code, unsigned level);

/// The most pixels that the squares of voxels may touch on all images together, a voxel on an image
/// counting as one at least. Beyond lies no picture of a model but fields of view so small, or
/// images so many, that the time would have no bound.
inline constexpr uint64_t kMostPixelsTouched = uint64_t{1} << 31;

/// Whether drawing the squares (side 2^-level) of voxels keeps to kMostPixelsTouched.
/// images   for each voxel the image it is drawn on, from 1 (0 = none); empty: every voxel on every
///          image
/// Errors   limit_exceeded
[[nodiscard]] Status check_drawable(std::span<const ReferenceProjection> projections,
                                    std::span<const uint64_t> codes,
                                    std::span<const uint8_t> images, unsigned level,
                                    unsigned threads);

}  // namespace afx
