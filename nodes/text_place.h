// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Where in a text something is, and how it is shown to people.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "codec/error.h"

namespace afx::nodes {

/// Turns byte offsets of a text into lines and columns. Remembers the last one, so that a series of
/// rising offsets costs one pass over the text altogether.
class TextPlaces {
 public:
  explicit TextPlaces(std::string_view text) : text_(text) {}
  /// Lines end with LF, CR or CR LF. Columns count characters (UTF-8), from 1.
  Place at(size_t offset);

 private:
  std::string_view text_;
  size_t offset_ = 0;
  uint32_t line_ = 1;
  uint32_t column_ = 1;
};

/// The line with that offset and below it a line with a caret under it. Of a long line the part
/// around the place, with "..." where something is left out; tabs and control characters as blanks.
std::string excerpt_at(std::string_view text, size_t offset);

/// The offset of the first byte that is not part of valid UTF-8; npos if all is valid.
size_t find_invalid_utf8(std::string_view text);

}  // namespace afx::nodes
