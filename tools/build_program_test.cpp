// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Runs of the program that build models in every form, convert them and compare them.
#include <gtest/gtest.h>

#include <cmath>

#include "afx/picture_io.h"
#include "tools/program_fixture.h"

namespace afx::tools {
namespace {

using nlohmann::json;

class BuildProgram : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    write_file(file("t.obj"), kTetrahedron);
  }
};

TEST_F(BuildProgram, EveryFormIsNearTheMesh) {
  for (const std::string form : {"depth", "points", "octree"}) {
    const std::string scene = form + ".wrl";
    (void)result("build t.obj -o " + scene + " --as " + form + " --resolution 64");
    // Half a voxel or pixel is 1/128 of the longest side.
    const json distance =
        result("compare t.obj " + scene + " --views 2 --size 64 --points 20000", 4);
    EXPECT_LT(distance.at("d1"), 1.0 / 64) << form;
    EXPECT_LT(distance.at("hausdorff"), 3.0 / 64) << form;
    EXPECT_GT(distance.at("psnr"), 20) << form;
    EXPECT_EQ(run("compare t.obj " + scene + " --views 0 --points 20000 --max-error d1=0.02").code,
              0);
    const Outcome beyond =
        run("compare t.obj " + scene + " --views 0 --points 20000 --max-error d1=0.00001");
    EXPECT_EQ(beyond.code, 4);
    EXPECT_THAT(beyond.out, HasSubstr("beyond the limit: d1 is 0.0"));
    EXPECT_EQ(run("render " + scene + " --size 32x32 -o " + form + ".png").code, 0);
    EXPECT_EQ(run("encode " + scene + " -o " + form + ".mp4").code, 0);
    EXPECT_EQ(run("compare --exact " + scene + " " + form + ".mp4").code, 0) << form;
  }
}

TEST_F(BuildProgram, DepthImagesGoToPointsAndBackToTheSamePixels) {
  (void)result("build t.obj -o a.wrl --as depth --views 1 --resolution 40");
  (void)result("build a.wrl -o b.wrl --as depth --views a.wrl");
  EXPECT_EQ(read_file(file("a_view01_depth.png")), read_file(file("b_view01_depth.png")));
  EXPECT_EQ(read_file(file("a_view01.png")), read_file(file("b_view01.png")));
}

TEST_F(BuildProgram, PointTexturesGoToPointsAndBackEqual) {
  (void)result("build t.obj -o a.wrl --as points --resolution 40 --depth-bits 12");
  (void)result("build a.wrl -o b.wrl --as points --views a.wrl --depth-bits 12");
  EXPECT_EQ(run("compare --exact a.wrl b.wrl").code, 0);
}

TEST_F(BuildProgram, OctreesGoToPointsAndBackWithTheSameOctree) {
  (void)result("build t.obj -o a.wrl --resolution 50");
  (void)result("build a.wrl -o b.wrl");
  ASSERT_EQ(run("encode a.wrl -o a.afx").code, 0);
  ASSERT_EQ(run("encode b.wrl -o b.afx").code, 0);
  ASSERT_EQ(run("decode a.afx -o a.oct").code, 0);
  ASSERT_EQ(run("decode b.afx -o b.oct").code, 0);
  EXPECT_EQ(read_file(file("a.oct")), read_file(file("b.oct")));
  EXPECT_GT(read_file(file("a.oct")).size(), 100U);
}

TEST_F(BuildProgram, EveryFormConvertsIntoEveryOther) {
  for (const std::string from : {"depth", "points", "octree"}) {
    (void)result("build t.obj -o " + from + ".wrl --as " + from + " --resolution 48");
    for (const std::string to : {"depth", "points", "octree"}) {
      const std::string scene = from + "_" + to + ".wrl";
      (void)result("build " + from + ".wrl -o " + scene + " --as " + to + " --resolution 48");
      const json distance = result("compare t.obj " + scene + " --views 0 --points 20000", 4);
      EXPECT_LT(distance.at("d1"), 2.0 / 48) << scene;
    }
  }
}

TEST_F(BuildProgram, PointsComeOutOfEveryFormAndGoInAgain) {
  for (const std::string form : {"depth", "points", "octree"}) {
    (void)result("build t.obj -o a.wrl -f --as " + form + " --resolution 48");
    const json points = result("decode a.wrl -o " + form + ".ply");
    EXPECT_GT(points.at("points"), 1000) << form;
    EXPECT_EQ(result("compare a.wrl " + form + ".ply --views 0").at("d1"), 0) << form;
    (void)result("build " + form + ".ply -o b.wrl -f --as points --resolution 48");
    EXPECT_LT(result("compare t.obj b.wrl --views 0 --points 20000", 4).at("d1"), 2.0 / 48);
  }
  EXPECT_EQ(run("decode t.obj -o x.ply").err,
            "afx: t.obj: is a mesh (expected something sampled)\n");
}

