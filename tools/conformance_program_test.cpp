// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "conformance/sha256.h"
#include "tools/program_fixture.h"

namespace afx::tools {
namespace {

using nlohmann::json;

/// A suite "s" of one case: a stream that is there already, and what it decodes to.
class ConformanceProgram : public Program {
 protected:
  [[nodiscard]] std::string digest(const std::string& name) const {
    const std::string bytes = read_file(file("s/" + name));
    return conformance::sha256({reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size()});
  }
  void make_suite(const std::string& kind, const std::string& form, const json& values) {
    write_file(file("s/values.json"), values.dump());
    const json check = {{"check", "decode"},
                        {"as", form},
                        {"file", "values.json"},
                        {"sha256", digest("values.json")}};
    const json one = {{"name", "one"},
                      {"about", "a stream"},
                      {"kind", kind},
                      {"stream", "one." + kind},
                      {"sha256", digest("one." + kind)},
                      {"origin", "us"},
                      {"expect", json::array({check})}};
    write_file(file("s/suite.json"),
               json{{"suite", "small"},
                    {"title", "Small"},
                    {"origins", {{"us", {{"text", "a test"}, {"licence", "CC0-1.0"}}}}},
                    {"cases", json::array({one})}}
                   .dump());
  }
  void SetUp() override {
    Program::SetUp();
    fs::create_directory(file("s"));
    // resolution 2, no images, one frame: a root with the voxel 0, 0, 0 (the README's stream)
    write_file(file("s/one.octree"), std::string("\x14\x00\x00\x00\x01\xC8\xFE\x40", 8));
  }
  json octree_values = {{"octreeResolution", 2},
                        {"numOfTextures", 0},
                        {"frames", {{{"octree", {1}}, {"voxelImageIndex", json::array()}}}}};
};

TEST_F(ConformanceProgram, ASuiteThatHoldsPasses) {
  make_suite("octree", "octree", octree_values);
  const Outcome outcome = run("conformance s");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "1 passed, 0 failed, 0 not run\n");
}

TEST_F(ConformanceProgram, AWrongExpectationFailsWithValuesAndBit) {
  octree_values["frames"][0]["octree"][0] = 2;
  make_suite("octree", "octree", octree_values);
  const Outcome outcome = run("conformance s");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_EQ(
      outcome.err,
      "afx: s/one.octree: one: decode as octree failed: /frames/0/octree/0 is 1 (expected 2), "
      "coded at bit 48\n");
}

TEST_F(ConformanceProgram, AValueOfASceneIsFoundInTheFile) {
  fs::copy_file(AFX_SOURCE_DIR "/conformance/suites/bifs-gpac/24-commands-basic/scene.mp4",
                file("s/one.mp4"));
  ASSERT_EQ(run("decode s/one.mp4 -o values.json").code, 0);
  json values = json::parse(read_file(file("values.json")));
  // The trace of access unit 1: Transform.translation of the second insertion is coded at bits 56,
  // 88 and 120 of the unit.
  json& y = values["accessUnits"][1]["commands"][1]["value"]["fields"]["translation"][1];
  ASSERT_EQ(y, 2);
  y = 3;
  make_suite("mp4", "commands", values);
  const std::string unit =
      read_file(AFX_SOURCE_DIR "/conformance/suites/bifs-gpac/24-commands-basic/au1.bifs");
  const size_t byte = read_file(file("s/one.mp4")).find(unit);
  ASSERT_NE(byte, std::string::npos);
  const Outcome outcome = run("conformance s");
  EXPECT_THAT(outcome.err, HasSubstr("/accessUnits/1/commands/1/value/fields/translation/1 is 2 "
                                     "(expected 3), coded at bit " +
                                     std::to_string(byte * 8 + 88) + "\n"));
}

TEST_F(ConformanceProgram, ReportsAreWrittenInTheFormOfTheirNames) {
  make_suite("octree", "octree", octree_values);
  ASSERT_EQ(
      run("conformance s --report r.html --report r.xml --report r.json --coverage c.html").code,
      0);
  EXPECT_THAT(read_file(file("r.html")), HasSubstr("<!DOCTYPE html>"));
  EXPECT_THAT(read_file(file("r.xml")), HasSubstr("<testcase classname=\"small\" name=\"one\""));
  EXPECT_EQ(json::parse(read_file(file("r.json"))).at("/cases/passed"_json_pointer), 1);
  EXPECT_THAT(read_file(file("c.html")), HasSubstr("What the conformance suites cover"));
  EXPECT_EQ(run("conformance s --report r.xml").code, 1);  // it is there already
  EXPECT_EQ(run("conformance s --report r.txt").code, 2);
}

TEST_F(ConformanceProgram, OurOwnDecoderPassesThroughTheDoorOfOthers) {
  make_suite("octree", "octree", octree_values);
  const Outcome outcome =
      run("conformance s --decoder '" AFX_PROGRAM
          " conformance answer {in} {out} --kind octree --as {as} --levels {levels}'");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "1 passed, 0 failed, 0 not run\n");
}

