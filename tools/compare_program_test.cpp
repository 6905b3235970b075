// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Runs of the program that compare models, or take models of any kind: verdicts, warnings and
// options.
#include "tools/program_fixture.h"

namespace afx::tools {
namespace {

class CompareProgram : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    write_file(file("t.obj"), kTetrahedron);
  }
};

TEST_F(CompareProgram, AVerdictStandsWhereNothingCanBeMeasured) {
  ASSERT_EQ(run("build t.obj -o a.wrl --as depth --views 1 --resolution 16").code, 0);
  ASSERT_EQ(run("build t.obj -o b.wrl --as depth --views 1 --resolution 20").code, 0);
  fs::remove(file("b_view01_depth.png"));
  const Outcome differ = run("compare a.wrl b.wrl --views 0");
  EXPECT_EQ(differ.code, 4);
  EXPECT_EQ(differ.out, "the scenes differ\n");
  EXPECT_THAT(differ.err, HasSubstr("b_view01_depth.png"));
  EXPECT_THAT(differ.err, HasSubstr("warning: how far apart the models are is not measured: "));
  EXPECT_EQ(run("compare a.wrl b.wrl --views 0 --max-error d1=1").code, 1);
}

TEST_F(CompareProgram, StandardInputIsMeasured) {
  ASSERT_EQ(run("build t.obj -o a.wrl --as points --resolution 16").code, 0);
  ASSERT_EQ(run("build t.obj -o b.wrl --as points --resolution 20").code, 0);
  const Outcome piped = run("compare - b.wrl --input-format wrl --views 0 < a.wrl");
  EXPECT_EQ(piped.code, 4) << piped.err;
  EXPECT_EQ(piped.out, run("compare a.wrl b.wrl --views 0").out);
  EXPECT_THAT(piped.out, HasSubstr("points: D1 "));
}

TEST_F(CompareProgram, WarningsOfPicturesAreGivenOnce) {
  write_file(file("mesh.obj"), kTwoTriangles);
  ASSERT_EQ(run("build mesh.obj -o a.wrl --resolution 16").code, 0);
  ASSERT_EQ(run("build mesh.obj -o b.wrl --resolution 24").code, 0);
  fs::remove(file("a_front.png"));
  const Outcome differ = run("compare a.wrl b.wrl --views 1 --size 16");
  EXPECT_EQ(differ.code, 4);
  const size_t at = differ.err.find("a_front.png");
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(differ.err.find("cannot be opened"), differ.err.rfind("cannot be opened"));
  EXPECT_EQ(run("compare a.wrl b.wrl --views 0 --max-error d1=1").code, 0);
  EXPECT_EQ(run("compare a.wrl b.wrl --views 0 --max-error d1=1 --strict").code, 3);
}

TEST_F(CompareProgram, ThresholdsJudgePictures) {
  ASSERT_EQ(run("render t.obj -o p.png --size 32x32").code, 0);
  ASSERT_EQ(run("render t.obj -o q.png --size 32x32 --azimuth 33").code, 0);
  EXPECT_EQ(run("compare p.png q.png").code, 4);
  EXPECT_EQ(run("compare p.png q.png --max-error psnr=1 --max-error ssim=0.01").code, 0);
  const Outcome beyond = run("compare p.png q.png --max-error psnr=99");
  EXPECT_EQ(beyond.code, 4);
  EXPECT_THAT(beyond.out, HasSubstr("\nbeyond the limit: psnr is "));
  EXPECT_THAT(beyond.out, HasSubstr(" (expected at least 99)\n"));
  EXPECT_EQ(run("compare p.png p.png --max-error psnr=99").code, 0);
}

TEST_F(CompareProgram, OptionsWithoutEffectAreUsageErrors) {
  write_file(file("a.oct"), "\xff");
  ASSERT_EQ(run("render t.obj -o p.png --size 32x32").code, 0);
  EXPECT_EQ(run("compare a.oct a.oct --resolution 2 --max-error d1=1").err,
            "afx: --max-error is for what is measured, not for the fields of octrees (see 'afx "
            "compare --help')\n");
  EXPECT_EQ(run("compare p.png p.png --views 3").err,
            "afx: --views is for models that are measured, not for pictures (see 'afx compare "
            "--help')\n");
  EXPECT_EQ(run("compare t.obj t.obj --exact").err,
            "afx: --exact is for two scenes (see 'afx compare --help')\n");
  write_file(file("a.wrl"),
             "Group { children [ DEF A OctreeImage { octreeResolution 2 octree 255 } ] }");
  EXPECT_EQ(run("compare a.wrl a.wrl --exact --max-error d1=1").code, 2);
  EXPECT_EQ(run("compare t.obj a.wrl --node A").code, 2);
}

