// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The files that a suite names, and finding suites in folders.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "codec/error.h"
#include "conformance/suite.h"

namespace afx::conformance {

/// The folders with a suite.json at or below these, in order of their names; links are not
/// followed. Errors  io: one is not there or cannot be read; malformed: there is no suite in it
Result<std::vector<std::string>> find_suites(const std::vector<std::string>& folders);

/// The bytes of a file of the suite. Errors  io; malformed: its SHA-256 is another
Result<std::vector<uint8_t>> read_suite_file(const Suite& suite, const SuiteFile& file);

/// The JSON of a file of the suite; one named .z is packed by zlib (RFC 1950), at most 256 MiB
/// unpacked. Errors  as read_suite_file; malformed: it is no JSON, or not packed right
Result<nlohmann::json> read_suite_json(const Suite& suite, const SuiteFile& file);

}  // namespace afx::conformance
