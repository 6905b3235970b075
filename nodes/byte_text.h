// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Bytes in scene text (BitWrapper.buffer), in the forms that BT has.
#pragma once

#include <string>
#include <string_view>

#include "codec/error.h"

namespace afx::nodes {

/// The bytes that a text stands for: "" none; "data:application/octet-string,00FF" hex; the same
/// with
/// ";base64," base64; "0x00FF" or "00FF" hex. Errors: malformed (none of these; an odd number of
/// digits).
Result<std::string> bytes_of_text(std::string_view text);

/// "data:application/octet-string;base64,..."; "" for no bytes.
std::string text_of_bytes(std::string_view bytes);

}  // namespace afx::nodes