TEST_F(CompareProgram, ARawOctreeIsMeasured) {
  // The eight voxels of a cube of side 1 around the origin, whose centres are at +-1/4.
  write_file(file("a.oct"), "\xff");
  write_file(file("p.ply"),
             "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
             "property float z\nend_header\n0.5 0.5 0.5\n-0.5 -0.5 -0.5\n");
  const auto distance = result("compare p.ply a.oct --resolution 2 --views 0", 4);
  EXPECT_EQ(distance.at("pointsB"), 8);
  EXPECT_GT(distance.at("d1"), 0.1);
  const Outcome unsized = run("compare p.ply a.oct --views 0");
  EXPECT_EQ(unsized.code, 2);
  EXPECT_THAT(unsized.err, HasSubstr("a.oct: a raw octree does not tell its size"));
  EXPECT_EQ(run("build a.oct -o x.wrl").err,
            "afx: a.oct: is a raw octree (expected a mesh, points, RGB-D pictures, a scene or "
            ".afx)\n");
}

TEST_F(CompareProgram, MeshesOfEveryEndingAreTaken) {
  write_file(file("t.raw"),
             "0 0 0 0 1 0 1 0 0\n0 0 0 1 0 0 0 0 1\n0 0 0 0 0 1 0 1 0\n1 0 0 0 1 0 0 0 1\n");
  EXPECT_EQ(result("compare t.obj t.raw --views 0 --points 1000 --shade never").at("d1"), 0);
  EXPECT_EQ(run("render t.raw -o p.png --size 16x16").code, 0);
  write_file(file("t.what"), "nothing known\n");
  EXPECT_EQ(run("render t.what -o q.png").code, 3);
}

TEST_F(CompareProgram, WhatModelsOfAFileLackIsSaid) {
  const std::string stream = kVectors + "surface-64-textured.afx";
  EXPECT_THAT(run("decode " + stream + " -o p.ply").err,
              HasSubstr("warning: a stream alone has no pictures: the model is grey\n"));
  EXPECT_THAT(run("render " + stream + " -o p.png --size 16x16").err,
              HasSubstr("warning: a stream alone has no pictures: the model is grey\n"));
  write_file(file("s.wrl"),
             "Group { children [ OctreeImage { octreeResolution 2 octree 255 } Shape { } ] }");
  for (const char* words : {"build s.wrl -o x.wrl --resolution 4", "decode s.wrl -o x.ply",
                            "compare t.obj s.wrl --views 0 --points 1000"})
    EXPECT_THAT(run(words).err, HasSubstr("warning: 1 Shape is left out")) << words;
}

TEST_F(CompareProgram, PointsOfAStreamAreThoseOfOneFrame) {
  const std::string decode = "decode " + kVectors + "frames-3.afx ";
  EXPECT_EQ(run(decode + "-o p.ply").code, 2);
  EXPECT_EQ(run(decode + "-o p_%04d.ply").code, 2);
  EXPECT_EQ(run(decode + "-o p.ply --frame 1 --levels 2").code, 2);
  EXPECT_EQ(run(decode + "-o p.ply --frame 1 --partial").code, 2);
  EXPECT_EQ(files(), (std::vector<std::string>{"t.obj"}));
  ASSERT_EQ(run(decode + "-o p.ply --frame 1 -q").code, 0);
  ASSERT_EQ(run(decode + "-o f.wrl --frame 1").code, 0);
  ASSERT_EQ(run("decode f.wrl -o f.ply -q").code, 0);
  EXPECT_EQ(read_file(file("p.ply")), read_file(file("f.ply")));
  ASSERT_EQ(run("decode - --input-format wrl -o s.ply -q < f.wrl").code, 0);
  EXPECT_EQ(read_file(file("s.ply")), read_file(file("f.ply")));
  EXPECT_EQ(run("decode f.wrl -o x.ply --frame 1").code, 2);
}

}  // namespace
}  // namespace afx::tools
