// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Which pixels of a camera's picture a piece of surface covers, and at what distance.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>

#include "afx/depth_camera.h"
#include "afx/surfels.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx {

/// The most pixels that pieces may touch on one picture together: beyond lies no model seen from
/// outside, but pieces so large that the time would have no bound. More of large pictures: 64
/// pieces that fill one are always drawn.
constexpr uint64_t most_surfel_pixels(uint32_t width, uint32_t height) {
  return std::max(uint64_t{1} << 31, 64 * (uint64_t{width} * height));
}

/// limit_exceeded: `what` is more than the limit.
Error beyond_limit(const std::string& what);

/// Errors  bad_argument: outside 1..most
Status check_depth_bits(unsigned bits, unsigned most);

/// A range of pixels counted from the lower left: i0 <= i < i1, j0 <= j < j1.
struct PixelRange {
  uint32_t i0 = 0, i1 = 0, j0 = 0, j1 = 0;
  [[nodiscard]] uint64_t count() const { return uint64_t{i1 - i0} * (j1 - j0); }
};

/// A piece as one camera sees it.
class SurfelFootprint {
 public:
  glm::dvec2 centre{0, 0};  ///< where it falls, in pixels from the picture's lower left corner
  double distance = 0;      ///< of the centre
  double area = 0;          ///< in pixels; negative where its outside faces away
  PixelRange range;         ///< the pixels worth asking, within the picture
  bool owns_pixel = false;  ///< the centre falls into a pixel of the picture: own_i, own_j
  uint32_t own_i = 0, own_j = 0;
  bool small = false;  ///< neither side is longer than one and a half pixels

  /// The rows that it touches, from the lowest: first <= j < end.
  [[nodiscard]] uint32_t first_row() const;
  [[nodiscard]] uint32_t end_row() const;

  /// Calls visit(i, j, distance) for the pixels in rows first <= j < end whose centres it covers,
  /// with its distance there, and if it is small for its own pixel in any case: what is smaller
  /// than a pixel is seen too. (Larger ones seen from their edge would be no more than dots.)
  template <class Visit>
  void for_each_pixel(uint32_t first, uint32_t end, Visit&& visit) const {
    bool own_left = small && owns_pixel && own_j >= first && own_j < end;
    double at = 0;
    for (uint32_t j = std::max(first, range.j0); j < std::min(end, range.j1); ++j)
      for (uint32_t i = range.i0; i < range.i1; ++i) {
        if (!covers(i, j, at)) continue;
        if (i == own_i && j == own_j) own_left = false;
        visit(i, j, at);
      }
    if (own_left) visit(own_i, own_j, distance);
  }

  /// Whether it covers the centre of a pixel, and then its distance there.
  [[nodiscard]] bool covers(uint32_t i, uint32_t j, double& at) const {
    const double dx = i + 0.5 - centre.x, dy = j + 0.5 - centre.y;
    const double s = dx * s_.x + dy * s_.y, t = dx * t_.x + dy * t_.y;
    const double nearness = 1 - s * bend_.x - t * bend_.y;  // centre's distance by the point's
    const double most = nearness * (1 + kSlack);
    if (!flat_ || !(s <= most && -s <= most && t <= most && -t <= most)) return false;
    at = distance + (s * deeper_.x + t * deeper_.y) / nearness;
    return true;
  }

 private:
  friend class SurfelCamera;
  static constexpr double kSlack = 1e-6;  // so that neighbours leave no seam

  bool flat_ = false;   // not seen from its edge
  glm::dvec2 s_{0, 0};  // s and t for each pixel from the centre, right and up
  glm::dvec2 t_{0, 0};
  glm::dvec2 deeper_{0, 0};  // distance from the centre to its ends in u and v
  glm::dvec2 bend_{0, 0};    // the same by the distance of the centre in perspective, else 0
};

/// A camera and its pixels.
class SurfelCamera {
 public:
  /// camera   checked; width, height   of the picture, above 0
  SurfelCamera(const DepthCamera& camera, uint32_t width, uint32_t height);

  /// Nothing is seen of pieces whose centre is behind a perspective camera. Those that reach behind
  /// it are worth asking about all pixels.
  [[nodiscard]] SurfelFootprint footprint(const Surfels& surfels, size_t n) const;

  /// The longer side of a pixel at a distance, in scene units.
  [[nodiscard]] double pixel_side(double distance) const;

 private:
  [[nodiscard]] PixelRange range_around(const SurfelFootprint& piece, const glm::dvec2& u,
                                        const glm::dvec2& v) const;

  CameraProjection projection_;
  glm::dmat3 axes_;  // of the camera: right, up, towards the viewer
  bool perspective_;
  double width_, height_;
};

}  // namespace afx
