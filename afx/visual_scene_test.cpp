// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/visual_scene.h"

#include <map>

#include "afx/shapes/shape_test_support.h"

namespace afx {
namespace {

/// Scenes by name, as an InlineLoader hands them out; counts what was loaded.
struct Library {
  std::map<std::string, std::string> texts;
  std::vector<std::string> loaded;

  InlineLoader loader() {
    return [this](std::span<const nodes::Url> urls, const UrlBase& base) -> Result<InlineScene> {
      const std::string name = base.folder + urls.front().text;
      loaded.push_back(name);
      if (!texts.contains(name)) return Error{Errc::io, Place::none(), name + " is not there"};
      return InlineScene{scene_of(texts[name]), UrlBase(base.folder), name};
    };
  }
};

struct Reading {
  VisualScene scene;
  Diagnostics diagnostics;
  std::string error;  // code and text
};

Reading read(const std::string& text, const VisualOptions& options = {},
             const Limits& limits = {}) {
  Reading out;
  const auto nodes = scene_of(text);
  auto scene = read_visual_scene(*nodes, UrlBase(""), options, limits, out.diagnostics);
  if (scene.ok())
    out.scene = std::move(scene).value();
  else
    out.error = std::string(to_string(scene.error().code)) + ": " + to_string(scene.error());
  return out;
}

VisualScene visual_scene(const std::string& text, const VisualOptions& options = {}) {
  Reading reading = read(text, options);
  EXPECT_EQ(reading.error, "");
  EXPECT_EQ(reading.diagnostics.count(), 0U);
  return std::move(reading.scene);
}

constexpr const char* kBox = "Shape { geometry Box {} } ";
using Numbers = std::vector<uint32_t>;

TEST(VisualScene, HasModelsAndShapesInTheirPlaces) {
  const VisualScene scene = visual_scene(
      "Group { children [ Transform { translation 1 2 3 children Shape { appearance Appearance { "
      "material Material { diffuseColor 1 0 0 } } geometry Sphere {} } } OctreeImage { "
      "octreeResolution 2 octree 1 } ] }");
  ASSERT_EQ(scene.shapes.size(), 1U);
  EXPECT_EQ(scene.shapes[0].to_world[3], glm::dvec4(1, 2, 3, 1));
  EXPECT_EQ(scene.shapes[0].look->diffuse, glm::vec3(1, 0, 0));
  EXPECT_FALSE(scene.shapes[0].geometry->indices.empty());
  ASSERT_EQ(scene.models.size(), 1U);
  EXPECT_NE(scene.models[0].octree(), nullptr);
  EXPECT_FALSE(scene.depends_on_viewer);
}

TEST(VisualScene, AnEmptySceneShowsNothing) {
  const VisualScene scene = visual_scene("Group {}");
  EXPECT_TRUE(scene.shapes.empty() && scene.models.empty() && scene.lights.empty());
  EXPECT_FALSE(scene.backdrop.has_value());
  EXPECT_FALSE(scene.fog.has_value());
  EXPECT_TRUE(scene.navigation.headlight);
}

TEST(VisualScene, WhatUseShowsAgainIsShared) {
  const VisualScene scene = visual_scene(
      "Group { children [ DEF S Shape { appearance DEF A Appearance { texture DEF T PixelTexture { "
      "image 1 1 1 9 } } geometry DEF G Box {} } USE S Shape { appearance USE A geometry Sphere {} "
      "} "
      "Shape { appearance Appearance { texture USE T } geometry USE G } ] }");
  ASSERT_EQ(scene.shapes.size(), 4U);
  EXPECT_EQ(scene.shapes[0].geometry, scene.shapes[1].geometry);
  EXPECT_EQ(scene.shapes[0].look, scene.shapes[2].look);
  EXPECT_NE(scene.shapes[0].geometry, scene.shapes[2].geometry);
  EXPECT_EQ(scene.shapes[0].geometry, scene.shapes[3].geometry);
  EXPECT_NE(scene.shapes[0].look, scene.shapes[3].look);
  EXPECT_EQ(scene.shapes[0].look->texture, scene.shapes[3].look->texture);
}

TEST(VisualScene, InstancesOfAProtoHaveTheirOwnGeometry) {
  const VisualScene scene = visual_scene(
      "PROTO P [ field SFVec3f s 1 1 1 ] { Shape { geometry Box { size IS s } } } "
      "Group { children [ DEF A P { s 2 2 2 } P {} USE A ] }");
  ASSERT_EQ(scene.shapes.size(), 3U);
  EXPECT_NEAR(volume_of(*scene.shapes[0].geometry), 8, 1e-5);
  EXPECT_NEAR(volume_of(*scene.shapes[1].geometry), 1, 1e-5);
  EXPECT_EQ(scene.shapes[0].geometry, scene.shapes[2].geometry);
}

TEST(VisualScene, LightsFallOnWhatTheyLight) {
  const VisualScene scene =
      visual_scene(std::string("Group { children [ ") + kBox + "Group { children [ " + kBox +
                   "DirectionalLight {} PointLight {} ] } DirectionalLight { on FALSE } ] }");
  ASSERT_EQ(scene.lights.size(), 2U);
  ASSERT_EQ(scene.shapes.size(), 2U);
  EXPECT_EQ(scene.shapes[0].lights, Numbers{1});
  EXPECT_EQ(scene.shapes[1].lights, (Numbers{0, 1}));
}

TEST(VisualScene, TheFirstOfEachIsBoundAndAllViewpointsListed) {
  const VisualScene scene = visual_scene(
      "Group { children [ Viewpoint { description \"a\" } Transform { rotation 0 1 0 "
      "1.5707963267948966 children Background { skyColor 1 0 0 } } Background { skyColor 0 1 0 } "
      "Fog {} "
      "Fog { visibilityRange 5 } NavigationInfo { speed 2 } NavigationInfo { speed 3 } Viewpoint { "
      "description \"b\" } ] }");
  ASSERT_EQ(scene.viewpoints.size(), 2U);
  EXPECT_EQ(scene.viewpoints[0].description, "a");
  ASSERT_TRUE(scene.backdrop.has_value());
  EXPECT_EQ(scene.backdrop->sky_colours[0], glm::vec3(1, 0, 0));
  expect_near(scene.backdrop->to_world * glm::dvec3(0, 0, -1), {-1, 0, 0});
  EXPECT_FALSE(scene.fog.has_value());
  EXPECT_EQ(scene.navigation.speed, 2);
}

TEST(VisualScene, UnknownGeometryIsOneWarning) {
  const Reading reading =
      read(std::string("Group { children [ Shape { geometry Text {} } ") + kBox +
           "Shape { geometry Text {} } Shape { geometry Extrusion {} } ] }");
  EXPECT_EQ(reading.scene.shapes.size(), 1U);
  ASSERT_EQ(reading.diagnostics.count(), 1U);
  EXPECT_EQ(reading.diagnostics.warnings()[0].code, "unknown_geometry");
  EXPECT_EQ(reading.diagnostics.warnings()[0].text,
            "shapes that are not shown: 3 (1 of Extrusion, 2 of Text)");
}

TEST(VisualScene, BadNodesAreErrors) {
  EXPECT_EQ(read("Shape { geometry DEF B Box { size -1 1 1 } }").error,
            "bad_argument: Box \"B\": field size is -1 1 1 (expected finite numbers, 0 or more)");
  EXPECT_EQ(read("Transform { scale inf 1 1 children DEF S Shape { geometry Box {} } }").error,
            "bad_argument: Shape \"S\": the matrix of its place has numbers beyond all size "
            "(expected at most 1e60)");
}

TEST(VisualScene, SizesAreLimited) {
  Limits limits;
  limits.memory = 100000;
  std::string spheres = "Group { children [ ";
  for (int i = 0; i < 9; ++i) spheres += "Shape { geometry Sphere {} } ";
  EXPECT_EQ(read(spheres + "] }", {}, limits).error.substr(0, 14), "limit_exceeded");
  std::string lights = "Group { children [ DEF L PointLight {} DEF S Shape { geometry Box {} } ";
  for (int i = 1; i < 400; ++i) lights += "USE L USE S ";
  limits.memory = 1000 * 512;  // a place of a node takes 512 bytes, a light on a shape 8
  EXPECT_EQ(read(lights + "] }", {}, limits).error,
            "limit_exceeded: 400 lights fall on 400 shapes, more than the limit");
  limits.memory = 700 * 512;
  EXPECT_EQ(read(lights + "] }", {}, limits).error,
            "limit_exceeded: the scene has more than 700 places of nodes");
  limits.memory = 1280000;
  EXPECT_EQ(read(lights + "] }", {}, limits).error, "");
}

TEST(VisualScene, HugeScalesAreErrors) {
  std::string text = "PointLight {}";
  for (int i = 0; i < 9; ++i)
    text = std::string("Transform { scale 1e38 1e38 1e38 children ").append(text).append(" }");
  EXPECT_EQ(read(text).error.substr(0, 24), "bad_argument: PointLight");
}

TEST(Inlines, StandWhereTheInlineStands) {
  Library library;
  library.texts["a.wrl"] =
      std::string("Transform { translation 0 1 0 children ") + kBox + "} OctreeImage {}";
  VisualOptions options;
  options.load_inline = library.loader();
  const VisualScene scene = visual_scene(
      "Group { children [ Transform { translation 1 0 0 children DEF I Inline { url \"a.wrl\" } } "
      "Transform { translation 2 0 0 children Inline { url \"a.wrl\" } } USE I ] }",
      options);
  ASSERT_EQ(scene.shapes.size(), 3U);
  EXPECT_EQ(scene.shapes[0].to_world[3], glm::dvec4(1, 1, 0, 1));
  EXPECT_EQ(scene.shapes[1].to_world[3], glm::dvec4(2, 1, 0, 1));
  EXPECT_EQ(scene.shapes[2].to_world[3], glm::dvec4(0, 1, 0, 1));
  EXPECT_EQ(scene.shapes[0].geometry, scene.shapes[1].geometry);
  ASSERT_EQ(scene.models.size(), 3U);
  EXPECT_EQ(scene.models[0].shape, scene.models[1].shape);
  EXPECT_EQ(scene.models[1].to_world[3], glm::dvec4(2, 0, 0, 1));
}

TEST(Inlines, SurroundingsStayOutsideAndLightsComeIn) {
  Library library;
  library.texts["a.wrl"] = std::string(
                               "Viewpoint {} Background {} Fog { visibilityRange 1 } "
                               "NavigationInfo { speed 9 } DirectionalLight {} PointLight {} ") +
                           kBox;
  VisualOptions options;
  options.load_inline = library.loader();
  const VisualScene scene =
      visual_scene(std::string("Group { children [ ") + kBox +
                       "Group { children [ Inline { url \"a.wrl\" } DirectionalLight {} ] } ] }",
                   options);
  EXPECT_TRUE(scene.viewpoints.empty());
  EXPECT_FALSE(scene.backdrop.has_value() || scene.fog.has_value());
  EXPECT_EQ(scene.navigation.speed, 1);
  ASSERT_EQ(scene.lights.size(), 3U);
  ASSERT_EQ(scene.shapes.size(), 2U);
  EXPECT_EQ(scene.shapes[0].lights, Numbers{1});  // the PointLight inside
  EXPECT_EQ(scene.shapes[1].lights, (Numbers{0, 1, 2}));
}

TEST(Inlines, WhatCannotBeLoadedIsAWarning) {
  const std::string text = "Group { children [ DEF I Inline { url \"no.wrl\" } Inline {} USE I ] }";
  const Reading none = read(text);
  ASSERT_EQ(none.diagnostics.count(), 1U);
  EXPECT_EQ(none.diagnostics.warnings()[0].text,
            "Inline \"I\": scenes that others name are not loaded");
  Library library;
  VisualOptions options;
  options.load_inline = library.loader();
  const Reading missing = read(text, options);
  ASSERT_EQ(missing.diagnostics.count(), 1U);
  EXPECT_EQ(missing.diagnostics.warnings()[0].code, "inline_not_shown");
  EXPECT_EQ(missing.diagnostics.warnings()[0].text, "Inline \"I\": no.wrl is not there");
  EXPECT_EQ(library.loaded.size(), 1U);
}

TEST(Inlines, AFileThatInlinesItselfIsAWarning) {
  Library library;
  library.texts["a.wrl"] = std::string(kBox) + "Inline { url \"b.wrl\" }";
  library.texts["b.wrl"] = std::string(kBox) + "DEF I Inline { url \"a.wrl\" }";
  VisualOptions options;
  options.load_inline = library.loader();
  options.file = "a.wrl";
  const Reading reading = read(library.texts["a.wrl"], options);
  EXPECT_EQ(reading.scene.shapes.size(), 2U);
  ASSERT_EQ(reading.diagnostics.count(), 1U);
  EXPECT_EQ(reading.diagnostics.warnings()[0].text, "Inline \"I\": a.wrl inlines itself");
  EXPECT_EQ(reading.diagnostics.warnings()[0].file, "b.wrl");
  options.file = "";  // not known: it is found a round later
  EXPECT_EQ(read(library.texts["a.wrl"], options).scene.shapes.size(), 3U);
}

TEST(Inlines, StandInEachOtherEightDeep) {
  Library library;
  for (int i = 0; i < 20; ++i)
    library.texts['s' + std::to_string(i)] =
        kBox + std::string("Inline { url \"s") + std::to_string(i + 1) + "\" }";
  VisualOptions options;
  options.load_inline = library.loader();
  const Reading reading = read(library.texts["s0"], options);
  EXPECT_EQ(reading.scene.shapes.size(), 9U);
  ASSERT_EQ(reading.diagnostics.count(), 1U);
  EXPECT_EQ(reading.diagnostics.warnings()[0].text, "Inline: it stands in more than 8 others");
}

TEST(Inlines, TheVisitsOfAllFilesAreLimitedTogether) {
  Library library;  // each shows the next 100 times: 100^8 boxes
  for (int i = 0; i < 8; ++i) {
    std::string text =
        "Group { children [ DEF I Inline { url \"s" + std::to_string(i + 1) + "\" } ";
    for (int k = 0; k < 99; ++k) text += "USE I ";
    library.texts['s' + std::to_string(i)] = text + "] }";
  }
  library.texts["s8"] = kBox;
  VisualOptions options;
  options.load_inline = library.loader();
  EXPECT_EQ(read(library.texts["s0"], options).error.substr(0, 14), "limit_exceeded");
}

TEST(Inlines, ErrorsAndWarningsNameTheFile) {
  Library library;
  library.texts["a.wrl"] = "Inline { url \"b.wrl\" }";
  library.texts["b.wrl"] = "Shape { geometry Sphere { radius -1 } }";
  library.texts["c.wrl"] =
      std::string("Shape { appearance Appearance { texture MovieTexture {} } geometry Box {} }");
  VisualOptions options;
  options.load_inline = library.loader();
  EXPECT_EQ(read("Inline { url \"a.wrl\" }", options).error,
            "bad_argument: b.wrl: Sphere: field radius is -1 (expected 0 or more)");
  const Reading warned = read("Inline { url \"c.wrl\" }", options);
  ASSERT_EQ(warned.diagnostics.count(), 1U);
  EXPECT_EQ(warned.diagnostics.warnings()[0].file, "c.wrl");
}

TEST(VisualSceneReader, ReadingForAnotherViewerReadsNothingAnew) {
  Library library;
  library.texts["a.wrl"] = "Billboard { children Shape { geometry Cone {} } }";
  VisualOptions options;
  options.load_inline = library.loader();
  const auto nodes = scene_of(
      "Group { children [ LOD { range 5 level [ Shape { appearance DEF A Appearance { texture "
      "MovieTexture {} } geometry Sphere {} } Shape { appearance USE A geometry Box {} } ] } "
      "OctreeImage "
      "{} Shape { geometry Text {} } Inline { url \"a.wrl\" } ] }");
  VisualSceneReader reader(*nodes, UrlBase(""), options, {});
  Diagnostics first, second;
  const auto near = reader.read(nodes::Viewer{{0, 0, 1}, {0, 1, 0}}, first);
  const auto far = reader.read(nodes::Viewer{{9, 0, 0}, {0, 1, 0}}, second);
  const auto again = reader.read(nodes::Viewer{{0, 0, 2}, {0, 1, 0}}, second);
  ASSERT_TRUE(near.ok() && far.ok() && again.ok());
  EXPECT_TRUE(near.value().depends_on_viewer);
  EXPECT_EQ(near.value().shapes[0].geometry, again.value().shapes[0].geometry);
  EXPECT_NE(near.value().shapes[0].geometry, far.value().shapes[0].geometry);
  EXPECT_EQ(near.value().shapes[0].look, far.value().shapes[0].look);
  EXPECT_EQ(near.value().models[0].shape, far.value().models[0].shape);
  EXPECT_EQ(near.value().shapes[1].geometry, far.value().shapes[1].geometry);
  // The Billboard in the Inline turns to the viewer.
  expect_near(glm::dvec3(near.value().shapes[1].to_world[2]), {0, 0, 1});
  expect_near(glm::dvec3(far.value().shapes[1].to_world[2]), {1, 0, 0});
  EXPECT_EQ(library.loaded.size(), 1U);
  EXPECT_EQ(first.count(), 2U);  // the texture, the text
  EXPECT_EQ(second.count(), 0U);
}

}  // namespace
}  // namespace afx
