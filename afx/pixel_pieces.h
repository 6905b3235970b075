// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// From the distances that a camera's pixels have to the pieces of surface that they show.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "afx/depth_camera.h"
#include "afx/surfels.h"
#include "codec/error.h"
#include "codec/limits.h"
#include "codec/parallel.h"

namespace afx {

/// How far the distances of two neighbouring pixels of one surface may differ, in pixel sides: the
/// surface is then seen at 14 degrees, where its own pixels no longer show it well. Beyond it is
/// another surface. One step of the depth is allowed on top: rounding alone can part neighbours by
/// that much.
inline constexpr double kSurfaceStep = 4;

/// Errors  limit_exceeded: more pieces than limits.memory / kSurfelBytes
inline Status check_surfel_memory(uint64_t pieces, const Limits& limits) {
  if (pieces <= limits.memory / kSurfelBytes) return {};
  return Error{Errc::limit_exceeded, Place::none(),
               std::to_string(pieces) + " pieces of surface take more memory than the limit"};
}

/// Whether all pieces lie within 1e37 of the origin along each axis, where single precision, which
/// scenes have, still holds sums of coordinates.
inline bool are_near_enough(const Surfels& surfels) {
  const auto is_near = [](const glm::dvec3& v) {
    constexpr double kFarthest = 1e37;
    return std::abs(v.x) < kFarthest && std::abs(v.y) < kFarthest && std::abs(v.z) < kFarthest;
  };
  for (size_t n = 0; n < surfels.size(); ++n)
    if (!is_near(surfels.centres[n]) || !is_near(glm::dvec3(surfels.u[n])) ||
        !is_near(glm::dvec3(surfels.v[n])))
      return false;
  return true;
}

/// A camera's pixels.
struct PixelGrid {
  DepthCamera camera;
  uint32_t width = 0, height = 0;
  glm::dvec2 shift{0, 0};  ///< of the picture on the camera's view, in parts of its size
  double step = 0;         ///< between depths, in scene units; 0 = none
};

/// What a pixel shows.
struct PixelSample {
  double distance;
  Rgba8 colour;
};

/// Makes the pieces. Samples is a type that knows, of the pixel in column i of row j from the lower
/// left,
///   size_t count(i, j)                                   the number of its samples,
///   PixelSample sample(i, j, n)                          each of them,
///   std::optional<double> nearest(i, j, distance)        its distance next to another one.
template <class Samples>
class PixelPieces {
 public:
  PixelPieces(const PixelGrid& grid, const Samples& samples)
      : grid_(grid), projection_(grid.camera), samples_(samples) {}

  [[nodiscard]] size_t count_row(uint32_t j) const {
    size_t count = 0;
    for (uint32_t i = 0; i < grid_.width; ++i) count += samples_.count(i, j);
    return count;
  }

  /// at   number of the row's first piece
  void fill_row(uint32_t j, size_t at, Surfels& surfels) const {
    for (uint32_t i = 0; i < grid_.width; ++i)
      for (size_t n = 0; n < samples_.count(i, j); ++n, ++at) {
        const PixelSample sample = samples_.sample(i, j, n);
        place(i, j, sample.distance, at, surfels);
        surfels.colours[at] = sample.colour;
      }
  }

 private:
  void place(uint32_t i, uint32_t j, double distance, size_t at, Surfels& surfels) const {
    const double w = grid_.width, h = grid_.height;
    const ScreenPoint middle{(i + 0.5) / w + grid_.shift.x, (j + 0.5) / h + grid_.shift.y,
                             distance};
    const glm::dvec2 slope = slope_at(i, j, distance);
    const glm::dvec3 centre = projection_.point(middle);
    const auto to = [&](double du, double dv, double deeper) {
      return projection_.point({middle.u + du, middle.v + dv, distance + deeper}) - centre;
    };
    surfels.centres[at] = centre;
    surfels.u[at] = glm::vec3(to(0.5 / w, 0, 0) + to(0, 0, slope.x / 2));
    surfels.v[at] = glm::vec3(to(0, 0.5 / h, 0) + to(0, 0, slope.y / 2));
  }

  /// How much farther the surface is one pixel to the right, and one up.
  [[nodiscard]] glm::dvec2 slope_at(uint32_t i, uint32_t j, double distance) const {
    const uint32_t w = grid_.width, h = grid_.height;
    const glm::dvec2 side = projection_.extent(distance) / glm::dvec2(w, h);
    const auto near = [&](bool inside, uint32_t ni, uint32_t nj, double pixel) {
      std::optional<double> there;
      if (inside) there = samples_.nearest(ni, nj, distance);
      if (there && std::abs(*there - distance) > kSurfaceStep * pixel + grid_.step) there.reset();
      return there;
    };
    glm::dvec2 slope(
        between(near(i > 0, i - 1, j, side.x), distance, near(i + 1 < w, i + 1, j, side.x)),
        between(near(j > 0, i, j - 1, side.y), distance, near(j + 1 < h, i, j + 1, side.y)));
    // Very wide angles: the near end of the piece must not reach the next pixel's centre.
    const double steep = std::abs(slope.x) + std::abs(slope.y);
    if (!grid_.camera.orthographic && steep > distance / 2) slope *= distance / 2 / steep;
    return slope;
  }

  // The mean of the slopes to both sides, but at most twice the smaller one, and none where they
  // lean against each other: where two surfaces meet, a piece lies along the flatter of them and
  // does not stand out of both (the limiter of van Leer, "Towards the ultimate conservative
  // difference scheme III", 1977).
  static double between(std::optional<double> before, double here, std::optional<double> after) {
    if (!before || !after) return after ? *after - here : (before ? here - *before : 0);
    const double a = here - *before, b = *after - here;
    if (!(a * b > 0)) return 0;
    const double most = 2 * std::min(std::abs(a), std::abs(b));
    return std::clamp((a + b) / 2, -most, most);
  }

  const PixelGrid& grid_;
  CameraProjection projection_;
  const Samples& samples_;
};

/// All pieces of a picture, from the lower left, rows upward.
/// Errors  limit_exceeded
template <class Samples>
Result<Surfels> pieces_of(const PixelGrid& grid, const Samples& samples, unsigned threads,
                          const Limits& limits) {
  const PixelPieces<Samples> pieces(grid, samples);
  std::vector<size_t> starts(grid.height);
  size_t count = 0;
  for (uint32_t j = 0; j < grid.height; ++j) {
    starts[j] = count;
    count += pieces.count_row(j);
  }
  if (Status memory = check_surfel_memory(count, limits); !memory.ok()) return memory.error();
  Surfels surfels;
  surfels.centres.resize(count);
  surfels.u.resize(count);
  surfels.v.resize(count);
  surfels.colours.resize(count);
  parallel_for(grid.height, threads,
               [&](size_t j) { pieces.fill_row(static_cast<uint32_t>(j), starts[j], surfels); });
  return surfels;
}

}  // namespace afx
