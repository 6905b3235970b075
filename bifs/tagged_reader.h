// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Tag and length, as descriptors and object descriptor commands begin. Source: ISO/IEC 14496-1,
// expandable classes (clause not checked); spec/bifs.md 15.2.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "codec/bit_reader.h"

namespace afx::bifs {

/// How a tagged structure begins.
struct TaggedHeader {
  uint8_t tag = 0;
  std::string name;          ///< for paths and texts
  uint64_t length = 0;       ///< bytes of the payload that follows; they are there
  uint8_t length_bytes = 0;  ///< of the length; 0: as few as can be
};

/// Reads tag and length.
///
/// name_of    the name that belongs to a tag
/// prefix     what stands before the name, "" or "outer/"
/// container  what the structure is in, e.g. "access unit"
/// Errors     of `in`: truncated (also where the payload is longer than what is left);
///            malformed (tag 0 or 0xFF, a length of more than 4 bytes)
TaggedHeader read_tagged_header(codec::BitReader& in, const char* (*name_of)(uint8_t tag),
                                const std::string& prefix, std::string_view container);

}  // namespace afx::bifs
