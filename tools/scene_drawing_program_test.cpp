// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The program draws scenes: what is in them, what their Inlines name, what depends on the viewer.
#include "tools/program_fixture.h"

namespace afx::tools {
namespace {

/// One voxel, two, three.
constexpr const char* kOne = "OctreeImage { octreeResolution 2 octree 1 } ";
constexpr const char* kTwo = "OctreeImage { octreeResolution 2 octree 129 } ";
constexpr const char* kThree = "OctreeImage { octreeResolution 2 octree 131 } ";

class SceneDrawing : public Program {
 protected:
  void write_scene(const std::string& name, const std::string& children) const {
    write_file(file(name), "#VRML V2.0 utf8\nGroup { children [ " + children + "] }\n");
  }
  /// Draws it and tells how many voxels that were.
  [[nodiscard]] int voxels(const std::string& name, const std::string& options = {}) const {
    const auto json = result("render " + name + " -o v.png -f --size 16x16 " + options);
    return json.is_object() ? json.value("voxels", -1) : -1;
  }
  [[nodiscard]] Outcome draw(const std::string& name, const std::string& options = {}) const {
    return run("render " + name + " -o v.png -f --size 16x16 " + options);
  }
};

TEST_F(SceneDrawing, SaysWhatItIsMadeOf) {
  write_scene("s.wrl", std::string(kTwo) +
                           "DepthImage { diTexture SimpleTexture { texture PixelTexture { image 2 "
                           "1 1 9 9 } depth PixelTexture { image 2 1 1 1 255 } } } Shape { "
                           "geometry Box {} } Shape { geometry IndexedLineSet { coord Coordinate { "
                           "point [ 0 0 0, 1 0 0 ] } coordIndex [ 0 1 ] } } Shape { geometry "
                           "PointSet { coord Coordinate { point [ 0 0 0, 1 1 1, 2 2 2 ] } } }");
  const Outcome outcome = draw("s.wrl");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.err, "v.png: 16 x 16, 2 voxels, 5 points, 12 triangles and 1 line\n");
}

TEST_F(SceneDrawing, ShapesAloneAreEnough) {
  write_scene("s.wrl", "Shape { geometry Sphere {} }");
  EXPECT_THAT(draw("s.wrl").err, HasSubstr(" triangles\n"));
  write_scene("e.wrl", "Background { skyColor 1 0 0 }");
  const Outcome nothing = draw("e.wrl");
  EXPECT_EQ(nothing.code, 3);
  EXPECT_EQ(nothing.err,
            "afx: e.wrl: the scene shows nothing to draw (expected a DepthImage, an OctreeImage or "
            "a Shape)\n");
}

TEST_F(SceneDrawing, OfALodItShowsTheLevelForItsCamera) {
  const auto lod = [](const std::string& range) {
    return "LOD { range " + range + " level [ " + kOne + kTwo + "] } ";
  };
  // The cube of side 1 fills the picture from some 3 units away.
  write_scene("near.wrl", lod("100"));
  write_scene("far.wrl", lod("0.5"));
  EXPECT_EQ(voxels("near.wrl"), 1);
  EXPECT_EQ(voxels("far.wrl"), 2);
  write_scene("empty.wrl", "LOD { range 0.5 level [ Group {} " + std::string(kThree) + "] }");
  EXPECT_EQ(voxels("empty.wrl"), 3);
}

TEST_F(SceneDrawing, BillboardsTurnToTheCamera) {
  write_scene("turned.wrl", "Billboard { children " + std::string(kTwo) + "}");
  write_scene("fixed.wrl", kTwo);
  ASSERT_EQ(run("render turned.wrl -o turned.png --size 16x16 --azimuth 40").code, 0);
  ASSERT_EQ(run("render fixed.wrl -o fixed.png --size 16x16 --azimuth 40").code, 0);
  EXPECT_NE(read_file(file("turned.png")), read_file(file("fixed.png")));
  // From the front there is nothing to turn: the camera stands on the z axis.
  write_scene("box.wrl", "OctreeImage { octreeResolution 2 octree 255 }");
  write_scene("turned_box.wrl",
              "Billboard { children OctreeImage { octreeResolution 2 octree 255 } }");
  const std::string front = " --size 16x16 --azimuth 0 --elevation 0";
  ASSERT_EQ(run("render box.wrl -o box.png" + front).code, 0);
  ASSERT_EQ(run("render turned_box.wrl -o turned_box.png" + front).code, 0);
  EXPECT_EQ(read_file(file("box.png")), read_file(file("turned_box.png")));
}

TEST_F(SceneDrawing, ATurntableIsReadForEachOfItsCameras) {
  // It is 5 units from the first camera and 3 from the second, which stands at (0, 0, -4).
  write_scene("s.wrl", "Transform { translation 0 0 -1 children LOD { range 4 level [ " +
                           std::string(kOne) + kTwo + "] } }");
  const std::string camera = " --position 0,0,4 --look-at 0,0,0";
  EXPECT_EQ(voxels("s.wrl", camera), 2);
  const auto turned = result("render s.wrl --size 16x16 --turntable 2 -o t_%d.png" + camera);
  EXPECT_EQ(turned["voxels"], 1);  // of the last
}

TEST_F(SceneDrawing, WarningsOfTheViewersSceneAreSaidToo) {
  write_scene("s.wrl", "LOD { range 0.5 level [ " + std::string(kOne) + "Group { children [ " +
                           kTwo + "Shape { geometry Text {} } ] } ] }");
  EXPECT_THAT(draw("s.wrl").err, HasSubstr("shapes that are not shown: 1 (1 of Text)"));
  EXPECT_EQ(draw("s.wrl", "--strict").code, 3);
}

TEST_F(SceneDrawing, InlinesNameScenesOfAnyKindRelativeToTheirFile) {
  fs::create_directory(file("sub"));
  write_scene("plain.wrl", kTwo);
  ASSERT_EQ(run("encode plain.wrl -o sub/two.mp4 -q").code, 0);
  write_scene("sub/three.bt", kThree);
  write_scene("sub/both.wrl", "Inline { url \"two.mp4\" } Inline { url \"three.bt\" } ");
  write_scene("s.wrl", std::string(kOne) + "Inline { url [ \"not.wrl\" \"sub/both.wrl\" ] }");
  EXPECT_EQ(voxels("s.wrl", "--strict"), 6);
  // The level of a LOD that is seen later has its stream still.
  write_scene("late.wrl", "LOD { range 0.5 level [ " + std::string(kOne) +
                              "Inline { url \"sub/two.mp4\" } ] }");
  EXPECT_EQ(voxels("late.wrl", "--strict"), 2);
}

TEST_F(SceneDrawing, WhatAnInlineCannotShowIsAWarning) {
  write_scene("a.wrl", std::string(kOne) + "Inline { url \"./a.wrl\" }");
  EXPECT_THAT(draw("a.wrl").err, HasSubstr("Inline: a.wrl inlines itself\n"));
  write_scene("b.wrl", std::string(kOne) + "DEF I Inline { url \"no.wrl\" }");
  EXPECT_THAT(draw("b.wrl").err, HasSubstr("Inline \"I\": no.wrl: "));
  write_file(file("bad.wrl"), "#VRML V2.0 utf8\nGroup { children [ }\n");
  write_scene("c.wrl", std::string(kOne) + "Inline { url \"bad.wrl\" }");
  EXPECT_THAT(draw("c.wrl").err, HasSubstr("Inline: bad.wrl:2:"));
  write_file(file("t.obj"), kTwoTriangles);
  write_scene("d.wrl", std::string(kOne) + "Inline { url \"t.obj\" }");
  EXPECT_THAT(draw("d.wrl").err, HasSubstr("Inline: t.obj is "));
  EXPECT_EQ(draw("d.wrl").code, 0);
}

TEST_F(SceneDrawing, ShapesAndInlinesAreLeftOutOfModelsAlone) {
  write_scene("in.wrl", kTwo);
  write_scene("s.wrl", std::string(kOne) + "Shape { geometry Box {} } Inline { url \"in.wrl\" }");
  EXPECT_EQ(draw("s.wrl").err, "v.png: 16 x 16, 3 voxels and 12 triangles\n");
  const Outcome built = run("build s.wrl -o m.wrl --resolution 4");
  EXPECT_THAT(built.err, HasSubstr("1 Shape is left out: a model is made of DepthImages and "
                                   "OctreeImages"));
  EXPECT_THAT(built.err, HasSubstr("1 Inline is left out"));
}

}  // namespace
}  // namespace afx::tools
