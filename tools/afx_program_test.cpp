// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The program as a user meets it: commands, files, messages, exit codes.
#include "tools/program_fixture.h"

namespace afx::tools {
namespace {

/// Seconds that a shell takes for ten runs of a command line.
double seconds_of(const std::string& line) {
  const std::string loop = "for i in 1 2 3 4 5 6 7 8 9 10; do " + line + " >/dev/null; done";
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(std::system(loop.c_str()), 0);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TEST_F(Program, HelpAndVersionAreInstant) {
#if !defined(NDEBUG) || defined(AFX_ADDRESS_SANITIZER)
  GTEST_SKIP() << "the promise is about Release builds";
#endif
  for (const char* option : {"--help", "--version"}) {
    double least = 1;  // another program may be busy
    for (int i = 0; i < 4; ++i) {
      const double nothing = seconds_of("/bin/true");
      least = std::min(least, (seconds_of(std::string(AFX_PROGRAM " ") + option) - nothing) / 10);
    }
    EXPECT_LT(least, 0.02) << option;
  }
}

TEST_F(Program, HelpAndVersionGoToStandardOutput) {
  EXPECT_THAT(run("--version").out, MatchesRegex("afx [0-9.]+\n"));
  for (const char* command :
       {"build", "encode", "decode", "info", "trace", "render", "view", "compare"}) {
    const Outcome help = run(std::string(command) + " --help");
    EXPECT_EQ(help.code, 0);
    EXPECT_THAT(help.out, HasSubstr("--json")) << command;
    EXPECT_EQ(help.err, "");
  }
}

TEST_F(Program, EveryStreamOfTheSuiteComesBackThroughSceneTextByteForByte) {
  const auto suite = nlohmann::json::parse(read_file(kVectors + "suite.json"));
  int streams = 0;
  for (const auto& one : suite.at("cases")) {
    const std::string stream = one.at("stream");
    if (stream == "frames-3.afx" || stream == "zero-symbol-inside.afx") continue;
    ASSERT_EQ(run("decode " + kVectors + stream + " -o x.wrl -f -q").code, 0) << stream;
    ASSERT_EQ(run("encode x.wrl -o x.afx -f -q").code, 0) << stream;
    EXPECT_EQ(read_file(file("x.afx")), read_file(kVectors + stream)) << stream;
    ++streams;
  }
  EXPECT_EQ(streams, 25);
}

TEST_F(Program, SeveralFramesGoToNumberedFilesAndBack) {
  const Outcome one = run("decode " + kVectors + "frames-3.afx -o x.wrl");
  EXPECT_EQ(one.code, 2);
  EXPECT_THAT(
      one.err,
      HasSubstr("the stream has 3 frames, but x.wrl is one file (expected a pattern such as "));
  ASSERT_EQ(run("decode " + kVectors + "frames-3.afx -o f_%03d.wrl").code, 0);
  EXPECT_EQ(files(), (std::vector<std::string>{"f_000.wrl", "f_001.wrl", "f_002.wrl"}));
  ASSERT_EQ(run("encode f_000.wrl f_001.wrl f_002.wrl -o x.afx").code, 0);
  EXPECT_EQ(read_file(file("x.afx")), read_file(kVectors + "frames-3.afx"));
  ASSERT_EQ(run("decode x.afx --frame 1 -o one.wrl").code, 0);
  EXPECT_EQ(read_file(file("one.wrl")), read_file(file("f_001.wrl")));
  EXPECT_EQ(run("decode x.afx --frame 3 -o none.wrl").code, 2);
}

TEST_F(Program, RawOctreesComeBack) {
  write_file(file("raw.oct"), std::string("\x81\x02\x41", 3));
  ASSERT_EQ(run("encode raw.oct --resolution 4 -o raw.afx").code, 0);
  ASSERT_EQ(run("decode raw.afx -o back.oct").code, 0);
  EXPECT_EQ(read_file(file("back.oct")), read_file(file("raw.oct")));
  EXPECT_EQ(run("compare raw.oct raw.afx --resolution 4").code, 0);
  const Outcome none = run("encode raw.oct -o other.afx");
  EXPECT_EQ(none.code, 2);
  EXPECT_EQ(none.err,
            "afx: raw.oct: a raw octree does not tell its size (expected --resolution N) (see 'afx "
            "encode --help')\n");
  const Outcome wrong = run("encode raw.oct --resolution 8 -o other.afx");
  EXPECT_EQ(wrong.code, 3);
  EXPECT_EQ(wrong.err,
            "afx: raw.oct: field octree has 3 bytes, too few for its structure (level 2 begins at "
            "byte 3 and has 3 nodes)\n");
  EXPECT_FALSE(fs::exists(file("other.afx")));
}

TEST_F(Program, ATexturedModelWrittenRawLosesItsIndicesAndSaysSo) {
  const Outcome raw = run("decode " + kVectors + "surface-64-textured.afx -o x.oct");
  EXPECT_EQ(raw.code, 0);
  EXPECT_THAT(raw.err, HasSubstr("symbols of voxelImageIndex are left out"));
  const Outcome strict = run("decode " + kVectors + "surface-64-textured.afx -o y.oct --strict");
  EXPECT_EQ(strict.code, 3);
  EXPECT_FALSE(fs::exists(file("y.oct")));
}

TEST_F(Program, PipesCarryStreams) {
  const std::string words = "decode - -o - --format wrl < " + kVectors +
                            "corner-2.afx | " AFX_PROGRAM
                            " encode - -o piped.afx --input-format wrl";
  ASSERT_EQ(run(words).code, 0) << run(words).err;
  EXPECT_EQ(read_file(file("piped.afx")), read_file(kVectors + "corner-2.afx"));
}

TEST_F(Program, InfoCountsWhatTheManifestCounts) {
  const Outcome info = run("info " + kVectors + "spot-256-textured.afx --json");
  ASSERT_EQ(info.code, 0);
  const auto json = nlohmann::json::parse(info.out);
  EXPECT_EQ(json.at("resolution"), 256);
  EXPECT_EQ(json.at("levels"), 8);
  EXPECT_EQ(json.at("bytes"), 31393);
  EXPECT_EQ(json.at("voxels"), 167323);  // the voxel set's own count
  EXPECT_EQ(json.at("frame").at(0).at("nodeSymbols"), 58020);
  EXPECT_NEAR(json.at("bitsPerVoxel").get<double>(), 31393 * 8.0 / 167323, 1e-9);
  EXPECT_THAT(run("info " + kVectors + "spot-256-textured.afx").out,
              HasSubstr("voxels: 167,323\n"));
}

TEST_F(Program, TracePrintsHeaderElementsWithBitOffsets) {
  const Outcome trace = run("trace " + kVectors + "corner-2.afx --json");
  ASSERT_EQ(trace.code, 0);
  EXPECT_THAT(trace.out,
              HasSubstr(R"({"bit":0,"width":5,"name":"octree_stream/resolution_bits","value":2})"));
  EXPECT_THAT(
      trace.out,
      HasSubstr(
          R"({"bit":16,"width":32,"name":"octree_stream/octree_frame_start_code","value":456})"));
}

TEST_F(Program, TruncatedStreamsAreOneLineAndWhatIsWholeOnRequest) {
  const std::string whole = read_file(kVectors + "spot-256.afx");
  write_file(file("cut.afx"), whole.substr(0, 9000));
  const Outcome plain = run("decode cut.afx -o x.wrl");
  EXPECT_EQ(plain.code, 3);
  EXPECT_THAT(
      plain.err,
      MatchesRegex("afx: cut.afx:9000: the data end inside the octree frame, at symbol [0-9]+ of "
                   "[0-9]+ known so far .*\n"));
  EXPECT_FALSE(fs::exists(file("x.wrl")));
  EXPECT_EQ(run("decode cut.afx --partial -o x.oct").code, 3);
  ASSERT_TRUE(fs::exists(file("x.oct")));
  ASSERT_EQ(run("decode " + kVectors + "spot-256.afx --levels 6 -o coarse.oct").code, 0);
  const std::string coarse = read_file(file("coarse.oct"));
  EXPECT_EQ(read_file(file("x.oct")).substr(0, coarse.size()), coarse);
}

TEST_F(Program, BadInputIsExitThreeWithItsPlace) {
  write_file(file("zero.afx"), std::string("\0\0\0\0\x01\xC8\x40", 7));
  const Outcome zero = run("info zero.afx");
  EXPECT_EQ(zero.code, 3);
  EXPECT_EQ(zero.err, "afx: zero.afx:0.5: octreeResolution is 0 (expected at least 1)\n");

  write_file(file("typo.wrl"), "#VRML V2.0 utf8\nGroup {\n  children [ OctreImage { } ]\n}\n");
  const Outcome typo = run("encode typo.wrl -o x.afx");
  EXPECT_EQ(typo.code, 3);
  EXPECT_THAT(typo.err, HasSubstr("afx: typo.wrl:3:14: "));
  EXPECT_THAT(typo.err, HasSubstr("OctreeImage"));
  EXPECT_THAT(typo.err, HasSubstr("\n             ^"));

  write_file(file("none.wrl"), "Group { }");
  EXPECT_EQ(run("encode none.wrl -o x.afx").err,
            "afx: none.wrl: the scene has no OctreeImage (expected one)\n");
  write_file(file("two.wrl"),
             "Group { children [ DEF A OctreeImage { octree 0 octreeResolution 2 } DEF B "
             "OctreeImage { octree 1 octreeResolution 2 } ] }");
  const Outcome two = run("encode two.wrl -o x.afx");
  EXPECT_EQ(two.code, 3);
  EXPECT_THAT(
      two.err,
      HasSubstr("2 OctreeImages: OctreeImage \"A\", OctreeImage \"B\" (expected --node NAME)"));
  EXPECT_EQ(run("encode two.wrl --node B -o b.afx").code, 0);
  EXPECT_EQ(run("encode two.wrl --node C -o c.afx").code, 2);

  write_file(file("big.wrl"), "OctreeImage { octreeResolution 2 octree [ 1 300 ] }");
  EXPECT_EQ(run("encode big.wrl -o x.afx").err,
            "afx: big.wrl: OctreeImage: field octree has 300 at position 1 (expected 0..255)\n");
  EXPECT_FALSE(fs::exists(file("x.afx")));
}

TEST_F(Program, OutputsAreNeverOverwrittenUnasked) {
  write_file(file("x.wrl"), "mine");
  const Outcome refused = run("decode " + kVectors + "corner-2.afx -o x.wrl");
  EXPECT_EQ(refused.code, 1);
  EXPECT_THAT(refused.err, HasSubstr("x.wrl"));
  EXPECT_THAT(refused.err, HasSubstr("exists"));
  EXPECT_EQ(read_file(file("x.wrl")), "mine");
  EXPECT_EQ(run("decode " + kVectors + "corner-2.afx -o x.wrl -f").code, 0);
  EXPECT_NE(read_file(file("x.wrl")), "mine");
  EXPECT_EQ(run("decode " + kVectors + "corner-2.afx -o dry.wrl -n").code, 0);
  EXPECT_FALSE(fs::exists(file("dry.wrl")));
}

TEST_F(Program, WrongCommandLinesSayHowToGetTheUsage) {
  const Outcome unknown = run("decode --nonsense a -o b");
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("--nonsense"));
  EXPECT_THAT(unknown.err, HasSubstr("(see 'afx decode --help')\n"));
  EXPECT_EQ(run("").code, 2);
  EXPECT_EQ(run("frobnicate").code, 2);
  EXPECT_EQ(run("decode " + kVectors + "corner-2.afx -o x.docx").code, 2);
  const Outcome missing = run("info nothing.afx");
  EXPECT_EQ(missing.code, 1);
  EXPECT_EQ(missing.err, "afx: nothing.afx: cannot be opened: No such file or directory\n");
}

TEST_F(Program, CompareTellsTheFirstDifference) {
  write_file(file("a.oct"), std::string("\x81\x02\x41", 3));
  write_file(file("b.oct"), std::string("\x81\x02\x42", 3));
  const Outcome differ = run("compare a.oct b.oct --resolution 4");
  EXPECT_EQ(differ.code, 4);
  EXPECT_EQ(differ.out,
            "field octree differs at position 2: 65 and 66 (lengths 3 and 3)\n"
            "voxels: 1 in A only, 1 in B only, 2 in both; 0.00 % of those have another "
            "image\n");
  EXPECT_EQ(run("compare a.oct a.oct --resolution 4").code, 0);
}

TEST_F(Program, BuildsEncodesDecodesAndRendersAMesh) {
  write_file(file("mesh.obj"), kTwoTriangles);
  ASSERT_EQ(run("build mesh.obj -o m.wrl --resolution 32 --json").code, 0)
      << read_file(file("err.log"));
  const auto built = nlohmann::json::parse(read_file(file("out.log")));
  // One image shows them both; others that no voxel takes are not written.
  EXPECT_EQ(files(), (std::vector<std::string>{"m.wrl", "m_front.png", "mesh.obj"}));
  ASSERT_EQ(run("encode m.wrl -o m.afx").code, 0);
  EXPECT_EQ(run("compare m.wrl m.afx").code, 0);
  ASSERT_EQ(run("info m.afx --json").code, 0);
  EXPECT_EQ(nlohmann::json::parse(read_file(file("out.log"))).at("voxels"), built.at("voxels"));
  for (const char* threads : {"1", "3"}) {
    ASSERT_EQ(run(std::string("render m.wrl --size 64x48 --threads ") + threads + " -o p" +
                  threads + ".png")
                  .code,
              0);
  }
  EXPECT_EQ(read_file(file("p1.png")), read_file(file("p3.png")));
  const auto picture = nlohmann::json::parse(run("info p1.png --json").out);
  EXPECT_EQ(picture.at("width"), 64);
  EXPECT_EQ(picture.at("height"), 48);
  EXPECT_EQ(run("compare p1.png p3.png").code, 0);
  ASSERT_EQ(run("render m.wrl --size 64x48 --level 2 -o coarse.png").code, 0);
  EXPECT_EQ(run("compare p1.png coarse.png").code, 4);
  EXPECT_EQ(run("render m.wrl --size 64x48 -o p.jpg --background '#12345678'").code, 2);
}

TEST_F(Program, BuildLeavesNothingBehindWhenItFails) {
  write_file(file("mesh.obj"), kTwoTriangles);
  write_file(file("m_front.png"), "mine");
  EXPECT_EQ(run("build mesh.obj -o m.wrl --resolution 16").code, 1);
  write_file(file("bad.obj"), "this is no mesh\n");
  EXPECT_EQ(run("build bad.obj -o n.wrl").code, 3);
  EXPECT_EQ(files(), (std::vector<std::string>{"bad.obj", "m_front.png", "mesh.obj"}));
  EXPECT_EQ(read_file(file("m_front.png")), "mine");
}

TEST_F(Program, AMissingPictureIsAWarningAndStrictAFailure) {
  write_file(file("mesh.obj"), kTwoTriangles);
  ASSERT_EQ(run("build mesh.obj -o m.wrl --resolution 16").code, 0);
  fs::remove(file("m_front.png"));
  const Outcome lenient = run("render m.wrl --size 32x32 -o p.png");
  EXPECT_EQ(lenient.code, 0);
  EXPECT_THAT(lenient.err, HasSubstr("m_front.png"));
  EXPECT_EQ(run("render m.wrl --size 32x32 -o q.png --strict").code, 3);
  EXPECT_FALSE(fs::exists(file("q.png")));
}

TEST_F(Program, CompletionKnowsEveryCommandAndItsOptions) {
  const std::vector<std::pair<std::string, std::string>> own{
      {"build", "image-size"}, {"encode", "node"},    {"decode", "partial"},
      {"info", "resolution"},  {"trace", "strict"},   {"render", "turntable"},
      {"compare", "node"},     {"completion", "help"}};
  for (const char* shell : {"bash", "zsh", "fish"}) {
    const Outcome script = run(std::string("completion ") + shell);
    EXPECT_EQ(script.code, 0);
    for (const auto& [command, option] : own) {
      const std::string line = std::string(shell) == "fish"
                                   ? "__fish_seen_subcommand_from " + command + "' -l " + option
                                   : "\\*:" + command + "\\) words='[^\n]*--" + option;
      EXPECT_THAT(script.out, testing::ContainsRegex(line)) << shell;
    }
  }
  ASSERT_EQ(run("completion bash").code, 0);
  const std::string check = "bash -n '" + (folder_ / "out.log").string() + "'";
  EXPECT_EQ(std::system(check.c_str()), 0);
}

}  // namespace
}  // namespace afx::tools
