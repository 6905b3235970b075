// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "codec/error.h"

namespace afx::bifs {

/// Where the bits of a script go.
using ScriptBits = std::function<void(uint64_t value, unsigned bits)>;

/// Parses the text of a script and writes it as the token tree of BIFS.
///
/// text         `javascript:` (also ecmascript:, vrmlscript:) and then functions; empty: no
/// function identifiers  the names of the declared fields: known from the start Errors unsupported:
/// the text is not inline, or what it says is not in the subset that the
///              tree can hold (place: line and column in the text)
Status encode_script(std::string_view text, std::vector<std::string> identifiers,
                     const ScriptBits& put);

}  // namespace afx::bifs
