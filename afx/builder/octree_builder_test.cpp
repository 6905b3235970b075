// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/octree_builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "afx/builder/test_meshes.h"
#include "afx/octree_colours.h"
#include "codec/octree_voxels.h"

namespace afx {
namespace {

BuiltOctree build_as_is(const Mesh& mesh, const BuildOptions& options) {
  Diagnostics diagnostics;
  auto built = build_octree(mesh, options, diagnostics);
  EXPECT_TRUE(built.ok()) << built.error().text;
  return std::move(built).value();
}

// Without light: most tests tell voxels by the colours of their materials.
BuiltOctree build(const Mesh& mesh, BuildOptions options) {
  options.shade = Shade::never;
  return build_as_is(mesh, options);
}

// A cube whose six sides have six colours.
Mesh dice() {
  Mesh mesh = box_mesh({-1, -1, -1}, {1, 1, 1});
  mesh.materials.clear();
  const glm::vec3 colours[6] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0, 1, 1}, {1, 0, 1}};
  for (const glm::vec3& colour : colours) mesh.materials.push_back({.colour = colour});
  for (uint32_t i = 0; i < 12; ++i) mesh.material_of[i] = i / 2;
  return mesh;
}

std::vector<uint8_t> middle_of(const Picture& picture) {
  const uint8_t* pixel = picture.pixel(picture.width / 2, picture.height / 2);
  return {pixel, pixel + 3};
}

TEST(BuildOctree, ShowsEachSideInItsImage) {
  const BuiltOctree built = build(dice(), {.resolution = 32});
  ASSERT_EQ(built.model.images.size(), 6U);
  // box_mesh lists its sides as -z, +z, -y, +y, -x, +x; images are front (+z), back, right (+x),
  // left, top, bottom.
  const std::vector<uint8_t> expected[6] = {{0, 255, 0},   {255, 0, 0},   {255, 0, 255},
                                            {0, 255, 255}, {255, 255, 0}, {0, 0, 255}};
  for (size_t k = 0; k < 6; ++k) {
    EXPECT_EQ(middle_of(built.model.images[k].picture), expected[k]) << kReferenceNames[k];
    EXPECT_EQ(built.model.images[k].picture.width, 32U);
  }
}

// The colours that whoever decodes the model gives to its voxels, against those of the mesh.
TEST(BuildOctree, ADecoderFindsTheColoursOfTheMesh) {
  const BuiltOctree built = build(dice(), {.resolution = 32});
  Diagnostics diagnostics;
  const auto coloured = colour_octree(built.model, 5, 1, Limits(), diagnostics);
  ASSERT_TRUE(coloured.ok()) << coloured.error().text;
  EXPECT_EQ(diagnostics.count(), 0U);
  ASSERT_EQ(coloured.value().codes.size(), 32U * 32 * 32 - 30U * 30 * 30);
  size_t sides = 0;
  for (size_t i = 0; i < coloured.value().codes.size(); ++i) {
    const Voxel v = codec::morton_decode(coloured.value().codes[i]);
    const int borders = (v.x % 31 == 0) + (v.y % 31 == 0) + (v.z % 31 == 0);
    if (borders != 1) continue;  // edges mix the colours of their sides
    ++sides;
    const Rgba8 colour = v.z == 31   ? Rgba8{0, 255, 0, 255}
                         : v.z == 0  ? Rgba8{255, 0, 0, 255}
                         : v.x == 31 ? Rgba8{255, 0, 255, 255}
                         : v.x == 0  ? Rgba8{0, 255, 255, 255}
                         : v.y == 31 ? Rgba8{255, 255, 0, 255}
                                     : Rgba8{0, 0, 255, 255};
    ASSERT_EQ(coloured.value().colours[i], colour) << v.x << ' ' << v.y << ' ' << v.z;
  }
  EXPECT_EQ(sides, 6U * 30 * 30);
  EXPECT_EQ(built.statistics.worst, 0U);
  EXPECT_EQ(built.statistics.psnr, 99);
}

TEST(BuildOctree, OneColourNeedsOneSymbol) {
  const BuiltOctree built = build(sphere_mesh(3), {.resolution = 64});
  EXPECT_EQ(built.model.fields.voxel_image_index.size(), 1U);
  EXPECT_EQ(built.statistics.index_symbols, 1U);
}

