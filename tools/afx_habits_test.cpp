// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What the program does in awkward places: pipes, closed descriptors, wrong words, hostile files.
#include "tools/program_fixture.h"

namespace afx::tools {
namespace {

TEST_F(Program, JsonNeverMixesWithDataOnStandardOutput) {
  const std::string stream = kVectors + "corner-2.afx";
  const std::string plain = run("decode " + stream + " -o - --format wrl").out;
  const Outcome both = run("decode " + stream + " -o - --format wrl --json");
  EXPECT_EQ(both.code, 0);
  EXPECT_EQ(both.out, plain);
  write_file(file("x.wrl"), plain);
  EXPECT_EQ(run("encode x.wrl -o - --format afx --json").out, read_file(stream));
}

TEST_F(Program, NothingIsReportedBeforeItIsThere) {
  const Outcome dry = run("decode " + kVectors + "corner-2.afx -o x.wrl -n --json");
  EXPECT_THAT(dry.err, HasSubstr("would write x.wrl: "));
  EXPECT_EQ(nlohmann::json::parse(dry.out).at("dryRun"), true);
  const Outcome full = run("decode " + kVectors + "corner-2.afx -o /dev/full --format wrl --json");
  EXPECT_EQ(full.code, 1);
  EXPECT_EQ(full.out, "");
  EXPECT_THAT(full.err, Not(HasSubstr("bytes")));
  write_file(file("x.wrl"), "mine");
  EXPECT_EQ(run("decode " + kVectors + "corner-2.afx -o x.wrl -n").code, 1);
}

TEST_F(Program, ClosedAndFullStandardDescriptorsAreFailures) {
  const std::string stream = kVectors + "corner-2.afx";
  EXPECT_EQ(run("decode " + stream + " -o x.wrl 2>&-").code, 0);
  EXPECT_EQ(read_file(file("x.wrl")).substr(0, 5), "#VRML");
  EXPECT_EQ(run("info " + stream + " >/dev/full || exit 1;").code, 1);
  EXPECT_EQ(run("--help >/dev/full || exit 1;").code, 1);
  EXPECT_EQ(run("info - --input-format afx <&-").code, 1);
}

TEST_F(Program, IgnoredInterruptsStayIgnoredOthersAre130) {
  const auto line = [&](const std::string& before, const std::string& signal) {
    return "cd '" + folder_.string() + "' && rm -f fifo && mkfifo fifo && exec bash -c '" + before +
           " sleep 1 >fifo & " AFX_PROGRAM " info - <fifo 2>/dev/null & p=$!; sleep 0.3; kill -" +
           signal + " $p; wait $p'";
  };
  for (const char* signal : {"TERM", "HUP"}) {
    EXPECT_EQ(WEXITSTATUS(std::system(line("", signal).c_str())), 130) << signal;
    const std::string ignoring = std::string("trap \"\" ") + signal + ";";
    EXPECT_EQ(WEXITSTATUS(std::system(line(ignoring, signal).c_str())), 3) << signal;
  }
}

TEST_F(Program, ModelsThatOverflowTheLibraryAreExitThree) {
#ifdef AFX_ADDRESS_SANITIZER
  GTEST_SKIP() << "the sanitizer reports the overflow itself";
#endif
  write_file(file("deep.gltf"), std::string(3000000, '['));
  const Outcome deep = run("build deep.gltf -o m.wrl");
  EXPECT_EQ(deep.code, 3);
  EXPECT_THAT(deep.err, HasSubstr("afx: deep.gltf: "));
  EXPECT_EQ(files(), (std::vector<std::string>{"deep.gltf"}));
}

TEST_F(Program, InfoOfABrokenModelIsAFailureWithItsOutput) {
  write_file(file("h.wrl"), "OctreeImage { octreeResolution 2 octree [ 2 2 2 ] }");
  write_file(file("z.wrl"), "OctreeImage { octreeResolution 0 }");
  for (const char* name : {"h.wrl", "z.wrl"}) {
    const Outcome info = run(std::string("info ") + name + " --json");
    EXPECT_EQ(info.code, 3) << name;
    EXPECT_THAT(info.err, HasSubstr(std::string("afx: ") + name + ": OctreeImage: ")) << name;
    EXPECT_EQ(nlohmann::json::parse(info.out).at("nodeTypes").at("OctreeImage"), 1);
  }
}

TEST_F(Program, EncodeNamesTheInputThatIsWrong) {
  write_file(file("a.wrl"), "OctreeImage { octreeResolution 2 octree 255 }");
  write_file(file("b.wrl"), "OctreeImage { octreeResolution 2 octree [ 255 1 ] }");
  write_file(file("c.wrl"), "OctreeImage { octreeResolution 2 octree 255 images DepthImage { } }");
  EXPECT_THAT(run("encode a.wrl b.wrl -o x.afx").err, HasSubstr("afx: b.wrl: field octree"));
  const Outcome images = run("encode a.wrl c.wrl -o x.afx");
  EXPECT_EQ(images.code, 3);
  EXPECT_THAT(images.err, HasSubstr("afx: c.wrl: the number of images is 1, but 0"));
  EXPECT_EQ(run("encode a.wrl -o f_%d.afx").code, 2);
}

TEST_F(Program, MistypedWordsAreNamed) {
  EXPECT_EQ(run("decod x").err,
            "afx: there is no command 'decod' (did you mean 'decode'?) (see 'afx --help')\n");
  EXPECT_EQ(run("render x.wrl -o x.png --bakend gl").err,
            "afx: there is no option '--bakend' (did you mean '--backend'?) (see 'afx render "
            "--help')\n");
  EXPECT_EQ(run("decod x").code, 2);
  EXPECT_EQ(run("view x.wrl").code, 1);
  EXPECT_EQ(run("conformance x").code, 1);
  const std::string in = kVectors + "corner-2.afx";
  for (const char* words : {"-o - --format foo", "-o x.wrl --format bt", "-o - --format png",
                            "-o - --format wrl "
                            "--input-format foo"}) {
    EXPECT_EQ(run("decode " + in + " " + words).code, 2) << words;
  }
  EXPECT_THAT(run("decode " + in + " -o - --format foo").err,
              HasSubstr("wrl, bt, xmt, json, oct or ply"));
  EXPECT_EQ(run("decode " + in + " -o - --format mp4").code, 2);
  EXPECT_EQ(run("info " + in + " --input-format json").code, 2);
  EXPECT_EQ(run("render " + in + " -o b.mp4").code, 2);
  EXPECT_EQ(run("render " + in + " -o b.tiff").code, 2);
}

TEST_F(Program, OptionsWithoutEffectAreUsageErrors) {
  write_file(file("a.wrl"), "OctreeImage { octreeResolution 2 octree 255 }");
  write_file(file("a.oct"), "\xff");
  EXPECT_EQ(run("encode a.wrl -o x.afx --resolution 2").code, 2);
  EXPECT_EQ(run("encode a.oct -o x.afx --resolution 2 --node A").code, 2);
  EXPECT_EQ(run("render a.wrl -o x.png --frame 0").code, 2);
  EXPECT_EQ(run("encode a.oct -o x.afx --resolution 2 --progress never -v").code, 0);
  EXPECT_EQ(run("compare a.oct a.wrl --resolution 2").code, 0);
}

TEST_F(Program, NamesWithOtherPercentSignsAndCapitalsWork) {
  ASSERT_EQ(run("decode " + kVectors + "corner-2.afx -o 50%_%02d.BT").code, 0);
  EXPECT_EQ(files(), (std::vector<std::string>{"50%_00.BT"}));
  EXPECT_THAT(read_file(file("50%_00.BT")), Not(HasSubstr("#VRML")));
}

TEST_F(Program, SharedModelsAreColouredOnceAndWhatIsNotDrawnIsCounted) {
  std::string scene = "Group { children [ DEF A OctreeImage { octreeResolution 2 octree 255 }";
  for (int i = 0; i < 99; ++i) scene += " USE A";
  write_file(file("s.wrl"), scene + " Shape { geometry Text { } } Shape { geometry Text { } } ] }");
  const Outcome render = run("render s.wrl -o s.png --size 16x16 --levels 1 --json");
  ASSERT_EQ(render.code, 0) << render.err;
  EXPECT_EQ(nlohmann::json::parse(render.out).at("voxels"), 800);
  EXPECT_THAT(render.err, HasSubstr("shapes that are not shown: 2 (2 of Text)"));
}

TEST_F(Program, ControlCharactersOfInputsAreEscaped) {
  const Outcome missing = run("info $'a\\033[31m.afx'");
  EXPECT_THAT(missing.err, Not(HasSubstr("\x1b")));
  write_file(file("c.wrl"), "DEF A\x1b OctreImage { }");
  EXPECT_THAT(run("info c.wrl").err, Not(HasSubstr("\x1b")));
}

TEST_F(Program, BuildSaysWhatIsNoMesh) {
  write_file(file("x.wrl"), "#VRML V2.0 utf8\n");
  const Outcome scene = run("build x.wrl -o m.wrl");
  EXPECT_EQ(scene.code, 3);
  EXPECT_EQ(scene.err,
            "afx: x.wrl: the scene has no DIBR nodes (expected DepthImage or OctreeImage)\n");
}

}  // namespace
}  // namespace afx::tools
