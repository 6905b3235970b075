// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/nearest_points.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>
#include <random>

namespace afx {
namespace {

using ::testing::ElementsAre;
using ::testing::ElementsAreArray;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// On whole numbers there are many equal distances.
std::vector<glm::vec3> scattered(size_t count) {
  std::mt19937 random(7);
  std::vector<glm::vec3> points;
  for (size_t i = 0; i < count; ++i) {
    const auto next = [&random] { return static_cast<float>(random() % 16); };
    const float x = next(), y = next(), z = next();
    points.emplace_back(x, y, z);
  }
  return points;
}

double squared(const glm::vec3& point, const glm::dvec3& place) {
  const glm::dvec3 d = glm::dvec3(point) - place;
  return glm::dot(d, d);
}

TEST(NearestPoints, FindsWhatLookingAtAllFinds) {
  const std::vector<glm::vec3> points = scattered(1500);
  const NearestPoints index(points);
  for (const glm::vec3& at : scattered(300)) {
    const glm::dvec3 place = glm::dvec3(at) + 0.5;
    double smallest = 1e9;
    for (const glm::vec3& p : points) smallest = std::min(smallest, squared(p, place));
    std::vector<uint32_t> all;
    for (uint32_t i = 0; i < points.size(); ++i)
      if (squared(points[i], place) == smallest) all.push_back(i);
    const NearestPoints::Nearest nearest = index.nearest(place);
    EXPECT_EQ(nearest.squared, smallest);
    EXPECT_THAT(nearest.points(), ElementsAreArray(all));
  }
}

TEST(NearestPoints, GivesTheFirstFewFromNearToFar) {
  const std::vector<glm::vec3> points = {{5, 0, 0}, {1, 0, 0}, {3, 0, 0}, {-2, 0, 0}};
  const NearestPoints index(points);
  EXPECT_THAT(index.nearest({0, 0, 0}, 3), ElementsAre(1, 3, 2));
  EXPECT_THAT(index.nearest({0, 0, 0}, 9), SizeIs(4));
}

TEST(NearestPoints, TellsOfManyInOnePlaceTheFirst) {
  std::vector<glm::vec3> points(1000, glm::vec3(1, 2, 3));
  points[0] = {-1, -2, -3};  // as far from the origin
  std::vector<uint32_t> first(NearestPoints::kMostEqual);
  std::iota(first.begin(), first.end(), 0U);
  EXPECT_THAT(NearestPoints(points).nearest({0, 0, 0}).points(), ElementsAreArray(first));
}

TEST(NearestPoints, GivesThePointsOfOnePlaceTogetherWithTheirNumbersAscending) {
  const std::vector<glm::vec3> points = {{2, 0, 0}, {0, 0, 0}, {2, 0, 0}, {-0.0F, 0, 0}, {1, 0, 0}};
  const NearestPoints index(points);
  EXPECT_THAT(index.nearest({0, 0, 0}, 4), ElementsAre(1, 3, 4, 0));
  EXPECT_THAT(index.nearest({3, 0, 0}, 9), ElementsAre(0, 2, 4, 1, 3));
}

// Where a search visits all of them this takes a minute.
TEST(NearestPoints, ManyPointsInOnePlaceTakeNoLongerThanOne) {
  const std::vector<glm::vec3> points(100000, glm::vec3(1, 2, 3));
  const NearestPoints index(points);
  for (size_t i = 0; i < points.size(); ++i) {
    ASSERT_EQ(index.nearest({1, 2, 3}).count, NearestPoints::kMostEqual);
    ASSERT_THAT(index.nearest({1, 2, 3}, 2), ElementsAre(0, 1));
  }
}

TEST(NearestPoints, OfNoneAreNone) {
  const NearestPoints index({});
  EXPECT_THAT(index.nearest({0, 0, 0}).points(), IsEmpty());
  EXPECT_THAT(index.nearest({0, 0, 0}, 3), IsEmpty());
}

TEST(NearestPoints, TheSpacingOfAGridIsItsStep) {
  std::vector<glm::vec3> points;
  for (int x = 0; x < 40; ++x)
    for (int y = 0; y < 50; ++y) points.emplace_back(0.25 * x, 0.375 * y, 3);
  EXPECT_NEAR(NearestPoints(points).spacing(), 0.25, 1e-6);
}

TEST(NearestPoints, TheSpacingIsTheMedianOfAllNearestDistances) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> place(-3, 8);
  std::vector<glm::vec3> points;
  for (int n = 0; n < 700; ++n) points.emplace_back(place(random), place(random), place(random));
  std::vector<double> nearest;
  for (const glm::vec3& p : points) {
    double least = 1e9;
    for (const glm::vec3& q : points)
      if (p != q) least = std::min(least, glm::distance(glm::dvec3(p), glm::dvec3(q)));
    nearest.push_back(least);
  }
  std::sort(nearest.begin(), nearest.end());
  EXPECT_DOUBLE_EQ(NearestPoints(points).spacing(), nearest[350]);
}

TEST(NearestPoints, PointsAtOnePlaceCountAsOne) {
  std::vector<glm::vec3> points(500, glm::vec3(1, 2, 3));
  EXPECT_EQ(NearestPoints(points).spacing(), 0);
  points.resize(1000, glm::vec3(1, 2, 7));
  EXPECT_EQ(NearestPoints(points).spacing(), 4);
  EXPECT_EQ(NearestPoints({}).spacing(), 0);
}

}  // namespace
}  // namespace afx