// Pairs of red and green in the image from the front.
size_t colours_of(const BuiltOctree& built) {
  std::map<std::string, int> counts;
  const Picture& front = built.model.images[0].picture;
  for (size_t i = 0; i < front.samples.size(); i += 3)
    ++counts[std::to_string(front.samples[i]) + ' ' + std::to_string(front.samples[i + 1])];
  return counts.size();
}

TEST(BuildOctree, ShadesWhatHasNoColours) {
  Mesh mesh = sphere_mesh(3);
  mesh.has_colours = false;
  const BuiltOctree shaded = build_as_is(mesh, {.resolution = 64});
  EXPECT_TRUE(shaded.statistics.shaded);
  EXPECT_GT(colours_of(shaded), 20U);
  const BuiltOctree flat = build_as_is(mesh, {.resolution = 64, .shade = Shade::never});
  EXPECT_FALSE(flat.statistics.shaded);
  EXPECT_EQ(colours_of(flat), 1U);
}

TEST(BuildOctree, ShadesPlainMaterialsInTheirColour) {
  Mesh mesh = sphere_mesh(3);
  mesh.materials[0].colour = {0, 1, 0};
  const BuiltOctree built = build_as_is(mesh, {.resolution = 64});
  EXPECT_TRUE(built.statistics.shaded);
  EXPECT_GT(colours_of(built), 20U);
  uint8_t brightest = 0;
  const Picture& front = built.model.images[0].picture;
  for (size_t i = 0; i < front.samples.size(); i += 3) {
    EXPECT_EQ(front.samples[i], 0);
    brightest = std::max(brightest, front.samples[i + 1]);
  }
  EXPECT_GE(brightest, 254);  // towards the light it is the colour itself
}

TEST(BuildOctree, PaintsNoLightOverTexturesAndColoursOfVerticesUnlessTold) {
  Mesh painted = sphere_mesh(3);
  painted.colours.assign(painted.positions.size(), glm::vec3(0, 1, 0));
  EXPECT_EQ(colours_of(build_as_is(painted, {.resolution = 64})), 1U);
  EXPECT_GT(colours_of(build_as_is(painted, {.resolution = 64, .shade = Shade::always})), 20U);
  Picture green(1, 1, 3);
  green.samples = {0, 255, 0};
  Mesh textured = sphere_mesh(3);
  textured.textures.push_back(green);
  textured.texture_coords.resize(textured.positions.size());
  textured.materials.push_back({.texture = 0});  // which no triangle uses
  EXPECT_TRUE(build_as_is(textured, {.resolution = 64}).statistics.shaded);
  textured.material_of[5] = 1;
  EXPECT_FALSE(build_as_is(textured, {.resolution = 64}).statistics.shaded);
  PointCloud cloud;
  cloud.positions = painted.positions;
  cloud.colours.assign(cloud.positions.size(), Rgba8{0, 255, 0, 255});
  Diagnostics diagnostics;
  const auto points = build_octree(cloud, {.resolution = 64}, diagnostics);
  ASSERT_TRUE(points.ok());
  EXPECT_FALSE(points.value().statistics.shaded);
}

TEST(BuildOctree, GivesTheSameForAnyNumberOfThreads) {
  const BuiltOctree one = build(dice(), {.resolution = 50, .threads = 1});
  const BuiltOctree four = build(dice(), {.resolution = 50, .threads = 4});
  EXPECT_EQ(one.model.fields, four.model.fields);
  for (size_t k = 0; k < 6; ++k)
    EXPECT_EQ(one.model.images[k].picture.samples, four.model.images[k].picture.samples);
}

TEST(BuildOctree, TurnsZUpIntoYUp) {
  const BuiltOctree built = build(dice(), {.resolution = 16, .up = UpAxis::z});
  // What was +z (green) is now on top; what was -y (blue) faces +z.
  EXPECT_EQ(middle_of(built.model.images[4].picture), (std::vector<uint8_t>{0, 255, 0}));
  EXPECT_EQ(middle_of(built.model.images[0].picture), (std::vector<uint8_t>{0, 0, 255}));
}

