// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/triangle_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <tuple>
#include <vector>

namespace afx {
namespace {

using Cell = std::tuple<int, int, int>;
using Corners = std::array<glm::ivec3, 3>;
using Vector = std::array<__int128, 3>;

std::set<Cell> cells_of(const Corners& corners, int bits, const CellRange& range) {
  std::set<Cell> cells;
  size_t visits = 0;
  TriangleCells(corners, bits).for_each(range, [&](int x, int y, int z) {
    cells.insert({x, y, z});
    ++visits;
  });
  EXPECT_EQ(visits, cells.size()) << "a cell was visited twice";
  return cells;
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// The separating axis theorem word for word: 13 axes, both ways, for a closed box whose upper sides
// are 10^-6 of a unit short of the next cell. What a triangle with integer corners below 2^7 does
// not touch of the half-open cell lies farther off than that: an axis separates by an integer or
// not at all, and the axes' components stay below 2^15, times 10^-6 below 1/10. 128 bits hold all
// products.
bool meets(const Corners& t, const Cell& cell, int size) {
  constexpr __int128 kFine = 1000000;
  const std::array<int, 3> number{std::get<0>(cell), std::get<1>(cell), std::get<2>(cell)};
  Vector low{}, high{};
  std::array<Vector, 3> p{};
  for (size_t k = 0; k < 3; ++k) {
    low[k] = __int128{number[k]} * size * kFine;
    high[k] = low[k] + __int128{size} * kFine - 1;
    for (size_t i = 0; i < 3; ++i) p[i][k] = __int128{t[i][static_cast<int>(k)]} * kFine;
  }
  std::vector<Vector> axes{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  std::array<Vector, 3> edges{};
  for (size_t i = 0; i < 3; ++i)
    for (size_t k = 0; k < 3; ++k)
      edges[i][k] = t[(i + 1) % 3][static_cast<int>(k)] - t[i][static_cast<int>(k)];
  axes.push_back(cross(edges[0], edges[1]));
  for (size_t k = 0; k < 3; ++k)
    for (const Vector& edge : edges) axes.push_back(cross(axes[k], edge));
  for (const Vector& axis : axes) {
    const auto along = [&](const Vector& v) {
      return axis[0] * v[0] + axis[1] * v[1] + axis[2] * v[2];
    };
    __int128 box_low = 0, box_high = 0;
    for (size_t k = 0; k < 3; ++k) {
      box_low += std::min(axis[k] * low[k], axis[k] * high[k]);
      box_high += std::max(axis[k] * low[k], axis[k] * high[k]);
    }
    const auto [least, most] = std::minmax({along(p[0]), along(p[1]), along(p[2])});
    if (most < box_low || least > box_high) return false;
  }
  return true;
}

std::set<Cell> brute_force(const Corners& corners, int size, const CellRange& range) {
  std::set<Cell> cells;
  for (int x = range.low.x; x <= range.high.x; ++x)
    for (int y = range.low.y; y <= range.high.y; ++y)
      for (int z = range.low.z; z <= range.high.z; ++z)
        if (meets(corners, {x, y, z}, size)) cells.insert({x, y, z});
  return cells;
}

constexpr CellRange kSmall{glm::ivec3(0), glm::ivec3(7)};

TEST(TriangleCells, AreThoseOfTheSeparatingAxisTheorem) {
  std::mt19937 random(1);
  for (int round = 0; round < 3000; ++round) {
    Corners corners;
    // Small ranges make coplanar, degenerate and touching cases common.
    const int span = 1 + static_cast<int>(random() % 127);
    for (glm::ivec3& c : corners)
      for (int k = 0; k < 3; ++k) c[k] = static_cast<int>(random() % static_cast<unsigned>(span));
    if (round % 3 == 0)  // corners on borders between cells
      for (glm::ivec3& c : corners) c = (c / 16) * 16;
    ASSERT_EQ(cells_of(corners, 4, kSmall), brute_force(corners, 16, kSmall))
        << "round " << round << ", corners " << corners[0].x << ' ' << corners[0].y << ' '
        << corners[0].z << ", " << corners[1].x << ' ' << corners[1].y << ' ' << corners[1].z
        << ", " << corners[2].x << ' ' << corners[2].y << ' ' << corners[2].z;
  }
}

TEST(TriangleCells, HoldPointsAndSegments) {
  const glm::ivec3 p(16, 15, 32);  // 16 and 32 are lower sides: they belong to the cells above
  EXPECT_EQ(cells_of({p, p, p}, 4, kSmall), (std::set<Cell>{{1, 0, 2}}));
  const glm::ivec3 q(16, 15, 64);
  EXPECT_EQ(cells_of({p, q, p}, 4, kSmall), (std::set<Cell>{{1, 0, 2}, {1, 0, 3}, {1, 0, 4}}));
}

TEST(TriangleCells, OfAPlaneBetweenTwoLayersAreOneLayer) {
  for (int axis = 0; axis < 3; ++axis) {
    Corners corners{glm::ivec3(0), glm::ivec3(0), glm::ivec3(0)};
    for (glm::ivec3& c : corners) c[axis] = 48;
    corners[1][(axis + 1) % 3] = 127;
    corners[2][(axis + 2) % 3] = 127;
    for (const auto& [x, y, z] : cells_of(corners, 4, kSmall))
      EXPECT_EQ((std::array{x, y, z})[static_cast<size_t>(axis)], 3);
  }
}

TEST(TriangleCells, OfSplitRangesAreTheCellsOfTheWhole) {
  std::mt19937 random(2);
  for (int round = 0; round < 200; ++round) {
    Corners corners;
    for (glm::ivec3& c : corners)
      for (int k = 0; k < 3; ++k) c[k] = static_cast<int>(random() % 2048);
    const CellRange whole{glm::ivec3(0), glm::ivec3(7)};
    std::set<Cell> joined;
    for (int part = 0; part < 8; ++part) {
      const glm::ivec3 low(part % 2 * 4, part / 2 % 2 * 4, part / 4 * 4);
      joined.merge(cells_of(corners, 8, {low, low + 3}));
    }
    EXPECT_EQ(joined, cells_of(corners, 8, whole));
  }
}

TEST(TriangleCells, DoNotOverflowAtTheLargestSizes) {
  // A triangle through the whole cube of 2048 voxels: along its diagonal every cell (i, i, i) is
  // met, and 3 * 2^19 is the farthest that products of coordinates go.
  const int far = (2048 << 8) - 1;
  const Corners corners{glm::ivec3(0), glm::ivec3(far, far, far), glm::ivec3(far, 0, far)};
  const TriangleCells cells(corners, 8);
  for (const int i : {0, 1, 1000, 2047}) {
    bool met = false;
    cells.for_each({glm::ivec3(i), glm::ivec3(i)}, [&](int, int, int) { met = true; });
    EXPECT_TRUE(met) << i;
  }
  bool met = false;  // x = z all over this triangle
  cells.for_each({glm::ivec3(1000, 0, 1002), glm::ivec3(1000, 2047, 2047)},
                 [&](int, int, int) { met = true; });
  EXPECT_FALSE(met);
}

}  // namespace
}  // namespace afx
