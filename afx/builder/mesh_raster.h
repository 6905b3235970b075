// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Where the lines of sight through the pixels' centres of a camera meet the triangles of a mesh.
// Whether a centre lies in a triangle is decided on integers, a point on an edge belonging to one
// of its two triangles, so closed surfaces have no gaps and no pixel twice. Source: Pineda, "A
// parallel algorithm for polygon rasterization", SIGGRAPH 1988.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "afx/builder/mesh.h"
#include "afx/depth_camera.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx {

/// A point of a triangle that a pixel's centre sees: corner 0 has the weight 1 - b - c.
struct Fragment {
  uint32_t x = 0, y = 0;  ///< pixel, row 0 at the top
  uint32_t triangle = 0;
  double distance = 0;  ///< to the plane through the camera
  double b = 0, c = 0;
};

/// The triangles of a mesh as one camera sees them, sorted into bands of rows that can be worked on
/// at the same time. Both sides of a triangle are seen; what lies nearer than the near plane is
/// not. Memory: 24 bytes a vertex, 8 a triangle, 4 for each triangle and band that it meets.
class MeshRaster {
 public:
  static constexpr uint32_t kBandRows =
      24;  ///< whole pixels of 1, 2, 3, 4, 6 and 8 rows of samples

  /// mesh     must stay as it is
  /// camera   checked; width, height >= 1, at most 65536
  /// Errors   limit_exceeded: more memory than limits.memory
  static Result<MeshRaster> of(const Mesh& mesh, const DepthCamera& camera, uint32_t width,
                               uint32_t height, unsigned threads, const Limits& limits);

  [[nodiscard]] uint32_t width() const { return width_; }
  [[nodiscard]] uint32_t height() const { return height_; }
  [[nodiscard]] uint32_t bands() const { return (height_ + kBandRows - 1) / kBandRows; }
  /// The rows of a band: from `first_row` up to, not with, `end_row`.
  [[nodiscard]] uint32_t first_row(uint32_t band) const { return band * kBandRows; }
  [[nodiscard]] uint32_t end_row(uint32_t band) const;

  /// Calls visit(fragment) for every fragment in a band, triangle by triangle.
  template <class Visit>
  void for_each(uint32_t band, Visit&& visit) const {
    for (size_t at = starts_[band]; at < starts_[band + 1]; ++at) {
      const uint32_t triangle = entries_[at];
      Parts parts;
      const int count = cut(triangle, parts);
      for (int part = 0; part < count; ++part)
        draw(parts[static_cast<size_t>(part)], triangle, band, visit);
    }
  }

 private:
  MeshRaster(const Mesh& mesh, const DepthCamera& camera, uint32_t width, uint32_t height);

  /// A corner of a triangle, or of a part that the near plane leaves of it.
  struct Corner {
    glm::dvec3 seen{0, 0, 0};  // in the camera's system
    double b = 0, c = 0;
  };
  using Parts = std::array<std::array<Corner, 3>, 2>;
  /// A triangle on the screen, in 1/256 of a pixel, y down, counterclockwise in these.
  struct Placed {
    std::array<int64_t, 3> x, y;
    std::array<double, 3> distance, b, c;
    int64_t doubled_area = 0;
  };
  struct Rows {
    int64_t first = 0, last = -1;
  };

  [[nodiscard]] int cut(uint32_t triangle, Parts& parts) const;
  [[nodiscard]] Placed place(const std::array<Corner, 3>& corners) const;
  [[nodiscard]] Rows rows_of(uint32_t triangle) const;
  void see_vertices(const DepthCamera& camera, unsigned threads);
  Status sort_into_bands(unsigned threads, const Limits& limits);

  template <class Visit>
  void draw(const std::array<Corner, 3>& corners, uint32_t triangle, uint32_t band,
            Visit&& visit) const;

  const Mesh& mesh_;
  bool perspective_;
  double near_;
  glm::dvec2 extent_;  // of the view, at distance 1 in perspective
  uint32_t width_, height_;
  std::vector<glm::dvec3> seen_;  // the vertices in the camera's system
  std::vector<size_t> starts_;    // of each band in entries_, and the end
  std::vector<uint32_t> entries_;
};

template <class Visit>
void MeshRaster::draw(const std::array<Corner, 3>& corners, uint32_t triangle, uint32_t band,
                      Visit&& visit) const {
  constexpr int64_t kUnit = 256, kHalf = kUnit / 2;
  const Placed p = place(corners);
  if (p.doubled_area == 0) return;
  const auto first_at_or_after = [](int64_t at) { return (at - kHalf + kUnit - 1) >> 8; };
  const auto last_at_or_before = [](int64_t at) { return (at - kHalf) >> 8; };
  const auto [left, right] = std::minmax({p.x[0], p.x[1], p.x[2]});
  const auto [top, bottom] = std::minmax({p.y[0], p.y[1], p.y[2]});
  const int64_t x0 = std::max<int64_t>(first_at_or_after(left), 0);
  const int64_t x1 = std::min<int64_t>(last_at_or_before(right), int64_t{width_} - 1);
  const int64_t y0 = std::max<int64_t>(first_at_or_after(top), first_row(band));
  const int64_t y1 = std::min<int64_t>(last_at_or_before(bottom), int64_t{end_row(band)} - 1);
  // Edge k runs from corner k+1 to corner k+2: its function is corner k's weight times the area.
  std::array<int64_t, 3> dx{}, dy{}, row{}, bias{};
  for (size_t k = 0; k < 3; ++k) {
    const size_t from = (k + 1) % 3, to = (k + 2) % 3;
    dx[k] = p.x[to] - p.x[from];
    dy[k] = p.y[to] - p.y[from];
    bias[k] = dy[k] > 0 || (dy[k] == 0 && dx[k] < 0) ? 0 : -1;
    row[k] = dx[k] * (y0 * kUnit + kHalf - p.y[from]) - dy[k] * (x0 * kUnit + kHalf - p.x[from]);
  }
  const double area = static_cast<double>(p.doubled_area);
  for (int64_t y = y0; y <= y1; ++y) {
    std::array<int64_t, 3> e = row;
    for (int64_t x = x0; x <= x1; ++x) {
      if (((e[0] + bias[0]) | (e[1] + bias[1]) | (e[2] + bias[2])) >= 0) {
        std::array<double, 3> w{};
        double sum = 1;
        for (size_t k = 0; k < 3; ++k) w[k] = static_cast<double>(e[k]) / area;
        if (perspective_) {  // weights on the screen become weights on the triangle
          for (size_t k = 0; k < 3; ++k) w[k] /= p.distance[k];
          sum = w[0] + w[1] + w[2];
        }
        Fragment f{static_cast<uint32_t>(x), static_cast<uint32_t>(y), triangle, 0, 0, 0};
        for (size_t k = 0; k < 3; ++k) {
          const double weight = w[k] / sum;
          f.distance += weight * p.distance[k];
          f.b += weight * p.b[k];
          f.c += weight * p.c[k];
        }
        visit(f);
      }
      for (size_t k = 0; k < 3; ++k) e[k] -= dy[k] * kUnit;
    }
    for (size_t k = 0; k < 3; ++k) row[k] += dx[k] * kUnit;
  }
}

}  // namespace afx
