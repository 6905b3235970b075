// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The rules that cases cover. Their form as a file: conformance/suites/rules.schema.json.
#pragma once

#include <string>
#include <vector>

#include "codec/error.h"
#include "conformance/suite.h"

namespace afx::conformance {

struct Rule {
  std::string id;
  std::string section;
  std::string text;
};

/// The rules of one text.
struct RuleSet {
  std::string area;
  std::string source;
  std::vector<Rule> rules;
};

/// Reads a file of rules.
/// Errors  io; malformed: it is no JSON or not of the form, an id is there twice
Result<RuleSet> read_rules(const std::string& path);

/// The rules that the suites name, each file once, in order.
/// Errors  those of read_rules; malformed: a case covers a rule that none of its suite's files has
Result<std::vector<RuleSet>> rules_of(const std::vector<Suite>& suites);

}  // namespace afx::conformance
