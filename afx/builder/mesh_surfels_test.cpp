// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/mesh_surfels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "afx/builder/test_meshes.h"

namespace afx {
namespace {

TEST(MeshSurfels, ABoxIsSampledOnceForEachCellOfItsSides) {
  const Mesh box = box_mesh({-1, -1, -1}, {1, 1, 1});
  const MeshLook look(box, Shade::never);
  const auto surfels = surfels_of(look, 10, 1, {});
  ASSERT_TRUE(surfels.ok()) << surfels.error().text;
  ASSERT_EQ(surfels.value().size(), 600U);
  for (size_t i = 0; i < 600; ++i) {
    const glm::vec3 normal = glm::cross(surfels.value().u[i], surfels.value().v[i]);
    // Outward, and a quarter of the cell's area 0.2 * 0.2.
    EXPECT_NEAR(glm::length(normal), 0.01, 1e-6);
    EXPECT_NEAR(glm::dot(glm::dvec3(normal), surfels.value().centres[i]), 0.01, 1e-4);
    EXPECT_EQ(surfels.value().colours[i], (Rgba8{255, 255, 255, 255}));
  }
}

TEST(MeshSurfels, TogetherHaveTheAreaOfTheSurfaceAndALittleMoreWhereGridsMeet) {
  const Mesh sphere = sphere_mesh(5);
  const MeshLook look(sphere, Shade::never);
  const auto surfels = surfels_of(look, 100, 2, {});
  ASSERT_TRUE(surfels.ok());
  double area = 0;
  for (size_t i = 0; i < surfels.value().size(); ++i) {
    const glm::vec3 across = glm::cross(surfels.value().u[i], surfels.value().v[i]);
    area += 4 * static_cast<double>(glm::length(across));
    EXPECT_NEAR(glm::length(surfels.value().centres[i]), 1, 2e-3);
    EXPECT_GT(glm::dot(glm::dvec3(across), surfels.value().centres[i]), 0);
  }
  EXPECT_GT(area, 4 * 3.14159 - 0.06);
  EXPECT_LT(area, 4 * 3.14159 * 1.15);  // strips of 3 degrees along the borders of six faces
}

TEST(MeshSurfels, AreTheSameForAnyNumberOfThreads) {
  const Mesh sphere = sphere_mesh(3);
  const MeshLook look(sphere, Shade::automatic);
  const auto one = surfels_of(look, 77, 1, {}), four = surfels_of(look, 77, 4, {});
  EXPECT_EQ(one.value().centres, four.value().centres);
  EXPECT_EQ(one.value().colours, four.value().colours);
}

TEST(MeshSurfels, KeepToTheLimit) {
  const Mesh box = box_mesh({-1, -1, -1}, {1, 1, 1});
  const MeshLook look(box, Shade::never);
  Limits small;
  small.memory = 599 * 2 * kSurfelBytes;
  EXPECT_EQ(surfels_of(look, 10, 1, small).error().text, "the surface has more than 599 samples");
}

}  // namespace
}  // namespace afx
