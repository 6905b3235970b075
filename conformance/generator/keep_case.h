// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "codec/error.h"

namespace afx::conformance {

/// A check of a suite, as in suite.schema.json, but for `file` and `sha256`: `expected` is what the
/// file is to hold, null where the check has none.
struct KeptCheck {
  nlohmann::json check;
  nlohmann::json expected = {};
};

/// A stream and what must hold of it.
struct KeptCase {
  std::string kind;  ///< as Case::kind
  std::vector<uint8_t> stream;
  std::vector<KeptCheck> checks;
};

/// Writes a suite of one case into a folder, which is made: suite.json, the stream, and a file for
/// each check that has values. name: of suite and case, as the schema wants it; about: in one line.
/// Errors  io
Status keep_case(const std::string& folder, const std::string& name, const std::string& about,
                 const KeptCase& kept);

}  // namespace afx::conformance
