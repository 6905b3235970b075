// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/mesh_shapes.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <utility>

#include "afx/builder/test_meshes.h"

namespace afx {
namespace {

std::shared_ptr<const Mesh> shared(Mesh mesh) { return std::make_shared<Mesh>(std::move(mesh)); }

std::vector<Shape> shapes(const std::shared_ptr<const Mesh>& mesh, Shade shade = Shade::automatic,
                          const Limits& limits = {}) {
  auto made = shapes_of(mesh, shade, limits);
  EXPECT_TRUE(made.ok()) << (made.ok() ? "" : made.error().text);
  return made.ok() ? std::move(made).value() : std::vector<Shape>();
}

Shape only_shape(Mesh mesh, Shade shade = Shade::automatic) {
  const auto made = shapes(shared(std::move(mesh)), shade);
  EXPECT_EQ(made.size(), 1U);
  return made.empty() ? Shape{std::make_shared<Geometry>(), std::make_shared<Look>(), {}, {}}
                      : made[0];
}

/// A square with a texture of 2 x 1 pixels.
Mesh textured(uint32_t components, std::vector<uint8_t> samples) {
  Picture picture(2, 1, components);
  picture.samples = std::move(samples);
  return textured_square(picture);
}

using Samples = std::vector<uint8_t>;

TEST(MeshShapes, ABoxOfOneColourIsLitAndHasSharpEdges) {
  // Linear 0.5 is 0.7354 as a display value, of 8 bits 188; 0.2140 is 127.5.
  const Shape shape = only_shape(box_mesh({0, 0, 0}, {1, 2, 3}, {0.5F, 0, 1}));
  const Geometry& g = *shape.geometry;
  EXPECT_TRUE(shape.look->lit);
  EXPECT_EQ(shape.look->texture, nullptr);
  EXPECT_FALSE(g.solid);
  EXPECT_EQ(g.indices.size(), 36U);
  ASSERT_EQ(g.positions.size(), 24U);
  ASSERT_EQ(g.colours.size(), 24U);
  EXPECT_TRUE(g.texture_coordinates.empty());
  for (size_t i = 0; i < 24; ++i) {
    EXPECT_EQ(g.colours[i], glm::vec3(188 / 255.0F, 0, 1));
    // It points away from the middle along one axis, on the side of which the corner lies.
    const glm::vec3 outwards = glm::sign(g.positions[i] - glm::vec3(0.5F, 1, 1.5F));
    const glm::vec3 n = g.normals[i] * outwards;
    EXPECT_TRUE(n == glm::vec3(1, 0, 0) || n == glm::vec3(0, 1, 0) || n == glm::vec3(0, 0, 1));
  }
}

TEST(MeshShapes, ASphereIsSmoothAlsoWhereVerticesAreDoubled) {
  Mesh sphere = sphere_mesh(2), doubled = sphere;
  doubled.positions.clear();
  for (glm::uvec3& t : doubled.triangles)
    for (int k = 0; k < 3; ++k) {
      doubled.positions.push_back(sphere.positions[t[k]]);
      t[k] = static_cast<uint32_t>(doubled.positions.size() - 1);
    }
  for (Mesh* mesh : {&sphere, &doubled}) {
    const Shape shape = only_shape(*mesh);
    EXPECT_EQ(shape.geometry->positions.size(), 66U);  // 4^2 * 8 / 2 + 2
    for (size_t i = 0; i < shape.geometry->positions.size(); ++i)
      EXPECT_GT(glm::dot(shape.geometry->positions[i], shape.geometry->normals[i]), 0.999F);
  }
}

TEST(MeshShapes, WithoutAnyColoursTheMeshIsGreyInTheLight) {
  Mesh mesh = box_mesh({0, 0, 0}, {1, 1, 1}, {0.1F, 0.2F, 0.3F});
  mesh.has_colours = false;
  const Shape shape = only_shape(mesh);
  EXPECT_TRUE(shape.look->lit);
  EXPECT_EQ(shape.look->diffuse, glm::vec3(0.8F));
  EXPECT_TRUE(shape.geometry->colours.empty());
  EXPECT_FALSE(only_shape(mesh, Shade::never).look->lit);
}

TEST(MeshShapes, ColoursOfVerticesAreShownAsTheyAre) {
  Mesh mesh = box_mesh({0, 0, 0}, {1, 1, 1}, {1, 0.5F, 1});
  mesh.colours.assign(8, glm::vec3(0.25F, 0.5F, 1));
  const Shape shape = only_shape(mesh);
  EXPECT_FALSE(shape.look->lit);
  ASSERT_EQ(shape.geometry->positions.size(), 8U);
  // Linear 0.25 is sRGB 136.96 / 255.
  for (const glm::vec3& colour : shape.geometry->colours)
    EXPECT_EQ(colour, glm::vec3(137 / 255.0F, 137 / 255.0F, 1));
  for (size_t i = 0; i < 8; ++i) EXPECT_NEAR(glm::length(shape.geometry->normals[i]), 1, 1e-6);
}

TEST(MeshShapes, ThereIsOneForEachMaterialThatHasTriangles) {
  Mesh mesh = box_mesh({0, 0, 0}, {1, 1, 1}, {1, 1, 1});
  mesh.materials.push_back({.colour = {0, 1, 0}});  // none is of it
  mesh.materials.push_back({.colour = {0, 0, 1}});
  mesh.material_of[3] = mesh.material_of[8] = 2;
  const auto made = shapes(shared(mesh));
  ASSERT_EQ(made.size(), 2U);
  EXPECT_EQ(made[0].geometry->indices.size(), 30U);
  EXPECT_EQ(made[1].geometry->indices.size(), 6U);
  EXPECT_EQ(made[1].geometry->positions.size(), 6U);
  EXPECT_EQ(made[1].geometry->colours.at(0), glm::vec3(0, 0, 1));
  // Triangle 3 is the second of the upper z side, its first corner (0, 0, 1).
  EXPECT_EQ(made[1].geometry->positions[made[1].geometry->indices[0]], mesh.positions[4]);
}

TEST(MeshShapes, TexturesAreSharedWithTheMeshAndUnlit) {
  const auto mesh = shared(textured(3, {1, 2, 3, 4, 5, 6}));
  const auto made = shapes(mesh);
  ASSERT_EQ(made.size(), 1U);
  const Look& look = *made[0].look;
  EXPECT_FALSE(look.lit);
  EXPECT_EQ(look.texture.get(), &mesh->textures[0]);
  EXPECT_EQ(look.diffuse, glm::vec3(1));
  EXPECT_TRUE(look.repeat_s && look.repeat_t);
  EXPECT_EQ(look.texture_transform, glm::mat3(1));
  EXPECT_EQ(made[0].geometry->texture_coordinates, mesh->texture_coords);
  EXPECT_TRUE(made[0].geometry->colours.empty());
}

TEST(MeshShapes, LightFallsOnTexturesWhereItIsAskedFor) {
  const Shape shape = only_shape(textured(3, {1, 2, 3, 4, 5, 6}), Shade::always);
  EXPECT_TRUE(shape.look->lit);
  EXPECT_EQ(shape.geometry->positions.size(), 4U);
  for (const glm::vec3& n : shape.geometry->normals) EXPECT_EQ(n, glm::vec3(0, 0, 1));
}

TEST(MeshShapes, AMaterialsColourGoesIntoThePictureOnce) {
  Mesh mesh = textured(3, {255, 255, 255, 0, 0, 0});
  mesh.materials[0].colour = {0.25F, 1, 1};
  mesh.materials.push_back(mesh.materials[0]);
  mesh.material_of[1] = 1;
  const auto made = shapes(shared(mesh));
  ASSERT_EQ(made.size(), 2U);
  EXPECT_EQ(made[0].look->texture->samples, (Samples{137, 255, 255, 0, 0, 0}));
  EXPECT_EQ(made[0].look->texture, made[1].look->texture);
}

TEST(MeshShapes, AlphaCountsOnlyWhereTheMaterialCutsByIt) {
  Mesh mesh = textured(4, {1, 2, 3, 100, 4, 5, 6, 200});
  EXPECT_EQ(only_shape(mesh).look->texture->samples, (Samples{1, 2, 3, 4, 5, 6}));
  mesh.materials[0].alpha_cutoff = 0.5F;
  EXPECT_EQ(only_shape(mesh).look->texture->samples, mesh.textures[0].samples);
}

TEST(MeshShapes, MirroredTexturesAreClampedWhereNothingMirroredIsSeen) {
  Mesh mesh = textured(1, {10, 20});
  mesh.materials[0].wrap_u = mesh.materials[0].wrap_v = Wrap::mirror;
  const Shape shape = only_shape(mesh);
  EXPECT_FALSE(shape.look->repeat_s || shape.look->repeat_t);
  EXPECT_EQ(shape.look->texture->width, 2U);
}

TEST(MeshShapes, MirroredTexturesHaveTheirMirrorImageInThePicture) {
  Mesh mesh = textured(1, {10, 20});
  mesh.materials[0].wrap_u = Wrap::mirror;
  mesh.materials[0].wrap_v = Wrap::clamp;
  mesh.texture_coords[1].x = mesh.texture_coords[2].x = 3;
  const Shape shape = only_shape(mesh);
  EXPECT_EQ(shape.look->texture->samples, (Samples{10, 20, 20, 10}));
  EXPECT_TRUE(shape.look->repeat_s);
  EXPECT_FALSE(shape.look->repeat_t);
  // u = 1.5 is the middle of the mirror image, 3/4 of the picture.
  EXPECT_EQ(shape.look->texture_transform * glm::vec3(1.5F, 0.5F, 1), glm::vec3(0.75F, 0.5F, 1));
}

TEST(MeshShapes, MemoryIsLimited) {
  const auto mesh = shared(box_mesh({0, 0, 0}, {1, 1, 1}));  // 36 corners
  Limits limits;
  limits.memory = 36 * 192;
  EXPECT_EQ(shapes(mesh, Shade::automatic, limits)[0].geometry->positions.size(), 24U);
  limits.memory = 36 * 64;  // too little for creases
  EXPECT_EQ(shapes(mesh, Shade::automatic, limits)[0].geometry->positions.size(), 8U);
  --limits.memory;
  const auto refused = shapes_of(mesh, Shade::automatic, limits);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, Errc::limit_exceeded);
}

TEST(MeshShapes, AMeshWithoutTrianglesHasNone) { EXPECT_TRUE(shapes(shared(Mesh())).empty()); }

}  // namespace
}  // namespace afx
