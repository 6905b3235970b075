// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "conformance/rules.h"
#include "conformance/runner.h"

namespace afx::conformance {

/// For continuous integration: XML as JUnit has it, a testsuite for each suite and a testcase for
/// each case.
std::string junit_report(const Report& report);

/// For programs: the decoder, the counts, and each case with its checks.
nlohmann::ordered_json json_report(const Report& report);

/// For people: one HTML page that needs nothing beside it. What failed comes first, explained, with
/// pictures side by side; then every case of every suite.
std::string html_report(const Report& report, const std::vector<RuleSet>& rules);

/// "12 passed, 1 failed, 0 not run".
std::string to_string(const Counts& counts);

}  // namespace afx::conformance
