// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "nodes/value_writer.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <type_traits>

namespace afx::nodes {

namespace {

constexpr size_t kLineWidth = 96;

template <class T>
void append_chars(std::string& out, T value, auto... format) {
  char text[40];
  const auto result = std::to_chars(text, text + sizeof text, value, format...);
  out.append(text, result.ptr);
}

template <class T, class Bits>
void append_float(std::string& out, T value) {
  if (!std::isnan(value)) return append_chars(out, value);
  const Bits bits = std::bit_cast<Bits>(value);
  if (bits == std::bit_cast<Bits>(std::numeric_limits<T>::quiet_NaN())) {
    out += "nan";
    return;
  }
  out += "nan(0x";
  append_chars(out, bits, 16);
  out += ')';
}

void append_floats(std::string& out, const float* values, size_t count) {
  for (size_t i = 0; i < count; ++i) {
    if (i > 0) out += ' ';
    append_number(out, values[i]);
  }
}

void append_one(std::string& out, bool value) { out += value ? "TRUE" : "FALSE"; }
void append_one(std::string& out, uint8_t value) { append_one(out, value != 0); }  // MFBool
void append_one(std::string& out, int32_t value) { append_number(out, value); }
void append_one(std::string& out, float value) { append_number(out, value); }
void append_one(std::string& out, double value) { append_number(out, value); }
void append_one(std::string& out, const std::string& value) { append_string(out, value); }
void append_one(std::string& out, const glm::vec2& value) { append_floats(out, &value.x, 2); }
void append_one(std::string& out, const glm::vec3& value) { append_floats(out, &value.x, 3); }
void append_one(std::string& out, const glm::vec4& value) { append_floats(out, &value.x, 4); }
void append_one(std::string& out, const Rotation& value) { append_floats(out, &value.x, 4); }
void append_one(std::string& out, NodeId value) { out += value.valid() ? "..." : "NULL"; }

void append_one(std::string& out, const CommandBuffer& value) {
  out += '{';
  out += value.text;
  out += '}';
}

void append_one(std::string& out, const Url& value) {
  append_string(
      out, value.is_descriptor() ? "od:" + std::to_string(value.object_descriptor) : value.text);
}

/// `line_ended` is called where a line has ended.
template <class Write, class LineEnded>
void append_wrapped(std::string& out, size_t count, size_t indent, Write write,
                    LineEnded line_ended) {
  size_t line = out.size();
  for (size_t i = 0; i < count; ++i) {
    if (out.size() - line > kLineWidth) {
      out += '\n';
      line_ended();
      line = out.size();
      out.append(indent, ' ');
    } else {
      out += ' ';
    }
    write(i);
  }
}

void append_one(std::string& out, const Image& value) {
  append_number(out, static_cast<int32_t>(value.width));
  out += ' ' + std::to_string(value.height) + ' ' + std::to_string(value.components);
  if (value.components == 0) return;
  append_wrapped(
      out, value.samples.size() / value.components, 2,
      [&](size_t pixel) {
        constexpr char kDigits[] = "0123456789ABCDEF";
        out += "0x";
        for (size_t c = 0; c < value.components; ++c) {
          const uint8_t sample = value.samples[pixel * value.components + c];
          out += kDigits[sample >> 4];
          out += kDigits[sample & 15];
        }
      },
      [] {});
}

template <class T, class LineEnded>
void append_list(std::string& out, const std::vector<T>& list, size_t indent,
                 LineEnded line_ended) {
  out += '[';
  append_wrapped(
      out, list.size(), indent,
      [&](size_t i) {
        append_one(out, list[i]);
        const bool tuple = !std::is_arithmetic_v<T> && !std::is_same_v<T, NodeId>;
        if (tuple && i + 1 < list.size()) out += ',';
      },
      line_ended);
  out += list.empty() ? "]" : " ]";
}

template <class LineEnded>
void append_any(std::string& out, const FieldValue& value, size_t indent, LineEnded line_ended) {
  std::visit(
      [&]<class T>(const T& v) {
        if constexpr (requires { append_one(out, v); }) {
          append_one(out, v);
        } else {
          append_list(out, v, indent, line_ended);
        }
      },
      value);
}

}  // namespace

void append_number(std::string& out, float value) { append_float<float, uint32_t>(out, value); }
void append_number(std::string& out, double value) { append_float<double, uint64_t>(out, value); }
void append_number(std::string& out, int32_t value) { append_chars(out, value); }

void append_string(std::string& out, std::string_view text) {
  out += '"';
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  out += '"';
}

void append_value(std::string& out, const FieldValue& value, size_t indent) {
  append_any(out, value, indent, [] {});
}

void append_value(TextOut& out, const FieldValue& value, size_t indent) {
  append_any(out.text(), value, indent, [&out] { out.piece(); });
}

}  // namespace afx::nodes
