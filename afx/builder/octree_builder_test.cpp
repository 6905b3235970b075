// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/octree_builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <random>
#include <string>
#include <utility>

#include "afx/builder/test_meshes.h"
#include "afx/octree_colours.h"
#include "afx/reference_projection.h"
#include "afx/surfel_sources.h"
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
    EXPECT_EQ(middle_of(built.model.images[k].picture), expected[k]) << built.names[k];
    EXPECT_EQ(built.names[k], reference_name(static_cast<unsigned>(k)));
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
  EXPECT_EQ(built.model.images.size(), 1U);  // the others, which no voxel takes, are left out
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

// A floor and a roof with a column between: no side shows what of them faces the other. Each of the
// three has a colour of its own on each side.
Mesh pavilion() {
  Mesh mesh;
  for (const auto& [low, high] :
       {std::pair(glm::vec3(-1, -0.4F, -1), glm::vec3(1, -0.3F, 1)),
        std::pair(glm::vec3(-1, 0.3F, -1), glm::vec3(1, 0.4F, 1)),
        std::pair(glm::vec3(-0.1F, -0.3F, -0.1F), glm::vec3(0.1F, 0.3F, 0.1F))}) {
    const Mesh box = box_mesh(low, high);
    const auto first = static_cast<uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), box.positions.begin(), box.positions.end());
    for (uint32_t i = 0; i < 12; ++i) {
      const auto part = static_cast<float>(mesh.materials.size());
      if (i % 2 == 0)
        mesh.materials.push_back({.colour = {part / 18, std::fmod(part, 5.0F) / 4, 0.5F}});
      mesh.triangles.push_back(box.triangles[i] + first);
      mesh.material_of.push_back(static_cast<uint32_t>(mesh.materials.size() - 1));
    }
  }
  mesh.has_colours = true;
  return mesh;
}

TEST(BuildOctree, AddsImagesUntilTheOutsideIsSeen) {
  const BuiltOctree six = build(pavilion(), {.resolution = 64, .images = 6});
  const BuiltOctree more = build(pavilion(), {.resolution = 64});
  EXPECT_LE(six.model.images.size(), 6U);
  EXPECT_GT(more.model.images.size(), 6U);
  const auto unseen = [](const BuiltOctree& built) {
    return built.statistics.exposed - built.statistics.seen;
  };
  EXPECT_GT(unseen(six), six.statistics.exposed / 10);
  EXPECT_LT(unseen(more), unseen(six));
  EXPECT_GT(more.statistics.psnr, six.statistics.psnr + 10);
  const BuiltOctree all = build(pavilion(), {.resolution = 64, .images = 40});
  EXPECT_LT(unseen(all), unseen(six) / 8);
  EXPECT_LE(all.model.images.size(), 40U);
  ASSERT_EQ(all.names.size(), all.model.images.size());
  const auto first = std::find(all.names.begin(), all.names.end(), "view07");
  ASSERT_NE(first, all.names.end());
  for (auto name = first; name != all.names.end(); ++name)
    EXPECT_EQ(*name, reference_name(6 + static_cast<unsigned>(name - first)));
}

TEST(BuildOctree, SaysWhatADecoderMakesOfItsColours) {
  const BuiltOctree built = build(pavilion(), {.resolution = 64});
  Diagnostics diagnostics;
  const auto coloured = colour_octree(built.model, 6, 1, Limits(), diagnostics);
  ASSERT_TRUE(coloured.ok()) << coloured.error().text;
  EXPECT_EQ(diagnostics.count(), 0U);  // none falls outside of its cropped image
  EXPECT_EQ(coloured.value().codes.size(), built.statistics.voxels);
  EXPECT_GE(built.statistics.psnr, built.statistics.best_psnr - 0.2);
}

TEST(BuildOctree, LosesLittleForFarFewerSymbols) {
  Mesh mesh = sphere_mesh(4);
  for (const glm::vec3& p : mesh.positions)  // colours that no two images show alike
    mesh.colours.emplace_back(0.5F + 0.4F * p.x * p.y, 0.5F + 0.4F * p.z, 0.5F - 0.4F * p.x);
  const BuiltOctree best = build(mesh, {.resolution = 100, .symbol_price = 0});
  const BuiltOctree usual = build(mesh, {.resolution = 100});
  const BuiltOctree dear = build(mesh, {.resolution = 100, .symbol_price = kSymbolPrice});
  // Beyond 70 dB, a component in 150 wrong by one, there is nothing to lose.
  EXPECT_GT(usual.statistics.psnr, std::min(best.statistics.psnr, 70.0) - 0.2);
  EXPECT_LT(2 * usual.statistics.index_symbols, best.statistics.index_symbols);
  EXPECT_LE(dear.statistics.index_symbols, usual.statistics.index_symbols);
}

