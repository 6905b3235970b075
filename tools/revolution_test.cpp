// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/revolution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace afx::tools {
namespace {

/// How far points reach in a direction.
double reach(const std::vector<glm::dvec3>& points, const glm::dvec3& direction) {
  double most = -1e9;
  for (const glm::dvec3& point : points) most = std::max(most, glm::dot(point, direction));
  return most;
}

TEST(RevolutionOutline, HoldsThePointsHoweverTheyAreTurned) {
  const glm::dvec3 around(1, 5, -2);
  const std::vector<glm::dvec3> points{{1, 0, -2}, {4, 1, 2}, {1.5, 3, -2}, {1, 4, -4}};
  const std::vector<glm::dvec3> outline = revolution_outline(points, around);
  for (int step = 0; step < 100; ++step) {
    const glm::dquat turn = glm::angleAxis(0.0628 * step, glm::dvec3(0, 1, 0));
    std::vector<glm::dvec3> turned;
    for (const glm::dvec3& point : points) turned.push_back(around + turn * (point - around));
    for (const double up : {-1.0, -0.3, 0.0, 0.3, 1.0}) {
      const glm::dvec3 direction(std::sqrt(1 - up * up), up, 0);
      EXPECT_GE(reach(outline, direction), reach(turned, direction) - 1e-12);
    }
  }
}

TEST(RevolutionOutline, IsNotWiderThanTheCircles) {
  // The farthest point from the axis is 3, 4, 5 away.
  const std::vector<glm::dvec3> points{{3, 0, 4}, {0, 2, 0}, {1, 1, 0}};
  const std::vector<glm::dvec3> outline = revolution_outline(points, {0, 0, 0});
  EXPECT_EQ(outline.size(), 2 * 256U);  // (1, 1) lies inside
  EXPECT_NEAR(reach(outline, {1, 0, 0}), 5, 5e-4);
  EXPECT_NEAR(reach(outline, {0, 0, -1}), 5, 5e-4);
  EXPECT_EQ(reach(outline, {0, 1, 0}), 2);
  EXPECT_EQ(reach(outline, {0, -1, 0}), 0);
  EXPECT_TRUE(revolution_outline({}, {0, 0, 0}).empty());
}

}  // namespace
}  // namespace afx::tools
