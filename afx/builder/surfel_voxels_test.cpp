// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/surfel_voxels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

#include "afx/octree_colours.h"
#include "afx/surfel_sources.h"
#include "afx/surfel_test_models.h"
#include "codec/octree_voxels.h"

namespace afx {
namespace {

// A cube from 0 to 2^levels, a voxel a unit.
Grid unit_grid(unsigned levels) {
  const double side = 1U << levels;
  return Grid({{0, 0, 0}, glm::dvec3(side)}, 1U << levels);
}

SurfaceVoxels voxels_or_fail(const Surfels& surfels, const Grid& grid, unsigned threads = 1) {
  uint64_t outside = 0;
  auto voxels = voxelize(surfels, grid, threads, {}, outside);
  EXPECT_TRUE(voxels.ok()) << voxels.error().text;
  return voxels.ok() ? voxels.value() : SurfaceVoxels{};
}

std::vector<uint64_t> codes_of(const std::vector<Voxel>& voxels) {
  std::vector<uint64_t> codes;
  for (const Voxel& v : voxels) codes.push_back(codec::morton_code(v));
  std::sort(codes.begin(), codes.end());
  return codes;
}

TEST(SurfelVoxels, OfAnOctreeInItsOwnCubeAreItsVoxelsAndColours) {
  for (const unsigned levels : {1U, 4U, 6U}) {
    const OctreeModel model = octree_of(sphere_voxels(levels, 0.44), levels);
    Diagnostics diagnostics;
    const auto surfels = surfels_of(model, 1, {}, diagnostics);
    ASSERT_TRUE(surfels.ok());
    const Grid cube({glm::dvec3(-0.5), glm::dvec3(0.5)}, 1U << levels);
    const SurfaceVoxels voxels = voxels_or_fail(surfels.value(), cube);
    const auto coloured = colour_octree(model, levels, 1, {}, diagnostics);
    ASSERT_TRUE(coloured.ok());
    EXPECT_EQ(voxels.codes, coloured.value().codes);
    EXPECT_EQ(voxels.colours, coloured.value().colours);
    EXPECT_EQ(codec::octree_from_morton(voxels.codes, levels), model.fields.octree);
  }
}

TEST(SurfelVoxels, APieceNoLongerThanAVoxelSetsTheOneOfItsCentre) {
  Surfels surfels;
  surfels.push_back({1.1, 2.9, 3.5}, {0.5, 0, 0}, {0, 0.5, 0}, {255, 0, 0, 255});
  surfels.push_back({1.9, 2.1, 3.1}, {0, 0, 0}, {0, 0, 0}, {0, 0, 255, 255});
  const SurfaceVoxels voxels = voxels_or_fail(surfels, unit_grid(3));
  EXPECT_EQ(voxels.codes, codes_of({{1, 2, 3}}));
  EXPECT_EQ(voxels.colours, (std::vector<Rgba8>{{188, 0, 188, 255}}));
  EXPECT_EQ(voxels.normals, (std::vector<glm::vec3>{{0, 0, 1}}));
}

TEST(SurfelVoxels, ALongerPieceSetsAllThatItPassesThrough) {
  Surfels surfels;  // 2 x 3.2 voxels, standing across x
  surfels.push_back({4.5, 3.5, 2.5}, {0, 1, 0}, {0, 0, 1.6}, {9, 9, 9, 255});
  const SurfaceVoxels voxels = voxels_or_fail(surfels, unit_grid(3));
  std::vector<Voxel> expected;
  for (const uint32_t y : {2U, 3U, 4U})
    for (const uint32_t z : {0U, 1U, 2U, 3U, 4U}) expected.push_back({4, y, z});
  EXPECT_EQ(voxels.codes, codes_of(expected));
  for (const Rgba8 c : voxels.colours) EXPECT_EQ(c, (Rgba8{9, 9, 9, 255}));
  for (const glm::vec3& n : voxels.normals) EXPECT_GT(n.x, 0.999F);
}

TEST(SurfelVoxels, OnlyAPieceAcrossTheMiddleOfItsVoxelIsTakenForAVoxels) {
  const auto count = [](const glm::dvec3& centre, float half) {
    Surfels surfels;
    surfels.push_back(centre, {half, 0, 0}, {0, half, 0}, {});
    return voxels_or_fail(surfels, unit_grid(3)).codes.size();
  };
  EXPECT_EQ(count({2.5, 2.5, 2.8}, 0.72F), 1U);
  EXPECT_EQ(count({2.5, 2.5, 2.8}, 0.9F), 9U);
  EXPECT_EQ(count({2.6, 2.5, 2.8}, 0.72F), 9U);
}

TEST(SurfelVoxels, TheSurfaceOfASteepDepthImageHasNoGaps) {
  // A slope of three units a pixel: columns of four voxels touch each other.
  SimpleTexture texture = empty_texture(8, 8, 8);
  for (uint32_t y = 0; y < 8; ++y)
    for (uint32_t x = 0; x < 8; ++x)
      texture.depth.samples[y * 8 + x] = static_cast<uint16_t>(4 + 3 * x);
  const DepthCamera camera{{4, 4, 40}, {1, 0, 0, 0}, true, {8, 8}, 0, 254};
  const auto surfels = surfels_of({camera, texture}, 1, {});
  ASSERT_TRUE(surfels.ok());
  Surfels moved = surfels.value();
  for (glm::dvec3& c : moved.centres) c = {c.x + 4, c.y + 4, c.z + 213.25};
  const SurfaceVoxels voxels = voxels_or_fail(moved, unit_grid(5));
  std::vector<bool> set(32 * 32);
  for (const uint64_t code : voxels.codes) {
    const Voxel v = codec::morton_decode(code);
    if (v.y == 8) set[v.x * 32 + v.z] = true;
  }
  for (uint32_t x = 4; x < 11; ++x) {
    int shared = 0;  // a height at which a column and the next both are set
    for (uint32_t z = 0; z < 32; ++z) shared += set[x * 32 + z] && set[(x + 1) * 32 + z];
    EXPECT_GE(shared, 1) << x;
  }
}

TEST(SurfelVoxels, PointsAndLongPiecesInOneVoxelAreAveraged) {
  Surfels surfels;
  surfels.push_back({2.5, 2.5, 2.5}, {2, 0, 0}, {0, 2, 0}, {255, 0, 0, 255});
  surfels.push_back({2.5, 2.5, 2.5}, {0, 0, 0}, {0, 0, 0}, {0, 255, 0, 255});
  surfels.push_back({7.5, 2.5, 2.5}, {0, 0, 0}, {0, 0, 0}, {0, 0, 255, 255});
  const SurfaceVoxels voxels = voxels_or_fail(surfels, unit_grid(3));
  ASSERT_TRUE(std::is_sorted(voxels.codes.begin(), voxels.codes.end()));
  const auto at = [&](const Voxel& v) {
    const auto found = std::find(voxels.codes.begin(), voxels.codes.end(), codec::morton_code(v));
    EXPECT_NE(found, voxels.codes.end());
    return voxels.colours[static_cast<size_t>(found - voxels.codes.begin())];
  };
  EXPECT_EQ(voxels.codes.size(), 26U);
  EXPECT_EQ(at({2, 2, 2}), (Rgba8{188, 188, 0, 255}));
  EXPECT_EQ(at({3, 2, 2}), (Rgba8{255, 0, 0, 255}));
  EXPECT_EQ(at({7, 2, 2}), (Rgba8{0, 0, 255, 255}));
}

TEST(SurfelVoxels, LeaveOutWhatIsTransparentAndCountWhatIsOutsideOrEndless) {
  Surfels surfels;
  const glm::vec3 none(0);
  surfels.push_back({2.5, 2.5, 2.5}, none, none, {1, 1, 1, 0});
  surfels.push_back({-0.5, 2.5, 2.5}, none, none, {});
  surfels.push_back({2.5, 8.5, 2.5}, none, none, {});
  surfels.push_back({2.5, std::numeric_limits<double>::quiet_NaN(), 2.5}, none, none, {});
  surfels.push_back({2.5, 2.5, 2.5}, {1e30F, 0, 0}, {0, 1, 0}, {});
  uint64_t outside = 0;
  const auto voxels = voxelize(surfels, unit_grid(3), 1, {}, outside);
  ASSERT_TRUE(voxels.ok());
  EXPECT_TRUE(voxels.value().codes.empty());
  EXPECT_EQ(outside, 4U);
}

TEST(SurfelVoxels, OfWhatReachesOutOfTheCubeOnlyTheInsideIsSet) {
  Surfels surfels;
  // A slope from z = 0 at x = 4.5 through the side x = 8 at z = 3.5 to z = 60.
  surfels.push_back({34.5, 4.5, 30}, {30, 0, 30}, {0, 0.4F, 0}, {});
  // Beside the cube: its end at y = 0.5 looks in at x = 1.
  surfels.push_back({1.5, -3.5, 7.5}, {0, 4, 0}, {0.4F, 0, 0}, {});
  surfels.push_back({4, 4, 8.5}, {4, 0, 0}, {0, 4, 0}, {});  // above it
  uint64_t outside = 0;
  const auto voxels = voxelize(surfels, unit_grid(3), 1, {}, outside);
  ASSERT_TRUE(voxels.ok());
  std::vector<Voxel> expected = {{1, 0, 7}};
  for (uint32_t n = 0; n < 4; ++n) {
    expected.push_back({4 + n, 4, n});
    if (n > 0) expected.push_back({4 + n, 4, n - 1});
  }
  EXPECT_EQ(voxels.value().codes, codes_of(expected));
  EXPECT_EQ(outside, 3U);
}

TEST(SurfelVoxels, FarFromTheOriginKeepTheirPlace) {
  Surfels surfels;
  const glm::dvec3 far(1e9, -1e9, 1e9);
  for (int n = 0; n < 8; ++n) surfels.push_back(far + (n + 0.5) / 1024.0, {}, {}, {});
  const Grid grid({far, far + 8.0 / 1024}, 8);
  const SurfaceVoxels voxels = voxels_or_fail(surfels, grid);
  std::vector<Voxel> diagonal;
  for (uint32_t n = 0; n < 8; ++n) diagonal.push_back({n, n, n});
  EXPECT_EQ(voxels.codes, codes_of(diagonal));
}

TEST(SurfelVoxels, KeepToTheLimitsForAnyNumberOfThreads) {
  Surfels surfels;
  surfels.push_back({4, 4, 4.5}, {3.9F, 0, 0}, {0, 3.9F, 0}, {5, 6, 7, 255});
  surfels.push_back({4, 4, 4.5}, {0, 3.9F, 0}, {0, 0, 3.9F}, {9, 6, 7, 255});
  const SurfaceVoxels one = voxels_or_fail(surfels, unit_grid(3), 1);
  const SurfaceVoxels three = voxels_or_fail(surfels, unit_grid(3), 3);
  EXPECT_EQ(one.codes, three.codes);
  EXPECT_EQ(one.colours, three.colours);
  Limits limits;
  limits.octree_nodes = 63;
  uint64_t outside = 0;
  const auto many = voxelize(surfels, unit_grid(3), 1, limits, outside);
  ASSERT_FALSE(many.ok());
  EXPECT_EQ(many.error().text,
            "the surface has more voxels than the limit (a lower resolution has fewer)");
  limits = {};
  limits.memory = 128;
  const auto memory = voxelize(surfels, unit_grid(3), 1, limits, outside);
  ASSERT_FALSE(memory.ok());
  EXPECT_EQ(memory.error().text, "the pieces of surface take more memory than the limit");
}

}  // namespace
}  // namespace afx
