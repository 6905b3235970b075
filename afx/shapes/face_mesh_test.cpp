// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/shapes/face_mesh.h"

#include <cmath>

#include "afx/shapes/ear_clipping.h"
#include "afx/shapes/shape_test_support.h"

namespace afx {
namespace {

double area_of(const std::vector<glm::dvec2>& corners,
               const std::vector<std::array<uint32_t, 3>>& triangles) {
  double sum = 0;
  for (const auto& t : triangles) {
    const glm::dvec2 a = corners[t[1]] - corners[t[0]], b = corners[t[2]] - corners[t[0]];
    EXPECT_GE(a.x * b.y - a.y * b.x, 0);
    sum += (a.x * b.y - a.y * b.x) / 2;
  }
  return sum;
}

TEST(EarClipping, AConcavePolygonIsCoveredOnce) {
  // An arrow: the square of side 4 less the triangle (0,0) (2,2) (0,4).
  const std::vector<glm::dvec2> arrow{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 2}};
  uint64_t work = 1000;
  const auto triangles = clip_ears(arrow, work);
  ASSERT_EQ(triangles.size(), 3U);
  EXPECT_DOUBLE_EQ(area_of(arrow, triangles), 12);
  EXPECT_LT(work, 1000U);
}

TEST(EarClipping, ACombIsCoveredOnce) {
  // 50 teeth of width 1 and height 9 on a beam of height 1, with gaps of width 1.
  std::vector<glm::dvec2> comb{{0, -1}, {100, -1}, {100, 0}};
  for (int x = 99; x > 0; x -= 2) {
    const double at = x;
    comb.insert(comb.end(), {{at, 0}, {at, 9}, {at - 1, 9}, {at - 1, 0}});
  }
  uint64_t work = 1 << 20;
  const auto triangles = clip_ears(comb, work);
  EXPECT_EQ(triangles.size(), comb.size() - 2);
  EXPECT_NEAR(area_of(comb, triangles), 100 + 50 * 9, 1e-9);
}

TEST(EarClipping, APolygonThatCrossesItselfComesToAnEnd) {
  const std::vector<glm::dvec2> star{{0, 3}, {-2, -3}, {3, 1}, {-3, 1}, {2, -3}};
  uint64_t work = 1000;
  EXPECT_EQ(clip_ears(star, work).size(), 3U);
  const std::vector<glm::dvec2> line{{0, 0}, {1, 0}, {2, 0}, {3, 0}};
  EXPECT_EQ(clip_ears(line, work).size(), 2U);
}

TEST(EarClipping, WorkIsLimited) {
  const std::vector<glm::dvec2> arrow{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 2}};
  uint64_t work = 3;
  EXPECT_TRUE(clip_ears(arrow, work).empty());
}

FaceMesh cube(float crease_angle) {
  FaceMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.points.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  mesh.corners = {4, 5, 7, 6, 1, 0, 2, 3, 5, 1, 3, 7, 0, 4, 6, 2, 6, 7, 3, 2, 0, 1, 5, 4};
  mesh.starts = {0, 4, 8, 12, 16, 20, 24};
  mesh.crease_angle = crease_angle;
  return mesh;
}

TEST(FaceMesh, EdgesSharperThanTheCreaseAngleStaySharp) {
  // The faces of a cube meet at 90 degrees.
  const Geometry sharp = geometry_of(cube(1.5F)).value();
  EXPECT_EQ(sharp.positions.size(), 24U);
  EXPECT_EQ(euler_number(sharp), 2);
  EXPECT_NEAR(volume_of(sharp), 8, 1e-9);
  expect_outward_normals(sharp);
  for (const glm::vec3& n : sharp.normals)
    EXPECT_EQ(std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)}), 1);
}

TEST(FaceMesh, SmoothCornersShareTheirNormal) {
  const Geometry smooth = geometry_of(cube(1.6F)).value();
  ASSERT_EQ(smooth.positions.size(), 8U);
  for (size_t i = 0; i < 8; ++i)
    expect_near(glm::dvec3(smooth.normals[i]), glm::dvec3(smooth.positions[i]) / std::sqrt(3.0));
}

