// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/surface_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <map>

#include "afx/builder/test_meshes.h"

namespace afx {
namespace {

PointCloud samples(const Mesh& mesh, const SurfaceSampling& sampling) {
  const auto cloud = sample_surface(mesh, sampling);
  EXPECT_TRUE(cloud.ok());
  return cloud.ok() ? cloud.value() : PointCloud{};
}

TEST(SampleSurface, GivesEachTriangleItsShareOfPoints) {
  // A box of sides 1, 2 and 3: its faces are 2, 3 and 6 squares large, in all 22.
  const PointCloud cloud = samples(box_mesh({0, 0, 0}, {1, 2, 3}), {.points = 2200});
  ASSERT_EQ(cloud.positions.size(), 2200U);
  std::map<std::array<float, 3>, int> of_face;
  for (const glm::vec3& n : cloud.normals) ++of_face[{n.x, n.y, n.z}];
  ASSERT_EQ(of_face.size(), 6U);
  for (const auto& [normal, points] : of_face) {
    const int expected = normal[2] != 0 ? 200 : (normal[1] != 0 ? 300 : 600);
    EXPECT_NEAR(points, expected, 2) << normal[0] << ' ' << normal[1] << ' ' << normal[2];
  }
}

TEST(SampleSurface, PutsPointsOnTheSurfaceAndNotTwoInOnePlace) {
  const PointCloud cloud = samples(textured_square(Picture(1, 1, 3)), {.points = 1000});
  // The square has the area 4; evenly spread, points are about sqrt(4 / 1000) = 0.063 apart.
  double nearest = 9;
  for (size_t i = 0; i < cloud.positions.size(); ++i) {
    const glm::vec3 p = cloud.positions[i];
    ASSERT_TRUE(std::abs(p.x) <= 1 && std::abs(p.y) <= 1 && p.z == 0);
    for (size_t j = 0; j < i; ++j)
      nearest = std::min<double>(nearest, glm::distance(p, cloud.positions[j]));
  }
  EXPECT_GT(nearest, 0.005);
  // 8 x 8 cells of 15.6 points each.
  std::array<int, 64> cells{};
  for (const glm::vec3& p : cloud.positions) {
    const glm::uvec2 at = glm::min(glm::uvec2((glm::vec2(p) + 1.0F) * 4.0F), glm::uvec2(7));
    ++cells[at.y * 8 + at.x];
  }
  for (const int points : cells) EXPECT_NEAR(points, 15.6, 6);
}

TEST(SampleSurface, PutsNoPointsOnTrianglesWithoutArea) {
  Mesh mesh = textured_square(Picture(1, 1, 3));
  mesh.triangles.insert(mesh.triangles.begin(), {0, 1, 1});
  mesh.triangles.insert(mesh.triangles.begin() + 2, {2, 2, 2});
  add_triangle(mesh, 3, 3, 0);
  mesh.material_of.assign(5, 0);
  const PointCloud cloud = samples(mesh, {.points = 100});
  ASSERT_EQ(cloud.positions.size(), 100U);
  for (const glm::vec3& normal : cloud.normals) EXPECT_EQ(normal, glm::vec3(0, 0, 1));
}

TEST(SampleSurface, SpacingIsASquareForEachPoint) {
  EXPECT_EQ(samples(box_mesh({0, 0, 0}, {1, 2, 3}), {.spacing = 0.1}).positions.size(), 2200U);
  EXPECT_EQ(samples(box_mesh({0, 0, 0}, {1, 2, 3}), {.spacing = 100}).positions.size(), 1U);
}

TEST(SampleSurface, TakesTheColoursOfTheSurface) {
  Picture texture(16, 1, 3);
  for (uint32_t x = 0; x < 16; ++x) texture.pixel(x, 0)[x < 8 ? 0 : 2] = 255;
  const PointCloud cloud = samples(textured_square(texture), {.points = 500});
  ASSERT_EQ(cloud.colours.size(), 500U);
  // Away from the middle and the border of the texture, where red and blue blend.
  size_t checked = 0;
  for (size_t i = 0; i < 500; ++i) {
    const float x = cloud.positions[i].x;
    if (std::abs(x) < 0.1F || std::abs(x) > 0.9F) continue;
    EXPECT_EQ(cloud.colours[i], (x < 0 ? Rgba8{255, 0, 0, 255} : Rgba8{0, 0, 255, 255}));
    ++checked;
  }
  EXPECT_GT(checked, 350U);
  Mesh plain = box_mesh({0, 0, 0}, {1, 1, 1});
  plain.has_colours = false;
  EXPECT_TRUE(samples(plain, {.points = 10}).colours.empty());
}

TEST(SampleSurface, LeavesOutWhatIsTransparent) {
  Picture texture(8, 8, 4);
  for (uint32_t y = 0; y < 8; ++y)
    for (uint32_t x = 0; x < 4; ++x) texture.pixel(x, y)[3] = 255;
  Mesh mesh = textured_square(texture);
  mesh.materials[0].alpha_cutoff = 0.5F;
  mesh.materials[0].wrap_u = Wrap::clamp;
  const PointCloud cloud = samples(mesh, {.points = 1000});
  EXPECT_NEAR(static_cast<double>(cloud.positions.size()), 500, 10);
  for (const glm::vec3& p : cloud.positions) EXPECT_LE(p.x, 0.01F);
  for (uint8_t& sample : mesh.textures[0].samples) sample = 0;
  const auto none = sample_surface(mesh, {.points = 10});
  ASSERT_FALSE(none.ok());
  EXPECT_EQ(none.error().text, "all of the surface is transparent");
}

TEST(SampleSurface, GivesTheSameForAnyNumberOfThreads) {
  const Mesh mesh = sphere_mesh(3);
  const PointCloud one = samples(mesh, {.points = 30000, .threads = 1});
  const PointCloud five = samples(mesh, {.points = 30000, .threads = 5});
  EXPECT_EQ(one.positions, five.positions);
  EXPECT_EQ(one.normals, five.normals);
  EXPECT_EQ(one.colours, five.colours);
}

TEST(SampleSurface, RefusesWhatHasNoSurface) {
  const auto refused = [](const Mesh& mesh, const SurfaceSampling& sampling) {
    const auto result = sample_surface(mesh, sampling);
    return result.ok() ? std::string()
                       : to_string(result.error().code) + (": " + result.error().text);
  };
  EXPECT_EQ(refused(Mesh(), {.points = 1}), "bad_argument: the mesh has no surface");
  EXPECT_EQ(refused(box_mesh({0, 0, 0}, {1, 0, 0}), {.points = 1}),
            "bad_argument: the mesh has no surface");
  const Mesh box = box_mesh({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(refused(box, {}), "bad_argument: neither a number of points nor a spacing is given");
  EXPECT_EQ(refused(box, {.points = 100, .limits = {.memory = 5599}}),
            "limit_exceeded: so many points take more memory than the limit");
  EXPECT_EQ(refused(box, {.points = 100, .limits = {.memory = 5600}}), "");
  EXPECT_EQ(refused(box, {.spacing = 1e-300}),
            "limit_exceeded: so many points take more memory than the limit");
}

}  // namespace
}  // namespace afx
