// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/cube_cut.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "afx/builder/test_meshes.h"

namespace afx {
namespace {

double area_of(const Mesh& mesh) {
  double area = 0;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    area += 0.5 * glm::length(glm::cross(b - a, c - a));
  }
  return area;
}

TEST(InsideOfCube, LeavesWhatFitsAsItIs) {
  const Mesh box = box_mesh({-1, -1, -1}, {1, 1, 1});
  uint64_t outside = 9;
  const Mesh inside = inside_of_cube(box, {{0, 0, 0}, 2}, outside);
  EXPECT_EQ(outside, 0U);
  EXPECT_EQ(inside.triangles, box.triangles);
  EXPECT_EQ(inside.positions, box.positions);
}

TEST(InsideOfCube, LeavesNothingOfWhatIsElsewhere) {
  uint64_t outside = 0;
  const Mesh inside = inside_of_cube(box_mesh({-1, -1, -1}, {1, 1, 1}), {{5, 0, 0}, 2}, outside);
  EXPECT_EQ(outside, 12U);
  EXPECT_TRUE(inside.triangles.empty());
  EXPECT_TRUE(inside.material_of.empty());
}

TEST(InsideOfCube, CutsTrianglesWithTheirTextureAndColours) {
  // The square -1..1 at z = 0, of which the cube around (1, 1, 0) holds a quarter.
  Mesh square = textured_square(Picture(2, 2, 3));
  square.colours = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};  // red grows with x, green with y
  uint64_t outside = 0;
  const Mesh inside = inside_of_cube(square, {{1, 1, 0}, 2}, outside);
  EXPECT_EQ(outside, 2U);
  EXPECT_NEAR(area_of(inside), 1, 1e-6);
  ASSERT_EQ(inside.texture_coords.size(), inside.positions.size());
  ASSERT_EQ(inside.colours.size(), inside.positions.size());
  ASSERT_EQ(inside.material_of.size(), inside.triangles.size());
  for (const glm::uvec3& t : inside.triangles)
    for (int k = 0; k < 3; ++k) {
      const glm::vec3 p = inside.positions[t[k]];
      EXPECT_GE(p.x, -1e-6F);
      EXPECT_GE(p.y, -1e-6F);
      EXPECT_NEAR(inside.texture_coords[t[k]].x, (p.x + 1) / 2, 1e-6);
      EXPECT_NEAR(inside.texture_coords[t[k]].y, (p.y + 1) / 2, 1e-6);
      EXPECT_NEAR(inside.colours[t[k]].r, (p.x + 1) / 2, 1e-6);
      EXPECT_NEAR(inside.colours[t[k]].g, (p.y + 1) / 2, 1e-6);
    }
}

TEST(InsideOfCube, CutsABoxToAllSidesOfTheCube) {
  uint64_t outside = 0;
  // Four long walls pass through the cube, 2 long there; their ends lie outside.
  const Mesh inside =
      inside_of_cube(box_mesh({-9, -0.5F, -0.5F}, {9, 0.5F, 0.5F}), {{0, 0, 0}, 2}, outside);
  EXPECT_EQ(outside, 12U);
  EXPECT_NEAR(area_of(inside), 8, 1e-5);
}

TEST(InsideOfCube, KeepsThePointsThatAGridHolds) {
  PointCloud cloud;
  cloud.origin = {7, 8, 9};
  cloud.positions = {{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 5, 0}};
  cloud.colours = {{1, 1, 1, 255}, {2, 2, 2, 255}, {3, 3, 3, 255}, {4, 4, 4, 255}};
  cloud.normals = {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}};
  uint64_t outside = 0;
  const PointCloud inside = inside_of_cube(cloud, Grid(Cube{{0, 0, 0}, 2}, 8), outside);
  EXPECT_EQ(outside, 2U);
  EXPECT_EQ(inside.origin, cloud.origin);
  EXPECT_EQ(inside.positions, (std::vector<glm::vec3>{{0, 0, 0}, {-1, 0, 0}}));
  EXPECT_EQ(inside.colours[1], (Rgba8{3, 3, 3, 255}));
  EXPECT_EQ(inside.normals[1].x, 3);
}

}  // namespace
}  // namespace afx
