// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/plane_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

namespace afx {
namespace {

glm::dvec3 normal_of(const std::vector<glm::dvec3>& offsets) {
  glm::dmat3 sum(0);
  for (const glm::dvec3& d : offsets) sum += glm::outerProduct(d, d);
  return plane_normal(sum);
}

TEST(PlaneNormal, IsAcrossThePointsThoughTheyAreNoisy) {
  // Offsets along (2, -1, 0) and (2, 4, -5), which are perpendicular to (1, 2, 2) / 3; and less
  // along that.
  const glm::dvec3 a(2, -1, 0), b(2, 4, -5), n = glm::dvec3(1, 2, 2) / 3.0;
  const glm::dvec3 normal = normal_of({a, -a, b, -b, 0.5 * n, -0.5 * n});
  EXPECT_NEAR(glm::length(normal), 1, 1e-14);
  EXPECT_NEAR(std::abs(glm::dot(normal, n)), 1, 1e-14);
}

TEST(PlaneNormal, OfPointsOnTheAxesIsAnAxis) {
  EXPECT_EQ(normal_of({{3, 0, 0}, {0, 2, 0}, {0, 0, 1}}), glm::dvec3(0, 0, 1));
  EXPECT_EQ(normal_of({{3, 0, 0}, {0, 1, 0}, {0, 0, 2}}), glm::dvec3(0, 1, 0));
  EXPECT_EQ(normal_of({{0, 3, 0}, {0, 0, 2}}), glm::dvec3(1, 0, 0));
}

TEST(PlaneNormal, IsUnknownOnALineAndInOnePlace) {
  EXPECT_EQ(normal_of({}), glm::dvec3(0));
  EXPECT_EQ(normal_of({{0.1, 0.7, 0.3}, {-0.2, -1.4, -0.6}}), glm::dvec3(0));
}

}  // namespace
}  // namespace afx
