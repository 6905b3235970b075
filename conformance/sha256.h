// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace afx::conformance {

/// The SHA-256 of some bytes as 64 small hexadecimal digits. Source: FIPS 180-4.
std::string sha256(std::span<const uint8_t> bytes);

}  // namespace afx::conformance