TEST(BuildOctree, CropsImagesToWhatVoxelsTake) {
  const BuiltOctree built = build(pavilion(), {.resolution = 64});
  uint64_t used = 0, all = 0;
  for (size_t k = 0; k < built.model.images.size(); ++k) {
    const Picture& picture = built.model.images[k].picture;
    ASSERT_EQ(built.used[k].size(), size_t{picture.width} * picture.height);
    used += static_cast<uint64_t>(std::count(built.used[k].begin(), built.used[k].end(), true));
    all += built.used[k].size();
  }
  EXPECT_EQ(built.statistics.used_pixels, used);
  EXPECT_EQ(built.statistics.pixels, all);
  // From the front: 64 wide, and 0.8 of 2 high (26 voxels, or one more with both ends).
  EXPECT_EQ(built.names[0], "front");
  EXPECT_EQ(built.model.images[0].picture.width, 64U);
  EXPECT_LE(built.model.images[0].picture.height, 27U);
}

TEST(BuildOctree, GivesTheSameForAnyNumberOfThreads) {
  const BuiltOctree one = build(pavilion(), {.resolution = 50, .threads = 1});
  const BuiltOctree four = build(pavilion(), {.resolution = 50, .threads = 4});
  EXPECT_EQ(one.model.fields, four.model.fields);
  EXPECT_EQ(one.names, four.names);
  for (size_t k = 0; k < one.names.size(); ++k)
    EXPECT_EQ(one.model.images[k].picture.samples, four.model.images[k].picture.samples);
}

TEST(BuildOctree, SaysWhereTheModelLay) {
  const Mesh mesh = box_mesh({10, 20, 30}, {14, 22, 33}, {1, 0, 0});
  const BuiltOctree built = build(mesh, {.resolution = 8});
  EXPECT_NEAR(built.statistics.side, 4, 1e-9);
  EXPECT_NEAR(built.statistics.centre.x, 12, 1e-9);
  EXPECT_NEAR(built.statistics.centre.y, 21, 1e-9);
  EXPECT_NEAR(built.statistics.centre.z, 31.5, 1e-9);
}

