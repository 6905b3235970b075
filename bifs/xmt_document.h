// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// XML as the reader of XMT-A wants it: elements, attributes and where in the text they stand.
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"
#include "nodes/text_place.h"

namespace afx::bifs {

/// A parsed XML text. What it hands out are parts of the text as it is written, so that they say
/// where they stand. The first failure sticks; later ones are not noted.
class XmtDocument {
 public:
  /// `text` must stay. Failures: malformed (not well-formed), limit_exceeded, no_memory.
  XmtDocument(std::string_view text, const Limits& limits, Diagnostics& diagnostics);

  /// The outermost element; none after a failure.
  [[nodiscard]] pugi::xml_node root() const;
  [[nodiscard]] std::string_view name(pugi::xml_node element) const { return part(element.name()); }
  [[nodiscard]] std::string_view name(pugi::xml_attribute a) const { return part(a.name()); }
  /// With its entities as they are written, see decode().
  [[nodiscard]] std::string_view value(pugi::xml_attribute attribute) const;
  [[nodiscard]] std::string_view value(pugi::xml_node text) const { return part(text.value()); }

  /// A part of the text with its entities and line ends resolved. Fails at an unknown entity.
  std::string decode(std::string_view part);

  [[nodiscard]] bool ok() const { return ok_; }
  [[nodiscard]] const Error& error() const { return error_; }
  /// Notes a failure at a part of the text.
  void fail(std::string_view where, std::string text, Errc code = Errc::malformed);
  /// Notes a failure of a cursor that read decode(part) behind `shift` characters put before it.
  void fail_inside(std::string_view part, size_t shift, const Error& error);
  void warn(std::string code, std::string_view where, std::string text);

 private:
  void parse();
  [[nodiscard]] uint64_t memory_needed() const;
  [[nodiscard]] size_t offset(std::string_view part) const;
  [[nodiscard]] std::string_view part(const char* in_copy) const;
  void fail_at(Errc code, size_t offset, std::string text);

  std::string_view text_;
  std::string copy_;  ///< the parser writes in it
  pugi::xml_document document_;
  Diagnostics* diagnostics_;
  nodes::TextPlaces places_;
  bool ok_ = true;
  Error error_;
};

/// The attributes of one element, asked for by name.
class XmtAttributes {
 public:
  XmtAttributes(XmtDocument& document, pugi::xml_node element)
      : document_(document), element_(element) {}

  /// The value as it is written; none if the element has no such attribute.
  std::optional<std::string_view> find(const char* name);
  /// The value, decoded; empty and a failure if there is no such attribute.
  std::string need(const char* name);
  /// The value, decoded; empty if there is no such attribute.
  std::string text(const char* name);
  /// An unsigned number up to `largest`, behind a prefix that it may have; none if there is no such
  /// attribute or after a failure.
  std::optional<uint64_t> number(const char* name, uint64_t largest, std::string_view prefix = "");
  /// true, false, yes, no.
  std::optional<bool> flag(const char* name);
  /// Fails if the element has an attribute that was not asked for.
  void finish();
  [[nodiscard]] std::string_view where() const { return document_.name(element_); }

 private:
  XmtDocument& document_;
  pugi::xml_node element_;
  std::vector<std::string_view> asked_;
  std::vector<pugi::xml_attribute> found_;
};

/// An unsigned number, decimal or 0x...; none if it is none or above `largest`.
std::optional<uint64_t> xmt_number(std::string_view text, uint64_t largest);
/// The words of a text, split at white space.
std::vector<std::string_view> words_of(std::string_view text);

}  // namespace afx::bifs
