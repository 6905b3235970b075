// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The classes of characters in scene text.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace afx::nodes {

enum CharClass : uint8_t { kSpaceChar = 1, kDelimiterChar = 2, kWordChar = 4, kWordBegin = 8 };

constexpr std::array<uint8_t, 256> make_char_classes() {
  std::array<uint8_t, 256> classes{};
  for (unsigned c = 0; c < 256; ++c) {
    const char ch = static_cast<char>(c);
    const bool space = std::string_view(" \t\n\r\v\f,").find(ch) != std::string_view::npos;
    const bool bracket = std::string_view("[]{}\"#").find(ch) != std::string_view::npos;
    const bool word = c > 0x20 && c != 0x7F && !bracket && !space &&
                      std::string_view("'.\\").find(ch) == std::string_view::npos;
    const bool begin = word && ch != '+' && ch != '-' && !(ch >= '0' && ch <= '9');
    classes[c] = static_cast<uint8_t>((space ? kSpaceChar | kDelimiterChar : 0) |
                                      (bracket ? kDelimiterChar : 0) | (word ? kWordChar : 0) |
                                      (begin ? kWordBegin : 0));
  }
  return classes;
}

inline constexpr std::array<uint8_t, 256> kCharClasses = make_char_classes();

constexpr bool has_class(char c, CharClass which) {
  return (kCharClasses[static_cast<unsigned char>(c)] & which) != 0;
}
constexpr bool is_space(char c) { return has_class(c, kSpaceChar); }
constexpr bool is_delimiter(char c) { return has_class(c, kDelimiterChar); }
constexpr bool is_word_char(char c) { return has_class(c, kWordChar); }
constexpr bool is_word_begin(char c) { return has_class(c, kWordBegin); }

/// The number of runs of characters that are not white space and begin in a text without comments;
/// before: whether white space is before it. Written so that compilers vectorise it: it goes over a
/// list before the list is read.
inline size_t count_tokens(const char* at, const char* end, bool before) {
  size_t count = 0;
  while (at != end) {
    const auto length =
        static_cast<size_t>(end - at) < 4096 ? static_cast<size_t>(end - at) : size_t{4096};
    count += before && !(at[0] <= ' ' || at[0] == ',') ? 1U : 0U;
    uint32_t begins = 0;
    for (size_t i = 1; i < length; ++i) {
      const bool gap = at[i - 1] <= ' ' || at[i - 1] == ',';
      const bool now = at[i] <= ' ' || at[i] == ',';
      begins += static_cast<uint32_t>(gap && !now);
    }
    count += begins;
    before = at[length - 1] <= ' ' || at[length - 1] == ',';
    at += length;
  }
  return count;
}

}  // namespace afx::nodes
