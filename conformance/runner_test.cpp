// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "conformance/runner.h"

#include <gmock/gmock.h>

#include <pugixml.hpp>

#include "conformance/command_decoder.h"
#include "conformance/conformance_test_support.h"
#include "conformance/report.h"

namespace afx::conformance {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(Patterns, AStarIsAnyTextAndAQuestionMarkOneCharacter) {
  EXPECT_TRUE(fits_pattern("octree/full-16", "octree/*"));
  EXPECT_TRUE(fits_pattern("octree/full-16", "*full*"));
  EXPECT_TRUE(fits_pattern("octree/full-16", "*-1?"));
  EXPECT_TRUE(fits_pattern("aab", "*ab"));
  EXPECT_TRUE(fits_pattern("", "*"));
  EXPECT_FALSE(fits_pattern("octree/full-16", "full*"));
  EXPECT_FALSE(fits_pattern("octree/full-16", "*-?"));
  EXPECT_FALSE(fits_pattern("a", ""));
}

/// Three cases: one passes, one fails, one is not run.
class Reports : public SuiteTest {
 protected:
  Reports() {
    const json first = document["cases"][0];
    document["cases"] = json::array();
    for (const char* name : {"good", "bad", "unasked"}) {
      document["cases"].push_back(first);
      document["cases"].back()["name"] = name;
      document["cases"].back()["stream"] = std::string(name) + ".afx";
      put(std::string(name) + ".afx", "stream");
    }
    suites.push_back(read().value());
  }
  [[nodiscard]] Report run(const RunOptions& options = {}) const {
    const ToldDecoder decoder([](const Question& question) -> Answer {
      if (question.path.ends_with("unasked.afx")) return not_run("no time");
      const char* code = question.path.ends_with("good.afx") ? "malformed"
                                                             : "<trun\x01"
                                                               "cated>";
      return {.state = Answer::State::rejected, .error = Finding{code, Place::none()}};
    });
    return run_suites(suites, decoder, options);
  }
  std::vector<Suite> suites;
};

TEST_F(Reports, CountWhatPassedFailedAndWasNotRunApart) {
  const Counts counts = run().counts();
  EXPECT_EQ(counts.passed, 1U);
  EXPECT_EQ(counts.failed, 1U);
  EXPECT_EQ(counts.not_run, 1U);
}

TEST_F(Reports, AreTheSameForAnyNumberOfJobs) {
  const auto text = [&](unsigned jobs) {
    json report = json_report(run({.jobs = jobs}));
    for (json& result : report["results"]) result.erase("seconds");
    return report.dump();
  };
  EXPECT_EQ(text(1), text(8));
}

TEST_F(Reports, HoldOnlyWhatTheFilterLets) {
  const Report report = run({.filter = "small/b*"});
  ASSERT_EQ(report.cases.size(), 1U);
  EXPECT_EQ(report.cases[0].one->name, "bad");
}

TEST_F(Reports, JUnitHasAFailureAndASkippedCase) {
  pugi::xml_document xml;
  ASSERT_TRUE(xml.load_string(junit_report(run()).c_str()));
  const pugi::xml_node suite = xml.child("testsuites").child("testsuite");
  EXPECT_EQ(suite.attribute("tests").as_int(), 3);
  EXPECT_EQ(suite.attribute("failures").as_int(), 1);
  EXPECT_EQ(suite.attribute("skipped").as_int(), 1);
  const pugi::xml_node bad = suite.find_child_by_attribute("testcase", "name", "bad");
  EXPECT_THAT(bad.child("failure").attribute("message").value(),
              StartsWith("reject: it is rejected, <trun?cated> (expected malformed"));
  EXPECT_TRUE(suite.find_child_by_attribute("testcase", "name", "unasked").child("skipped"));
}

TEST_F(Reports, JsonHasEachCheck) {
  const json report = json_report(run());
  EXPECT_EQ(report.at("/cases/failed"_json_pointer), 1);
  EXPECT_EQ(report.at("/results/1/checks/0/verdict"_json_pointer), "failed");
  EXPECT_EQ(report.at("/results/2/verdict"_json_pointer), "not run");
}

TEST_F(Reports, ThePageExplainsWhatFailedAndNeedsNoOtherFile) {
  const std::string page = html_report(run(), {});
  EXPECT_THAT(page, HasSubstr("1 passed, 1 failed, 1 not run"));
  EXPECT_THAT(page, HasSubstr("small/bad"));
  EXPECT_THAT(page, HasSubstr("&lt;trun\\x01cated&gt;"));
  EXPECT_THAT(page, Not(HasSubstr("http")));
  EXPECT_THAT(page, Not(HasSubstr("<link")));
}

/// A decoder that is a line of the shell.
class Command : public SuiteTest {
 protected:
  [[nodiscard]] Answer ask(const std::string& line, Form form = Form::octree,
                           double seconds = 20) const {
    return CommandDecoder(line, seconds)
        .ask({.path = folder.path() + "/one.afx",
              .kind = "octree",
              .form = form,
              .levels = kAllLevels});
  }
};

TEST_F(Command, TheAnswerIsReadFromItsFile) {
  const Answer answer =
      ask("test \"$(cat {in})\" = stream && echo '{\"a\": 1, \"warnings\": [{\"code\": \"w\", "
          "\"bit\": 3}]}' > {out}");
  EXPECT_EQ(answer.state, Answer::State::accepted) << answer.why;
  EXPECT_EQ(answer.values, json({{"a", 1}}));
  ASSERT_TRUE(answer.warnings);
  EXPECT_EQ(answer.warnings->at(0), (Finding{"w", Place::at_bit(3)}));
}

TEST_F(Command, ExitCodeThreeIsARejection) {
  Answer answer = ask("exit 3 # {in}");
  EXPECT_EQ(answer.state, Answer::State::rejected);
  EXPECT_FALSE(answer.error);
  answer =
      ask("echo '{\"error\": {\"code\": \"malformed\", \"line\": 2, \"column\": 7, \"text\": "
          "\"t\"}}' > {out}; exit 3");
  ASSERT_TRUE(answer.error);
  EXPECT_EQ(*answer.error, (Finding{"malformed", Place::at_line(2, 7)}));
  EXPECT_EQ(answer.error_text, "t");
}

TEST_F(Command, OtherEndsAreFailuresThatSayHow) {
  EXPECT_EQ(ask("echo first >&2; echo no such table >&2; exit 1").why,
            "it failed with exit code 1 (no such table)");
  EXPECT_THAT(ask("kill -SEGV $$").why, HasSubstr("it crashed: signal 11"));
  EXPECT_EQ(ask("true").why, "it wrote no answer");
  EXPECT_THAT(ask("echo '{' > {out}").why, HasSubstr("its answer: "));
  EXPECT_EQ(ask("echo '{\"error\": {\"code\": \"x\"}}' > {out}").why,
            "its answer has an error, but it ended with exit code 0");
}

TEST_F(Command, WhatTakesTooLongIsEndedWithAllThatItStarted) {
  const Answer answer = ask("sleep 60 & sleep 60", Form::octree, 0.1);
  EXPECT_EQ(answer.state, Answer::State::failed);
  EXPECT_EQ(answer.why, "it did not end in time");
}

TEST_F(Command, WhatItHasNoWordForIsNotAsked) {
  EXPECT_EQ(ask("cp {in} {out}", Form::stream).state, Answer::State::not_run);
  const Answer answer = ask("test {as} = stream && cp {in} {out}", Form::stream);
  EXPECT_EQ(answer.bytes, bytes_of("stream"));
}

TEST_F(Command, NamesWithBlanksAndQuotesReachIt) {
  put("it's one.afx", "stream");
  const Answer answer =
      CommandDecoder("test {as} = stream && cat {in} > {out}", 20)
          .ask({.path = folder.path() + "/it's one.afx", .kind = "octree", .form = Form::stream});
  EXPECT_EQ(answer.bytes, bytes_of("stream")) << answer.why;
}

}  // namespace
}  // namespace afx::conformance
