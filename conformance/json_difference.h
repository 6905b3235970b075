// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>

#include "conformance/suite.h"

namespace afx::conformance {

/// The first place where two documents differ.
struct JsonDifference {
  std::string path;      ///< JSON pointer
  std::string expected;  ///< the value there as short JSON; "nothing" where it is not there
  std::string found;
};

/// Compares two documents in depth: lists by place, objects by the names of their members in
/// alphabetical order, numbers by value (1 is 1.0) or, where a tolerance names them, within it.
std::optional<JsonDifference> first_difference(const nlohmann::json& expected,
                                               const nlohmann::json& found,
                                               std::span<const Tolerance> tolerances);

}  // namespace afx::conformance
