// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/voxel_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include "afx/voxel_shading.h"
#include "codec/octree_voxels.h"

namespace afx {
namespace {

std::vector<uint64_t> sorted_codes(const std::vector<Voxel>& voxels) {
  std::vector<uint64_t> codes;
  for (const Voxel& v : voxels) codes.push_back(codec::morton_code(v));
  std::sort(codes.begin(), codes.end());
  codes.erase(std::unique(codes.begin(), codes.end()), codes.end());
  return codes;
}

std::vector<uint64_t> random_codes(unsigned seed, uint32_t side, size_t count) {
  std::mt19937 random(seed);
  std::vector<Voxel> voxels;
  for (size_t i = 0; i < count; ++i) {
    voxels.push_back({static_cast<uint32_t>(random() % side),
                      static_cast<uint32_t>(random() % side),
                      static_cast<uint32_t>(random() % side)});
  }
  return sorted_codes(voxels);
}

TEST(VoxelBlocks, EveryVoxelIsFoundAtItsPlaceAndNoOther) {
  const std::vector<uint64_t> codes = random_codes(1, 16, 700);
  const VoxelBlocks blocks(codes);
  EXPECT_EQ(blocks.voxel_count(), codes.size());
  for (uint64_t code = 0; code < 16 * 16 * 16; ++code) {
    const auto at = std::lower_bound(codes.begin(), codes.end(), code);
    const bool there = at != codes.end() && *at == code;
    ASSERT_EQ(blocks.find(code),
              there ? static_cast<size_t>(at - codes.begin()) : VoxelBlocks::kNone);
  }
}

TEST(VoxelBlocks, NoVoxelsMakeNoBlocks) {
  const VoxelBlocks blocks({});
  EXPECT_EQ(blocks.voxel_count(), 0U);
  EXPECT_EQ(blocks.find(0), VoxelBlocks::kNone);
  EXPECT_TRUE(voxel_normals(blocks, 2).empty());
}

TEST(VoxelNormals, AgreeWithAPlainCountOfNeighbours) {
  const std::vector<uint64_t> codes = random_codes(2, 12, 600);
  const VoxelBlocks blocks(codes);
  const std::vector<glm::vec3> normals = voxel_normals(blocks, 2);
  for (size_t i = 0; i < codes.size(); ++i) {
    const Voxel a = codec::morton_decode(codes[i]);
    double x = 0, y = 0, z = 0;
    for (const uint64_t code : codes) {
      const Voxel b = codec::morton_decode(code);
      const int dx = static_cast<int>(b.x) - static_cast<int>(a.x);
      const int dy = static_cast<int>(b.y) - static_cast<int>(a.y);
      const int dz = static_cast<int>(b.z) - static_cast<int>(a.z);
      const double length = std::sqrt(dx * dx + dy * dy + dz * dz);
      if (length == 0 || std::max({std::abs(dx), std::abs(dy), std::abs(dz)}) > 1) continue;
      x -= dx / length, y -= dy / length, z -= dz / length;
    }
    const double length = std::max(1e-12, std::sqrt(x * x + y * y + z * z));
    if (length < 1e-9) x = y = z = 0;
    ASSERT_NEAR(normals[i].x, x / length, 1e-6);
    ASSERT_NEAR(normals[i].y, y / length, 1e-6);
    ASSERT_NEAR(normals[i].z, z / length, 1e-6);
  }
}

TEST(VoxelNormals, InTheMiddleOfAFullCubeThereIsNone) {
  const std::vector<uint64_t> codes = random_codes(3, 4, 5000);
  ASSERT_EQ(codes.size(), 64U);
  const std::vector<glm::vec3> normals = voxel_normals(VoxelBlocks(codes), 1);
  EXPECT_EQ(normals[VoxelBlocks(codes).find(codec::morton_code({1, 2, 1}))], glm::vec3(0));
  EXPECT_EQ(normals[VoxelBlocks(codes).find(codec::morton_code({1, 2, 3}))], glm::vec3(0, 0, 1));
}

TEST(VoxelNormals, NeighboursAtTheEndsOfTheRangeDoNotWrapAround) {
  const uint32_t last = (1U << 21) - 1;
  const std::vector<uint64_t> codes = sorted_codes({{0, 0, 0}, {last, 0, 0}, {last, last, last}});
  for (const glm::vec3& n : voxel_normals(VoxelBlocks(codes), 1)) EXPECT_EQ(n, glm::vec3(0));
}

/// Voxels that the sphere around the centre of the cube passes through.
std::vector<uint64_t> sphere_shell(unsigned level, double radius) {
  const uint32_t side = 1U << level;
  std::vector<Voxel> voxels;
  for (uint32_t z = 0; z < side; ++z) {
    for (uint32_t y = 0; y < side; ++y) {
      for (uint32_t x = 0; x < side; ++x) {
        double least = 0, most = 0;
        for (const uint32_t at : {x, y, z}) {
          const double a = at - side / 2.0, b = a + 1;
          const double near = a <= 0 && b >= 0 ? 0 : std::min(std::abs(a), std::abs(b));
          const double far = std::max(std::abs(a), std::abs(b));
          least += near * near, most += far * far;
        }
        const double r = radius * side;
        if (std::sqrt(least) <= r && r <= std::sqrt(most)) voxels.push_back({x, y, z});
      }
    }
  }
  return sorted_codes(voxels);
}

TEST(SurfaceNormals, OfASphereShellPointOutwards) {
  const unsigned level = 6;
  const std::vector<uint64_t> codes = sphere_shell(level, 0.4);
  const VoxelBlocks blocks(codes);
  const std::vector<glm::vec3> normals = surface_normals(codes, level, blocks, 2);
  double sum = 0;
  for (size_t i = 0; i < codes.size(); ++i) {
    const Voxel v = codec::morton_decode(codes[i]);
    const glm::dvec3 out(v.x - 31.5, v.y - 31.5, v.z - 31.5);
    const double length = std::sqrt(out.x * out.x + out.y * out.y + out.z * out.z);
    const double cosine =
        (out.x * normals[i].x + out.y * normals[i].y + out.z * normals[i].z) / length;
    EXPECT_GT(cosine, 0.85);
    sum += cosine;
  }
  EXPECT_GT(sum / static_cast<double>(codes.size()), 0.98);
  EXPECT_EQ(normals, surface_normals(codes, level, blocks, 8));
}

TEST(SurfaceNormals, RowsOfSightAreFewForFewVoxels) {
  EXPECT_EQ(sight_level(21, 1), 8U);  // a lone voxel asks for 2^16 rows, not 2^42
  EXPECT_EQ(sight_level(5, 1), 5U);
  EXPECT_EQ(sight_level(9, (1 << 18) / 16), 9U);
  EXPECT_EQ(sight_level(9, (1 << 18) / 16 - 1), 8U);
  EXPECT_EQ(sight_level(11, 1 << 22), 11U);
  EXPECT_EQ(sight_level(12, size_t{1} << 40), 11U);
}

TEST(ShadedColour, IsTheColourItselfTowardsTheLightAndDarkerBehind) {
  const glm::vec3 light = glm::normalize(glm::vec3(-0.45F, 0.7F, 0.8F));
  const Rgba8 colour{200, 100, 0, 255};
  EXPECT_EQ(shaded_colour(colour, light), colour);
  EXPECT_NEAR(shade_light(light), 0.65, 1e-6);
  EXPECT_NEAR(shade_light(-light), 0.06, 1e-6);
  const Rgba8 behind = shaded_colour(colour, -light);
  EXPECT_LT(behind.r, 100);
  EXPECT_GT(behind.r, behind.g);
  EXPECT_EQ(behind.b, 0);
  EXPECT_EQ(behind.a, 255);
}

}  // namespace
}  // namespace afx