TEST(BuildOctree, DrawsImagesOfOtherSizes) {
  for (const uint32_t size : {1U, 7U, 16U, 100U}) {
    const BuiltOctree built = build(dice(), {.resolution = 32, .image_size = size});
    for (const ReferenceImage& image : built.model.images) {
      EXPECT_LE(image.picture.width, size);
      EXPECT_NEAR(image.picture.width / double{image.field_of_view.x}, size, 1e-3);
    }
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

// The centres of voxels as points, in a cube that is elsewhere and far away.
PointCloud centres_of(const std::vector<uint64_t>& codes, unsigned levels, const Cube& cube) {
  PointCloud cloud;
  cloud.origin = {1e6, -2e6, 3e6};
  for (const uint64_t code : codes) {
    const glm::dvec3 p = voxel_centre(code, levels) * cube.side;
    cloud.positions.emplace_back(cube.centre + p - cloud.origin);
    cloud.colours.push_back({static_cast<uint8_t>(code), 9, 9, 255});
  }
  return cloud;
}

TEST(BuildOctree, FindsTheVoxelsAgainWhoseCentresItIsGiven) {
  std::mt19937 random(7);
  for (const uint32_t resolution : {1U, 3U, 100U, 256U}) {
    const unsigned levels = octree_levels(resolution);
    std::vector<uint64_t> codes;
    for (int n = 0; n < 500; ++n) codes.push_back(random() % (uint64_t{1} << (3 * levels)));
    std::sort(codes.begin(), codes.end());
    codes.erase(std::unique(codes.begin(), codes.end()), codes.end());
    BuildOptions options{.resolution = resolution};
    options.cube = Cube{{1e6 + 3, -2e6 - 0.7, 3e6}, 5.3};
    Diagnostics diagnostics;
    const auto built = build_octree(centres_of(codes, levels, *options.cube), options, diagnostics);
    ASSERT_TRUE(built.ok()) << built.error().text;
    EXPECT_EQ(diagnostics.count(), 0U);
    EXPECT_EQ(built.value().model.resolution, resolution);
    EXPECT_EQ(built.value().model.fields.octree, codec::octree_from_morton(codes, levels));
    EXPECT_NEAR(built.value().statistics.side, 5.3, 1e-12);
    EXPECT_NEAR(glm::length(built.value().statistics.centre - options.cube->centre), 0, 1e-9);
  }
}

// The scene's own way from one form to the other: colours and octree stay.
TEST(BuildOctree, OfThePiecesOfAnOctreeInItsCubeIsTheSameOctree) {
  const BuiltOctree first = build(pavilion(), {.resolution = 50});
  Diagnostics diagnostics;
  const auto surfels = surfels_of(first.model, 2, {}, diagnostics);
  ASSERT_TRUE(surfels.ok());
  BuildOptions options{.resolution = 50};
  options.cube = Cube{{0, 0, 0}, 1};
  const auto again = build_octree(surfels.value(), options, diagnostics);
  ASSERT_TRUE(again.ok()) << again.error().text;
  EXPECT_EQ(again.value().model.fields.octree, first.model.fields.octree);
  EXPECT_EQ(diagnostics.count(), 0U);
}

TEST(BuildOctree, LeavesOutWhatLiesOutsideOfTheCube) {
  BuildOptions options{.resolution = 16};
  options.cube = Cube{{1, 1, 1}, 2};  // one corner of the dice
  Diagnostics diagnostics;
  const auto built = build_octree(dice(), options, diagnostics);
  ASSERT_TRUE(built.ok()) << built.error().text;
  ASSERT_EQ(diagnostics.warnings().size(), 1U);
  EXPECT_EQ(diagnostics.warnings()[0].code, "outside_cube");
  EXPECT_EQ(diagnostics.warnings()[0].text,
            "12 triangles reach out of the cube; what lies outside is left out");
  // Three squares of 8 voxels a side at 8 voxels from the corner of the cube, and their edges.
  EXPECT_EQ(built.value().statistics.voxels, 9U * 9 * 9 - 8U * 8 * 8);
  PointCloud cloud;
  cloud.positions = {{1, 1, 1}, {9, 9, 9}};
  Diagnostics of_points;
  ASSERT_TRUE(build_octree(cloud, options, of_points).ok());
  ASSERT_EQ(of_points.warnings().size(), 1U);
  EXPECT_EQ(of_points.warnings()[0].text,
            "1 points lie outside of the cube; what lies outside is left out");
}

TEST(BuildOctree, OfPiecesKeepsWhatLiesInTheCubeToTheLastDigit) {
  const double far = 1e9, end = std::nextafter(far + 8, 0.0);  // single precision has far + 64 next
  Surfels surfels;
  surfels.push_back({far + 0.5, 0.5, 0.5}, {}, {}, {9, 9, 9, 255});
  surfels.push_back({end, 7.5, 7.5}, {}, {}, {9, 9, 9, 255});
  surfels.push_back({far + 8.5, 4, 4}, {}, {}, {9, 9, 9, 255});
  surfels.push_back({far - 3, 4.5, 4.5}, {3.5F, 0, 0}, {0, 0.4F, 0}, {9, 9, 9, 255});
  BuildOptions options{.resolution = 8};
  options.cube = Cube{{far + 4, 4, 4}, 8};
  Diagnostics diagnostics;
  const auto built = build_octree(surfels, options, diagnostics);
  ASSERT_TRUE(built.ok()) << built.error().text;
  EXPECT_EQ(built.value().statistics.voxels, 3U);
  ASSERT_EQ(diagnostics.warnings().size(), 1U);
  EXPECT_EQ(diagnostics.warnings()[0].code, "outside_cube");
  EXPECT_EQ(diagnostics.warnings()[0].text,
            "2 samples reach out of the cube; what lies outside is left out");
}

TEST(BuildOctree, OfPiecesNeedsOneThatCanBeSeen) {
  Surfels surfels;
  surfels.push_back({1, 2, 3}, {}, {}, {9, 9, 9, 0});
  Diagnostics diagnostics;
  BuildOptions options{.resolution = 8};
  const auto text = [&] {
    const auto built = build_octree(surfels, options, diagnostics);
    return built.ok() ? std::string() : built.error().text;
  };
  EXPECT_EQ(text(), "nothing of the model can be seen");
  surfels.push_back({1, 2, 3}, {2000, 0, 0}, {0, 2000, 0}, {});  // endless for a cube of 8
  EXPECT_EQ(text(), "nothing of the model can be seen");
  options.cube = Cube{{9000, 9000, 9000}, 8};
  EXPECT_EQ(text(), "nothing of the model lies in the cube");
  EXPECT_EQ(diagnostics.count(), 0U);
}

TEST(BuildOctree, RefusesWhatItCannotBuild) {
  Diagnostics diagnostics;
  const auto text_of = [&](const auto& input, const BuildOptions& options) {
    const auto built = build_octree(input, options, diagnostics);
    return built.ok() ? std::string() : built.error().text;
  };
  const auto text = [&](const BuildOptions& options) { return text_of(dice(), options); };
  EXPECT_EQ(text({.resolution = 0}), "the resolution is 0 (expected 1 to 2048)");
  EXPECT_EQ(text({.resolution = 2049}), "the resolution is 2049 (expected 1 to 2048)");
  EXPECT_EQ(text({.resolution = 8, .image_size = 5000}),
            "the image size is 5000 (expected at most 4096)");
  EXPECT_EQ(text_of(Mesh(), {.resolution = 8}), "the mesh has no triangles");
  EXPECT_EQ(text_of(PointCloud(), {.resolution = 8}), "the point cloud has no points");
  EXPECT_EQ(text_of(Surfels(), {.resolution = 8}), "the model has no samples");
  EXPECT_EQ(text({.resolution = 8, .images = 5}),
            "5 images (expected 6 to 127, or 0 for as many as are worth their bytes)");
  EXPECT_EQ(text({.resolution = 8, .images = 128}),
            "128 images (expected 6 to 127, or 0 for as many as are worth their bytes)");
  EXPECT_EQ(text({.resolution = 8, .symbol_price = -1}),
            "the price of an index symbol is -1.000000 (expected 0 or more)");
  EXPECT_EQ(text({.resolution = 8, .cube = Cube{{0, 0, 0}, 0}}),
            "the cube's side is 0.000000 (expected a length > 0)");
  EXPECT_EQ(text({.resolution = 8, .cube = Cube{{NAN, 0, 0}, 1}}),
            "the cube's centre is not finite");
  EXPECT_EQ(text({.resolution = 8, .cube = Cube{{9, 9, 9}, 1}}),
            "nothing of the model lies in the cube");
  BuildOptions small{.resolution = 64};
  small.limits.octree_nodes = 100;
  const auto many = build_octree(dice(), small, diagnostics);
  ASSERT_FALSE(many.ok());
  EXPECT_EQ(many.error().code, Errc::limit_exceeded);
  EXPECT_EQ(many.error().text,
            "the surface has more voxels than the limit (a lower resolution has fewer)");
}

TEST(BuildOctree, ImagesKeepToTheMemoryLimit) {
  Diagnostics diagnostics;
  const auto error = [&](BuildOptions options, uint64_t memory) {
    options.limits.memory = memory;
    const auto built = build_octree(dice(), options, diagnostics);
    return built.ok() ? Error{Errc::io, {}, "none"} : built.error();
  };
  const BuildOptions large{.resolution = 8, .image_size = 512};
  EXPECT_EQ(error(large, 27 * 512 * 512).text, "none");
  const Error drawing = error(large, 27 * 512 * 512 - 1);
  EXPECT_EQ(drawing.code, Errc::limit_exceeded);
  EXPECT_EQ(drawing.text,
            "to draw an image of 262144 pixels takes 7077888 bytes (expected at most 7077887)");
}

TEST(BuildOctree, ManyImagesKeepToTheMemoryLimitTogether) {
  PointCloud dust;  // everything hides something, so many views are taken
  std::mt19937 random(3);
  const auto next = [&random] { return static_cast<float>(random() % 32); };
  for (int n = 0; n < 12000; ++n) {
    const float x = next(), y = next(), z = next();
    dust.positions.emplace_back(x, y, z);
  }
  BuildOptions options{.resolution = 32, .image_size = 256, .images = 127, .symbol_price = 0};
  Diagnostics diagnostics;
  const auto built = build_octree(dust, options, diagnostics);
  ASSERT_TRUE(built.ok());
  const uint64_t bytes = 3 * built.value().statistics.pixels;
  options.limits.memory = bytes - 1;
  const auto refused = build_octree(dust, options, diagnostics);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().text, "a set of " + std::to_string(built.value().names.size()) +
                                      " images takes " + std::to_string(bytes) +
                                      " bytes (expected at most " + std::to_string(bytes - 1) +
                                      ")");
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
