// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/voxelize.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <set>

#include "afx/builder/test_meshes.h"
#include "afx/srgb.h"
#include "codec/octree_voxels.h"

namespace afx {
namespace {

SurfaceVoxels voxels_of(const Mesh& mesh, uint32_t resolution, unsigned threads = 1) {
  const Grid grid(bounds_of(mesh.positions), resolution);
  auto voxels = voxelize(mesh, grid, threads, Limits());
  EXPECT_TRUE(voxels.ok());
  EXPECT_TRUE(std::is_sorted(voxels.value().codes.begin(), voxels.value().codes.end()));
  EXPECT_EQ(std::adjacent_find(voxels.value().codes.begin(), voxels.value().codes.end()),
            voxels.value().codes.end());
  EXPECT_EQ(voxels.value().codes.size(), voxels.value().colours.size());
  EXPECT_EQ(voxels.value().codes.size(), voxels.value().normals.size());
  return std::move(voxels).value();
}

// Whether empty cells connected by their sides lead from the cube's border to its middle.
bool leaks(const SurfaceVoxels& voxels, unsigned levels) {
  const uint32_t side = (1U << levels) + 2;  // with a margin of empty cells
  std::vector<bool> taken(size_t{side} * side * side);
  const auto place = [&](uint32_t x, uint32_t y, uint32_t z) {
    return (size_t{z} * side + y) * side + x;
  };
  for (const uint64_t code : voxels.codes) {
    const Voxel v = codec::morton_decode(code);
    taken[place(v.x + 1, v.y + 1, v.z + 1)] = true;
  }
  const Voxel middle{side / 2, side / 2, side / 2};
  std::vector<Voxel> open{{0, 0, 0}};
  taken[0] = true;
  while (!open.empty()) {
    const Voxel v = open.back();
    open.pop_back();
    if (v == middle) return true;
    for (const auto& [dx, dy, dz] :
         {std::tuple{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}) {
      const Voxel n{v.x + static_cast<uint32_t>(dx), v.y + static_cast<uint32_t>(dy),
                    v.z + static_cast<uint32_t>(dz)};
      if (n.x >= side || n.y >= side || n.z >= side || taken[place(n.x, n.y, n.z)]) continue;
      taken[place(n.x, n.y, n.z)] = true;
      open.push_back(n);
    }
  }
  return false;
}

TEST(Voxelize, ACubeIsItsOutermostLayer) {
  for (const uint32_t n : {1U, 2U, 4U, 8U, 32U, 64U}) {
    const SurfaceVoxels voxels = voxels_of(box_mesh({-1, -1, -1}, {1, 1, 1}), n);
    const uint64_t inner = n < 2 ? 0 : uint64_t{n - 2} * (n - 2) * (n - 2);
    EXPECT_EQ(voxels.codes.size(), uint64_t{n} * n * n - inner) << n;
  }
}

TEST(Voxelize, ABoxOfOtherProportionsHasNoThickWalls) {
  // 16 x 8 x 4 voxels, centred: x 0..15, y 4..11, z 6..9. Its shell: the box less 14 x 6 x 2.
  const SurfaceVoxels voxels = voxels_of(box_mesh({0, 0, 0}, {4, 2, 1}), 16);
  EXPECT_EQ(voxels.codes.size(), 16U * 8 * 4 - 14U * 6 * 2);
  for (const uint64_t code : voxels.codes) {
    const Voxel v = codec::morton_decode(code);
    EXPECT_TRUE(v.y >= 4 && v.y <= 11 && v.z >= 6 && v.z <= 9);
  }
}

TEST(Voxelize, AResolutionBetweenPowersOfTwoIsTheLongestSide) {
  for (const uint32_t n : {3U, 5U, 12U, 100U}) {
    const SurfaceVoxels voxels = voxels_of(box_mesh({0, 0, 0}, {7, 7, 7}), n);
    EXPECT_EQ(voxels.codes.size(), uint64_t{n} * n * n - uint64_t{n - 2} * (n - 2) * (n - 2)) << n;
  }
}

TEST(Voxelize, ASquareBetweenTwoLayersSetsOne) {
  const SurfaceVoxels voxels = voxels_of(textured_square(Picture(1, 1, 3)), 32);
  EXPECT_EQ(voxels.codes.size(), 32U * 32);
}

// The shape, in voxel units: radius 32 around (32, 32, 32). A voxel whose box the sphere crosses
// clearly must be set, one that the sphere stays clear of must not. The tolerance is the distance
// between the sphere and its triangles, 1 - cos(half the angle of an edge of 90/2^6 degrees), times
// 32 voxels, about 0.004, and what fixed point adds.
TEST(Voxelize, ASphereSetsTheVoxelsItCrosses) {
  constexpr double kRadius = 32, kTolerance = 0.02;
  const SurfaceVoxels voxels = voxels_of(sphere_mesh(6), 64);
  const std::set<uint64_t> set(voxels.codes.begin(), voxels.codes.end());
  for (uint32_t x = 0; x < 64; ++x)
    for (uint32_t y = 0; y < 64; ++y)
      for (uint32_t z = 0; z < 64; ++z) {
        const auto nearest = [](uint32_t i) { return std::max({0.0, i - 32.0, 31.0 - i}); };
        const auto farthest = [](uint32_t i) {
          return std::max(std::abs(i - 32.0), std::abs(i - 31.0));
        };
        const double near = std::hypot(nearest(x), nearest(y), nearest(z));
        const double far = std::hypot(farthest(x), farthest(y), farthest(z));
        const bool is_set = set.count(codec::morton_code({x, y, z})) != 0;
        if (near < kRadius - kTolerance && far > kRadius + kTolerance) {
          ASSERT_TRUE(is_set) << x << ' ' << y << ' ' << z;
        }
        if (far < kRadius - kTolerance || near > kRadius + kTolerance) {
          ASSERT_FALSE(is_set) << x << ' ' << y << ' ' << z;
        }
      }
}

TEST(Voxelize, ClosedMeshesKeepTheirInsideClosed) {
  EXPECT_FALSE(leaks(voxels_of(sphere_mesh(5), 128), 7));
  EXPECT_FALSE(leaks(voxels_of(sphere_mesh(1), 100), 7));
  Mesh tilted = box_mesh({-3, -1, -2}, {3, 1, 2});
  for (glm::vec3& p : tilted.positions)
    p = {0.8F * p.x - 0.6F * p.y, 0.6F * p.x + 0.8F * p.y, p.z + 0.1F * p.x};
  EXPECT_FALSE(leaks(voxels_of(tilted, 64), 6));
}

TEST(Voxelize, TheLeakTestFindsASingleHole) {
  SurfaceVoxels voxels = voxels_of(box_mesh({-1, -1, -1}, {1, 1, 1}), 16);
  EXPECT_FALSE(leaks(voxels, 4));
  voxels.codes.erase(
      std::find(voxels.codes.begin(), voxels.codes.end(), codec::morton_code({0, 8, 8})));
  EXPECT_TRUE(leaks(voxels, 4));
}

TEST(Voxelize, GivesTheSameForAnyNumberOfThreads) {
  const Mesh mesh = sphere_mesh(4);
  const SurfaceVoxels one = voxels_of(mesh, 200, 1), five = voxels_of(mesh, 200, 5);
  EXPECT_EQ(one.codes, five.codes);
  EXPECT_EQ(one.colours, five.colours);
  EXPECT_EQ(one.normals, five.normals);
}

TEST(Voxelize, NormalsOfASpherePointOutwards) {
  const SurfaceVoxels voxels = voxels_of(sphere_mesh(5), 64);
  double sum = 0;
  for (size_t i = 0; i < voxels.codes.size(); ++i) {
    const Voxel v = codec::morton_decode(voxels.codes[i]);
    const glm::vec3 out = glm::normalize(glm::vec3(v.x, v.y, v.z) - 31.5F);
    EXPECT_GT(glm::dot(out, voxels.normals[i]), 0.95F);
    sum += glm::dot(out, voxels.normals[i]);
  }
  EXPECT_GT(sum / static_cast<double>(voxels.codes.size()), 0.999);
}

TEST(Voxelize, AColourComesOutAsItWentIn) {
  const auto& linear = srgb_to_linear();
  for (const uint8_t value :
       {uint8_t{0}, uint8_t{1}, uint8_t{10}, uint8_t{100}, uint8_t{200}, uint8_t{255}}) {
    const SurfaceVoxels voxels =
        voxels_of(box_mesh({0, 0, 0}, {1, 1, 1}, {linear[value], 0, 1}), 8);
    for (const Rgba8& colour : voxels.colours) EXPECT_EQ(colour, (Rgba8{value, 0, 255, 255}));
  }
}

Picture checkerboard(uint32_t side) {
  Picture picture(side, side, 3);
  for (uint32_t y = 0; y < side; ++y)
    for (uint32_t x = 0; x < side; ++x)
      for (int k = 0; k < 3; ++k) picture.pixel(x, y)[k] = (x + y) % 2 != 0 ? 255 : 0;
  return picture;
}

TEST(Voxelize, ACheckerboardFinerThanVoxelsIsItsMeanInLinearLight) {
  // Half of the light of white is 188 in sRGB (0.5 linear = 0.7354 * 255 = 187.5), not 128.
  for (const uint32_t side : {128U, 256U, 100U}) {
    const SurfaceVoxels voxels = voxels_of(textured_square(checkerboard(side)), 16);
    for (const Rgba8& colour : voxels.colours) {
      EXPECT_NEAR(colour.r, 188, side == 100 ? 6 : 1);
      EXPECT_EQ(colour.r, colour.b);
    }
  }
}

TEST(Voxelize, TexturesStandUpright) {
  Picture picture(2, 2, 3);  // red green / blue white
  const uint8_t samples[] = {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255};
  picture.samples.assign(samples, samples + 12);
  const SurfaceVoxels voxels = voxels_of(textured_square(picture), 64);
  const auto at = [&](uint32_t x, uint32_t y) {
    const auto found =
        std::lower_bound(voxels.codes.begin(), voxels.codes.end(), codec::morton_code({x, y, 32}));
    return voxels.colours[static_cast<size_t>(found - voxels.codes.begin())];
  };
  // In the middle of a texel there is only its own colour. y grows upwards: red is the upper left.
  EXPECT_NEAR(at(15, 48).r, 255, 8);
  EXPECT_NEAR(at(15, 48).g, 0, 40);
  EXPECT_GT(at(48, 48).g, 240);
  EXPECT_GT(at(16, 16).b, 240);
  EXPECT_GT(at(48, 16).r, 240);
  EXPECT_GT(at(48, 16).b, 240);
}

TEST(Voxelize, VerticesBlendTheirColours) {
  Mesh mesh = textured_square(Picture(1, 1, 3));
  mesh.materials[0].texture = Material::kNoTexture;
  mesh.colours = {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 0, 0}};  // red grows with x, in linear light
  const SurfaceVoxels voxels = voxels_of(mesh, 64);
  for (size_t i = 0; i < voxels.codes.size(); ++i) {
    const double expected = (codec::morton_decode(voxels.codes[i]).x + 0.5) / 64;
    EXPECT_NEAR(srgb_to_linear()[voxels.colours[i].r], expected, 0.01);
  }
}

TEST(Voxelize, SurvivesTrianglesWithoutArea) {
  Mesh mesh = box_mesh({0, 0, 0}, {1, 1, 1}, {1, 0, 0});
  add_triangle(mesh, 0, 0, 0);
  add_triangle(mesh, 0, 7, 7);  // the box's diagonal
  const SurfaceVoxels voxels = voxels_of(mesh, 16);
  EXPECT_EQ(voxels.codes.size(), 16U * 16 * 16 - 14U * 14 * 14 + 14U);
  for (const Rgba8& colour : voxels.colours) EXPECT_EQ(colour, (Rgba8{255, 0, 0, 255}));
}

TEST(Voxelize, AModelWithoutExtentIsOneVoxel) {
  Mesh mesh = box_mesh({5, 5, 5}, {5, 5, 5});
  EXPECT_EQ(voxels_of(mesh, 64).codes.size(), 1U);
  mesh = box_mesh({1e30F, 0, 0}, {2e30F, 1e30F, 1e30F});
  EXPECT_EQ(voxels_of(mesh, 4).codes.size(), 64U - 8);
}

TEST(Voxelize, KeepsToTheLimits) {
  const Mesh mesh = sphere_mesh(3);
  Limits limits;
  limits.octree_nodes = 1000;
  const auto voxels = voxelize(mesh, Grid(bounds_of(mesh.positions), 64), 2, limits);
  ASSERT_FALSE(voxels.ok());
  EXPECT_EQ(voxels.error().code, Errc::limit_exceeded);
}

TEST(VoxelizePoints, PutsEachPointIntoItsVoxel) {
  PointCloud cloud;
  cloud.positions = {{0, 0, 0}, {4, 4, 4}, {1.5F, 2.5F, 3.5F}, {1.6F, 2.4F, 3.6F}};
  cloud.colours = {{255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 0, 255}, {255, 255, 255, 255}};
  const auto voxels = voxelize(cloud, Grid(bounds_of(cloud.positions), 4), Limits());
  ASSERT_TRUE(voxels.ok());
  ASSERT_EQ(voxels.value().codes, (std::vector<uint64_t>{0, codec::morton_code({1, 2, 3}), 63}));
  EXPECT_EQ(voxels.value().colours[0], (Rgba8{255, 0, 0, 255}));
  EXPECT_EQ(voxels.value().colours[1], (Rgba8{188, 188, 188, 255}));  // the mean in linear light
  EXPECT_EQ(voxels.value().colours[2], (Rgba8{0, 255, 0, 255}));
}

// A square whose texture is red and opaque on the left, green and transparent on the right.
Mesh half_there() {
  Picture texture(16, 16, 4);
  for (uint32_t y = 0; y < 16; ++y)
    for (uint32_t x = 0; x < 16; ++x) {
      texture.pixel(x, y)[x < 8 ? 0 : 1] = 255;
      texture.pixel(x, y)[3] = x < 8 ? 255 : 0;
    }
  Mesh mesh = textured_square(texture);
  mesh.materials[0].alpha_cutoff = 0.5F;
  return mesh;
}

TEST(Voxelize, LeavesOutWhereTheTextureIsTransparent) {
  const SurfaceVoxels voxels = voxels_of(half_there(), 16);
  EXPECT_EQ(voxels.codes.size(), 8U * 16);
  for (size_t i = 0; i < voxels.codes.size(); ++i) {
    EXPECT_LT(codec::morton_decode(voxels.codes[i]).x, 8U);
    EXPECT_EQ(voxels.colours[i], (Rgba8{255, 0, 0, 255}));  // nothing of the green beside it
    EXPECT_EQ(voxels.normals[i], glm::vec3(0, 0, 1));
  }
}

TEST(Voxelize, AVoxelIsThereWhereMeanAlphaReachesTheCutoff) {
  // A quarter of the texels of every voxel is opaque.
  Picture texture(64, 64, 4);
  for (uint32_t y = 0; y < 64; y += 2)
    for (uint32_t x = 0; x < 64; x += 2) texture.pixel(x, y)[3] = 255;
  Mesh mesh = textured_square(texture);
  mesh.materials[0].alpha_cutoff = 0.24F;
  EXPECT_EQ(voxels_of(mesh, 8).codes.size(), 64U);
  mesh.materials[0].alpha_cutoff = 0.26F;
  const Grid grid(bounds_of(mesh.positions), 8);
  const auto none = voxelize(mesh, grid, 1, Limits());
  ASSERT_FALSE(none.ok());
  EXPECT_EQ(none.error().code, Errc::bad_argument);
  EXPECT_EQ(none.error().text, "all of the surface is transparent");
}

TEST(Voxelize, OpaqueSurfaceStaysWhateverLiesOnIt) {
  Mesh mesh = half_there();
  for (uint8_t& sample : mesh.textures[0].samples) sample = 0;
  mesh.materials.push_back({.colour = {0, 0, 1}});
  for (size_t t = 0; t < 2; ++t) {
    mesh.triangles.push_back(mesh.triangles[t]);
    mesh.material_of.push_back(1);
  }
  const SurfaceVoxels voxels = voxels_of(mesh, 16);
  EXPECT_EQ(voxels.codes.size(), 16U * 16);
  for (const Rgba8& colour : voxels.colours) EXPECT_EQ(colour, (Rgba8{0, 0, 255, 255}));
}

TEST(Voxelize, TrianglesWithoutAreaAreTheLinesAndPointsThatTheyAre) {
  Mesh mesh;
  mesh.materials.push_back({.colour = {1, 0, 0}});
  mesh.positions = {{0, 0, 0}, {8, 8, 8}, {4, 4, 4}, {8, 0, 0}};
  add_triangle(mesh, 0, 1, 2);  // a line: the diagonal
  add_triangle(mesh, 0, 1, 1);  // the same with a corner twice
  add_triangle(mesh, 3, 3, 3);  // a point, in the corner of the cube
  const SurfaceVoxels voxels = voxels_of(mesh, 8);
  std::set<uint64_t> expected = {codec::morton_code({7, 0, 0})};
  for (uint32_t i = 0; i < 8; ++i) expected.insert(codec::morton_code({i, i, i}));
  const std::set<uint64_t> found(voxels.codes.begin(), voxels.codes.end());
  // Where the diagonal passes through corners of voxels, their neighbours may be set too.
  EXPECT_TRUE(std::includes(found.begin(), found.end(), expected.begin(), expected.end()));
  for (const Rgba8& colour : voxels.colours) EXPECT_EQ(colour, (Rgba8{255, 0, 0, 255}));
  for (const glm::vec3& normal : voxels.normals) EXPECT_EQ(normal, glm::vec3(0));
}

TEST(Voxelize, TrianglesWithoutAreaMakeNoHoles) {
  // A long side of each face with a needle of no area beside it.
  Mesh mesh = box_mesh({-1, -1, -1}, {1, 1, 1});
  const SurfaceVoxels before = voxels_of(mesh, 32);
  const size_t triangles = mesh.triangles.size();
  for (size_t t = 0; t < triangles; ++t) {
    const glm::uvec3 v = mesh.triangles[t];
    const auto middle = static_cast<uint32_t>(mesh.positions.size());
    mesh.positions.push_back((mesh.positions[v.x] + mesh.positions[v.y]) / 2.0F);
    mesh.triangles[t] = {v.x, middle, v.z};
    add_triangle(mesh, middle, v.y, v.z);
    add_triangle(mesh, v.x, v.y, middle);
  }
  EXPECT_EQ(voxels_of(mesh, 32).codes, before.codes);
}

}  // namespace
}  // namespace afx
