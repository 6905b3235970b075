// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/xmt_values.h"

#include <algorithm>
#include <concepts>
#include <utility>

#include "nodes/byte_text.h"
#include "nodes/value_writer.h"

namespace afx::bifs {

using nodes::FieldType;
using nodes::FieldValue;
using nodes::Url;

namespace {

constexpr std::string_view kDescriptorUrl = "od://od";

bool is_text(FieldType type) {
  const FieldType one = element_type(type);
  return one == FieldType::sf_string || one == FieldType::sf_script || one == FieldType::sf_url;
}

/// "od://od10" is object descriptor 10.
Url url_of(std::string_view text) {
  if (!text.starts_with(kDescriptorUrl)) return Url::from_text(text);
  const Url url = Url::from_text("od:" + std::string(text.substr(kDescriptorUrl.size())));
  return url.is_descriptor() ? url : Url{std::string(text)};
}

std::string text_of(const Url& url) {
  if (!url.is_descriptor()) return url.text;
  return std::string(kDescriptorUrl) + std::to_string(url.object_descriptor);
}

bool starts_with_quote(std::string_view text) {
  const size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '"';
}

FieldValue one_text(FieldType type, std::string text) {
  switch (type) {
    case FieldType::sf_url:
      return url_of(text);
    case FieldType::mf_url:
      return std::vector<Url>{url_of(text)};
    case FieldType::mf_string:
    case FieldType::mf_script:
      return std::vector<std::string>{std::move(text)};
    default:
      return text;
  }
}

}  // namespace

template <class Read>
auto XmtValueReader::with_cursor(std::string_view attribute, const std::string& text, size_t shift,
                                 Read read) {
  Diagnostics warnings;
  nodes::TextCursor in(text, warnings);
  auto value = read(in);
  if (in.ok() && !in.at_end()) in.fail_expected("the end of the value");
  if (!in.ok()) document_.fail_inside(attribute, shift, in.error());
  for (const Warning& warning : warnings.warnings())
    document_.warn(warning.code, attribute, warning.text);
  return value;
}

bool XmtValueReader::take(std::string_view where, uint64_t count, uint64_t bytes_each) {
  if (!document_.ok()) return false;
  Diagnostics none;
  nodes::TextCursor nowhere({}, none);
  if (!budget_.take(nowhere, count, bytes_each))
    document_.fail(where, nowhere.error().text, nowhere.error().code);
  return document_.ok();
}

FieldValue XmtValueReader::read(std::string_view attribute, const nodes::FieldDefinition& field,
                                std::string_view node) {
  if (field.bytes) return read_bytes(attribute);
  std::string text = document_.decode(attribute);
  const bool list = is_multiple(field.type);
  const bool in_quotes = (list || field.type == FieldType::sf_url) && starts_with_quote(text);
  if (is_text(field.type) && !in_quotes) return read_text(attribute, std::move(text), field);
  if (list) text = "[" + text + "]";
  FieldValue value = with_cursor(attribute, text, list ? 1 : 0, [&](nodes::TextCursor& in) {
    in.context = {node, field.name};
    nodes::ValueReader values(in, limits_);
    values.budget() = budget_;
    FieldValue read = values.read(field.type);
    budget_ = values.budget();
    return read;
  });
  if (auto* url = std::get_if<Url>(&value); url != nullptr && !url->is_descriptor())
    *url = url_of(url->text);
  if (auto* urls = std::get_if<std::vector<Url>>(&value))
    for (Url& url : *urls)
      if (!url.is_descriptor()) url = url_of(url.text);
  return value;
}

/// Text without quotes: it is the whole attribute.
FieldValue XmtValueReader::read_text(std::string_view attribute, std::string text,
                                     const nodes::FieldDefinition& field) {
  const size_t bad = nodes::find_invalid_utf8(text);
  if (bad != std::string::npos)
    document_.warn("invalid_utf8", attribute, "a byte that is not UTF-8; it is kept");
  const bool blank = text.find_first_not_of(" \t\r\n") == std::string::npos;
  if (is_multiple(field.type) && blank) return zero_value(field.type);
  if (!take(attribute, 1, sizeof(std::string) + text.size())) return zero_value(field.type);
  return one_text(field.type, std::move(text));
}

std::string XmtValueReader::read_bytes(std::string_view attribute) {
  std::string text = document_.decode(attribute);
  const size_t comma = text.find(',');
  if (comma != std::string::npos && text.find('%') == comma + 1) std::erase(text, '%');
  if (!take(attribute, 1, text.size() + 1)) return {};
  Result<std::string> bytes = nodes::bytes_of_text(text);
  if (bytes.ok()) return std::move(bytes).value();
  document_.fail(attribute, bytes.error().text, bytes.error().code);
  return {};
}

double XmtValueReader::read_double(std::string_view attribute) {
  return with_cursor(attribute, document_.decode(attribute), 0,
                     [](nodes::TextCursor& in) { return in.float64(); });
}

namespace {

class ValueWriter {
 public:
  explicit ValueWriter(std::string& out) : out_(out) {}

