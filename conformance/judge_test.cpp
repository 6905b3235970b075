// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "conformance/judge.h"

#include <gmock/gmock.h>

#include "afx/picture_io.h"
#include "conformance/conformance_test_support.h"

namespace afx::conformance {
namespace {

using nlohmann::json;
using testing::HasSubstr;

Answer values(json document) { return {.values = std::move(document)}; }
Answer rejection(const std::string& code, Place place = Place::none()) {
  return {.state = Answer::State::rejected, .error = Finding{code, place}};
}

class Judged : public SuiteTest {
 protected:
  void expect_passed(const json& check, const Answer& answer) {
    const Outcome found = outcome(check, answer);
    EXPECT_EQ(found.verdict, Verdict::passed) << found.text;
  }
  void expect(Verdict verdict, const json& check, const Answer& answer, const std::string& text) {
    const Outcome found = outcome(check, answer);
    EXPECT_EQ(found.verdict, verdict);
    EXPECT_THAT(found.text, HasSubstr(text));
  }
};

TEST_F(Judged, TheRightValuesPassWhateverTheOrderOfTheirNames) {
  expect_passed(decode_check({{"a", {1, 2}}, {"b", "x"}}),
                values(json::parse(R"({"b": "x", "a": [1.0, 2]})")));
}

TEST_F(Judged, AWrongValueFailsWithItsPlaceAndBothValues) {
  const json check = decode_check({{"frames", {{{"octree", {129, 2}}}}}});
  const Outcome found = outcome(check, values({{"frames", {{{"octree", {129, 3}}}}}}));
  EXPECT_EQ(found.verdict, Verdict::failed);
  EXPECT_EQ(found.text, "/frames/0/octree/1 is 3 (expected 2)");
  ASSERT_TRUE(found.difference);
  EXPECT_EQ(found.difference->path, "/frames/0/octree/1");
}

TEST_F(Judged, AMissingOrAnExtraValueFails) {
  const json check = decode_check({{"a", {1, 2}}});
  expect(Verdict::failed, check, values({{"a", {1}}}), "/a/1 is nothing (expected 2)");
  expect(Verdict::failed, check, values({{"a", {1, 2, 3}}}), "/a/2 is 3 (expected nothing)");
  expect(Verdict::failed, check, values({{"a", {1, 2}}, {"b", 1}}), "/b is 1 (expected nothing)");
  expect(Verdict::failed, check, values(json::object()), "/a is nothing (expected [1,2])");
}

TEST_F(Judged, ANumberMayBeOffByItsToleranceAndNoMore) {
  json check = decode_check({{"n", {{{"x", 1.0}, {"y", 1.0}}}}});
  check["tolerances"] = {{{"path", "/n/*/x"}, {"abs", 0.01}, {"reason", "six digits"}}};
  expect_passed(check, values({{"n", {{{"x", 1.009}, {"y", 1.0}}}}}));
  expect(Verdict::failed, check, values({{"n", {{{"x", 1.011}, {"y", 1.0}}}}}), "/n/0/x is 1.011");
  expect(Verdict::failed, check, values({{"n", {{{"x", 1.0}, {"y", 1.009}}}}}), "/n/0/y is 1.009");
}

TEST_F(Judged, AnErrorWhereValuesAreExpectedFailsAndIsTold) {
  Answer answer = rejection("truncated", Place::at_bit(12));
  answer.error_text = "the data end";
  expect(Verdict::failed, decode_check(json::object()), answer,
         "it is rejected, truncated at bit 12: the data end (expected to be accepted)");
}

TEST_F(Judged, WarningsAreComparedWhereTheyAreExpected) {
  json check = decode_check({{"a", 1}});
  check["warnings"] = {{{"code", "align_bits"}, {"bit", 17}}};
  Answer answer = values({{"a", 1}});
  expect(Verdict::not_run, check, answer, "it tells no warnings");
  answer.warnings = {{"align_bits", Place::at_bit(17)}};
  expect_passed(check, answer);
  answer.warnings = {{"align_bits", Place::at_bit(18)}};
  expect(Verdict::failed, check, answer,
         "its warnings are: align_bits at bit 18 (expected: align_bits at bit 17)");
  answer.warnings->clear();
  expect(Verdict::failed, check, answer, "its warnings are: none");
}

TEST_F(Judged, ARejectionThatSucceedsFails) {
  const json check = {{"check", "reject"}, {"code", "malformed"}, {"bit", 5}, {"reason", "a 0"}};
  expect(Verdict::failed, check, values({{"a", 1}}),
         "it is accepted (expected malformed at bit 5: a 0)");
}

TEST_F(Judged, ARejectionNeedsItsCodeAndItsPlace) {
  const json check = {{"check", "reject"}, {"code", "malformed"}, {"bit", 5}};
  expect_passed(check, rejection("malformed", Place::at_bit(5)));
  expect(Verdict::failed, check, rejection("truncated", Place::at_bit(5)), "truncated at bit 5");
  expect(Verdict::failed, check, rejection("malformed", Place::at_bit(6)), "malformed at bit 6");
  expect(Verdict::failed, check, rejection("malformed"), "it is rejected, malformed (expected");
  expect(Verdict::not_run, check, {.state = Answer::State::rejected}, "without saying why");
  expect_passed({{"check", "reject"}, {"code", "malformed"}},
                rejection("malformed", Place::at_line(1, 2)));
}

TEST_F(Judged, OfATruncatedStreamWhatIsWholeIsComparedBesideItsError) {
  json check = decode_check({{"a", 1}});
  check["partial"] = true;
  Answer answer = rejection("truncated");
  expect(Verdict::not_run, check, answer, "gives nothing");
  answer.values = {{"a", 1}};
  expect_passed(check, answer);
  expect(Verdict::failed, check, values({{"a", 1}}), "it is accepted");
}

TEST_F(Judged, TheBytesOfAStreamEncodedAgainMustBeTheSame) {
  const json check = {{"check", "reencode"}};
  expect_passed(check, {.bytes = bytes_of("stream")});
  expect(Verdict::failed, check, {.bytes = bytes_of("strap")},
         "differs from byte 3 on, in 5 bytes (expected the 6 bytes of the stream)");
  expect(Verdict::failed, check, {.bytes = bytes_of("streams")}, "differs from byte 6 on");
}

TEST_F(Judged, WhereAFormatLeavesChoicesWhatItSaysMustBeTheSame) {
  document["cases"][0]["kind"] = "mp4";
  document["cases"][0]["expect"] = {{{"check", "reencode"}, {"equal", "commands"}}};
  const std::vector<Suite> suites{read().value()};
  for (const bool same : {true, false}) {
    const ToldDecoder decoder([&](const Question& question) -> Answer {
      if (question.form == Form::stream) return {.bytes = bytes_of("again")};
      const bool again = question.path.ends_with("again.mp4");
      return values(
          {{"config", again}, {"accessUnits", {{{"bytes", again}, {"x", again && !same}}}}});
    });
    const Outcome found = run_suites(suites, decoder, {}).cases[0].checks[0];
    EXPECT_EQ(found.verdict, same ? Verdict::passed : Verdict::failed);
    EXPECT_EQ(found.text, same ? "" : "encoded again, /accessUnits/0/x is true (expected false)");
  }
}

TEST_F(Judged, APictureMayBeAsFarAwayAsItsCaseSays) {
  Picture grey(4, 4, 3);
  const auto expected = encode_picture(grey, "png").value();
  put("one.png", std::string(expected.begin(), expected.end()));
  const json check = {{"check", "render"}, {"file", "one.png"}, {"sha256", sha256(expected)},
                      {"width", 4},        {"height", 4},       {"maxMean", 0.5}};
  grey.samples[7] = 24;  // of 48: half a step in the mean
  expect_passed(check, {.bytes = encode_picture(grey, "png").value()});
  grey.samples[8] = 1;
  const Outcome found = outcome(check, {.bytes = encode_picture(grey, "png").value()});
  EXPECT_EQ(found.text,
            "its picture is 0.52 steps of 1/255 away in the mean (expected at most 0.50)");
  ASSERT_TRUE(found.pictures);
  EXPECT_EQ(decode_picture(found.pictures->difference).value().samples[7], 24 * 8);
  expect(Verdict::failed, check, {.bytes = encode_picture(Picture(4, 5, 3), "png").value()},
         "its picture has 4 x 5 pixels of 3 (expected 4 x 4 pixels of 3)");
  expect(Verdict::failed, check, {.bytes = bytes_of("no picture")}, "cannot be read");
}

TEST_F(Judged, WhatWasNotAskedIsNotRunAndACrashFails) {
  expect(Verdict::not_run, decode_check(1), not_run("has no {as}"), "has no {as}");
  expect(Verdict::failed, decode_check(1), failed("it crashed"), "it crashed");
}

TEST_F(Judged, TheBitOfAWrongValueIsToldWhereItIsKnown) {
  document["cases"][0]["expect"] = json::array({decode_check({{"a", 1}})});
  const std::vector<Suite> suites{read().value()};
  const ToldDecoder decoder([](const Question&) { return values({{"a", 2}}); });
  const auto locate = [](const Question& question, const std::string& pointer) {
    EXPECT_TRUE(question.path.ends_with("/one.afx"));
    EXPECT_EQ(pointer, "/a");
    return std::optional<uint64_t>(19);
  };
  const Outcome found = run_suites(suites, decoder, {.locate = locate}).cases[0].checks[0];
  EXPECT_EQ(found.text, "/a is 2 (expected 1), coded at bit 19");
}

}  // namespace
}  // namespace afx::conformance
