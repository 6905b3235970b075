// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Source: ISO/IEC 14772-1:1997 (VRML97), grammar (clause not checked).
#include "nodes/text_cursor.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace afx::nodes {

namespace {

constexpr std::string_view kKeywords[] = {"DEF",     "EXTERNPROTO", "FALSE", "IS",          "NULL",
                                          "PROTO",   "ROUTE",       "TO",    "TRUE",        "USE",
                                          "eventIn", "eventOut",    "field", "exposedField"};

constexpr size_t kShownBytes = 40;
constexpr ptrdiff_t kProgress = ptrdiff_t{1} << 20;  // bytes from one note to the next
constexpr ptrdiff_t kPart = ptrdiff_t{1} << 15;      // of a list, small enough for the cache

}  // namespace

std::string quoted(std::string_view text) {
  std::string out = "'";
  size_t shown = std::min(text.size(), kShownBytes);
  while (shown < text.size() && shown > 0 &&
         (static_cast<unsigned char>(text[shown]) & 0xC0) == 0x80)
    --shown;
  for (const char c : text.substr(0, shown)) out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  return out + (shown < text.size() ? "...'" : "'");
}

bool is_identifier(std::string_view name) {
  if (name.empty() || !is_word_begin(name[0])) return false;
  if (!std::all_of(name.begin(), name.end(), is_word_char)) return false;
  return std::find(std::begin(kKeywords), std::end(kKeywords), name) == std::end(kKeywords);
}

TextCursor::TextCursor(std::string_view text, Diagnostics& diagnostics, const Passed* passed)
    : text_(text),
      at_(text.data()),
      end_(text.data() + text.size()),
      next_note_(std::min(end_ - at_, kProgress) + at_),
      passed_(passed != nullptr && *passed ? passed : nullptr),
      diagnostics_(&diagnostics),
      places_(text) {}

void TextCursor::skip_byte_order_mark() {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  if (offset() == 0 && text_.starts_with(kMark)) at_ += kMark.size();
}

void TextCursor::skip_comments() {
  while (at_ != end_ && *at_ == '#') {
    while (at_ != end_ && *at_ != '\n' && *at_ != '\r') ++at_;
    while (at_ != end_ && is_space(*at_)) ++at_;
  }
}

bool TextCursor::at_end() {
  skip_space();
  return at_ == end_;
}

bool TextCursor::accept(char c) {
  note_progress();
  skip_space();
  if (at_ == end_ || *at_ != c) return false;
  ++at_;
  return true;
}

bool TextCursor::expect(char c, std::string_view after) {
  if (accept(c)) return true;
  fail_expected(std::string("'") + c + "' after " + std::string(after));
  return false;
}

std::string_view TextCursor::peek_word() {
  skip_space();
  if (at_ == end_ || !is_word_begin(*at_)) return {};
  const char* const stop = std::find_if_not(at_, end_, is_word_char);
  return {at_, static_cast<size_t>(stop - at_)};
}

std::string_view TextCursor::take_word() {
  const std::string_view word = peek_word();
  if (!word.empty()) check_utf8(word, offset());
  at_ += word.size();
  return word;
}

bool TextCursor::accept_word(std::string_view word) {
  if (peek_word() != word) return false;
  at_ += word.size();
  return true;
}

std::string_view TextCursor::take_token() {
  skip_space();
  const char* const begin = at_;
  at_ = std::find_if(at_, end_, is_delimiter);
  return {begin, static_cast<size_t>(at_ - begin)};
}

bool TextCursor::boolean() {
  for (const bool value : {true, false})
    if (accept_word(value ? "TRUE" : "FALSE") || accept_word(value ? "true" : "false"))
      return value;
  fail_expected("TRUE or FALSE");
  return false;
}

std::string TextCursor::string() {
  skip_space();
  const size_t opened = offset();
  std::string out;
  if (!accept('"')) {
    fail_expected("a string in quotes");
    return out;
  }
  for (;;) {
    const char* const stop = std::find_if(at_, end_, [](char c) { return c == '"' || c == '\\'; });
    out.append(at_, stop);
    at_ = stop;
    if (at_ == end_) {
      fail(Errc::truncated, opened, "the string that begins here is never closed [expected '\"']");
      return {};
    }
    ++at_;
    if (*stop == '"') break;
    const bool escape = at_ != end_ && (*at_ == '"' || *at_ == '\\');
    if (escape && *at_ == '\\' && double_backslashes_) out += '\\';
    out += escape ? *at_++ : '\\';
  }
  check_utf8({text_.data() + opened, offset() - opened}, opened);
  return out;
}

