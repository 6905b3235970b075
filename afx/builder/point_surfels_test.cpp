// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/point_surfels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

namespace afx {
namespace {

// Points on a sphere of radius 2 around a place, evenly: a spiral.
PointCloud sphere(int count, const glm::vec3& middle) {
  PointCloud cloud;
  for (int n = 0; n < count; ++n) {
    const double z = 1 - 2 * (n + 0.5) / count, r = std::sqrt(1 - z * z);
    const double angle = n * glm::pi<double>() * (3 - std::sqrt(5.0));
    cloud.positions.push_back(
        middle + glm::vec3(glm::dvec3(r * std::cos(angle), r * std::sin(angle), z) * 2.0));
  }
  return cloud;
}

Surfels surfels_or_fail(const PointCloud& cloud, unsigned threads = 1) {
  auto surfels = surfels_of(cloud, threads, {});
  EXPECT_TRUE(surfels.ok()) << surfels.error().text;
  return surfels.ok() ? surfels.value() : Surfels{};
}

TEST(PointSurfels, OfASphereFaceOutwardsAndOverlapALittle) {
  PointCloud cloud = sphere(3000, {5, 6, 7});
  cloud.origin = {1e6, 0, 0};
  const Surfels surfels = surfels_or_fail(cloud);
  ASSERT_EQ(surfels.size(), 3000U);
  // 16 pi of area for 3000 points: 0.13 apart in a square grid.
  const double apart = std::sqrt(16 * glm::pi<double>() / 3000);
  double area = 0;
  for (size_t n = 0; n < surfels.size(); ++n) {
    const glm::dvec3 out = glm::normalize(surfels.centres[n] - glm::dvec3(1e6 + 5, 6, 7));
    const glm::dvec3 across = glm::cross(surfels.u[n], surfels.v[n]);
    EXPECT_GT(glm::dot(out, glm::normalize(across)), 0.98) << n;
    EXPECT_NEAR(glm::length(surfels.u[n]), 0.72 * apart, 0.15 * apart);
    EXPECT_EQ(surfels.colours[n], (Rgba8{255, 255, 255, 255}));
    area += 4 * glm::length(across);
  }
  EXPECT_GT(area, 1.3 * 16 * glm::pi<double>());
  EXPECT_LT(area, 2.5 * 16 * glm::pi<double>());
}

TEST(PointSurfels, NormalsOfTheFileComeFirst) {
  PointCloud cloud = sphere(500, {0, 0, 0});
  cloud.normals.assign(500, glm::vec3(0, 3, 0));
  cloud.normals[7] = glm::vec3(0);
  const Surfels surfels = surfels_or_fail(cloud);
  for (size_t n = 0; n < 500; ++n) {
    const glm::vec3 outside = glm::normalize(glm::cross(surfels.u[n], surfels.v[n]));
    const glm::vec3 expected = n == 7 ? glm::normalize(cloud.positions[7]) : glm::vec3(0, 1, 0);
    EXPECT_GT(glm::dot(outside, expected), 0.97F) << n;
  }
}

TEST(PointSurfels, APointAloneHasNoExtent) {
  PointCloud cloud;
  cloud.positions = {{1, 2, 3}};
  cloud.colours = {{9, 8, 7, 255}};
  const Surfels surfels = surfels_or_fail(cloud);
  EXPECT_EQ(surfels.centres, (std::vector<glm::dvec3>{{1, 2, 3}}));
  EXPECT_EQ(surfels.u[0], glm::vec3(0));
  EXPECT_EQ(surfels.v[0], glm::vec3(0));
  EXPECT_EQ(surfels.colours[0], (Rgba8{9, 8, 7, 255}));
  EXPECT_EQ(surfels_or_fail({}).size(), 0U);
}

TEST(PointSurfels, AreTheSameForAnyNumberOfThreads) {
  const PointCloud cloud = sphere(20000, {0, 0, 0});
  const Surfels one = surfels_or_fail(cloud, 1), four = surfels_or_fail(cloud, 4);
  EXPECT_EQ(one.centres, four.centres);
  EXPECT_EQ(one.u, four.u);
  EXPECT_EQ(one.v, four.v);
}

TEST(PointSurfels, KeepToTheLimits) {
  Limits limits;
  limits.memory = 99 * (kSurfelBytes + 40);
  const auto many = surfels_of(sphere(100, {0, 0, 0}), 1, limits);
  ASSERT_FALSE(many.ok());
  EXPECT_EQ(many.error().code, Errc::limit_exceeded);
  EXPECT_EQ(many.error().text, "100 points take more memory than the limit");
}

TEST(PointSurfels, PointsOfSurfelsAreTheirCentres) {
  Surfels surfels;
  surfels.push_back({1e7, 2, 3}, {2, 0, 0}, {0, 5, 0}, {1, 2, 3, 255});
  surfels.push_back({1e7 + 0.125, 2, 4}, {0, 0, 0}, {0, 0, 0}, {4, 5, 6, 255});
  const PointCloud cloud = points_of(surfels);
  EXPECT_EQ(cloud.origin, glm::dvec3(1e7, 2, 3));
  EXPECT_EQ(cloud.positions, (std::vector<glm::vec3>{{0, 0, 0}, {0.125, 0, 1}}));
  EXPECT_EQ(cloud.normals, (std::vector<glm::vec3>{{0, 0, 1}, {0, 0, 0}}));
  EXPECT_EQ(cloud.colours, surfels.colours);
  EXPECT_TRUE(points_of({}).positions.empty());
}

}  // namespace
}  // namespace afx
