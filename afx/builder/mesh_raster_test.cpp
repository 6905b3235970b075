// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/mesh_raster.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <string>
#include <vector>

#include "afx/builder/test_meshes.h"

namespace afx {
namespace {

// Looks along -z at the square -2..2 from z = 10.
DepthCamera front() { return {{0, 0, 10}, {1, 0, 0, 0}, true, {4, 4}, 1, 20}; }

std::vector<Fragment> fragments_of(const Mesh& mesh, const DepthCamera& camera, uint32_t width,
                                   uint32_t height) {
  const auto made = MeshRaster::of(mesh, camera, width, height, 1, {});
  EXPECT_TRUE(made.ok());
  const MeshRaster& raster = made.value();
  std::vector<Fragment> found;
  for (uint32_t band = 0; band < raster.bands(); ++band)
    raster.for_each(band, [&](const Fragment& f) { found.push_back(f); });
  return found;
}

// How often each pixel is met.
std::vector<int> hits(const std::vector<Fragment>& fragments, uint32_t width, uint32_t height) {
  std::vector<int> count(size_t{width} * height);
  for (const Fragment& f : fragments) ++count[size_t{f.y} * width + f.x];
  return count;
}

TEST(MeshRaster, ABoxFillsTheInsideOfItsShadowOnceForEachSide) {
  const Mesh box = box_mesh({-1, -1, -1}, {1, 1, 1});
  const auto count = hits(fragments_of(box, front(), 40, 40), 40, 40);
  for (uint32_t y = 0; y < 40; ++y)
    for (uint32_t x = 0; x < 40; ++x) {
      const bool inside = x >= 10 && x < 30 && y >= 10 && y < 30;
      EXPECT_EQ(count[y * 40 + x], inside ? 2 : 0) << x << " " << y;
    }
}

TEST(MeshRaster, EdgesThroughPixelCentresBelongToOneTriangle) {
  // 39 pixels on -2..2: the middle of the square and its diagonal lie on centres.
  Mesh square = textured_square(Picture(1, 1, 3));
  for (const int hit : hits(fragments_of(square, front(), 39, 39), 39, 39)) EXPECT_LE(hit, 1);
  size_t met = 0;
  for (const int hit : hits(fragments_of(square, front(), 39, 39), 39, 39))
    met += static_cast<size_t>(hit);
  EXPECT_EQ(met, 19U * 19U);  // centres at -2 + (i + 0.5) * 4/39 within -1..1: i = 10..28
}

TEST(MeshRaster, TheSurfaceOfASphereHasNoGapsAndIsMetTwiceEverywhere) {
  const Mesh sphere = sphere_mesh(4);
  const uint32_t size = 97;
  DepthCamera camera = front();
  camera.orientation = glm::angleAxis(0.3, glm::normalize(glm::dvec3(1, 2, 3)));
  camera.position = camera.orientation * glm::dvec3(0, 0, 10);
  for (const bool parallel : {true, false}) {
    camera.orthographic = parallel;
    camera.field_of_view = parallel ? glm::dvec2(2.5) : glm::dvec2(0.25);
    for (const int hit : hits(fragments_of(sphere, camera, size, size), size, size))
      EXPECT_TRUE(hit == 0 || hit == 2) << hit;
  }
}

TEST(MeshRaster, DistanceAndWeightsAreThoseOfTheRayThroughThePixel) {
  Mesh mesh;
  mesh.materials.emplace_back();
  mesh.positions = {{-3, -2, 1}, {4, -1, -5}, {0, 3, 2}};
  add_triangle(mesh, 0, 1, 2);
  DepthCamera camera = front();
  for (const bool parallel : {true, false}) {
    camera.orthographic = parallel;
    camera.field_of_view = parallel ? glm::dvec2(8) : glm::dvec2(0.8);
    const uint32_t size = 50;
    const CameraProjection projection(camera);
    const auto fragments = fragments_of(mesh, camera, size, size);
    EXPECT_GT(fragments.size(), 300U);
    for (const Fragment& f : fragments) {
      const glm::dvec3 a(mesh.positions[0]), b(mesh.positions[1]), c(mesh.positions[2]);
      const glm::dvec3 on_triangle = a * (1 - f.b - f.c) + b * f.b + c * f.c;
      const glm::dvec3 on_ray =
          projection.point({(f.x + 0.5) / size, 1 - (f.y + 0.5) / size, f.distance});
      // Corners are rounded to 1/256 of a pixel; the triangle is seen at less than 60 degrees.
      EXPECT_LT(glm::distance(on_triangle, on_ray), 8.0 / size / 256 * 4) << parallel;
    }
  }
}

TEST(MeshRaster, WhatLiesBeforeTheNearPlaneIsCutAway) {
  Mesh mesh;  // a floor under the camera, from far before to behind it
  mesh.materials.emplace_back();
  mesh.positions = {{-100, -1, -100}, {100, -1, -100}, {100, -1, 100}, {-100, -1, 100}};
  add_triangle(mesh, 0, 1, 2);
  add_triangle(mesh, 0, 2, 3);
  const DepthCamera camera{{0, 0, 0}, {1, 0, 0, 0}, false, {1.5, 1.5}, 2, 50};
  const uint32_t size = 64;
  const auto count = hits(fragments_of(mesh, camera, size, size), size, size);
  for (uint32_t y = 0; y < size; ++y) {
    // A row at slope s below the middle meets the floor at distance 1/s.
    const double slope = ((y + 0.5) / size - 0.5) * 2 * std::tan(0.75);
    const bool seen = slope > 0.01 && 1 / slope > 2;  // within 100, beyond the near plane
    for (uint32_t x = 0; x < size; ++x) EXPECT_EQ(count[y * size + x], seen ? 1 : 0) << y;
  }
}

TEST(MeshRaster, BandsAreCompleteForAnyNumberOfThreads) {
  const Mesh sphere = sphere_mesh(3);
  const auto of_one = MeshRaster::of(sphere, front(), 100, 101, 1, {});
  const auto of_four = MeshRaster::of(sphere, front(), 100, 101, 4, {});
  ASSERT_TRUE(of_one.ok() && of_four.ok());
  const MeshRaster &one = of_one.value(), &four = of_four.value();
  ASSERT_EQ(one.bands(), 5U);
  EXPECT_EQ(one.end_row(4), 101U);
  for (uint32_t band = 0; band < one.bands(); ++band) {
    std::vector<uint32_t> a, b;
    one.for_each(band, [&](const Fragment& f) {
      EXPECT_TRUE(f.y >= one.first_row(band) && f.y < one.end_row(band));
      a.push_back(f.triangle);
    });
    four.for_each(band, [&](const Fragment& f) { b.push_back(f.triangle); });
    EXPECT_EQ(a, b);
  }
}

// Corners far off the screen are drawn as if they lay at 2^20 pixels: no product leaves 64 bits.
TEST(MeshRaster, ATriangleWithCornersFarOffTheScreenFillsIt) {
  for (const float far : {1e5F, 1e9F, 1e30F}) {  // 2^20 pixels are 1e5 here
    Mesh mesh;
    mesh.materials.emplace_back();
    mesh.positions = {{-far, -far, 1}, {far, -far, 1}, {far, far, 1}, {-far, far, 1}};
    add_triangle(mesh, 0, 1, 2);
    add_triangle(mesh, 0, 2, 3);
    const auto fragments = fragments_of(mesh, front(), 40, 40);
    ASSERT_EQ(fragments.size(), 1600U) << far;
    for (const int hit : hits(fragments, 40, 40)) EXPECT_EQ(hit, 1) << far;
    for (const Fragment& f : fragments) EXPECT_NEAR(f.distance, 9, 1e-9) << far;
  }
}

TEST(MeshRaster, TrianglesOverManyRowsKeepToTheLimit) {
  // 240 rows are 10 bands, of which each triangle meets all: 4 * 24 + 2 * (8 + 10 * 4) bytes.
  Mesh mesh = textured_square(Picture(1, 1, 3));
  for (glm::vec3& p : mesh.positions) p *= 2;
  const auto error = [&](uint64_t memory) {
    Limits limits;
    limits.memory = memory;
    const auto raster = MeshRaster::of(mesh, front(), 2, 240, 1, limits);
    return raster.ok() ? std::string() : raster.error().text;
  };
  EXPECT_EQ(error(192), "");
  EXPECT_EQ(error(191),
            "the triangles on the rows of the picture take 192 bytes (expected at most 191)");
  EXPECT_EQ(error(100),
            "the triangles on the rows of the picture take 112 bytes (expected at most 100)");
}

}  // namespace
}  // namespace afx
