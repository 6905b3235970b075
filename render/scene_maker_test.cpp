// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/scene_maker.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>

#include "nodes/scene_reader.h"

namespace afx::render {
namespace {

/// Two voxels, at the lowest and the highest corner.
constexpr const char* kOctree = "OctreeImage { octreeResolution 2 octree 129 } ";
/// A picture of 2 x 1 pixels, both there.
constexpr const char* kImage =
    "DepthImage { diTexture SimpleTexture { texture PixelTexture { image 2 1 3 0xFF0000 0xFF } "
    "depth PixelTexture { image 2 1 1 1 255 } } } ";

nodes::Scene nodes_of(const std::string& text) {
  Diagnostics diagnostics;
  auto scene = nodes::read_scene_text(text, {}, diagnostics);
  EXPECT_TRUE(scene.ok()) << (scene.ok() ? "" : scene.error().text);
  return scene.ok() ? std::move(scene).value() : nodes::Scene();
}

VisualScene visual_scene(const std::string& text) {
  Diagnostics diagnostics;
  const nodes::Scene nodes = nodes_of(text);
  auto scene = read_visual_scene(nodes, UrlBase(""), {}, {}, diagnostics);
  EXPECT_TRUE(scene.ok()) << (scene.ok() ? "" : scene.error().text);
  return scene.ok() ? std::move(scene).value() : VisualScene();
}

Scene made(SceneMaker& maker, const VisualScene& from) {
  Diagnostics diagnostics;
  auto scene = maker.make(from, diagnostics);
  EXPECT_TRUE(scene.ok()) << (scene.ok() ? "" : scene.error().text);
  EXPECT_EQ(diagnostics.count(), 0U);
  return scene.ok() ? std::move(scene).value() : Scene();
}

Scene made(const std::string& text) {
  SceneMaker maker;
  return made(maker, visual_scene(text));
}

TEST(SceneMaker, OctreesBecomeTreesAndDepthImagesSurfelsInTheirPlaces) {
  const Scene scene =
      made("Group { children [ Transform { translation 1 2 3 children " + std::string(kOctree) +
           "} Transform { scale 2 2 2 children [ " + kImage + kImage + "] } ] }");
  ASSERT_EQ(scene.voxels.size(), 1U);
  EXPECT_EQ(scene.voxels[0].tree->voxels(), 2U);
  EXPECT_EQ(scene.voxels[0].local_to_world[3], glm::dvec4(1, 2, 3, 1));
  ASSERT_EQ(scene.surfels.size(), 2U);
  for (const SurfelCloud& cloud : scene.surfels) {
    EXPECT_EQ(cloud.surfels->size(), 2U);
    EXPECT_EQ(cloud.local_to_world[0][0], 2);
  }
  EXPECT_TRUE(check_scene(scene).ok());
}

TEST(SceneMaker, ShapesLightsAndSurroundingsComeAlong) {
  const Scene scene = made(
      "Group { children [ DirectionalLight { direction 0 -1 0 } Shape { geometry Box {} } Fog { "
      "visibilityRange 7 } Background { skyColor 0.5 0 1 } ] }");
  ASSERT_EQ(scene.shapes.size(), 1U);
  EXPECT_EQ(scene.shapes[0].geometry->indices.size(), 36U);
  EXPECT_EQ(scene.shapes[0].lights, std::vector<uint32_t>{0});
  ASSERT_EQ(scene.lights.size(), 1U);
  EXPECT_EQ(scene.lights[0].direction, glm::dvec3(0, -1, 0));
  EXPECT_TRUE(scene.headlight);
  ASSERT_TRUE(scene.fog.has_value());
  EXPECT_EQ(scene.fog->visibility_range, 7);
  ASSERT_TRUE(scene.backdrop.has_value());
  EXPECT_EQ(scene.backdrop->sky_colours[0], glm::vec3(0.5F, 0, 1));
}

TEST(SceneMaker, TheHeadlightIsOffWhereTheSceneSaysSo) {
  EXPECT_FALSE(made("NavigationInfo { headlight FALSE }").headlight);
}

TEST(SceneMaker, WhatUseShowsAgainIsMadeOnce) {
  const Scene scene = made("Group { children [ DEF O " + std::string(kOctree) + "USE O DEF D " +
                           kImage + "Transform { children USE D } " + kOctree + "] }");
  ASSERT_EQ(scene.voxels.size(), 3U);
  EXPECT_EQ(scene.voxels[0].tree, scene.voxels[1].tree);
  EXPECT_NE(scene.voxels[0].tree, scene.voxels[2].tree);
  ASSERT_EQ(scene.surfels.size(), 2U);
  EXPECT_EQ(scene.surfels[0].surfels, scene.surfels[1].surfels);
}

TEST(SceneMaker, OctreesAreMadeAtTheLevelAskedFor) {
  const VisualScene from = visual_scene("OctreeImage { octreeResolution 4 octree [ 129 255 1 ] }");
  const auto voxels = [&from](unsigned level) {
    SceneMaker maker({.level = level});
    const Scene scene = made(maker, from);
    return std::pair(scene.voxels.at(0).tree->level(), scene.voxels.at(0).tree->voxels());
  };
  EXPECT_EQ(voxels(0), std::pair(0U, size_t{1}));
  EXPECT_EQ(voxels(1), std::pair(1U, size_t{2}));
  EXPECT_EQ(voxels(2), std::pair(2U, size_t{9}));  // 8 of the first, 1 of the last
  EXPECT_EQ(voxels(32), std::pair(2U, size_t{9}));
}

TEST(SceneMaker, AReadingForAnotherViewerSharesWhatIsKnown) {
  const nodes::Scene nodes = nodes_of("Group { children [ LOD { range 5 level [ " +
                                      std::string(kOctree) + kImage + "] } " + kOctree + "] }");
  VisualSceneReader reader(nodes, UrlBase(""), {}, {});
  SceneMaker maker;
  const auto scene_from = [&](double distance) {
    Diagnostics diagnostics;
    auto visual = reader.read(nodes::Viewer{{0, 0, distance}, {0, 1, 0}}, diagnostics);
    EXPECT_TRUE(visual.ok());
    return made(maker, visual.value());
  };
  const Scene near = scene_from(1), far = scene_from(9), again = scene_from(2);
  ASSERT_EQ(near.voxels.size(), 2U);
  ASSERT_EQ(far.voxels.size(), 1U);
  EXPECT_EQ(far.voxels[0].tree, near.voxels[1].tree);
  EXPECT_EQ(far.surfels.size(), 1U);
  ASSERT_EQ(again.voxels.size(), 2U);
  EXPECT_EQ(again.voxels[0].tree, near.voxels[0].tree);
}

TEST(SceneMaker, WarnsOfAShapeOnce) {
  // Two voxels with one index, of an image without a picture.
  const nodes::Scene nodes = nodes_of(
      "OctreeImage { octreeResolution 2 octree 129 voxelImageIndex 1 images DepthImage {} }");
  VisualSceneReader reader(nodes, UrlBase(""), {}, {});
  SceneMaker maker;
  Diagnostics reading, first, second;
  const auto visual = reader.read({}, reading);
  ASSERT_TRUE(visual.ok());
  ASSERT_TRUE(maker.make(visual.value(), first).ok());
  ASSERT_TRUE(maker.make(visual.value(), second).ok());
  EXPECT_EQ(first.count(), 1U);
  EXPECT_EQ(second.count(), 0U);
}

TEST(SceneMaker, MemoryIsLimitedForAllTogetherAndComesBack) {
  const VisualScene one = visual_scene(kImage), other = visual_scene(kImage);
  Limits limits;
  limits.memory = 3 * kSurfelBytes;  // each has two
  SceneMaker maker({}, limits);
  Diagnostics diagnostics;
  {
    const VisualScene gone = visual_scene(kImage);
    EXPECT_TRUE(maker.make(gone, diagnostics).ok());
  }
  EXPECT_TRUE(maker.make(one, diagnostics).ok());
  EXPECT_TRUE(maker.make(one, diagnostics).ok());
  const auto refused = maker.make(other, diagnostics);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, Errc::limit_exceeded);
}

TEST(SceneMaker, AModelWithoutShapeIsAnError) {
  SceneMaker maker;
  Diagnostics diagnostics;
  const std::vector<DibrModel> models(1);
  const auto scene = maker.make(models, diagnostics);
  ASSERT_FALSE(scene.ok());
  EXPECT_EQ(scene.error().code, Errc::bad_argument);
}

}  // namespace
}  // namespace afx::render
