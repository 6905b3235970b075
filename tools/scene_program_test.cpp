// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The program on scenes: text to MP4 and BIFS and back, what it says of them, and what it refuses.
#include "tools/program_fixture.h"

namespace afx::tools {

namespace {

const std::string kBifs = AFX_SOURCE_DIR "/conformance/suites/bifs-gpac/";
const std::string kMp4 = AFX_SOURCE_DIR "/conformance/suites/bifs-gpac/";

constexpr const char* kScene =
    "#VRML V2.0 utf8\n"
    "Group { children [\n"
    "  DEF MODEL OctreeImage { octreeResolution 4 octree [ 129 255 1 ]\n"
    "    voxelImageIndex [ 0 1 1 ]\n"
    "    images [ DepthImage { diTexture SimpleTexture { texture ImageTexture { url \"front.png\" "
    "} } } ] }\n"
    "] }\n";

/// The smallest PNG: one grey pixel.
constexpr uint8_t kPngBytes[] = {
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48,
    0x44, 0x52, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x08, 0x00, 0x00, 0x00,
    0x00, 0x3a, 0x7e, 0x9b, 0x55, 0x00, 0x00, 0x00, 0x0a, 0x49, 0x44, 0x41, 0x54, 0x78,
    0xda, 0x63, 0x60, 0x00, 0x00, 0x00, 0x02, 0x00, 0x01, 0xe5, 0x27, 0xde, 0xfc, 0x00,
    0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
const std::string kPng(std::begin(kPngBytes), std::end(kPngBytes));

}  // namespace

using SceneProgram = Program;

TEST_F(SceneProgram, ASceneWithOctreeAndPictureComesBackEqualFromOneFile) {
  write_file(file("scene.wrl"), kScene);
  write_file(file("front.png"), kPng);
  const Outcome encoded = run("encode scene.wrl -o scene.mp4");
  ASSERT_EQ(encoded.code, 0) << encoded.err;
  fs::create_directory(file("back"));
  const Outcome decoded = run("decode scene.mp4 -o back/scene.wrl");
  ASSERT_EQ(decoded.code, 0) << decoded.err;
  EXPECT_EQ(read_file(file("back/front.png")), kPng);
  EXPECT_EQ(run("compare scene.wrl back/scene.wrl").code, 0);
  EXPECT_EQ(run("compare scene.wrl scene.mp4").code, 0);
}

TEST_F(SceneProgram, ABuiltModelComesBackEqualFromOneFile) {
  write_file(file("mesh.obj"), kTwoTriangles);
  ASSERT_EQ(run("build mesh.obj -o model.wrl --resolution 16").code, 0);
  ASSERT_EQ(run("encode model.wrl -o model.mp4").code, 0);
  EXPECT_EQ(run("compare model.wrl model.mp4").code, 0);
  fs::create_directory(file("back"));
  ASSERT_EQ(run("decode model.mp4 -o back/model.wrl").code, 0);
  EXPECT_EQ(run("compare model.wrl back/model.wrl").code, 0);
  EXPECT_EQ(read_file(file("back/model_front.png")), read_file(file("model_front.png")));
}

TEST_F(SceneProgram, TheOctreeStreamOfTheFileIsThatOfTheSceneAlone) {
  write_file(file("scene.wrl"), kScene);
  ASSERT_EQ(run("encode scene.wrl -o scene.mp4 --pictures none").code, 0);
  ASSERT_EQ(run("encode scene.wrl -o scene.afx").code, 0);
  const std::string stream = read_file(file("scene.afx"));
  EXPECT_NE(read_file(file("scene.mp4")).find(stream), std::string::npos);
}

TEST_F(SceneProgram, WithoutAfxTheFieldsStayInTheScene) {
  write_file(file("scene.wrl"), kScene);
  ASSERT_EQ(run("encode scene.wrl -o scene.bifs --afx none").code, 0);
  ASSERT_EQ(run("decode scene.bifs -o scene.json").code, 0);
  EXPECT_THAT(read_file(file("scene.json")), HasSubstr("\"octree\": [129, 255, 1]"));
  EXPECT_EQ(run("compare scene.wrl scene.bifs").code, 0);
}

TEST_F(SceneProgram, InfoShowsTracksObjectDescriptorsAndWhatNodesTake) {
  const Outcome info = run("info '" + kMp4 + "14-bitwrapper/scene.mp4' --json");
  ASSERT_EQ(info.code, 3) << "its AFX payload is no stream";
  const auto json = nlohmann::json::parse(info.out);
  ASSERT_EQ(json["track"].size(), 3U);
  EXPECT_EQ(json["track"][2]["stream"], "AFX stream");
  EXPECT_EQ(json["track"][2]["afxObjectCode"], 6);
  EXPECT_EQ(json["objectDescriptor"][0]["id"], 40);
  EXPECT_EQ(json["objectDescriptor"][0]["tracks"][0], 40);
  EXPECT_TRUE(json["nodeSizes"].contains("BitWrapper"));
}

TEST_F(SceneProgram, TraceShowsEveryElementOfAnAccessUnit) {
  const Outcome trace = run("trace '" + kMp4 + "36-peer-end-flags/scene.mp4' --json");
  ASSERT_EQ(trace.code, 0) << trace.err;
  uint64_t next = 0;
  std::istringstream lines(trace.out);
  for (std::string line; std::getline(lines, line);) {
    const auto element = nlohmann::json::parse(line);
    EXPECT_EQ(element["bit"], next) << line;  // without a gap
    next = element["bit"].get<uint64_t>() + element["width"].get<uint64_t>();
  }
  EXPECT_EQ(next % 8, 0U);
}

TEST_F(SceneProgram, QuantizationSaysTheLargestErrorOfEachField) {
  std::string scene = "Group { children [";
  for (int i = 0; i < 40; ++i)
    scene += " Transform { translation " + std::to_string(i) + ".3 2 -7 }";
  write_file(file("scene.bt"), scene + "] }");
  const Outcome encoded = run("encode scene.bt -o scene.mp4 --quantize --bits position3D=8 --json");
  ASSERT_EQ(encoded.code, 0) << encoded.err;
  const auto json = nlohmann::json::parse(encoded.out);
  ASSERT_EQ(json["quantized"]["fields"].size(), 1U);
  const auto& field = json["quantized"]["fields"][0];
  EXPECT_EQ(field["field"], "translation");
  EXPECT_EQ(field["bits"], 8);
  EXPECT_LE(field["largestError"].get<double>(), field["bound"].get<double>());
  EXPECT_EQ(run("compare scene.bt scene.mp4").code, 4);
}

TEST_F(SceneProgram, GpacsChoicesGiveGpacsBits) {
  ASSERT_EQ(run("encode '" + kBifs + "24-commands-basic/scene.bt' -o x.bifs --choices gpac").code,
            0);
  const std::string stream = read_file(file("x.bifs"));
  for (int unit = 0; unit < 9; ++unit) {
    const std::string name = "24-commands-basic/au" + std::to_string(unit) + ".bifs";
    EXPECT_NE(stream.find(read_file(kBifs + name)), std::string::npos) << name;
  }
}

TEST_F(SceneProgram, WhatIsWrongHasFilePlaceAndSentence) {
  write_file(file("a.bt"), "Group { }\nAT 0 { REPLACE A.b BY 1 }");
  EXPECT_THAT(run("encode a.bt -o a.mp4").err,
              HasSubstr("a.bt:2:16: REPLACE: no node 'A' before this"));
  write_file(file("b.xmt"), "<?xml version=\"1.0\"?>\n<XMT-A><Body><Replce/></Body></XMT-A>");
  EXPECT_THAT(run("encode b.xmt -o b.mp4").err, HasSubstr("b.xmt:2:"));
  const std::string whole = read_file(kMp4 + "36-peer-end-flags/scene.mp4");
  write_file(file("c.mp4"), whole.substr(0, whole.size() - 8));
  EXPECT_THAT(run("decode c.mp4 -o c.bt").err, HasSubstr("c.mp4:"));
  EXPECT_EQ(run("decode c.mp4 -o c.bt").code, 3);
  EXPECT_EQ(files(), (std::vector<std::string>{"a.bt", "b.xmt", "c.mp4"}));
}

TEST_F(SceneProgram, OptionsThatDoNotGoWithTheFilesAreUsageErrors) {
  write_file(file("scene.wrl"), kScene);
  EXPECT_EQ(run("encode scene.wrl -o scene.mp4 --node MODEL").code, 2);
  EXPECT_EQ(run("encode scene.wrl -o scene.afx --afx none").code, 2);
  EXPECT_EQ(run("encode scene.wrl -o scene.mp4 --quantize --bits colour=8").code, 2);
  EXPECT_EQ(run("encode scene.wrl scene.wrl -o scene.mp4").code, 2);
  ASSERT_EQ(run("encode scene.wrl -o scene.mp4").code, 0);
  EXPECT_EQ(run("decode scene.mp4 -o scene.oct").code, 2);
  EXPECT_EQ(run("decode scene.mp4 -o scene.bt --levels 3").code, 2);
}

TEST_F(SceneProgram, StandardInputAndOutputWillDo) {
  write_file(file("scene.wrl"), kScene);
  const Outcome encoded = run("encode - --input-format wrl -o - --format mp4 < scene.wrl");
  EXPECT_EQ(encoded.code, 0) << encoded.err;
  write_file(file("x.mp4"), encoded.out);
  EXPECT_EQ(run("compare scene.wrl x.mp4").code, 0);
}

TEST_F(SceneProgram, AnotherProgramListsTheStreamsOfAWrittenFile) {
  write_file(file("scene.wrl"), kScene);
  write_file(file("front.png"), kPng);
  ASSERT_EQ(run("encode scene.wrl -o scene.mp4").code, 0);
  const std::string line = "cd '" + folder_.string() +
                           "' && ffprobe -v error -show_entries stream=codec_tag_string "
                           "-of csv=p=0 scene.mp4 > probe.log 2>&1";
  ASSERT_EQ(std::system(line.c_str()), 0) << read_file(file("probe.log"));
  EXPECT_THAT(read_file(file("probe.log")), HasSubstr("mp4s"));
}

}  // namespace afx::tools
