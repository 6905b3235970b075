// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/triangle_cells.h"

#include <algorithm>
#include <glm/common.hpp>

namespace afx {
namespace {

int64_t floor_div(int64_t a, int64_t b) {  // b > 0
  const int64_t q = a / b;
  return q - (a % b < 0 ? 1 : 0);
}

}  // namespace

// The farthest a half-open cell [i*s, (i+1)*s) reaches in a direction m is sum of m*i*s plus m*s
// for each m > 0, and then not quite: where some m > 0, what is to be reached must be less, which
// among integers is "at most one less".
TriangleCells::TriangleCells(const std::array<glm::ivec3, 3>& corners, int cell_bits)
    : corners_(corners), cell_(int64_t{1} << cell_bits) {
  const glm::ivec3 low = glm::min(glm::min(corners[0], corners[1]), corners[2]);
  const glm::ivec3 high = glm::max(glm::max(corners[0], corners[1]), corners[2]);
  for (int k = 0; k < 3; ++k) {
    bounds_.low[k] = low[k] >> cell_bits;
    bounds_.high[k] = high[k] >> cell_bits;
  }
  std::array<int64_t, 3> normal{};
  for (int k = 0; k < 3; ++k) {
    const int u = (k + 1) % 3, v = (k + 2) % 3;
    const auto edge = [&](int corner, int axis) {
      return int64_t{corners[static_cast<size_t>(corner)][axis]} - corners[0][axis];
    };
    normal[static_cast<size_t>(k)] = edge(1, u) * edge(2, v) - edge(1, v) * edge(2, u);
  }
  for (int k = 0; k < 3; ++k) {
    const auto size = [&](int axis) { return std::abs(normal[static_cast<size_t>(axis)]); };
    if (size(k) > size(axis_)) axis_ = k;
    shadows_[static_cast<size_t>(k)] = shadow_along(k, normal[static_cast<size_t>(k)]);
  }
  for (size_t side = 0; side < 2; ++side) {
    const int64_t sign = side == 0 ? 1 : -1;
    Plane plane{{}, 0};
    bool rising = false;
    for (size_t k = 0; k < 3; ++k) {
      const int64_t m = sign * normal[k];
      plane.a[k] = m * cell_;
      plane.c += std::max<int64_t>(m, 0) * cell_ - m * corners[0][static_cast<int>(k)];
      rising = rising || m > 0;
    }
    if (rising) --plane.c;
    planes_[side] = plane;
  }
}

void TriangleCells::add_edge(Shadow& shadow, int u, int v, int from, int to, bool reversed) const {
  const glm::ivec3 p = corners_[static_cast<size_t>(from)], q = corners_[static_cast<size_t>(to)];
  int64_t mu = int64_t{p[v]} - q[v], mv = int64_t{q[u]} - p[u];  // to the left of the edge
  if (reversed) {
    mu = -mu;
    mv = -mv;
  }
  if (mu == 0 && mv == 0) return;
  const int64_t reach = (std::max<int64_t>(mu, 0) + std::max<int64_t>(mv, 0)) * cell_;
  const int64_t strict = mu > 0 || mv > 0 ? 1 : 0;
  shadow.lines[static_cast<size_t>(shadow.count++)] = {mu * cell_, mv * cell_,
                                                       reach - mu * p[u] - mv * p[v] - strict};
}

TriangleCells::Shadow TriangleCells::shadow_along(int axis, int64_t normal) const {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  Shadow shadow;
  for (int k = 0; k < 3; ++k) {
    if (normal >= 0) add_edge(shadow, u, v, k, (k + 1) % 3, false);
    if (normal <= 0) add_edge(shadow, u, v, k, (k + 1) % 3, true);
  }
  return shadow;
}

CellRange TriangleCells::within(const CellRange& range) const {
  return {glm::max(bounds_.low, range.low), glm::min(bounds_.high, range.high)};
}

// Narrows the interval to where a*i + b >= 0.
void TriangleCells::limit(int64_t a, int64_t b, Interval& interval) {
  if (interval.low == interval.high) {  // mostly: spares a division
    if (a * interval.low + b < 0) interval.high = interval.low - 1;
    return;
  }
  if (a > 0) {
    interval.low = std::max(interval.low, -floor_div(b, a));
  } else if (a < 0) {
    interval.high = std::min(interval.high, floor_div(b, -a));
  } else if (b < 0) {
    interval.high = interval.low - 1;
  }
}

void TriangleCells::limit_row(int v, Interval& row) const {
  const Shadow& shadow = shadows_[static_cast<size_t>(axis_)];
  for (int k = 0; k < shadow.count; ++k) {
    const Line& line = shadow.lines[static_cast<size_t>(k)];
    limit(line.a, line.b * v + line.c, row);
  }
}

void TriangleCells::limit_column(int u, int v, Interval& column) const {
  if (column.low == column.high && bounds_.low == bounds_.high) return;  // one cell: it holds all
  const auto w = static_cast<size_t>(axis_), next = (w + 1) % 3, after = (w + 2) % 3;
  for (const Plane& plane : planes_)
    limit(plane.a[w], plane.a[next] * u + plane.a[after] * v + plane.c, column);
  // The shadow along u has lines in (v, w), the one along v in (w, u).
  const Shadow& along_u = shadows_[next];
  for (int k = 0; k < along_u.count; ++k) {
    const Line& line = along_u.lines[static_cast<size_t>(k)];
    limit(line.b, line.a * v + line.c, column);
  }
  const Shadow& along_v = shadows_[after];
  for (int k = 0; k < along_v.count; ++k) {
    const Line& line = along_v.lines[static_cast<size_t>(k)];
    limit(line.a, line.b * u + line.c, column);
  }
}

}  // namespace afx
