// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/placement.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "afx/builder/test_meshes.h"

namespace afx {
namespace {

PointCloud two_points() {
  PointCloud cloud;
  cloud.origin = {100, 200, 300};
  cloud.positions = {{1, 2, 3}, {5, 2, 1}};
  cloud.normals = {{0, 0, 2}, {1, 0, 0}};
  return cloud;
}

TEST(Place, ChangesNothingByDefault) {
  PointCloud cloud = two_points();
  ASSERT_TRUE(place(cloud, {}).ok());
  EXPECT_EQ(cloud.positions, two_points().positions);
  EXPECT_EQ(cloud.normals, two_points().normals);
  EXPECT_EQ(cloud.origin, two_points().origin);
}

TEST(Place, TurnsZUpToYUp) {
  // What pointed up, +z, points to +y; what pointed forward, -y, to +z; x stays.
  PointCloud cloud = two_points();
  ASSERT_TRUE(place(cloud, {.up = UpAxis::z}).ok());
  EXPECT_EQ(cloud.positions, (std::vector<glm::vec3>{{1, 3, -2}, {5, 1, -2}}));
  EXPECT_EQ(cloud.normals, (std::vector<glm::vec3>{{0, 2, 0}, {1, 0, 0}}));
  EXPECT_EQ(cloud.origin, glm::dvec3(100, 300, -200));
}

TEST(Place, ScalesAboutTheOriginOfTheFile) {
  PointCloud cloud = two_points();
  ASSERT_TRUE(place(cloud, {.scale = 0.5}).ok());
  EXPECT_EQ(cloud.positions, (std::vector<glm::vec3>{{0.5F, 1, 1.5F}, {2.5F, 1, 0.5F}}));
  EXPECT_EQ(cloud.normals, two_points().normals);
  EXPECT_EQ(cloud.origin, glm::dvec3(50, 100, 150));
}

TEST(Place, FitsTheLongestSideAroundTheOrigin) {
  PointCloud cloud = two_points();  // 4 long in x, 2 in z: the middle is (3, 2, 2)
  ASSERT_TRUE(place(cloud, {.fit = 1}).ok());
  EXPECT_EQ(cloud.positions, (std::vector<glm::vec3>{{-0.5F, 0, 0.25F}, {0.5F, 0, -0.25F}}));
  EXPECT_EQ(cloud.origin, glm::dvec3(0));
  Mesh mesh = box_mesh({1, 1, 1}, {2, 3, 9});
  ASSERT_TRUE(place(mesh, {.up = UpAxis::z, .fit = 4}).ok());
  EXPECT_EQ(bounds_of(mesh).low, glm::dvec3(-0.25, -2, -0.5));
  EXPECT_EQ(bounds_of(mesh).high, glm::dvec3(0.25, 2, 0.5));
}

TEST(Place, FitsWhatTrianglesUse) {
  Mesh mesh = box_mesh({0, 0, 0}, {2, 2, 2});
  mesh.positions.emplace_back(1e30F, 0, 0);  // used by none
  ASSERT_TRUE(place(mesh, {.fit = 1e10}).ok());
  EXPECT_EQ(bounds_of(mesh).low, glm::dvec3(-5e9F));
  EXPECT_LE(mesh.positions.back().x, 1.01e37F);
}

TEST(Place, MovesAPointWithoutScale) {
  PointCloud cloud;
  cloud.positions = {{7, 8, 9}};
  ASSERT_TRUE(place(cloud, {.fit = 3}).ok());
  EXPECT_EQ(cloud.positions[0], glm::vec3(0));
}

TEST(MoveBy, MovesPointsByTheirOriginAlone) {
  PointCloud cloud;
  cloud.origin = {500000.03, 1, 2};
  cloud.positions = {{0.5F, 0, 0}};
  move_by(cloud, {-500000, 1, 0});
  EXPECT_NEAR(cloud.origin.x, 0.03, 1e-9);
  EXPECT_EQ(cloud.origin.y, 2);
  EXPECT_EQ(cloud.positions[0], glm::vec3(0.5F, 0, 0));
}

TEST(MoveBy, MovesVerticesAndPieces) {
  Mesh mesh;
  mesh.positions = {{1, 2, 3}};
  move_by(mesh, {1, 1, -1});
  EXPECT_EQ(mesh.positions[0], glm::vec3(2, 3, 2));
  Surfels surfels;
  surfels.push_back({1, 2, 3}, {1, 0, 0}, {0, 1, 0}, {});
  move_by(surfels, {1, 1, -1});
  EXPECT_EQ(surfels.centres[0], glm::dvec3(2, 3, 2));
  EXPECT_EQ(surfels.u[0], glm::vec3(1, 0, 0));
}

TEST(Place, RefusesWhatIsNoPlacement) {
  const auto refused = [](const Placement& placement) {
    PointCloud cloud = two_points();
    const Status status = place(cloud, placement);
    EXPECT_EQ(cloud.positions, two_points().positions);
    EXPECT_FALSE(status.ok());
    return status.ok() ? "" : to_string(status.error().code) + (": " + status.error().text);
  };
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (const double scale : {0.0, -1.0, kNan, std::numeric_limits<double>::infinity()})
    EXPECT_EQ(refused({.scale = scale}), "bad_argument: the scale is no positive number");
  for (const double fit : {-1.0, kNan})
    EXPECT_EQ(refused({.fit = fit}),
              "bad_argument: the length to fit the model to is no positive number");
  EXPECT_EQ(refused({.scale = 2, .fit = 1}),
            "bad_argument: a model is scaled or fitted to a length, not both");
  EXPECT_EQ(refused({.scale = 1e38}),
            "bad_argument: so large a scale makes coordinates that are not finite");
}

TEST(Place, TurnsAndScalesPiecesOfSurfaceAsAWhole) {
  Surfels surfels;
  surfels.push_back({1, 2, 3}, {1, 0, 0}, {0, 1, 0}, {});
  surfels.push_back({3, 2, 3}, {1, 0, 0}, {0, 1, 0}, {});
  ASSERT_TRUE(place(surfels, {.up = UpAxis::z, .scale = 2}).ok());
  EXPECT_EQ(surfels.centres[0], glm::dvec3(2, 6, -4));
  EXPECT_EQ(surfels.u[0], glm::vec3(2, 0, 0));
  EXPECT_EQ(surfels.v[0], glm::vec3(0, 0, -2));  // faced +z, faces up now
  ASSERT_TRUE(place(surfels, {.fit = 1}).ok());
  EXPECT_EQ(surfels.centres[1], glm::dvec3(0.5, 0, 0));
}

}  // namespace
}  // namespace afx
