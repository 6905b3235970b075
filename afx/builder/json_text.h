// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>

#include "codec/error.h"
#include "codec/limits.h"

namespace afx {

/// Parses a JSON text.
/// Errors  malformed, with line and column: it is no JSON; a number is too large; limit_exceeded:
///         the document would take more than limits.memory
Result<nlohmann::json> parse_json(std::span<const uint8_t> bytes, const Limits& limits);

}  // namespace afx