  void put(bool value) { out_ += value ? "true" : "false"; }
  void put(uint8_t value) { put(value != 0); }  // MFBool
  void put(int32_t value) { nodes::append_number(out_, value); }
  void put(float value) { nodes::append_number(out_, value); }
  void put(double value) { nodes::append_number(out_, value); }
  void put(const std::string& value) { nodes::append_string(out_, value); }
  void put(const Url& value) { nodes::append_string(out_, text_of(value)); }
  void put(const glm::vec2& value) { floats(&value.x, 2); }
  void put(const glm::vec3& value) { floats(&value.x, 3); }
  void put(const glm::vec4& value) { floats(&value.x, 4); }
  void put(const nodes::Rotation& value) { floats(&value.x, 4); }
  void put(const nodes::Image& value) {
    const auto begin = static_cast<ptrdiff_t>(out_.size());
    nodes::append_value(out_, value);
    std::replace(out_.begin() + begin, out_.end(), '\n', ' ');
  }
  void put(const nodes::NodeId&) {}
  void put(const nodes::CommandBuffer&) {}
  template <class T>
  void put(const std::vector<T>& list) {
    for (const T& element : list) {
      if (!out_.empty()) out_ += ' ';
      put(element);
    }
  }

 private:
  void floats(const float* values, size_t count) {
    for (size_t i = 0; i < count; ++i) {
      if (i > 0) out_ += ' ';
      put(values[i]);
    }
  }
  std::string& out_;
};

}  // namespace

void append_xmt_value(std::string& out, const FieldValue& value, FieldType type, bool bytes) {
  std::string text;
  if (const auto* string = std::get_if<std::string>(&value)) {
    text = bytes ? nodes::text_of_bytes(*string) : *string;
  } else if (const auto* url = std::get_if<Url>(&value)) {
    text = text_of(*url);
    if (starts_with_quote(text)) ValueWriter(text = {}).put(*url);
  } else {
    const auto* list = std::get_if<std::vector<std::string>>(&value);
    // Scripts stand without quotes where that is the same.
    const bool plain = type == FieldType::mf_script && list != nullptr && list->size() == 1 &&
                       list->front().find_first_not_of(" \t\r\n\"") == 0;
    if (plain) {
      text = list->front();
    } else {
      ValueWriter writer(text);
      std::visit([&](const auto& any) { writer.put(any); }, value);
    }
  }
  out += text;
}

void append_escaped(std::string& out, std::string_view text) {
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '"') {
      out += "&quot;";
    } else if (byte < 0x20) {
      out += "&#" + std::to_string(byte) + ';';
    } else {
      out += c;
    }
  }
}

std::string xmt_text_of_bytes(std::string_view bytes) {
  constexpr std::string_view kHex = "0123456789ABCDEF";
  std::string out = "data:application/octet-string,";
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    out.append({'%', kHex[byte >> 4], kHex[byte & 15]});
  }
  return out;
}

}  // namespace afx::bifs