/// A decoder that shares nothing with us: another language, from the text alone.
class DecoderInPython : public ConformanceProgram {
 protected:
  void SetUp() override {
    ConformanceProgram::SetUp();
    script_ = read_file(AFX_SOURCE_DIR "/conformance/octree_decoder.py");
    ASSERT_NE(script_, "");
  }
  void break_rule(const std::string& right, const std::string& wrong) {
    const size_t at = script_.find(right);
    ASSERT_NE(at, std::string::npos) << right;
    script_.replace(at, right.size(), wrong);
  }
  [[nodiscard]] Outcome judge(const std::string& filter) const {
    write_file(file("decoder.py"), script_);
    return run("conformance " AFX_SOURCE_DIR "/conformance/suites --filter '" + filter +
               "' --decoder '/usr/bin/python3 decoder.py {in} {out} --levels {levels} --max-nodes "
               "1000000'");
  }

  std::string script_;
};

TEST_F(DecoderInPython, PassesTheOctreeSuitesButForEncoding) {
  const Outcome outcome = judge("octree-r*");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, testing::EndsWith(" passed, 0 failed, 0 not run\n"));
}

TEST_F(DecoderInPython, WithAFaultOfItsTextureTableFailsAndIsToldWhere) {
  break_rule("self.coder.symbol(self.textures, 32, 512)",
             "self.coder.symbol(self.textures, 31, 512)");
  const Outcome outcome = judge("octree-rules/texture*");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err,
              testing::ContainsRegex("decode as octree failed: /frames/0/[A-Za-z]+/[0-9]+ is "
                                     "[0-9]+ \\(expected [0-9]+\\), coded at bit [0-9]+"));
}

TEST_F(DecoderInPython, ThatFindsNoMissingStartCodeFailsTheRejections) {
  break_rule("!= START_CODE", "!= START_CODE and False");
  const Outcome outcome = judge("octree-rejects/start-code*");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("(expected malformed at bit "));
}

TEST_F(ConformanceProgram, ADecoderThatCrashesFails) {
  make_suite("octree", "octree", octree_values);
  const Outcome outcome = run("conformance s --decoder 'kill -SEGV $$ # {in}'");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("decode as octree failed: it crashed: signal 11"));
}

TEST_F(ConformanceProgram, WrongCommandLinesAndSuitesAreSaidPlainly) {
  EXPECT_EQ(run("conformance").code, 2);
  EXPECT_EQ(run("conformance nowhere").code, 1);
  EXPECT_EQ(run("conformance s").code, 3);  // no suite.json in it
  make_suite("octree", "octree", octree_values);
  EXPECT_EQ(run("conformance s --filter 'x*'").code, 2);
  EXPECT_EQ(run("conformance s --decoder true").code, 2);
  write_file(file("s/suite.json"), "{\"suite\": \"x\"}");
  const Outcome outcome = run("conformance s");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.err, "afx: s/suite.json: /title is not there\n");
}

TEST_F(ConformanceProgram, TheGeneratorSaysHowManyCasesHold) {
  const Outcome outcome = run("conformance generate --seed 5 --cases 20 --kind all --keep kept");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "20 octree cases hold\n20 scene cases hold\n");
  EXPECT_FALSE(fs::exists(file("kept")));
  EXPECT_EQ(run("conformance generate --case 7 --kind scene").out, "1 scene case holds\n");
}

TEST_F(ConformanceProgram, TheGeneratorKnowsItsKinds) {
  const Outcome outcome = run("conformance generate --kind octrees");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.err.find("expected octree, scene or all"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace afx::tools
