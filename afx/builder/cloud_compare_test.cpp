// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/cloud_compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace afx {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

CloudDifference difference(const PointCloud& a, const PointCloud& b,
                           const CloudCompareOptions& options = {}) {
  const auto result = compare_clouds(a, b, options);
  EXPECT_TRUE(result.ok());
  return result.ok() ? result.value() : CloudDifference{};
}

// A square of side 15 in the plane z = 0, a point on each whole number.
PointCloud square(const glm::vec3& shift = {0, 0, 0}) {
  PointCloud cloud;
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) cloud.positions.push_back(glm::vec3(x, y, 0) + shift);
  return cloud;
}

// Points evenly over a sphere: along a spiral, by the golden angle.
PointCloud sphere(double radius, int points) {
  PointCloud cloud;
  for (int i = 0; i < points; ++i) {
    const double z = 1 - (2 * i + 1.0) / points, angle = i * 2.39996322972865332;
    const double r = std::sqrt(1 - z * z);
    cloud.positions.emplace_back(radius * r * std::cos(angle), radius * r * std::sin(angle),
                                 radius * z);
  }
  return cloud;
}

TEST(CompareClouds, OfEqualCloudsIsNothing) {
  const CloudDifference d = difference(square(), square());
  for (const GeometryError& error : {d.both.to_point, d.both.to_plane}) {
    EXPECT_EQ(error.mean_squared, 0);
    EXPECT_EQ(error.largest, 0);
    EXPECT_EQ(error.psnr, kInfinite);
  }
  EXPECT_EQ(d.peak, 15);
  EXPECT_FALSE(d.has_colours);
}

TEST(CompareClouds, AShiftAlongTheNormalCountsForBothDistances) {
  const CloudDifference d = difference(square(), square({0, 0, 0.5F}));
  for (const CloudError& error : {d.a_to_b, d.b_to_a, d.both})
    for (const GeometryError& geometry : {error.to_point, error.to_plane}) {
      EXPECT_DOUBLE_EQ(geometry.mean_squared, 0.25);
      EXPECT_DOUBLE_EQ(geometry.largest, 0.5);
      EXPECT_DOUBLE_EQ(geometry.psnr, 10 * std::log10(3 * 225 / 0.25));
    }
}

TEST(CompareClouds, AShiftInThePlaneIsNoDistanceToIt) {
  const CloudDifference d = difference(square(), square({0.25F, 0, 0}));
  EXPECT_DOUBLE_EQ(d.both.to_point.mean_squared, 0.0625);
  EXPECT_DOUBLE_EQ(d.both.to_point.largest, 0.25);
  EXPECT_NEAR(d.both.to_plane.mean_squared, 0, 1e-24);
}

TEST(CompareClouds, TakesTheNormalsOfTheReferenceWhereItHasThem) {
  // Normals on purpose along the shift, of another length than 1; those of B count for nothing.
  PointCloud a = square(), b = square({0.25F, 0, 0});
  a.normals.assign(a.positions.size(), glm::vec3(-3, 0, 0));
  b.normals.assign(b.positions.size(), glm::vec3(0, 0, 1));
  const CloudDifference d = difference(a, b);
  for (const CloudError& error : {d.a_to_b, d.b_to_a})
    EXPECT_DOUBLE_EQ(error.to_plane.mean_squared, 0.0625);
}

TEST(CompareClouds, WithoutANormalTheDistanceToThePointStandsIn) {
  PointCloud a = square(), b = square({0.25F, 0, 0});
  a.normals.assign(a.positions.size(), glm::vec3(0, 0, 1));
  a.normals[0] = {0, 0, 0};  // one of 256 points
  const CloudDifference d = difference(a, b);
  EXPECT_DOUBLE_EQ(d.a_to_b.to_plane.mean_squared, 0.0625 / 256);
  EXPECT_DOUBLE_EQ(d.b_to_a.to_plane.mean_squared, 0.0625 / 256);
  // Points on a line have no plane.
  PointCloud line, beside;
  for (int i = 0; i < 20; ++i) {
    line.positions.emplace_back(i, 0, 0);
    beside.positions.emplace_back(i, 2, 0);
  }
  EXPECT_DOUBLE_EQ(difference(line, beside).both.to_plane.mean_squared, 4);
}

TEST(CompareClouds, SpheresAreTheDifferenceOfTheirRadiiApart) {
  // Points lie at most about 0.04 apart, beside their nearest by half of that; the height of that
  // arc, 0.02^2 / 2, is what the distance to the plane may be off by.
  const CloudDifference d = difference(sphere(1, 10000), sphere(1.1, 10000));
  EXPECT_NEAR(std::sqrt(d.both.to_plane.mean_squared), 0.1, 1e-3);
  EXPECT_NEAR(d.both.to_plane.largest, 0.1, 2e-3);
  EXPECT_NEAR(std::sqrt(d.both.to_point.mean_squared), 0.1, 3e-3);
  EXPECT_GE(d.both.to_point.mean_squared, d.both.to_plane.mean_squared);
}

TEST(CompareClouds, TheTwoDirectionsDifferAndTheWorseCounts) {
  // B lacks the half of A with x >= 8: the farthest, at x = 15, is 8 from x = 7. From B to A all
  // are 0.
  const PointCloud a = square();
  PointCloud b;
  for (const glm::vec3& p : a.positions)
    if (p.x < 8) b.positions.push_back(p);
  const CloudDifference d = difference(a, b);
  EXPECT_DOUBLE_EQ(d.a_to_b.to_point.largest, 8);
  // Each row: 1 + 4 + 9 + ... + 64 = 204 over 16 points.
  EXPECT_DOUBLE_EQ(d.a_to_b.to_point.mean_squared, 204.0 / 16);
  EXPECT_EQ(d.b_to_a.to_point.mean_squared, 0);
  EXPECT_DOUBLE_EQ(d.both.to_point.mean_squared, 204.0 / 16);
  EXPECT_DOUBLE_EQ(d.both.to_point.psnr, 10 * std::log10(3 * 225 * 16 / 204.0));
}

