// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/point_normals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace afx {
namespace {

std::vector<glm::vec3> normals(const std::vector<glm::vec3>& points) {
  return estimate_normals(points, NearestPoints(points), 1);
}

TEST(EstimateNormals, OfAPlaneIsItsNormal) {
  // x + 2y + 2z = 0: (1, 2, 2) / 3, spanned by (2, -1, 0) and (2, 4, -5).
  std::vector<glm::vec3> points;
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j)
      points.push_back(static_cast<float>(i) * glm::vec3(2, -1, 0) +
                       static_cast<float>(j) * glm::vec3(2, 4, -5));
  for (const glm::vec3& normal : normals(points)) {
    EXPECT_NEAR(glm::length(normal), 1, 1e-6);
    EXPECT_NEAR(std::abs(glm::dot(normal, glm::vec3(1, 2, 2) / 3.0F)), 1, 1e-6);
  }
}

TEST(EstimateNormals, OfThreePointsIsThatOfTheirTriangle) {
  for (const glm::vec3& normal : normals({{0, 0, 0}, {1, 0, 0}, {0, 0, 2}}))
    EXPECT_NEAR(std::abs(normal.y), 1, 1e-6);
}

TEST(EstimateNormals, IsUnknownOnALineAndInOnePlace) {
  EXPECT_EQ(normals({{1, 2, 3}}), std::vector<glm::vec3>(1, glm::vec3(0)));
  EXPECT_EQ(normals(std::vector<glm::vec3>(20, {4, 5, 6})),
            std::vector<glm::vec3>(20, glm::vec3(0)));
  std::vector<glm::vec3> line;
  for (int i = 0; i < 20; ++i) line.push_back(static_cast<float>(i) * glm::vec3(0.1F, 0.7F, 0.3F));
  EXPECT_EQ(normals(line), std::vector<glm::vec3>(20, glm::vec3(0)));
}

TEST(DirectionMean, TakesOppositeDirectionsAsOne) {
  DirectionMean mean;
  EXPECT_EQ(mean.value(), glm::dvec3(0));
  mean.add({1, 0, 0});
  mean.add({-0.6, 0.8, 0});  // as (0.6, -0.8, 0)
  const glm::dvec3 expected = glm::normalize(glm::dvec3(1.6, -0.8, 0));
  EXPECT_NEAR(glm::length(mean.value() - expected), 0, 1e-12);
}

}  // namespace
}  // namespace afx