std::string_view TextCursor::braces() {
  skip_space();
  const size_t opened = offset();
  if (!expect('{', "the field name")) return {};
  const char* const begin = at_;
  for (size_t depth = 1; at_ != end_;) {
    const char c = *at_;
    if (c == '#') {
      skip_space();
      continue;
    }
    if (c == '"') {
      (void)string();
      continue;
    }
    ++at_;
    if (c == '{') ++depth;
    if (c == '}' && --depth == 0) return {begin, static_cast<size_t>(at_ - begin - 1)};
  }
  fail_unclosed(opened, "'}'");
  return {};
}

void TextCursor::check_utf8(std::string_view bytes, size_t offset) {
  const size_t bad = find_invalid_utf8(bytes);
  if (bad != std::string_view::npos)
    warn("invalid_utf8", offset + bad, "a byte that is not UTF-8; it is kept");
}

size_t TextCursor::count_tokens_in_list() const {
  size_t count = 0;
  const char* told = at_;
  for (const char* at = at_; at != end_ && *at != ']';) {
    at = count_in_part(at, std::min(end_ - at, kPart) + at, count);
    if (passed_ == nullptr || at - told < kProgress) continue;
    (*passed_)(static_cast<size_t>(at - text_.data()));
    told = at;
  }
  return count;
}

/// Counts the tokens that begin before `stop` or the first `]`, or, where there are comments,
/// before the end of the one that goes on behind `stop`; how far it came.
const char* TextCursor::count_in_part(const char* at, const char* stop, size_t& count) const {
  const auto find = [&](char c) { return std::memchr(at, c, static_cast<size_t>(stop - at)); };
  const auto add = [&](const char* end) {
    count += count_tokens(at, end, at == text_.data() || is_delimiter(at[-1]));
    at = end;
  };
  if (const void* const close = find(']'); close != nullptr) stop = static_cast<const char*>(close);
  if (find('#') == nullptr) return add(stop), stop;
  while (at < stop) {  // line by line; the `]` may have been in a comment
    add(std::find(at, stop, '#'));
    if (at != stop) at = std::find_if(at, end_, [](char c) { return c == '\n' || c == '\r'; });
  }
  return at;
}

void TextCursor::tell_passed() {
  if (passed_ == nullptr || at_ == end_) return;
  (*passed_)(offset());
  next_note_ = std::min(end_ - at_, kProgress) + at_;
}

void TextCursor::fail(Errc code, size_t offset, std::string text) {
  if (!ok_) return;
  ok_ = false;
  error_.code = code;
  error_.place = places_.at(offset);
  error_.excerpt = excerpt_at(text_, offset);
  if (!context.node.empty()) error_.text = std::string(context.node);
  if (!context.field.empty()) (error_.text += '.') += context.field;
  if (!error_.text.empty()) error_.text += ": ";
  error_.text += text;
  at_ = end_;
}

void TextCursor::fail_expected(std::string_view expected) {
  skip_space();
  const std::string wanted = " [expected " + std::string(expected) + "]";
  if (at_ == end_) return fail(Errc::truncated, offset(), "the text ends here" + wanted);
  const size_t begin = offset();
  std::string_view found = take_token();
  if (found.empty()) found = text_.substr(begin, 1);
  fail(Errc::malformed, begin, "found " + quoted(found) + wanted);
}

void TextCursor::fail_unclosed(size_t opened, std::string_view expected) {
  if (!ok_) return;
  if (!at_end()) return fail_expected(expected);
  const std::string where = to_string(places_.at(opened));
  fail(Errc::truncated, offset(),
       "the text ends here, and " + quoted(text_.substr(opened, 1)) + " of " + where +
           " is still open [expected " + std::string(expected) + "]");
}

void TextCursor::warn(std::string code, size_t offset, std::string text) {
  const bool kept = diagnostics_->warnings().size() < Diagnostics::kKept;  // places cost time
  diagnostics_->warn(std::move(code), kept ? places_.at(offset) : Place{}, std::move(text));
}

}  // namespace afx::nodes
