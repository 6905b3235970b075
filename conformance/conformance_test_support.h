// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// A small suite in a folder of the test's own, and a decoder that gives the answers it is told.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "conformance/decoder.h"
#include "conformance/runner.h"
#include "conformance/sha256.h"
#include "conformance/suite.h"
#include "conformance/temporary_folder.h"

namespace afx::conformance {

inline std::vector<uint8_t> bytes_of(const std::string& text) { return {text.begin(), text.end()}; }

/// A decoder of which the test says what it answers.
class ToldDecoder final : public Decoder {
 public:
  explicit ToldDecoder(std::function<Answer(const Question&)> answer)
      : answer_(std::move(answer)) {}
  [[nodiscard]] std::string name() const override { return "told"; }
  [[nodiscard]] Answer ask(const Question& question) const override { return answer_(question); }

 private:
  std::function<Answer(const Question&)> answer_;
};

/// One suite with one case "one", whose stream "one.afx" has the bytes "stream".
class SuiteTest : public testing::Test {
 protected:
  SuiteTest() {
    put("one.afx", "stream");
    document["cases"][0]["sha256"] = sha256(bytes_of("stream"));
  }

  void put(const std::string& name, const std::string& text) const {
    ASSERT_TRUE(write_whole_file(folder.path() + "/" + name, bytes_of(text)).ok());
  }

  /// A decode check of the form octree against a file with this JSON.
  nlohmann::json decode_check(const nlohmann::json& values) const {
    put("one.json", values.dump());
    return {{"check", "decode"},
            {"as", "octree"},
            {"file", "one.json"},
            {"sha256", sha256(bytes_of(values.dump()))}};
  }

  [[nodiscard]] Result<Suite> read() const {
    put("suite.json", document.dump());
    return read_suite(folder.path());
  }

  /// What comes of a check when the decoder answers this.
  [[nodiscard]] Outcome outcome(const nlohmann::json& check, const Answer& answer) {
    document["cases"][0]["expect"] = nlohmann::json::array({check});
    const auto suite = read();
    if (!suite.ok()) return {.verdict = Verdict::failed, .text = to_string(suite.error())};
    const ToldDecoder decoder([&](const Question&) { return answer; });
    const std::vector<Suite> suites{suite.value()};
    return run_suites(suites, decoder, {}).cases.at(0).checks.at(0);
  }

  TemporaryFolder folder = std::move(TemporaryFolder::make().value());
  nlohmann::json document = {{"suite", "small"},
                             {"title", "A small suite"},
                             {"origins", {{"us", {{"text", "the test"}, {"licence", "CC0-1.0"}}}}},
                             {"cases",
                              {{{"name", "one"},
                                {"about", "one case"},
                                {"kind", "octree"},
                                {"stream", "one.afx"},
                                {"origin", "us"},
                                {"expect", {{{"check", "reject"}, {"code", "malformed"}}}}}}}};
};

}  // namespace afx::conformance
