// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The parser works in a copy and leaves entities as they are; a place in the copy is the same place
// in the text.
#include "bifs/xmt_document.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "nodes/nearest_name.h"
#include "nodes/text_cursor.h"

namespace afx::bifs {

namespace {

constexpr std::string_view kWhiteSpace = " \t\r\n";

struct Entity {
  std::string_view name;
  char character;
};
constexpr Entity kEntities[] = {
    {"lt", '<'}, {"gt", '>'}, {"amp", '&'}, {"quot", '"'}, {"apos", '\''}};

void append_utf8(std::string& out, uint32_t code) {
  const auto put = [&](uint32_t byte) { out += static_cast<char>(byte); };
  if (code < 0x80) return put(code);
  const unsigned more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
  put((0xFF00U >> (more + 1) & 0xFF) | code >> 6 * more);
  for (unsigned i = more; i-- > 0;) put(0x80 | (code >> 6 * i & 0x3F));
}

/// What is between & and ; as characters; false if it is no entity.
bool append_entity(std::string& out, std::string_view entity) {
  for (const Entity& known : kEntities)
    if (entity == known.name) return out += known.character, true;
  if (!entity.starts_with('#')) return false;
  const bool hex = entity.starts_with("#x");
  entity.remove_prefix(hex ? 2 : 1);
  uint32_t code = 0;
  const char* const end = entity.data() + entity.size();
  const auto [stop, failure] = std::from_chars(entity.data(), end, code, hex ? 16 : 10);
  const bool surrogate = code >= 0xD800 && code < 0xE000;
  if (failure != std::errc{} || stop != end || code == 0 || code > 0x10FFFF || surrogate)
    return false;
  append_utf8(out, code);
  return true;
}

/// Takes one character as it is written from the front and appends what it means; false at an
/// entity that is none.
bool append_next(std::string& out, std::string_view& from) {
  if (from[0] == '&') {
    constexpr size_t kLongest = 12;
    const size_t end = from.substr(0, kLongest).find(';');
    if (end == std::string_view::npos || !append_entity(out, from.substr(1, end - 1))) return false;
    from.remove_prefix(end + 1);
    return true;
  }
  const bool carriage_return = from[0] == '\r';
  out += carriage_return ? '\n' : from[0];
  from.remove_prefix(carriage_return && from.starts_with("\r\n") ? 2 : 1);
  return true;
}

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

}  // namespace

XmtDocument::XmtDocument(std::string_view text, const Limits& limits, Diagnostics& diagnostics)
    : text_(text), diagnostics_(&diagnostics), places_(text) {
  const size_t zero = text.find('\0');
  if (zero != std::string_view::npos)
    fail_at(Errc::malformed, zero, "a byte of 0 [expected an XML text in UTF-8]");
  if (memory_needed() > limits.memory)
    fail_at(Errc::limit_exceeded, 0, "a text that takes more than the limit memory allows");
  if (ok_) parse();
}

/// An upper bound: an element or text takes a node, and each begins behind '<' or '>'.
uint64_t XmtDocument::memory_needed() const {
  constexpr uint64_t kNode = 72, kAttribute = 48;
  uint64_t bytes = text_.size();
  for (const char c : text_) bytes += c == '<' || c == '>' ? kNode : c == '=' ? kAttribute : 0;
  return bytes;
}

void XmtDocument::parse() {
  copy_ = std::string(text_);
  const pugi::xml_parse_result parsed = document_.load_buffer_inplace(
      copy_.data(), copy_.size(), pugi::parse_cdata, pugi::encoding_utf8);
  for (const pugi::xml_node outer : document_.children())
    if (parsed && outer != document_.document_element())
      fail(name(outer), "a second outermost element [expected the end of the text]");
  if (parsed) return;
  if (parsed.status == pugi::status_out_of_memory)
    return fail_at(Errc::no_memory, 0, "no memory for the text");
  fail_at(Errc::malformed, static_cast<size_t>(parsed.offset),
          std::string("not well-formed XML: ") + parsed.description());
}

pugi::xml_node XmtDocument::root() const {
  return ok_ ? document_.document_element() : pugi::xml_node{};
}

std::string_view XmtDocument::part(const char* in_copy) const {
  const char* const begin = copy_.data();
  if (in_copy < begin || in_copy > begin + copy_.size()) return text_.substr(0, 0);
  return text_.substr(static_cast<size_t>(in_copy - begin), std::string_view(in_copy).size());
}

std::string_view XmtDocument::value(pugi::xml_attribute attribute) const {
  const std::string_view found = part(attribute.value());
  return found.data() != text_.data() ? found : name(attribute).substr(0, 0);
}

size_t XmtDocument::offset(std::string_view part) const {
  return static_cast<size_t>(part.data() - text_.data());
}

std::string XmtDocument::decode(std::string_view part) {
  if (part.find_first_of("&\r") == std::string_view::npos) return std::string(part);
  std::string out;
  for (std::string_view left = part; !left.empty();) {
    if (append_next(out, left)) continue;
    fail(left, nodes::quoted(left.substr(0, left.find(';') + 1)) +
                   " is no character [expected &amp; &lt; &gt; &quot; &apos; or a number that XML "
                   "allows, as &#233;]");
    return {};
  }
  return out;
}

void XmtDocument::fail(std::string_view where, std::string text, Errc code) {
  fail_at(code, offset(where), std::move(text));
}

void XmtDocument::fail_at(Errc code, size_t offset, std::string text) {
  if (!ok_) return;
  ok_ = false;
  error_ = {code, places_.at(offset), std::move(text), nodes::excerpt_at(text_, offset)};
}

void XmtDocument::fail_inside(std::string_view part, size_t shift, const Error& error) {
  if (!ok_) return;
  // The cursor counted lines and columns of the decoded text: go along with it.
  std::string_view left = part;
  Place at = Place::at_line(1, 1 + static_cast<uint32_t>(shift));
  const auto is_before = [&] {
    return at.line < error.place.line ||
           (at.line == error.place.line && at.column < error.place.column);
  };
  while (!left.empty() && is_before()) {
    std::string next;
    if (!append_next(next, left)) break;
    const bool line_end = next == "\n";
    at.column = line_end ? 1 : at.column + (is_continuation(next[0]) ? 0 : 1);
    at.line += line_end ? 1 : 0;
  }
  fail(left, error.text, error.code == Errc::truncated ? Errc::malformed : error.code);
}

void XmtDocument::warn(std::string code, std::string_view where, std::string text) {
  const bool kept = diagnostics_->warnings().size() < Diagnostics::kKept;  // places cost time
  diagnostics_->warn(std::move(code), kept ? places_.at(offset(where)) : Place{}, std::move(text));
}

std::optional<std::string_view> XmtAttributes::find(const char* name) {
  asked_.emplace_back(name);
  const pugi::xml_attribute attribute = element_.attribute(name);
  if (!attribute) return std::nullopt;
  found_.push_back(attribute);
  return document_.value(attribute);
}

std::string XmtAttributes::text(const char* name) {
  const auto value = find(name);
  return value ? document_.decode(*value) : std::string();
}

std::string XmtAttributes::need(const char* name) {
  const auto value = find(name);
  if (value) return document_.decode(*value);
  document_.fail(where(), std::string(where()) + " without " + name + " [expected that attribute]");
  return {};
}

std::optional<uint64_t> XmtAttributes::number(const char* name, uint64_t largest,
                                              std::string_view prefix) {
  const auto value = find(name);
  if (!value) return std::nullopt;
  const std::string_view digits =
      value->starts_with(prefix) ? value->substr(prefix.size()) : *value;
  const auto number = xmt_number(digits, largest);
  if (!number)
    document_.fail(*value, std::string(name) + " " + nodes::quoted(*value) + " [expected 0 to " +
                               std::to_string(largest) + "]");
  return number;
}

std::optional<bool> XmtAttributes::flag(const char* name) {
  const auto value = find(name);
  if (!value) return std::nullopt;
  for (const std::string_view yes : {"true", "TRUE", "yes"})
    if (*value == yes) return true;
  for (const std::string_view no : {"false", "FALSE", "no"})
    if (*value == no) return false;
  document_.fail(*value,
                 std::string(name) + " " + nodes::quoted(*value) + " [expected true or false]");
  return std::nullopt;
}

void XmtAttributes::finish() {
  for (const pugi::xml_attribute attribute : element_.attributes()) {
    if (std::find(found_.begin(), found_.end(), attribute) != found_.end()) continue;
    const std::string_view name = document_.name(attribute);
    const bool twice = std::find(asked_.begin(), asked_.end(), name) != asked_.end();
    nodes::NearestName nearest(name);
    for (const std::string_view known : asked_) nearest.offer(known);
    document_.fail(name, std::string(where()) + (twice ? ": a second " : ": no attribute ") +
                             nodes::quoted(name) + (twice ? "" : nearest.hint()));
  }
}

std::optional<uint64_t> xmt_number(std::string_view text, uint64_t largest) {
  const bool hex = text.starts_with("0x");
  if (hex) text.remove_prefix(2);
  uint64_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, failure] = std::from_chars(text.data(), end, number, hex ? 16 : 10);
  if (failure != std::errc{} || stop != end || number > largest) return std::nullopt;
  return number;
}

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  for (size_t at = text.find_first_not_of(kWhiteSpace); at != std::string_view::npos;) {
    const size_t end = std::min(text.find_first_of(kWhiteSpace, at), text.size());
    words.push_back(text.substr(at, end - at));
    at = text.find_first_not_of(kWhiteSpace, end);
  }
  return words;
}

}  // namespace afx::bifs
