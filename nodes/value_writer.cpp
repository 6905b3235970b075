// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "nodes/value_writer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstring>
#include <limits>
#include <type_traits>

namespace afx::nodes {

namespace {

constexpr size_t kLineWidth = 96;

constexpr size_t kLongestNumber = 32;  // of a double: -2.2250738585072014e-308

/// The texts of 0 to 255, of which octrees are made: a row is three characters and their number.
constexpr auto kByteTexts = [] {
  std::array<std::array<char, 4>, 256> texts{};
  for (size_t i = 0; i < texts.size(); ++i) {
    size_t length = 0;
    for (size_t unit = i < 10 ? 1 : i < 100 ? 10 : 100; unit > 0; unit /= 10)
      texts[i][length++] = static_cast<char>('0' + i / unit % 10);
    texts[i][3] = static_cast<char>(length);
  }
  return texts;
}();

template <class T>
char* write_chars(char* at, T value, auto... format) {
  return std::to_chars(at, at + kLongestNumber, value, format...).ptr;
}

char* write_one(char* at, int32_t value) {
  if (value < 0 || value > 255) return write_chars(at, value);
  const std::array<char, 4>& text = kByteTexts[static_cast<size_t>(value)];
  std::memcpy(at, text.data(), text.size());
  return at + text[3];
}

template <std::floating_point T>
char* write_one(char* at, T value) {
  if (!std::isnan(value)) return write_chars(at, value);
  using Bits = std::conditional_t<sizeof(T) == 4, uint32_t, uint64_t>;
  const Bits bits = std::bit_cast<Bits>(value);
  const bool usual = bits == std::bit_cast<Bits>(std::numeric_limits<T>::quiet_NaN());
  at = std::copy_n(usual ? "nan" : "nan(0x", usual ? 3 : 6, at);
  if (usual) return at;
  at = write_chars(at, bits, 16);
  *at++ = ')';
  return at;
}

char* write_floats(char* at, const float* values, size_t count) {
  for (size_t i = 0; i < count; ++i) {
    if (i > 0) *at++ = ' ';
    at = write_one(at, values[i]);
  }
  return at;
}

char* write_one(char* at, const glm::vec2& value) { return write_floats(at, &value.x, 2); }
char* write_one(char* at, const glm::vec3& value) { return write_floats(at, &value.x, 3); }
char* write_one(char* at, const glm::vec4& value) { return write_floats(at, &value.x, 4); }
char* write_one(char* at, const Rotation& value) { return write_floats(at, &value.x, 4); }

/// Values that are numbers and nothing else.
template <class T>
concept Numbers =
    !std::same_as<T, bool> && !std::same_as<T, uint8_t> && requires(char* at, const T& value) {
  write_one(at, value);
};
constexpr size_t kLongestNumbers = 4 * (kLongestNumber + 1);

template <Numbers T>
void append_one(std::string& out, const T& value) {
  char text[kLongestNumbers];
  out.append(text, write_one(text, value));
}
void append_one(std::string& out, bool value) { out += value ? "TRUE" : "FALSE"; }
void append_one(std::string& out, uint8_t value) { append_one(out, value != 0); }  // MFBool
void append_one(std::string& out, const std::string& value) { append_string(out, value); }
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

/// A comma is put between tuples.
template <class T>
constexpr bool kIsTuple = !std::is_arithmetic_v<T> && !std::is_same_v<T, NodeId>;

/// What append_wrapped does, a line at a time: long lists are of numbers.
template <Numbers T, class LineEnded>
void append_elements(std::string& out, const std::vector<T>& list, size_t indent,
                     LineEnded line_ended) {
  char line[kLineWidth + kLongestNumbers + 2];
  char* at = line;
  size_t before = 0;  // characters of the line that are in `out` already
  for (size_t i = 0; i < list.size(); ++i) {
    if (before + static_cast<size_t>(at - line) > kLineWidth) {
      out.append(line, at) += '\n';
      line_ended();
      out.append(indent, ' ');
      at = line;
      before = indent;
    } else {
      *at++ = ' ';
    }
    at = write_one(at, list[i]);
    if (kIsTuple<T> && i + 1 < list.size()) *at++ = ',';
  }
  out.append(line, at);
}

template <class T, class LineEnded>
void append_elements(std::string& out, const std::vector<T>& list, size_t indent,
                     LineEnded line_ended) {
  append_wrapped(
      out, list.size(), indent,
      [&](size_t i) {
        append_one(out, list[i]);
        if (kIsTuple<T> && i + 1 < list.size()) out += ',';
      },
      line_ended);
}

template <class T, class LineEnded>
void append_list(std::string& out, const std::vector<T>& list, size_t indent,
                 LineEnded line_ended) {
  out += '[';
  append_elements(out, list, indent, line_ended);
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

void append_number(std::string& out, float value) { append_one(out, value); }
void append_number(std::string& out, double value) { append_one(out, value); }
void append_number(std::string& out, int32_t value) { append_one(out, value); }

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