TEST(FaceMesh, AngleWeightsMakeNormalsFreeOfHowAFaceIsCut) {
  FaceMesh mesh = cube(1.6F);
  mesh.corners = {};
  mesh.starts = {0};
  const FaceMesh quads = cube(1.6F);
  for (size_t face = 0; face < 6; ++face)  // each quad as two triangles
    for (const auto& t : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
      for (const int corner_of : t)
        mesh.corners.push_back(quads.corners[face * 4 + static_cast<size_t>(corner_of)]);
      mesh.starts.push_back(static_cast<uint32_t>(mesh.corners.size()));
    }
  const Geometry smooth = geometry_of(mesh).value();
  ASSERT_EQ(smooth.positions.size(), 8U);
  for (size_t i = 0; i < 8; ++i)
    expect_near(glm::dvec3(smooth.normals[i]), glm::dvec3(smooth.positions[i]) / std::sqrt(3.0));
}

TEST(FaceMesh, OnlyTheEdgeThatIsSmoothIsSmooth) {
  // A roof: two faces that meet at 60 degrees (normals), and a wall that meets one at 90.
  FaceMesh mesh;
  const float c = 0.5F, s = std::sqrt(3.0F) / 2;
  mesh.points = {{0, 0, 0}, {0, 0, 1}, {-s, -c, 1}, {-s, -c, 0}, {s, -c, 1}, {s, -c, 0}};
  mesh.corners = {0, 3, 2, 1, 0, 1, 4, 5};
  mesh.starts = {0, 4, 8};
  mesh.crease_angle = 1;  // below 60 degrees (1.047)
  EXPECT_EQ(geometry_of(mesh).value().positions.size(), 8U);
  mesh.crease_angle = 1.1F;
  const Geometry smooth = geometry_of(mesh).value();
  EXPECT_EQ(smooth.positions.size(), 6U);
  expect_near(glm::dvec3(smooth.normals[smooth.indices[0]]), {0, 1, 0});
}

TEST(FaceMesh, ClockwiseFacesHaveTheirOutsideOnTheOtherSide) {
  FaceMesh mesh = cube(0);
  mesh.ccw = false;
  const Geometry inside = geometry_of(mesh).value();
  EXPECT_NEAR(volume_of(inside), -8, 1e-9);
  expect_outward_normals(inside);
}

TEST(FaceMesh, FacesWithoutAreaShowNothing) {
  FaceMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}};
  mesh.corners = {0, 1, 2, 0, 1, 0, 1, 3};
  mesh.starts = {0, 3, 5, 8};
  EXPECT_EQ(geometry_of(mesh).value().indices.size(), 3U);
}

TEST(FaceMesh, TheLongestSideOfTheBoxIsSTheNextT) {
  FaceMesh mesh;  // 1 x 4 x 2 in x, y, z: s along y, t along z to 1/2
  mesh.points = {{1, 1, 1}, {2, 5, 1}, {2, 5, 3}};
  mesh.corners = {0, 1, 2};
  mesh.starts = {0, 3};
  const Geometry g = geometry_of(mesh).value();
  expect_near(g.texture_coordinates[0], {0, 0});
  expect_near(g.texture_coordinates[1], {1, 0});
  expect_near(g.texture_coordinates[2], {1, 0.5});
  mesh.points = {{0, 0, 0}, {0, 2, 0}, {2, 2, 2}};  // all alike: x, then y
  expect_near(geometry_of(mesh).value().texture_coordinates[1], {0, 1});
  mesh.points = {{0, 0, 0}, {1, 0, 3}, {0, 1, 0}};  // z, then x before y
  expect_near(geometry_of(mesh).value().texture_coordinates[1], {1, 1.0 / 3});
}

}  // namespace
}  // namespace afx
