// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Suites made wrong on purpose: each is refused, or fails, in the right words.
#include "conformance/suite.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "conformance/conformance_test_support.h"
#include "conformance/coverage.h"
#include "conformance/rules.h"
#include "conformance/suite_files.h"

namespace afx::conformance {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

class WrongSuite : public SuiteTest {
 protected:
  void expect_refused(const json& patch, const std::string& text) {
    json wrong = document;
    wrong.merge_patch(patch);
    put("suite.json", wrong.dump());
    const auto suite = read_suite(folder.path());
    ASSERT_FALSE(suite.ok()) << text;
    EXPECT_EQ(suite.error().code, Errc::malformed);
    EXPECT_THAT(suite.error().text, HasSubstr(text));
  }
  /// The same with one case, which is changed.
  void expect_case_refused(const json& patch, const std::string& text) {
    json one = document["cases"][0];
    one.merge_patch(patch);
    expect_refused({{"cases", json::array({one})}}, text);
  }
  void expect_check_refused(const json& check, const std::string& text) {
    expect_case_refused({{"expect", json::array({check})}}, text);
  }
  std::string failure() {
    const std::vector<Suite> suites{read().value()};
    const ToldDecoder decoder([](const Question&) {
      return Answer{.state = Answer::State::rejected, .error = Finding{"malformed", Place::none()}};
    });
    const Report report = run_suites(suites, decoder, {});
    return report.cases[0].verdict() == Verdict::failed ? report.cases[0].checks[0].text : "passed";
  }
};

TEST_F(WrongSuite, WithoutAFaultItIsRead) {
  const auto suite = read();
  ASSERT_TRUE(suite.ok()) << to_string(suite.error());
  EXPECT_EQ(suite.value().cases.size(), 1U);
  EXPECT_EQ(failure(), "passed");
}

TEST_F(WrongSuite, AStreamWithOtherBytesFails) {
  put("one.afx", "stream!");
  EXPECT_THAT(failure(), HasSubstr("one.afx: the SHA-256 is "));
  EXPECT_THAT(failure(), HasSubstr("(expected " + sha256(bytes_of("stream")) + ")"));
}

TEST_F(WrongSuite, AStreamThatIsNotThereFails) {
  std::filesystem::remove(folder.path() + "/one.afx");
  EXPECT_THAT(failure(), HasSubstr("one.afx: "));
  EXPECT_THAT(failure(), HasSubstr("No such file"));
}

TEST_F(WrongSuite, AFileBesideTheStreamThatIsNotThereFails) {
  document["cases"][0]["beside"] = {{{"file", "picture.png"}, {"sha256", std::string(64, '0')}}};
  EXPECT_THAT(failure(), HasSubstr("picture.png: "));
}

TEST_F(WrongSuite, ExpectedValuesWithOtherBytesFail) {
  json check = decode_check({{"a", 1}});
  put("one.json", "{\"a\": 2}");
  const Outcome found = outcome(check, {.values = {{"a", 2}}});
  EXPECT_EQ(found.verdict, Verdict::failed);
  EXPECT_THAT(found.text, HasSubstr("one.json: the SHA-256 is "));
}

TEST_F(WrongSuite, ExpectedValuesThatAreNoJsonFail) {
  put("one.json", "{");
  const json check = {{"check", "decode"},
                      {"as", "octree"},
                      {"file", "one.json"},
                      {"sha256", sha256(bytes_of("{"))}};
  EXPECT_THAT(outcome(check, {.values = {{"a", 2}}}).text,
              HasSubstr("one.json:1:2: this is not JSON"));
}

TEST_F(WrongSuite, WhatIsNoJsonIsRefusedWithItsPlace) {
  put("suite.json", "{\n \"suite\": }");
  const auto suite = read_suite(folder.path());
  ASSERT_FALSE(suite.ok());
  EXPECT_EQ(suite.error().place, Place::at_line(2, 11));
}

TEST_F(WrongSuite, AMemberThatIsMissingWrongOrUnknownIsNamed) {
  expect_refused({{"suite", nullptr}}, "/suite is not there");
  expect_refused({{"title", 7}}, "/title is not a text");
  expect_refused({{"tittle", "x"}}, "/tittle is not known here");
  expect_refused({{"cases", json::array()}}, "/cases holds no case");
  expect_refused({{"cases", json::array({1})}}, "/cases/0 is not an object");
  expect_case_refused({{"kind", "film"}}, "/cases/0/kind is 'film' (expected octree, mp4, ");
  expect_case_refused({{"origin", "them"}}, "names the origin 'them'");
  expect_case_refused({{"expect", json::array()}}, "/cases/0/expect holds no check");
}

TEST_F(WrongSuite, APathThatLeavesTheFolderIsRefused) {
  for (const char* path : {"../one.afx", "/etc/passwd", "a/../../b", ""})
    expect_case_refused({{"stream", path}}, "/cases/0/stream is '" + std::string(path) + "'");
}

TEST_F(WrongSuite, TwoCasesOfOneNameAreRefused) {
  const json one = document["cases"][0];
  expect_refused({{"cases", {one, one}}}, "/cases/1 has the name of another: one");
}

TEST_F(WrongSuite, AWrongCheckIsNamed) {
  expect_check_refused({{"check", "guess"}},
                       "is 'guess' (expected decode, reencode, render or reject)");
  expect_check_refused({{"check", "reject"}, {"code", "bad"}},
                       "/cases/0/expect/0/code is 'bad' (expected truncated, ");
  expect_check_refused({{"check", "reject"}, {"code", "malformed"}, {"bit", -1}},
                       "/bit is -1 (expected an integer from 0");
  expect_check_refused({{"check", "decode"}, {"as", "image"}},
                       "/as is 'image' (expected octree, commands, tracks or picture)");
  expect_check_refused({{"check", "reencode"}, {"equal", "picture"}}, "/equal is 'picture'");
  expect_check_refused({{"check", "reencode"}, {"bytes", 1}}, "/bytes is not known here");
}

TEST_F(WrongSuite, AFolderWithoutSuitesIsAnError) {
  EXPECT_EQ(find_suites({folder.path()}).error().code, Errc::malformed);
  EXPECT_EQ(find_suites({folder.path() + "/no"}).error().code, Errc::io);
  ASSERT_TRUE(read().ok());
  EXPECT_THAT(find_suites({folder.path()}).value(), ElementsAre(folder.path()));
}

class RulesOfSuites : public SuiteTest {
 protected:
  RulesOfSuites() {
    put("rules.json", json{{"area", "octree"},
                           {"source", "a text"},
                           {"rules",
                            {{{"id", "a"}, {"section", "1"}, {"text", "Rule a."}},
                             {{"id", "b"}, {"section", "2"}, {"text", "Rule b."}}}}}
                          .dump());
    document["rules"] = json::array({"rules.json"});
    document["cases"][0]["covers"] = json::array({"a"});
  }
};

TEST_F(RulesOfSuites, ACaseThatCoversNoKnownRuleIsAnError) {
  document["cases"][0]["covers"] = json::array({"c"});
  const auto sets = rules_of({read().value()});
  ASSERT_FALSE(sets.ok());
  EXPECT_THAT(sets.error().text, HasSubstr("the case one covers 'c', which is no rule"));
}

TEST_F(RulesOfSuites, ThePageShowsWhatIsCoveredAndTheGapsInRed) {
  const std::vector<Suite> suites{read().value()};
  const auto sets = rules_of(suites);
  ASSERT_TRUE(sets.ok()) << to_string(sets.error());
  const auto cover = cover_of(sets.value().at(0), suites);
  EXPECT_THAT(cover.at(0).cases, ElementsAre("small/one"));
  EXPECT_TRUE(cover.at(1).cases.empty());
  const std::string page = coverage_page(sets.value(), suites);
  EXPECT_THAT(page, HasSubstr("2 rules, 1 without a case"));
  EXPECT_THAT(page, HasSubstr("<tr class=\"gap\"><td class=\"rule\"><code>b</code>"));
  EXPECT_THAT(page, HasSubstr("<tr><td class=\"rule\"><code>a</code>"));
}

TEST(Sha256, IsThatOfTheStandardsExample) {  // FIPS 180-4, "abc"
  EXPECT_EQ(sha256(bytes_of("abc")),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

}  // namespace
}  // namespace afx::conformance
