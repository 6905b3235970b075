// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/layer_leaning.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <optional>
#include <span>

#include "afx/plane_cell.h"
#include "afx/plane_fit.h"
#include "codec/parallel.h"

namespace afx {
namespace {

constexpr double kGap = 1.25;   // pixel sides of depth between samples of a surface in one pixel
constexpr double kStep = 1.42;  // the same in pixels next to each other; more on the diagonal
constexpr double kHalfSide = 0.82;  // of a piece, in pixels; the rest covers what lies off the grid
constexpr double kMostShift = 0.45;      // pixels; the centre stays in its pixel
constexpr double kMostReach = 0.97;      // pixels; the next pixel's centre is 1 away
constexpr double kMostNearer = 1 / 8.0;  // how much of its distance a piece may come nearer

/// Where a sample is. Around it lengths are in pixels: x right, y up, z along the line of sight
/// towards the viewer.
struct SamplePlace {
  uint32_t i, j;
  double depth;       // as stored
  double distance;    // in scene units
  double side;        // of a pixel there, the longer one, in scene units
  double depth_step;  // in pixels
  bool perspective;   // pixels grow with the distance

  [[nodiscard]] glm::dvec3 offset(int di, int dj, double other) const {
    const double z = (other - depth) * depth_step;
    const double grown = perspective ? 1 - z * side / distance : 1;
    return {di * grown, dj * grown, z};
  }
};

/// Sums over the samples of a surface, those near in depth more.
struct SurfaceSums {
  double weight = 0;
  glm::dvec3 sum{0};
  glm::dmat3 squares{0};

  void add(const glm::dvec3& p) {
    const double far = p.z / (kSurfaceStep + 1);
    const double w = std::max(0.0, 1 - far * far);
    weight += w;
    const glm::dvec3 wp = w * p;
    sum += wp;
    for (int k = 0; k < 3; ++k) squares[k] += wp[k] * p;
  }
  [[nodiscard]] glm::dvec3 mean() const { return sum / weight; }
  [[nodiscard]] glm::dmat3 covariance() const {
    const glm::dvec3 m = mean();
    glm::dmat3 c = squares;
    for (int k = 0; k < 3; ++k) c[k] -= sum[k] * m;
    return c;
  }
};

/// Depths of a surface in a pixel, as stored.
struct DepthRange {
  double low, high;
};

/// A piece in the lengths around its sample.
struct Leaning {
  glm::dvec2 shift{0, 0};
  HalfSides half;
};

Leaning lean_along(const glm::dvec3& normal, const glm::dvec3& mean, const SamplePlace& place) {
  const int axis = main_axis(normal);
  Leaning piece{.half = plane_cell(normal, axis, kHalfSide)};
  double nearer = 0;  // its near end looks larger
  if (place.perspective) {
    double& u = piece.half.u.z;
    double& v = piece.half.v.z;
    const double all = (std::abs(u) + std::abs(v)) * place.side / place.distance;
    nearer = std::min(all, kMostNearer);
    if (all > nearer) u *= nearer / all, v *= nearer / all;
  }
  if (axis == 2) return piece;
  // Across the line of sight a sample is somewhere in its pixel.
  const double reach = kHalfSide * normal.z / std::abs(normal[axis]);
  const double room = std::clamp(kMostReach * (1 - nearer) - reach, 0.0, kMostShift);
  piece.shift[axis] = std::clamp(glm::dot(normal, mean) / normal[axis], -room, room);
  return piece;
}

class LayerLeaning {
 public:
  LayerLeaning(const PixelGrid& grid, const LayerSamples& samples)
      : grid_(grid), projection_(grid.camera), samples_(samples) {}

  void lean_row(uint32_t j, Surfels& surfels) const {
    for (uint32_t i = 0; i < grid_.width; ++i) {
      if (!has_layers(i, j)) continue;
      const size_t first = samples_.first(i, j), end = first + samples_.count(i, j);
      for (size_t n = first; n < end; ++n) lean(place_of(i, j, samples_.depth(n)), n, surfels);
    }
  }

 private:
  /// Calls visit(di, dj) for the pixels around one.
  template <class Visit>
  void for_each_pixel_around(uint32_t i, uint32_t j, Visit&& visit) const {
    const int left = i > 0 ? -1 : 0, right = i + 1 < grid_.width ? 1 : 0;
    const int below = j > 0 ? -1 : 0, above = j + 1 < grid_.height ? 1 : 0;
    for (int dj = below; dj <= above; ++dj)
      for (int di = left; di <= right; ++di)
        if (di != 0 || dj != 0) visit(di, dj);
  }

  [[nodiscard]] std::span<const uint32_t> depths(uint32_t i, uint32_t j, int di, int dj) const {
    return samples_.depths(static_cast<uint32_t>(int64_t{i} + di),
                           static_cast<uint32_t>(int64_t{j} + dj));
  }

