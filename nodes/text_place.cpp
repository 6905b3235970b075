// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "nodes/text_place.h"

#include <algorithm>
#include <cstdint>

namespace afx::nodes {

namespace {

constexpr size_t kBefore = 60, kAfter = 40;  // bytes of a long line that are shown

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

size_t line_begin(std::string_view text, size_t offset) {
  while (offset > 0 && text[offset - 1] != '\n' && text[offset - 1] != '\r') --offset;
  return offset;
}

/// Number of bytes that a lead byte announces, 0 if it cannot lead; `low` and `high` bound the
/// second.
size_t sequence_length(unsigned char lead, unsigned char& low, unsigned char& high) {
  low = 0x80;
  high = 0xBF;
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead <= 0xDF) return 2;
  if (lead >= 0xE0 && lead <= 0xEF) {
    if (lead == 0xE0) low = 0xA0;   // no overlong forms
    if (lead == 0xED) high = 0x9F;  // no surrogates
    return 3;
  }
  if (lead >= 0xF0 && lead <= 0xF4) {
    if (lead == 0xF0) low = 0x90;
    if (lead == 0xF4) high = 0x8F;  // nothing above U+10FFFF
    return 4;
  }
  return 0;
}

}  // namespace

Place TextPlaces::at(size_t offset) {
  offset = std::min(offset, text_.size());
  if (offset < offset_) *this = TextPlaces(text_);
  for (; offset_ < offset; ++offset_) {
    const char c = text_[offset_];
    const bool pair = c == '\r' && offset_ + 1 < text_.size() && text_[offset_ + 1] == '\n';
    if (c == '\n' || (c == '\r' && !pair)) {
      ++line_;
      column_ = 1;
    } else if (!is_continuation(c)) {
      ++column_;
    }
  }
  return Place::at_line(line_, column_);
}

std::string excerpt_at(std::string_view text, size_t offset) {
  offset = std::min(offset, text.size());
  size_t begin = line_begin(text, offset);
  size_t end = std::min(text.find_first_of("\r\n", offset), text.size());
  std::string line, caret;
  if (offset - begin > kBefore) {
    begin = offset - kBefore;
    while (begin < offset && is_continuation(text[begin])) ++begin;
    line = caret = "...";
  }
  const bool cut = end - offset > kAfter;
  if (cut) end = offset + kAfter;
  while (cut && end > offset && is_continuation(text[end])) --end;
  for (size_t i = begin; i < end; ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    line += c < 0x20 || c == 0x7F ? ' ' : text[i];
    if (i < offset && !is_continuation(text[i])) caret += ' ';
  }
  std::replace(caret.begin(), caret.end(), '.', ' ');
  return line + (cut ? "...\n" : "\n") + caret + '^';
}

size_t find_invalid_utf8(std::string_view text) {
  size_t i = 0;
  while (i < text.size()) {
    unsigned char low = 0, high = 0;
    const size_t length = sequence_length(static_cast<unsigned char>(text[i]), low, high);
    if (length == 0 || i + length > text.size()) return i;
    for (size_t k = 1; k < length; ++k) {
      const auto c = static_cast<unsigned char>(text[i + k]);
      if (c < low || c > high) return i;
      low = 0x80;
      high = 0xBF;
    }
    i += length;
  }
  return std::string_view::npos;
}

}  // namespace afx::nodes
