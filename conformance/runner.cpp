// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "conformance/runner.h"

#include <algorithm>
#include <chrono>
#include <mutex>

#include "codec/parallel.h"
#include "conformance/suite_files.h"

namespace afx::conformance {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Why the files of a case cannot be used; empty: they can.
std::string wrong_file(const Suite& suite, const Case& one) {
  std::vector<SuiteFile> files{one.stream};
  files.insert(files.end(), one.beside.begin(), one.beside.end());
  for (const SuiteFile& file : files) {
    const auto bytes = read_suite_file(suite, file);
    if (!bytes.ok()) return to_string(bytes.error(), file.path);
  }
  return {};
}

void run_case(CaseOutcome& outcome, const Decoder& decoder, const LocateValue& locate) {
  const auto begin = Clock::now();
  const std::string wrong = wrong_file(*outcome.suite, *outcome.one);
  for (const Check& check : outcome.one->expect) {
    outcome.checks.push_back(wrong.empty()
                                 ? judge(*outcome.suite, *outcome.one, check, decoder, locate)
                                 : Outcome{.verdict = Verdict::failed, .text = wrong});
  }
  outcome.seconds = seconds_since(begin);
}

}  // namespace

Verdict CaseOutcome::verdict() const {
  Verdict verdict = Verdict::not_run;
  for (const Outcome& check : checks) {
    if (check.verdict == Verdict::failed) return Verdict::failed;
    if (check.verdict == Verdict::passed) verdict = Verdict::passed;
  }
  return verdict;
}

void Counts::add(Verdict verdict) {
  ++(verdict == Verdict::passed ? passed : verdict == Verdict::failed ? failed : not_run);
}

Counts Report::counts() const {
  Counts counts;
  for (const CaseOutcome& one : cases) counts.add(one.verdict());
  return counts;
}

bool fits_pattern(std::string_view name, std::string_view pattern) {
  size_t at = 0, star = std::string_view::npos, from = 0, in_pattern = 0;
  while (at < name.size()) {
    if (in_pattern < pattern.size() && pattern[in_pattern] == '*') {
      star = in_pattern++;
      from = at;
    } else if (in_pattern < pattern.size() &&
               (pattern[in_pattern] == '?' || pattern[in_pattern] == name[at])) {
      ++at;
      ++in_pattern;
    } else if (star != std::string_view::npos) {  // the last * takes one character more
      in_pattern = star + 1;
      at = ++from;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', in_pattern) == std::string_view::npos;
}

Report run_suites(const std::vector<Suite>& suites, const Decoder& decoder,
                  const RunOptions& options) {
  const auto begin = Clock::now();
  Report report;
  report.decoder = decoder.name();
  for (const Suite& suite : suites)
    for (const Case& one : suite.cases)
      if (options.filter.empty() || fits_pattern(suite.name + "/" + one.name, options.filter))
        report.cases.push_back({.suite = &suite, .one = &one});
  std::mutex telling;
  size_t done = 0;
  parallel_for(report.cases.size(), options.jobs, [&](size_t i) {
    run_case(report.cases[i], decoder, options.locate);
    const std::lock_guard lock(telling);
    ++done;
    if (options.progress)
      options.progress(static_cast<double>(done) / static_cast<double>(report.cases.size()));
  });
  report.seconds = seconds_since(begin);
  return report;
}

}  // namespace afx::conformance
