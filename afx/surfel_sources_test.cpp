// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/surfel_sources.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "afx/surfel_footprint.h"
#include "afx/surfel_test_models.h"

namespace afx {
namespace {

// Looks along -z from the origin at a box 4 wide and 2 high, 1 to 9 away; with dmax 9 of 4 bits a
// step of depth is 8 / 14.
DepthCamera plain_camera() { return {{0, 0, 0}, {1, 0, 0, 0}, true, {4, 2}, 1, 9}; }

Surfels surfels_or_fail(const DepthImage& image, unsigned threads = 1) {
  auto surfels = surfels_of(image, threads, {});
  EXPECT_TRUE(surfels.ok()) << surfels.error().text;
  return surfels.ok() ? surfels.value() : Surfels{};
}

// A depth for each column, the same in all rows; unit pixels. Depth 15 is distance 1.
DepthImage columns(const std::vector<uint16_t>& depths, uint32_t height = 1) {
  const auto width = static_cast<uint32_t>(depths.size());
  SimpleTexture texture = empty_texture(width, height, 4);
  for (uint32_t y = 0; y < height; ++y)
    std::copy(depths.begin(), depths.end(), texture.depth.samples.begin() + y * width);
  DepthCamera camera = plain_camera();
  camera.field_of_view = {width, height};
  return {camera, texture};
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double most = 1e-6) {
  EXPECT_NEAR(glm::distance(a, b), 0, most) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(SurfelSources, APixelAloneIsItsCellFacingTheCamera) {
  SimpleTexture texture = empty_texture(4, 2, 4);
  texture.depth.samples[1 * 4 + 3] = 1;  // the lower right pixel, on the far plane
  texture.colour.pixel(3, 1)[1] = 200;
  const Surfels surfels = surfels_or_fail({plain_camera(), texture});
  ASSERT_EQ(surfels.size(), 1U);
  expect_near(surfels.centres[0], {1.5, -0.5, -9});
  expect_near(surfels.u[0], {0.5, 0, 0});
  expect_near(surfels.v[0], {0, 0.5, 0});
  EXPECT_EQ(surfels.colours[0], (Rgba8{0, 200, 0, 255}));
}

TEST(SurfelSources, APixelInPerspectiveIsAsLargeAsItsCellAtItsDistance) {
  DepthCamera camera = plain_camera();
  camera.orthographic = false;
  camera.field_of_view = {2 * std::atan(1.0), 2 * std::atan(0.5)};  // 2 x 1 at distance 1
  SimpleTexture texture = empty_texture(4, 2, 4);
  texture.depth.samples[0] = 1;  // the upper left pixel, 9 away: 18 x 9 units, 4.5 a pixel
  const Surfels surfels = surfels_or_fail({camera, texture});
  ASSERT_EQ(surfels.size(), 1U);
  expect_near(surfels.centres[0], {-1.5 * 4.5, 0.5 * 4.5, -9}, 1e-9);
  expect_near(surfels.u[0], {2.25, 0, 0});
  expect_near(surfels.v[0], {0, 2.25, 0});
}

TEST(SurfelSources, PixelsOfASlopeTakeItsSlopeAndMeetAtTheirEdges) {
  const Surfels surfels = surfels_or_fail(columns({3, 5, 7, 9}));
  ASSERT_EQ(surfels.size(), 4U);
  const double nearer = 2 * 8.0 / 14;  // two steps of the depth a pixel
  for (size_t n = 0; n < 4; ++n) expect_near(surfels.u[n], {0.5, 0, nearer / 2});
  for (size_t n = 0; n + 1 < 4; ++n)
    expect_near(surfels.centres[n] + glm::dvec3(surfels.u[n]),
                surfels.centres[n + 1] - glm::dvec3(surfels.u[n + 1]));
}

TEST(SurfelSources, BetweenTwoSlopesAPixelTakesTheirMean) {
  const Surfels surfels = surfels_or_fail(columns({3, 5, 11}));
  expect_near(surfels.u[0], {0.5, 0, 1 * 8.0 / 14});
  expect_near(surfels.u[1], {0.5, 0, 2 * 8.0 / 14});
  expect_near(surfels.u[2], {0.5, 0, 3 * 8.0 / 14});
}

TEST(SurfelSources, WhereAFlatSurfaceMeetsASteepOnePiecesLieAlongTheFlatOne) {
  const Surfels step = surfels_or_fail(columns({5, 6, 12, 12}));
  expect_near(step.u[1], {0.5, 0, 1 * 8.0 / 14});  // twice the smaller of 1 and 6 steps
  expect_near(step.u[2], {0.5, 0, 0});             // 6 and none
  const Surfels ridge = surfels_or_fail(columns({5, 9, 4}));
  expect_near(ridge.u[1], {0.5, 0, 0});  // up and down
}

TEST(SurfelSources, AcrossAJumpOfMoreThanFourPixelsPiecesDoNotLean) {
  // A step of depth is 4/7 of a pixel: 7 steps are 4 pixels, and one is allowed for rounding.
  const Surfels far = surfels_or_fail(columns({4, 13}));
  for (const glm::vec3& u : far.u) expect_near(u, {0.5, 0, 0});
  const Surfels near = surfels_or_fail(columns({4, 12}));
  for (const glm::vec3& u : near.u) expect_near(u, {0.5, 0, 0.5 * 8 * 8.0 / 14});
}

TEST(SurfelSources, UpIsTheSecondSide) {
  SimpleTexture texture = empty_texture(1, 2, 4);
  texture.depth.samples = {5, 3};  // the upper pixel is nearer
  DepthCamera camera = plain_camera();
  camera.field_of_view = {1, 2};
  const Surfels surfels = surfels_or_fail({camera, texture});
  ASSERT_EQ(surfels.size(), 2U);
  EXPECT_LT(surfels.centres[0].y, surfels.centres[1].y);
  for (const glm::vec3& v : surfels.v) expect_near(v, {0, 0.5, 8.0 / 14});
}

TEST(SurfelSources, OpacityIsTakenOverAndWhatIsTransparentIsLeftOut) {
  DepthImage image = columns({5, 5, 5});
  auto& texture = std::get<SimpleTexture>(image.texture);
  texture.colour = Picture(3, 1, 2);
  texture.colour.samples = {10, 255, 20, 0, 30, 128};
  const Surfels surfels = surfels_or_fail(image);
  ASSERT_EQ(surfels.size(), 2U);
  EXPECT_EQ(surfels.colours[0], (Rgba8{10, 10, 10, 255}));
  EXPECT_EQ(surfels.colours[1], (Rgba8{30, 30, 30, 128}));
}

class OwnCamera : public ::testing::TestWithParam<bool> {};

TEST_P(OwnCamera, APieceCoversItsPixelAloneAndFacesTheViewer) {
  DepthImage image{test_camera(GetParam()), rough_texture(23, 17, 16, 3, 5)};
  const Surfels surfels = surfels_or_fail(image);
  EXPECT_GT(surfels.size(), 200U);
  const SurfelCamera view(image.camera, 23, 17);
  for (size_t n = 0; n < surfels.size(); ++n) {
    const SurfelFootprint piece = view.footprint(surfels, n);
    ASSERT_TRUE(piece.owns_pixel);
    EXPECT_NEAR(piece.area, 1, 1e-5);
    for (uint32_t j = 0; j < 17; ++j)
      for (uint32_t i = 0; i < 23; ++i) {
        double at = 0;
        ASSERT_EQ(piece.covers(i, j, at), i == piece.own_i && j == piece.own_j) << i << ' ' << j;
      }
  }
}

TEST_P(OwnCamera, PiecesAreTheSameForAnyNumberOfThreads) {
  const DepthImage image{test_camera(GetParam()), rough_texture(40, 30, 8, 4, 6)};
  const Surfels one = surfels_or_fail(image, 1), four = surfels_or_fail(image, 4);
  EXPECT_EQ(one.centres, four.centres);
  EXPECT_EQ(one.u, four.u);
  EXPECT_EQ(one.v, four.v);
  EXPECT_EQ(one.colours, four.colours);
}

TEST_P(OwnCamera, APointTextureOfOneLayerGivesWhatTheSimpleTextureGives) {
  const SimpleTexture simple = rough_texture(9, 7, 10, 3, 7);
  PointTexture points{9, 7, 10, {0}, {}, {}};
  for (uint32_t j = 0; j < 7; ++j)
    for (uint32_t i = 0; i < 9; ++i) {
      const uint16_t depth = simple.depth.samples[(6 - j) * 9 + i];
      if (depth != 0) {
        points.depths.push_back(depth);
        points.colours.push_back(colour_at(simple.colour, i, 6 - j));
      }
      points.starts.push_back(static_cast<uint32_t>(points.depths.size()));
    }
  const Surfels a = surfels_or_fail({test_camera(GetParam()), simple});
  const Surfels b = surfels_or_fail({test_camera(GetParam()), points});
  EXPECT_EQ(a.centres, b.centres);
  EXPECT_EQ(a.u, b.u);
  EXPECT_EQ(a.v, b.v);
  EXPECT_EQ(a.colours, b.colours);
}

INSTANTIATE_TEST_SUITE_P(All, OwnCamera, ::testing::Bool());

TEST(SurfelSources, ASampleOfALayerLeansToTheLayerNextToIt) {
  DepthCamera camera = plain_camera();
  camera.field_of_view = {2, 1};
  // Far, near; then in the other pixel near, far: one step apart each.
  const PointTexture points{2, 1, 4, {0, 2, 4}, {2, 14, 13, 3}, std::vector<Rgba8>(4)};
  const Surfels surfels = surfels_or_fail({camera, points});
  ASSERT_EQ(surfels.size(), 4U);
  const double step = 8.0 / 14;
  expect_near(surfels.u[0], {0.5, 0, step / 2});   // 2 -> 3
  expect_near(surfels.u[1], {0.5, 0, -step / 2});  // 14 -> 13
  expect_near(surfels.u[2], {0.5, 0, -step / 2});
  expect_near(surfels.u[3], {0.5, 0, step / 2});
}

TEST(SurfelSources, AVoxelIsASquareAcrossItsNormal) {
  const std::vector<uint64_t> codes = sphere_voxels(5, 0.4);
  Diagnostics diagnostics;
  const auto result = surfels_of(octree_of(codes, 5), 1, {}, diagnostics);
  ASSERT_TRUE(result.ok()) << result.error().text;
  const Surfels& surfels = result.value();
  ASSERT_EQ(surfels.size(), codes.size());
  for (size_t n = 0; n < surfels.size(); ++n) {
    const Voxel v = codec::morton_decode(codes[n]);
    EXPECT_NEAR(glm::length(surfels.u[n]), 0.85 / 32, 1e-6);
    EXPECT_NEAR(glm::length(surfels.v[n]), 0.85 / 32, 1e-6);
    const glm::dvec3 normal = glm::normalize(glm::cross(surfels.u[n], surfels.v[n]));
    EXPECT_GT(glm::dot(normal, glm::normalize(surfels.centres[n])), 0.85) << n;
    // In its voxel, on the line through the middle along the normal, and near the sphere, from
    // which the middles of voxels are up to 0.87 sides away.
    const glm::dvec3 off = 32.0 * (surfels.centres[n] + 0.5) - (glm::dvec3(v.x, v.y, v.z) + 0.5);
    EXPECT_LT(std::max({std::abs(off.x), std::abs(off.y), std::abs(off.z)}), 0.4501);
    EXPECT_LT(glm::length(glm::cross(off, normal)), 1e-5);
    EXPECT_NEAR(32 * glm::length(surfels.centres[n]), 32 * 0.4, 0.5);
  }
}

TEST(SurfelSources, ObjectsStandInTheWorldAndAMirroredOneKeepsItsOutside) {
  DibrModel model{glm::translate(glm::dmat4(1), glm::dvec3(10, 0, 0)),
                  std::vector<DepthImage>{columns({5}), columns({1})}};
  DibrModel mirrored = model;
  mirrored.to_world = glm::scale(glm::dmat4(1), glm::dvec3(-2, 1, 1));
  Diagnostics diagnostics;
  const auto result = surfels_of(std::vector{model, mirrored}, 1, {}, diagnostics);
  ASSERT_TRUE(result.ok());
  const Surfels& surfels = result.value();
  ASSERT_EQ(surfels.size(), 4U);
  expect_near(surfels.centres[1], {10, 0, -9});
  expect_near(surfels.centres[3], {0, 0, -9});
  expect_near(surfels.u[1], {0.5, 0, 0});
  for (const size_t n : {0U, 1U, 2U, 3U}) {
    const glm::vec3 outside = glm::cross(surfels.u[n], surfels.v[n]);
    expect_near(outside, {0, 0, n < 2 ? 0.25 : 0.5});
  }
}

TEST(SurfelSources, AnOctreeOfASceneIsAmongItsObjects) {
  const DibrModel model{glm::scale(glm::dmat4(1), glm::dvec3(8)), octree_of({0, 7}, 1)};
  Diagnostics diagnostics;
  const auto result = surfels_of(std::vector{model}, 1, {}, diagnostics);
  ASSERT_TRUE(result.ok());
  ASSERT_EQ(result.value().size(), 2U);
  const glm::dvec3 centre = result.value().centres[0];
  EXPECT_LT(std::max({centre.x, centre.y, centre.z}), 0);  // in its eighth of the cube
  EXPECT_GT(std::min({centre.x, centre.y, centre.z}), -4);
  EXPECT_NEAR(glm::length(result.value().u[1]), 0.85 * 4, 1e-6);
}

TEST(SurfelSources, RefuseWhatIsTooMuchOrCannotBe) {
  Limits limits;
  limits.memory = 2 * kSurfelBytes;
  const auto many = surfels_of(columns({5, 5, 5}), 1, limits);
  ASSERT_FALSE(many.ok());
  EXPECT_EQ(many.error().code, Errc::limit_exceeded);
  EXPECT_EQ(many.error().text, "3 pieces of surface take more memory than the limit");

  DepthImage image = columns({5});
  image.camera.far_plane = 0.5;
  const auto bad = surfels_of(image, 1, {});
  ASSERT_FALSE(bad.ok());
  EXPECT_EQ(bad.error().text, "field farPlane is 0.5 (expected more than nearPlane)");

  Diagnostics diagnostics;
  DibrModel model{glm::dmat4(1), std::vector<DepthImage>{columns({5, 5}), columns({5})}};
  const auto together = surfels_of(std::vector{model}, 1, limits, diagnostics);
  ASSERT_FALSE(together.ok());
  EXPECT_EQ(together.error().text, "3 pieces of surface take more memory than the limit");
  model.to_world[1][1] = std::numeric_limits<double>::infinity();
  const auto endless = surfels_of(std::vector{model}, 1, {}, diagnostics);
  ASSERT_FALSE(endless.ok());
  EXPECT_EQ(endless.error().text, "a transform of the scene is not finite");
  model.to_world = glm::dmat4(1);
  model.to_world[3].x = -1e37;
  const auto far = surfels_of(std::vector{model}, 1, {}, diagnostics);
  ASSERT_FALSE(far.ok());
  EXPECT_EQ(far.error().text, "a transform of the scene moves points beyond 1e37");
}

}  // namespace
}  // namespace afx
