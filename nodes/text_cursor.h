// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The words, numbers and strings of scene text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "codec/diagnostics.h"
#include "codec/error.h"
#include "nodes/text_classes.h"
#include "nodes/text_place.h"

namespace afx::nodes {

/// Goes over a text. The first failure sticks: the cursor then stands at the end of the text, so
/// that every loop ends as it does there, and later failures are not noted.
class TextCursor {
 public:
  /// Hears, about once in a megabyte, up to which offset the text has been gone over.
  using Passed = std::function<void(size_t offset)>;

  /// passed  may be empty; must live as long as the cursor
  TextCursor(std::string_view text, Diagnostics& diagnostics, const Passed* passed = nullptr);

  [[nodiscard]] bool ok() const { return ok_; }
  [[nodiscard]] const Error& error() const { return error_; }
  [[nodiscard]] size_t offset() const { return static_cast<size_t>(at_ - text_.data()); }
  [[nodiscard]] std::string_view text() const { return text_; }
  /// Goes to an offset of the text, unless there has been a failure.
  void seek(size_t offset) {
    if (ok_) at_ = text_.data() + offset;
  }
  [[nodiscard]] size_t bytes_left() const { return static_cast<size_t>(end_ - at_); }

  /// Goes over the byte order mark that some editors put first.
  void skip_byte_order_mark();
  /// Goes over white space, commas and comments.
  void skip_space() {
    while (at_ != end_ && is_space(*at_)) ++at_;
    if (at_ != end_ && *at_ == '#') skip_comments();
  }
  /// Whether, after white space, the text ends.
  bool at_end();
  /// The next character after white space, NUL at the end.
  char peek() {
    skip_space();
    return at_ == end_ ? '\0' : *at_;
  }
  /// Takes the character if it is next after white space.
  bool accept(char c);
  /// The same where it must be there: `[`, `{`, `.` and so on.
  bool expect(char c, std::string_view after);
  /// The word that is next after white space, not taken; empty if there is none. Words are VRML's
  /// identifiers.
  std::string_view peek_word();
  /// Takes the word that is next; empty if there is none.
  std::string_view take_word();
  /// Takes the word if it is next.
  bool accept_word(std::string_view word);
  /// Takes everything up to white space or a bracket: what a number is made of.
  std::string_view take_token();

  /// Numbers; 0 and a failure if there is none, or it does not fit. Integers also as 0x..., those
  /// above 0x7FFFFFFF meaning their bits. Floats also inf, nan, nan(0xBITS); too small ones become
  /// 0.
  int32_t int32();
  uint32_t uint32();
  uint64_t uint64();  ///< decimal only
  float float32();
  double float64();
  /// TRUE, FALSE, true, false.
  bool boolean();
  /// A string in quotes with \" and \\; other backslashes stand for themselves.
  std::string string();
  /// Whether \\ in a string stands for itself.
  void keep_double_backslashes(bool keep) { double_backslashes_ = keep; }
  /// What is between `{` and the `}` that belongs to it, strings and comments taken as such.
  std::string_view braces();

  /// How many words or numbers stand before the next `]`, comments left out; an upper bound for the
  /// length of a list. Takes nothing.
  [[nodiscard]] size_t count_tokens_in_list() const;

  /// Tells how far the text has been gone over, if it is time to; for the loops over long lists.
  void note_progress() {
    if (at_ >= next_note_) tell_passed();
  }

  /// Notes a failure at an offset.
  void fail(Errc code, size_t offset, std::string text);
  /// Notes that something else stands here than `expected`, e.g. "a number".
  void fail_expected(std::string_view expected);
  /// Notes that a bracket opened at `opened` is never closed, or that something else stands here.
  void fail_unclosed(size_t opened, std::string_view expected);
  void warn(std::string code, size_t offset, std::string text);
  [[nodiscard]] Place place(size_t offset) { return places_.at(offset); }

  /// What is being read, put before the texts of failures: "Transform", "translation".
  struct Context {
    std::string_view node, field;
  };
  Context context;

 private:
  void skip_comments();
  void tell_passed();
  const char* count_in_part(const char* at, const char* stop, size_t& count) const;
  template <class T>
  T float_number();
  template <class T>
  T float_slow();
  int64_t integer_slow(int64_t low, int64_t high, std::string_view kind);
  void check_utf8(std::string_view bytes, size_t offset);

  std::string_view text_;
  const char* at_;
  const char* end_;
  const char* next_note_;  // where the next progress is told, at the latest at the end
  const Passed* passed_;
  bool ok_ = true;
  bool double_backslashes_ = false;
  Error error_;
  Diagnostics* diagnostics_;
  TextPlaces places_;
};

/// Text for a message: shortened, in quotes.
std::string quoted(std::string_view text);
/// Whether a name can be written as a word: an identifier that is no keyword.
bool is_identifier(std::string_view name);

}  // namespace afx::nodes
