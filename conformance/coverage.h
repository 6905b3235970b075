// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <string>
#include <vector>

#include "conformance/rules.h"
#include "conformance/suite.h"

namespace afx::conformance {

/// The cases that cover one rule, as "suite/case".
struct RuleCover {
  const Rule* rule = nullptr;
  std::vector<std::string> cases;
};

/// For each rule of a set, in its order.
std::vector<RuleCover> cover_of(const RuleSet& set, const std::vector<Suite>& suites);

/// A page for people: rules down, cases across, rules without a case in red. Needs nothing beside
/// it.
std::string coverage_page(const std::vector<RuleSet>& sets, const std::vector<Suite>& suites);

}  // namespace afx::conformance
