// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "conformance/judge.h"

namespace afx::conformance {

struct CaseOutcome {
  const Suite* suite = nullptr;
  const Case* one = nullptr;
  std::vector<Outcome> checks = {};  ///< one for each of Case::expect
  double seconds = 0;

  /// Failed if a check failed, not run if none was judged.
  [[nodiscard]] Verdict verdict() const;
};

struct Counts {
  uint64_t passed = 0;
  uint64_t failed = 0;
  uint64_t not_run = 0;

  void add(Verdict verdict);
  [[nodiscard]] uint64_t all() const { return passed + failed + not_run; }
};

/// What came of the cases of some suites, which it refers to.
struct Report {
  std::string decoder;
  std::vector<CaseOutcome> cases;  ///< in the order of the suites
  double seconds = 0;

  [[nodiscard]] Counts counts() const;  ///< of cases
};

struct RunOptions {
  std::string filter =
      {};             ///< only cases whose "suite/case" fits: * any text, ? a character; "": all
  unsigned jobs = 0;  ///< cases at a time; 0 = all cores
  LocateValue locate = {};
  std::function<void(double done)> progress = {};  ///< 0..1; calls do not overlap
};

/// Judges a decoder by the cases of some suites, which must outlive the report. A stream whose file
/// is not as the suite says fails its checks.
Report run_suites(const std::vector<Suite>& suites, const Decoder& decoder,
                  const RunOptions& options);

/// Whether a name fits a pattern of * and ?.
bool fits_pattern(std::string_view name, std::string_view pattern);

}  // namespace afx::conformance
