// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "conformance/generator/random_values.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "bifs/command.h"
#include "bifs/quantizer.h"

namespace afx::conformance {

namespace {

using nodes::FieldDefinition;
using nodes::FieldType;
using nodes::FieldValue;

constexpr std::array<std::string_view, 14> kStrings{"",
                                                    "a",
                                                    "two words",
                                                    " blanks around ",
                                                    "\"quoted\"",
                                                    "back\\slash\\",
                                                    "\\\"",
                                                    "one\nline\r\nand another",
                                                    "tab\there",
                                                    "# no comment",
                                                    "<a href='b'>&amp;</a>",
                                                    "{ [ ] }",
                                                    "\u00e9\u65e5\u672c\U0001F600",
                                                    "USE NULL TRUE 1.5"};
constexpr std::array<std::string_view, 6> kUrls{
    "", "a.png", "http://b.example/c?d=1&e=f#g", "with blank.mp4", "od", "a\"b\\c"};
constexpr std::array<std::string_view, 5> kScripts{
    "javascript:", "javascript:function f(){}", "javascript:function g(a,b){return a+b*2;}",
    "javascript:function h(v){if (v>1) {v--;} else v=-v;}",
    "javascript:function i(){var j;for (j=0;j<3;j++)k[j]='x';}\nfunction l(){while (true)break;}"};

std::string random_string(Choices& choices) {
  const uint32_t draw = choices.below(kStrings.size() + 2);
  if (draw < kStrings.size()) return std::string(kStrings[draw]);
  if (draw == kStrings.size()) return std::string(1 + choices.below(400), 'x');
  std::string text;
  while (choices.below(8) != 0) text += static_cast<char>(' ' + choices.below(95));
  return text;
}

std::string random_bytes(Choices& choices) {
  std::string bytes;
  while (choices.below(6) != 0) bytes += static_cast<char>(choices.below(256));
  return bytes;
}

nodes::Url random_url(Choices& choices) {
  const uint32_t draw = choices.below(kUrls.size() + 2);
  if (draw < kUrls.size()) return {std::string(kUrls[draw])};
  return {{}, static_cast<int32_t>(draw == kUrls.size() ? choices.below(20) : choices.below(1024))};
}

nodes::Image random_image(Choices& choices) {
  nodes::Image image;
  image.width = choices.below(5);
  image.height = image.width == 0 ? 0 : 1 + choices.below(4);
  image.components = image.width == 0 ? 4 : 1 + choices.below(4);  // of nothing: as decoders say it
  image.samples.resize(size_t{image.width} * image.height * image.components);
  for (uint8_t& sample : image.samples) sample = static_cast<uint8_t>(choices.below(256));
  return image;
}

template <class Float, class Bits>
Float random_float(Choices& choices) {
  using Limit = std::numeric_limits<Float>;
  static constexpr std::array kSpecial{Float{-0.0},       Limit::max(),        Limit::lowest(),
                                       Limit::min(),      Limit::denorm_min(), Limit::epsilon(),
                                       Limit::infinity(), -Limit::infinity(),  Limit::quiet_NaN()};
  switch (choices.below(6)) {
    case 0:
      return static_cast<Float>(choices.below(3));
    case 1:
      return static_cast<Float>(choices.below(2001)) / 1000 - 1;
    case 2:
      return static_cast<Float>(static_cast<int32_t>(choices.below(200001)) - 100000);
    case 3:
      return choices.of(kSpecial);
    default: {
      Bits bits = choices.below(UINT32_MAX);
      if constexpr (sizeof(Bits) == 8) bits = bits << 32 | choices.below(UINT32_MAX);
      const Float value = std::bit_cast<Float>(bits);
      return std::isnan(value) ? Float{1} : value;  // signalling ones do not survive every machine
    }
  }
}

float random_float32(Choices& choices) { return random_float<float, uint32_t>(choices); }

int32_t random_int32(Choices& choices, const FieldDefinition& field, const ValueRules& rules) {
  if (rules.integers_fit && field.quant_category == bifs::kCategoryLinearScalar) {
    const double lower = field.bounds ? field.bounds->lower : 0;
    const double upper = std::min(field.bounds ? field.bounds->upper : 0x1p31,
                                  lower + static_cast<double>((1U << field.quant_bits % 32U) - 1));
    return static_cast<int32_t>(lower) +
           static_cast<int32_t>(choices.below(static_cast<uint32_t>(upper - lower) + 1));
  }
  switch (choices.below(4)) {
    case 0:
      return static_cast<int32_t>(choices.below(4));
    case 1:
      return static_cast<int32_t>(choices.below(256));
    case 2:
      return static_cast<int32_t>(choices.below(2001)) - 1000;
    default:
      return std::bit_cast<int32_t>(choices.below(UINT32_MAX));
  }
}

template <class T>
T of_floats(Choices& choices) {
  T value;
  float* const at = &value.x;
  for (size_t i = 0; i < sizeof(T) / sizeof(float); ++i) at[i] = random_float32(choices);
  return value;
}

FieldValue random_element(Choices& choices, const FieldDefinition& field, FieldType type,
                          const ValueRules& rules) {
  switch (type) {
    case FieldType::sf_bool:
      return choices.below(2) != 0;
    case FieldType::sf_float:
      return random_float32(choices);
    case FieldType::sf_time:
      return random_float<double, uint64_t>(choices);
    case FieldType::sf_int32:
      return random_int32(choices, field, rules);
    case FieldType::sf_string:
      return field.bytes ? random_bytes(choices) : random_string(choices);
    case FieldType::sf_vec2f:
      return of_floats<glm::vec2>(choices);
    case FieldType::sf_vec3f:
    case FieldType::sf_color:
      return of_floats<glm::vec3>(choices);
    case FieldType::sf_vec4f:
      return of_floats<glm::vec4>(choices);
    case FieldType::sf_rotation:
      return of_floats<nodes::Rotation>(choices);
    case FieldType::sf_image:
      return random_image(choices);
    case FieldType::sf_url:
      return random_url(choices);
    case FieldType::sf_script:
      return std::string(choices.of(kScripts));
    default:
      return zero_value(type);
  }
}

template <class T>
void append_to(std::vector<T>& list, const FieldValue& element) {
  if constexpr (std::is_same_v<T, uint8_t>) {  // MFBool
    list.push_back(static_cast<uint8_t>(std::get<bool>(element)));
  } else {
    list.push_back(std::get<T>(element));
  }
}
void append_to(auto&, const FieldValue&) {}  // no list

/// Adds to a list an element of its type.
void append(FieldValue& list, const FieldValue& element) {
  std::visit([&](auto& values) { append_to(values, element); }, list);
}

bool same(const auto& a, const auto& b) { return a == b; }
bool same(const nodes::Rotation& a, const nodes::Rotation& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z && a.angle == b.angle;
}
template <class T>
bool same(const std::vector<T>& a, const std::vector<T>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const T& x, const T& y) { return same(x, y); });
}

}  // namespace

FieldValue random_value(Choices& choices, const FieldDefinition& field, FieldType type,
                        const ValueRules& rules) {
  if (!is_multiple(type)) return random_element(choices, field, type, rules);
  FieldValue list = zero_value(type);
  if (choices.one_in(40)) {
    const FieldValue element = random_element(choices, field, element_type(type), rules);
    for (uint32_t left = choices.below(300); left > 0; --left) append(list, element);
  }
  while (choices.below(3) != 0)
    append(list, random_element(choices, field, element_type(type), rules));
  return list;
}

bool is_default(const FieldDefinition& field, const FieldValue& value) {
  const FieldType type = element_type(field.type);
  if (type == FieldType::sf_script || field.type == FieldType::sf_image ||
      value.index() != field.default_value.index())
    return false;
  if (const auto* buffer = std::get_if<nodes::CommandBuffer>(&value))
    return dynamic_cast<const bifs::BufferedCommands&>(*buffer->content).commands.empty();
  return std::visit(
      [&]<class T>(const T& v) {
        if constexpr (requires { same(v, v); })
          return same(v, *std::get_if<T>(&field.default_value));
        return false;
      },
      value);
}

}  // namespace afx::conformance