  /// Whether a pixel that has samples, or one around it, has several.
  [[nodiscard]] bool has_layers(uint32_t i, uint32_t j) const {
    if (samples_.count(i, j) != 1) return samples_.count(i, j) > 1;
    bool several = false;
    for_each_pixel_around(
        i, j, [&](int di, int dj) { several = several || depths(i, j, di, dj).size() > 1; });
    return several;
  }

  [[nodiscard]] SamplePlace place_of(uint32_t i, uint32_t j, uint32_t depth) const {
    const double distance = samples_.distance(depth);
    const glm::dvec2 pixel = projection_.extent(distance) / glm::dvec2(grid_.width, grid_.height);
    const double side = std::max(pixel.x, pixel.y);
    return {i,
            j,
            static_cast<double>(depth),
            distance,
            side,
            grid_.step / side,
            !grid_.camera.orthographic};
  }

  void lean(const SamplePlace& place, size_t n, Surfels& surfels) const {
    const SurfaceSums around = surface_around(place);
    glm::dvec3 normal = plane_normal(around.covariance());
    if (normal == glm::dvec3(0)) return;
    if (normal.z < 0) normal = -normal;
    put(lean_along(normal, around.mean(), place), place, n, surfels);
  }

  [[nodiscard]] SurfaceSums surface_around(const SamplePlace& place) const {
    SurfaceSums around;
    const DepthRange own = add_run(place, 0, 0, place.depth, around);
    for_each_pixel_around(place.i, place.j, [&](int di, int dj) {
      const std::optional<double> next = linked(place, di, dj, own);
      if (next) add_run(place, di, dj, *next, around);
    });
    return around;
  }

  /// A depth of a pixel nearby that belongs to the same surface as a range of depths: one within
  /// it, else the one next to it, if that is near enough.
  [[nodiscard]] std::optional<double> linked(const SamplePlace& place, int di, int dj,
                                             const DepthRange& range) const {
    const std::span<const uint32_t> all = depths(place.i, place.j, di, dj);
    const auto above = std::lower_bound(all.begin(), all.end(), range.low);
    std::optional<double> next;
    if (above != all.end()) next = *above;
    if (above != all.begin()) {
      const double below = *(above - 1);
      if (!next || range.low - below < *next - range.high) next = below;
    }
    if (!next) return next;
    const double step = kStep * std::sqrt(di * di + dj * dj) / place.depth_step + 1;
    if (*next < range.low - step || *next > range.high + step) next.reset();
    return next;
  }

  /// Adds the samples of a pixel from one depth on, both ways, up to the first gap.
  DepthRange add_run(const SamplePlace& place, int di, int dj, double from,
                     SurfaceSums& around) const {
    const double gap = kGap / place.depth_step + 1, reach = kSurfaceStep / place.depth_step + 1;
    const std::span<const uint32_t> all = depths(place.i, place.j, di, dj);
    DepthRange run{from, from};
    const auto first = std::lower_bound(all.begin(), all.end(), from);
    for (auto at = first; at != all.end(); ++at) {
      if (*at > std::min(run.high + gap, place.depth + reach)) break;
      run.high = *at;
      around.add(place.offset(di, dj, *at));
    }
    for (auto at = first; at != all.begin();) {
      if (*--at < std::max(run.low - gap, place.depth - reach)) break;
      run.low = *at;
      around.add(place.offset(di, dj, *at));
    }
    return run;
  }

  void put(const Leaning& piece, const SamplePlace& place, size_t n, Surfels& surfels) const {
    const glm::dvec2 pixel(1.0 / grid_.width, 1.0 / grid_.height);
    const double u = (place.i + 0.5 + piece.shift.x) * pixel.x + grid_.shift.x;
    const double v = (place.j + 0.5 + piece.shift.y) * pixel.y + grid_.shift.y;
    const glm::dvec3 centre = projection_.point({u, v, place.distance});
    const glm::dmat3 axes(projection_.point({u + pixel.x, v, place.distance}) - centre,
                          projection_.point({u, v + pixel.y, place.distance}) - centre,
                          projection_.point({u, v, place.distance - place.side}) - centre);
    surfels.centres[n] = centre;
    surfels.u[n] = glm::vec3(axes * piece.half.u);
    surfels.v[n] = glm::vec3(axes * piece.half.v);
  }

  const PixelGrid& grid_;
  CameraProjection projection_;
  const LayerSamples& samples_;
};

}  // namespace

void lean_along_layers(const PixelGrid& grid, const LayerSamples& samples, unsigned threads,
                       Surfels& surfels) {
  const LayerLeaning leaning(grid, samples);
  parallel_for(grid.height, threads,
               [&](size_t j) { leaning.lean_row(static_cast<uint32_t>(j), surfels); });
}

}  // namespace afx