TEST_F(BuildProgram, RgbdPicturesBecomeEveryForm) {
  // A wall 2 units before the camera, 1 unit wide for each 50 pixels: red left, blue right.
  Picture colour(40, 30, 3);
  DeepPicture depth{40, 30, 1, 16, std::vector<uint16_t>(1200, 2000)};
  for (uint32_t y = 0; y < 30; ++y)
    for (uint32_t x = 0; x < 40; ++x) colour.pixel(x, y)[x < 20 ? 0 : 2] = 255;
  depth.samples[0] = 0;
  const auto colours = encode_picture(colour, "png");
  const auto depths = encode_picture(depth, "png", {.colour = false});
  ASSERT_TRUE(colours.ok() && depths.ok());
  write_file(file("c.png"), {colours.value().begin(), colours.value().end()});
  write_file(file("d.png"), {depths.value().begin(), depths.value().end()});
  write_file(file("scan.json"), R"({"depthScale": 0.001, "fx": 100, "fy": 100, "cx": 19.5,
 "cy": 14.5, "frames": [{"colour": "c.png", "depth": "d.png",
 "pose": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]}]})");
  const json points = result("build scan.json -o p.wrl --as points --resolution 40");
  EXPECT_EQ(points.at("samples"), 1199);
  EXPECT_EQ(points.at("points"), 1199);
  const json octree = result("build scan.json -o o.wrl --as octree --resolution 40");
  EXPECT_NEAR(octree.at("voxels").get<double>(), 1199, 100);  // about a voxel for each pixel
  const json depth_images = result("build scan.json -o d.wrl --as depth --views p.wrl");
  EXPECT_EQ(depth_images.at("usedPixels"), 1199);
  write_file(file("bad.json"), R"({"frames": []})");
  EXPECT_EQ(run("build bad.json -o x.wrl").err,
            "afx: bad.json: frames is not a list of one frame or more\n");
}

TEST_F(BuildProgram, ViewsAreANumberAutomaticOrAFile) {
  EXPECT_EQ(result("build t.obj -o a.wrl --as depth --views 21 --resolution 16").at("views"), 21);
  const json automatic =
      result("build t.obj -o b.wrl --as depth --views auto --resolution 16 --perspective");
  EXPECT_GE(automatic.at("views"), 4);
  EXPECT_GT(automatic.at("coverage"), 0.99);
  write_file(file("c.json"), R"({"cameras": [{"position": [0, 0, 3], "fieldOfView": [2, 2],
 "nearPlane": 1, "farPlane": 4, "width": 10, "height": 12}]})");
  const json given = result("build t.obj -o c.wrl --as depth --views c.json");
  EXPECT_EQ(given.at("pixels"), 120);
  write_file(file("bad.json"), R"({"cameras": [{"width": 10}]})");
  EXPECT_EQ(run("build t.obj -o d.wrl --as depth --views bad.json").err,
            "afx: bad.json: cameras[0].position is missing\n");
  EXPECT_EQ(run("build t.obj -o d.wrl --as depth --views 256").err,
            "afx: --views is 256 (expected 1 to 255, auto or a file) (see 'afx build --help')\n");
}

TEST_F(BuildProgram, DepthMayStandInTheAlphaChannel) {
  const json alpha =
      result("build t.obj -o a.wrl --as depth --resolution 16 --depth-in-alpha --depth-bits 8");
  EXPECT_EQ(alpha.at("pictures"), 6);
  EXPECT_EQ(result("info a_front.png").at("components"), 4);
  (void)result("build t.obj -o b.wrl --as depth --resolution 16 --depth-bits 8");
  const json distance = result("compare a.wrl b.wrl --views 0", 4);  // other nodes, same model
  EXPECT_EQ(distance.at("d1"), 0);
  EXPECT_EQ(distance.at("colour"), nullptr);
}

TEST_F(BuildProgram, TheSameInputGivesTheSameBytesForAnyNumberOfThreads) {
  for (const std::string form : {"depth --views auto", "points", "octree"}) {
    for (const std::string& name : files())
      if (name.starts_with("one")) fs::remove(file(name));
    (void)result("build t.obj -o one.wrl --threads 1 --resolution 40 --as " + form);
    const auto once = contents();
    (void)result("build t.obj -o one.wrl -f --threads 3 --resolution 40 --as " + form);
    EXPECT_EQ(contents(), once) << form;
  }
}

