// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/surfel_footprint.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

#include "afx/surfel_test_models.h"

namespace afx {
namespace {

Surfels one(const glm::dvec3& centre, const glm::vec3& u, const glm::vec3& v) {
  Surfels surfels;
  surfels.push_back(centre, u, v, {1, 2, 3, 255});
  return surfels;
}

class Footprint : public ::testing::TestWithParam<bool> {};

// The line of sight meets the plane of the piece; s and t follow from the dual of u and v.
TEST_P(Footprint, IsWhereTheLinesOfSightOfPixelsMeetThePiece) {
  const DepthCamera camera = test_camera(GetParam());
  const CameraProjection projection(camera);
  const SurfelCamera view(camera, 16, 12);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(0.3, 0.7), side(-0.8, 0.8);
  int inside = 0;
  for (int round = 0; round < 200; ++round) {
    const auto vector = [&] {
      return glm::vec3(glm::dvec3(side(random), side(random), side(random)));
    };
    const Surfels surfels =
        one(projection.point({place(random), place(random), 4}), vector(), vector());
    const glm::dvec3 u(surfels.u[0]), v(surfels.v[0]), normal = glm::cross(u, v);
    const SurfelFootprint piece = view.footprint(surfels, 0);
    for (uint32_t j = 0; j < 12; ++j)
      for (uint32_t i = 0; i < 16; ++i) {
        const double x = (i + 0.5) / 16, y = (j + 0.5) / 12;
        const glm::dvec3 from = projection.point({x, y, 1});
        const glm::dvec3 ray = projection.point({x, y, 2}) - from;
        const double along = glm::dot(normal, surfels.centres[0] - from) / glm::dot(normal, ray);
        const glm::dvec3 off = from + along * ray - surfels.centres[0];
        const double n2 = glm::dot(normal, normal);
        const double s = glm::dot(glm::cross(off, v), normal) / n2;
        const double t = glm::dot(glm::cross(u, off), normal) / n2;
        const double edge = std::max(std::abs(s), std::abs(t));
        if (std::abs(edge - 1) < 1e-4 || std::abs(glm::dot(normal, ray)) < 1e-3 * std::sqrt(n2))
          continue;
        const bool behind = 1 + along <= 0;
        double at = 0;
        const bool covered = piece.covers(i, j, at);
        ASSERT_EQ(covered, edge < 1 && !behind) << i << ' ' << j << ' ' << s << ' ' << t;
        if (!covered) continue;
        ++inside;
        EXPECT_NEAR(at, 1 + along, 1e-6);
        EXPECT_TRUE(i >= piece.range.i0 && i < piece.range.i1);
        EXPECT_TRUE(j >= piece.range.j0 && j < piece.range.j1);
      }
  }
  EXPECT_GT(inside, 500);
}

TEST_P(Footprint, OfAPieceSmallerThanAPixelIsThePixelOfItsCentre) {
  const DepthCamera camera = test_camera(GetParam());
  const CameraProjection projection(camera);
  const Surfels surfels =
      one(projection.point({3.1 / 16, 5.9 / 12, 3}), {1e-3F, 0, 0}, {0, 1e-3F, 0});
  int calls = 0;
  SurfelCamera(camera, 16, 12)
      .footprint(surfels, 0)
      .for_each_pixel(0, 12, [&](uint32_t i, uint32_t j, double at) {
        EXPECT_EQ(i, 3U);
        EXPECT_EQ(j, 5U);
        EXPECT_NEAR(at, 3, 1e-12);
        ++calls;
      });
  EXPECT_EQ(calls, 1);
}

TEST_P(Footprint, OfALongPieceSeenFromItsEdgeIsEmpty) {
  const DepthCamera camera = test_camera(GetParam());
  const CameraProjection projection(camera);
  const glm::dvec3 centre = projection.point({0.51, 0.52, 3});
  const glm::vec3 away(0.7 * projection.towards_viewer(centre));
  const glm::vec3 up(camera.orientation * glm::dvec3(0, 1, 0));
  const auto count = [&](float half) {  // a pixel is 0.25 high, or 0.18 in perspective
    const Surfels surfels = one(centre, away, half * up);
    int pixels = 0;
    SurfelCamera(camera, 16, 12)
        .footprint(surfels, 0)
        .for_each_pixel(0, 12, [&](uint32_t, uint32_t, double) { ++pixels; });
    return pixels;
  };
  EXPECT_EQ(count(0.1F), 1);
  EXPECT_EQ(count(0.6F), 0);
}

TEST_P(Footprint, IsNegativeInAreaWhereTheOutsideFacesAway) {
  const DepthCamera camera = test_camera(GetParam());
  const glm::dvec3 centre = CameraProjection(camera).point({0.5, 0.5, 3});
  const glm::vec3 right(camera.orientation * glm::dvec3(0.1, 0, 0));
  const glm::vec3 up(camera.orientation * glm::dvec3(0, 0.1, 0));
  const SurfelCamera view(camera, 16, 12);
  // 0.2 x 0.2 units; the picture at distance 3 is 4 x 3, or 6 tan 0.45 by 6 tan 0.35.
  const double pixels =
      GetParam() ? 0.04 * 4 * 4 : 0.04 * (16 / (6 * std::tan(0.45))) * (12 / (6 * std::tan(0.35)));
  EXPECT_NEAR(view.footprint(one(centre, right, up), 0).area, pixels, 1e-5);
  EXPECT_NEAR(view.footprint(one(centre, up, right), 0).area, -pixels, 1e-5);
}

TEST_P(Footprint, OutsideThePictureOrNotFiniteHasNoRows) {
  const DepthCamera camera = test_camera(GetParam());
  const CameraProjection projection(camera);
  const SurfelCamera view(camera, 16, 12);
  const glm::vec3 u(0.01F, 0, 0), v(0, 0.01F, 0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const glm::dvec3& centre :
       {projection.point({1.2, 0.5, 3}), projection.point({0.5, -0.2, 3}), glm::dvec3(nan, 0, 0),
        glm::dvec3(1e300, 1e300, 0)}) {
    const SurfelFootprint piece = view.footprint(one(centre, u, v), 0);
    EXPECT_FALSE(piece.owns_pixel);
    EXPECT_LE(piece.end_row(), piece.first_row());
  }
}

INSTANTIATE_TEST_SUITE_P(OrthographicOrNot, Footprint, ::testing::Bool());

TEST(PerspectiveFootprint, NothingIsSeenOfAPieceBehindTheCamera) {
  const DepthCamera camera = test_camera(false);
  const Surfels surfels = one(CameraProjection(camera).point({0.5, 0.5, -3}), {1, 0, 0}, {0, 1, 0});
  const SurfelFootprint piece = SurfelCamera(camera, 16, 12).footprint(surfels, 0);
  EXPECT_FALSE(piece.owns_pixel);
  EXPECT_EQ(piece.range.count(), 0U);
}

TEST(MostSurfelPixels, AreEnoughToFillLargePicturesSixtyFourTimes) {
  EXPECT_EQ(most_surfel_pixels(4, 4), 2147483648U);
  EXPECT_EQ(most_surfel_pixels(4096, 8192), 2147483648U);
  EXPECT_EQ(most_surfel_pixels(32768, 32768), 68719476736U);
}

}  // namespace
}  // namespace afx
