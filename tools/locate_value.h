// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "codec/limits.h"
#include "conformance/decoder.h"

namespace afx::tools {

/// The bit of the file at which the value at a JSON pointer of an answer is coded, as our decoder
/// reads the stream: of an OctreeImage stream the symbol (codec/octree_symbol_place.h); of a scene
/// stream the value, or what can be told of where it is: its field, its node, its command or its
/// access unit. Nothing of other forms, and where the stream cannot be read.
std::optional<uint64_t> locate_value(const conformance::Question& question,
                                     const std::string& pointer, const Limits& limits);

}  // namespace afx::tools