TEST_F(BuildProgram, ATargetIsReachedOrTheErrorSaysWhatCanBe) {
  const std::string jpeg = "build t.obj -o a.wrl -f --resolution 64 --image-format jpeg ";
  const json psnr = result(jpeg + "--target-psnr 40");
  EXPECT_GE(psnr.at("imagePsnr"), 40);
  ASSERT_EQ(run("encode a.wrl -o a.afx").code, 0);
  const uint64_t bytes = psnr.at("imageBytes").get<uint64_t>() + fs::file_size(file("a.afx"));
  const json size = result(jpeg + "--target-size " + std::to_string(bytes));
  ASSERT_EQ(run("encode a.wrl -o a.afx -f").code, 0);
  EXPECT_LE(size.at("imageBytes").get<uint64_t>() + fs::file_size(file("a.afx")), bytes);
  EXPECT_GE(size.at("jpegQuality"), psnr.at("jpegQuality"));  // which is known to fit
  const Outcome small = run(jpeg + "--target-size 10");
  EXPECT_EQ(small.code, 2);
  EXPECT_THAT(small.err, HasSubstr("afx: t.obj: the octree alone takes "));
  EXPECT_THAT(small.err, HasSubstr("(expected a greater --target-size or less --resolution)"));
}

TEST_F(BuildProgram, ScaleFitAndUpPlaceTheModel) {
  (void)result("build t.obj -o a.wrl --as points --resolution 16 --fit 10");
  (void)result("build t.obj -o b.wrl --as points --resolution 16 --scale 10");
  EXPECT_EQ(run("build t.obj -o c.wrl --fit 10 --scale 10").code, 2);
  write_file(file("big.obj"),
             "v -5 -5 -5\nv 5 -5 -5\nv -5 5 -5\nv -5 -5 5\n"
             "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  EXPECT_LT(result("compare big.obj a.wrl --views 0", 4).at("d1"), 1.0 / 16);
  EXPECT_GT(result("compare big.obj b.wrl --views 0", 4).at("d1"), 0.3);
  // (x, -z, y) of the tetrahedron: what z up turns into it.
  write_file(file("z.obj"),
             "v 0 0 0\nv 1 0 0\nv 0 0 1\nv 0 -1 0\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  (void)result("build t.obj -o y.wrl --as points --resolution 16");
  (void)result("build z.obj -o z.wrl --as points --resolution 16 --up z");
  (void)result("build z.obj -o lying.wrl --as points --resolution 16");
  EXPECT_EQ(run("compare --exact y.wrl z.wrl").code, 0);
  EXPECT_EQ(run("compare --exact y.wrl lying.wrl").code, 4);
}

TEST_F(BuildProgram, OptionsOfOtherFormsAreUsageErrors) {
  for (const char* words :
       {"--views 6x --as octree", "--views 6", "--as depth --views 0", "--as points --views 6",
        "--as points --views auto", "--images 3", "--scale inf", "--depth-bits 8",
        "--as depth --depth-bits 9", "--as points --coverage", "--as depth --images 7",
        "--target-size 100", "--as depth --depth-in-alpha --image-format jpeg", "--cube 0 0 0 0",
        "--image-format jpeg --target-size 9 --target-psnr 9", "--resolution 4096"})
    EXPECT_EQ(run(std::string("build t.obj -o x.wrl ") + words).code, 2) << words;
  EXPECT_EQ(run("compare t.obj t.obj --max-error d3=1").code, 2);
  EXPECT_EQ(run("build t.obj -o x.wrl --as points --views auto").err,
            "afx: --views is auto (expected a file with one camera, the reference plane of --as "
            "points) (see 'afx build --help')\n");
  EXPECT_EQ(run("build t.obj -o x.wrl --images 3").err,
            "afx: --images is 3 (expected 0, or 6 to 127) (see 'afx build --help')\n");
}

TEST_F(BuildProgram, AModelIsTheSameAsItself) {
  const json same = result("compare t.obj t.obj --views 1 --size 32 --points 1000");
  EXPECT_EQ(same.at("same"), true);
  EXPECT_EQ(same.at("d1"), 0);
}

TEST_F(BuildProgram, CompareTellsTheSizesOfTheParts) {
  const json built = result("build t.obj -o a.wrl --resolution 32");
  const json sizes = result("compare t.obj a.wrl --views 0 --points 1000", 4);
  EXPECT_EQ(sizes.at("sizeA"), json({{"file", std::string(kTetrahedron).size()}}));
  EXPECT_EQ(sizes.at("sizeB").at("file"), built.at("sceneBytes"));
  EXPECT_EQ(sizes.at("sizeB").at("pictures"), built.at("imageBytes"));
  EXPECT_EQ(sizes.at("sizeB").at("octree"), built.at("octreeBytes"));
  EXPECT_EQ(sizes.at("sizeB").at("imageIndices"), built.at("voxelImageIndexSymbols"));
}

TEST_F(BuildProgram, MeshesAreDrawnAsTheyAre) {
  ASSERT_EQ(run("render t.obj -o p.png --size 40x30 --azimuth 30").code, 0);
  ASSERT_EQ(run("render t.obj -o q.png --size 40x30 --azimuth 30 --threads 1").code, 0);
  EXPECT_EQ(read_file(file("p.png")), read_file(file("q.png")));
}

}  // namespace
}  // namespace afx::tools
