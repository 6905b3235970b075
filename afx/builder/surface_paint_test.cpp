// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/surface_paint.h"

#include <gtest/gtest.h>

#include "afx/builder/test_meshes.h"
#include "afx/srgb.h"

namespace afx {
namespace {

TEST(SurfacePaint, IsMaterialTimesVertexColourTimesTexture) {
  Picture texture(1, 1, 3);
  texture.samples = {255, 255, 0};
  Mesh mesh = textured_square(texture);
  mesh.materials[0].colour = {0.5F, 1, 1};
  mesh.colours = {{1, 0, 1}, {1, 0.5F, 1}, {1, 1, 1}, {1, 1, 1}};
  const SurfacePaint paint(mesh);
  // At a corner, and at the middle of the first triangle's first side.
  EXPECT_EQ(paint.at(0, {0, 0}, 1).light, glm::dvec3(0.5, 0, 0));
  EXPECT_EQ(paint.at(0, {0.5, 0}, 1).light, glm::dvec3(0.5, 0.25, 0));
  EXPECT_EQ(paint.at(0, {0.5, 0}, 1).alpha, 1);
}

TEST(SurfacePaint, WithoutTextureIsTheColour) {
  const Mesh mesh = box_mesh({0, 0, 0}, {1, 1, 1}, {0.25F, 0.5F, 1});
  const SurfacePaint paint(mesh);
  EXPECT_EQ(paint.at(3, {0.2, 0.7}, 100).light, glm::dvec3(0.25, 0.5, 1));
  EXPECT_EQ(paint.texels(3), 0);
}

TEST(SurfacePaint, CountsTheTexelsOfATriangle) {
  // Half of the texture of 6 x 4 texels; twice over, half of four of them.
  Mesh mesh = textured_square(Picture(6, 4, 3));
  EXPECT_DOUBLE_EQ(SurfacePaint(mesh).texels(0), 12);
  for (glm::vec2& place : mesh.texture_coords) place *= 2.0F;
  EXPECT_DOUBLE_EQ(SurfacePaint(mesh).texels(0), 48);
}

TEST(SurfacePaint, TakesEachTrianglesOwnMaterial) {
  Mesh mesh = textured_square(Picture(1, 1, 3));  // black
  mesh.textures.emplace_back(1, 1, 1).samples = {255};
  mesh.materials.push_back({.colour = {1, 0, 0}, .texture = 1});
  mesh.materials.push_back({.colour = {0, 0, 1}});
  mesh.material_of = {1, 2};
  const SurfacePaint paint(mesh);
  EXPECT_EQ(paint.at(0, {0.3, 0.3}, 1).light, glm::dvec3(1, 0, 0));
  EXPECT_EQ(paint.at(1, {0.3, 0.3}, 1).light, glm::dvec3(0, 0, 1));
}

TEST(SurfacePaint, IsRoundedToSrgb) { EXPECT_EQ(to_srgb({0, 0.5, 1}), (Rgba8{0, 188, 255, 255})); }

}  // namespace
}  // namespace afx