TEST(BuildOctree, SaysWhereTheModelLay) {
  const Mesh mesh = box_mesh({10, 20, 30}, {14, 22, 33}, {1, 0, 0});
  for (const UpAxis up : {UpAxis::y, UpAxis::z}) {
    const BuiltOctree built = build(mesh, {.resolution = 8, .up = up});
    EXPECT_NEAR(built.statistics.side, 4, 1e-9);
    EXPECT_NEAR(built.statistics.centre.x, 12, 1e-9);
    EXPECT_NEAR(built.statistics.centre.y, 21, 1e-9);
    EXPECT_NEAR(built.statistics.centre.z, 31.5, 1e-9);
  }
}

TEST(BuildOctree, DrawsImagesOfOtherSizes) {
  for (const uint32_t size : {1U, 7U, 16U, 100U}) {
    const BuiltOctree built = build(dice(), {.resolution = 32, .image_size = size});
    EXPECT_EQ(built.model.images[3].picture.width, size);
    Diagnostics diagnostics;
    EXPECT_TRUE(colour_octree(built.model, 5, 1, Limits(), diagnostics).ok());
    if (size == 100) {
      EXPECT_EQ(built.statistics.worst, 0U);
    }
  }
}

TEST(BuildOctree, BuildsTheSmallestModels) {
  const BuiltOctree built = build(box_mesh({0, 0, 0}, {1, 1, 1}, {1, 0, 0}), {.resolution = 1});
  EXPECT_EQ(built.statistics.voxels, 1U);
  EXPECT_TRUE(built.model.fields.octree.empty());
  EXPECT_EQ(middle_of(built.model.images[0].picture), (std::vector<uint8_t>{255, 0, 0}));
  PointCloud cloud;
  cloud.positions = {{1, 2, 3}};
  cloud.colours = {{1, 2, 3, 255}};
  Diagnostics diagnostics;
  const auto point = build_octree(cloud, {.resolution = 2048, .image_size = 16}, diagnostics);
  ASSERT_TRUE(point.ok());
  EXPECT_EQ(point.value().statistics.voxels, 1U);
}

TEST(BuildOctree, BuildsPointClouds) {
  PointCloud cloud;
  for (int x = 0; x < 32; ++x)
    for (int y = 0; y < 32; ++y) {
      cloud.positions.emplace_back(x, y, 0);
      cloud.colours.push_back({static_cast<uint8_t>(x * 8), static_cast<uint8_t>(y * 8), 0, 255});
    }
  Diagnostics diagnostics;
  const auto built = build_octree(cloud, {.resolution = 32}, diagnostics);
  ASSERT_TRUE(built.ok()) << built.error().text;
  EXPECT_EQ(built.value().statistics.voxels, 1024U);
  const Picture& front = built.value().model.images[0].picture;
  EXPECT_EQ(front.pixel(5, 31 - 9)[0], 40);
  EXPECT_EQ(front.pixel(5, 31 - 9)[1], 72);
}

TEST(BuildOctree, RefusesWhatItCannotBuild) {
  Diagnostics diagnostics;
  const auto code = [&](const auto& input, const BuildOptions& options) {
    const auto built = build_octree(input, options, diagnostics);
    return built.ok() ? Errc::io : built.error().code;
  };
  EXPECT_EQ(code(dice(), {.resolution = 0}), Errc::bad_argument);
  EXPECT_EQ(code(dice(), {.resolution = 2049}), Errc::bad_argument);
  EXPECT_EQ(code(dice(), {.resolution = 8, .image_size = 5000}), Errc::bad_argument);
  EXPECT_EQ(code(Mesh(), {.resolution = 8}), Errc::bad_argument);
  EXPECT_EQ(code(PointCloud(), {.resolution = 8}), Errc::bad_argument);
  BuildOptions small{.resolution = 64};
  small.limits.octree_nodes = 100;
  EXPECT_EQ(code(dice(), small), Errc::limit_exceeded);
}

TEST(BuildOctree, ReportsProgressThatGrows) {
  std::vector<double> reported;
  BuildOptions options{.resolution = 100};
  options.progress = [&](const char*, double done) { reported.push_back(done); };
  build(sphere_mesh(2), options);
  EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
  EXPECT_EQ(reported.back(), 1);
}

}  // namespace
}  // namespace afx