TEST(CompareClouds, SinglePointsAreTheirDistanceApart) {
  PointCloud a, b;
  a.positions = {{1, 2, 3}};
  b.positions = {{1, 5, 7}};
  const CloudDifference d = difference(a, b);
  EXPECT_DOUBLE_EQ(d.both.to_point.largest, 5);
  EXPECT_DOUBLE_EQ(d.both.to_point.mean_squared, 25);
  EXPECT_DOUBLE_EQ(d.both.to_plane.mean_squared, 25);
  EXPECT_EQ(d.peak, 1);
  EXPECT_DOUBLE_EQ(difference(a, b, {.peak = 10}).both.to_point.psnr, 10 * std::log10(300 / 25.0));
}

TEST(CompareClouds, CoordinatesCountFromTheOrigins) {
  PointCloud b = square({0, 0, 1});
  b.origin = {1e9, 0, 0};
  PointCloud a = square({2, 0, 1});
  a.origin = {1e9 - 2, 0, 0};
  EXPECT_EQ(difference(a, b).both.to_point.mean_squared, 0);
}

TEST(CompareClouds, ComparesColoursWithTheMeanOfEquallyNearPoints) {
  PointCloud a, b;
  a.positions = {{0, 0, 0}};
  a.colours = {{100, 50, 0}};
  b.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 3, 0}};
  b.colours = {{110, 50, 0}, {130, 50, 20}, {0, 0, 255}};
  const CloudDifference d = difference(a, b);
  ASSERT_TRUE(d.has_colours);
  // A to B: (100, 50, 0) against (120, 50, 10).
  EXPECT_EQ(d.a_to_b.rgb.mean_squared, glm::dvec3(400, 0, 100));
  EXPECT_DOUBLE_EQ(d.a_to_b.rgb.psnr.r, 10 * std::log10(255 * 255 / 400.0));
  EXPECT_EQ(d.a_to_b.rgb.psnr.g, kInfinite);
  // Y' = 0.2126 * 20 + 0.0722 * 10 = 4.974; Cb = (10 - Y') / 1.8556; Cr = (20 - Y') / 1.5748.
  EXPECT_NEAR(d.a_to_b.ycbcr.mean_squared.x, 4.974 * 4.974, 1e-9);
  EXPECT_NEAR(d.a_to_b.ycbcr.mean_squared.y, std::pow(5.026 / 1.8556, 2), 1e-9);
  EXPECT_NEAR(d.a_to_b.ycbcr.mean_squared.z, std::pow(15.026 / 1.5748, 2), 1e-9);
  // B to A: red differs by 10, 30 and 100.
  EXPECT_NEAR(d.b_to_a.rgb.mean_squared.r, (100 + 900 + 10000) / 3.0, 1e-9);
  EXPECT_NEAR(d.both.rgb.mean_squared.r, (100 + 900 + 10000) / 3.0, 1e-9);
}

TEST(CompareClouds, GivesTheSameForAnyNumberOfThreads) {
  std::mt19937 random(1);
  const auto cloud = [&random] {
    PointCloud made;
    for (int i = 0; i < 20000; ++i) {
      const auto next = [&random] { return static_cast<float>(random() % 1000) * 0.1F; };
      const float x = next(), y = next(), z = next();
      made.positions.emplace_back(x, y, z);
      made.colours.push_back({static_cast<uint8_t>(random()), 1, 2, 255});
    }
    return made;
  };
  const PointCloud a = cloud(), b = cloud();
  const CloudDifference one = difference(a, b, {.threads = 1});
  const CloudDifference five = difference(a, b, {.threads = 5});
  EXPECT_EQ(one.a_to_b.to_point.mean_squared, five.a_to_b.to_point.mean_squared);
  EXPECT_EQ(one.b_to_a.to_plane.mean_squared, five.b_to_a.to_plane.mean_squared);
  EXPECT_EQ(one.both.to_plane.largest, five.both.to_plane.largest);
  EXPECT_EQ(one.both.ycbcr.mean_squared, five.both.ycbcr.mean_squared);
}

TEST(CompareClouds, RefusesWhatCannotBeCompared) {
  const PointCloud some = square();
  const auto refused = [](const PointCloud& a, const PointCloud& b,
                          const CloudCompareOptions& options = {}) {
    const auto result = compare_clouds(a, b, options);
    return result.ok() ? std::string()
                       : to_string(result.error().code) + (": " + result.error().text);
  };
  EXPECT_EQ(refused({}, some), "bad_argument: point cloud A has no points");
  EXPECT_EQ(refused(some, {}), "bad_argument: point cloud B has no points");
  PointCloud odd = some;
  odd.colours.resize(3);
  EXPECT_EQ(refused(some, odd),
            "bad_argument: point cloud B does not have a colour and a normal for each point");
  EXPECT_EQ(refused(some, some, {.peak = -1}), "bad_argument: the peak is no positive length");
  EXPECT_EQ(refused(some, some, {.limits = {.memory = 512 * 72 - 1}}),
            "limit_exceeded: to compare the points takes more memory than the limit");
  EXPECT_EQ(refused(some, some, {.limits = {.memory = 512 * 72}}), "");
}

}  // namespace
}  // namespace afx
