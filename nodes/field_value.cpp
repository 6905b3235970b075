// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "nodes/field_value.h"

#include <bit>
#include <charconv>
#include <iterator>

namespace afx::nodes {

namespace {

using enum FieldType;

struct FieldTypeRow {
  FieldType type;
  std::string_view name;
  FieldType element;
  FieldValue (*zero)();
};

template <class T>
FieldValue zero_of() {
  return T{};
}

const FieldTypeRow kFieldTypes[] = {
    {sf_bool, "SFBool", sf_bool, zero_of<bool>},
    {sf_float, "SFFloat", sf_float, zero_of<float>},
    {sf_time, "SFTime", sf_time, zero_of<double>},
    {sf_int32, "SFInt32", sf_int32, zero_of<int32_t>},
    {sf_string, "SFString", sf_string, zero_of<std::string>},
    {sf_vec3f, "SFVec3f", sf_vec3f, zero_of<glm::vec3>},
    {sf_vec2f, "SFVec2f", sf_vec2f, zero_of<glm::vec2>},
    {sf_color, "SFColor", sf_color, zero_of<glm::vec3>},
    {sf_rotation, "SFRotation", sf_rotation, zero_of<Rotation>},
    {sf_image, "SFImage", sf_image, zero_of<Image>},
    {sf_node, "SFNode", sf_node, zero_of<NodeId>},
    {sf_vec4f, "SFVec4f", sf_vec4f, zero_of<glm::vec4>},
    {sf_url, "SFURL", sf_url, zero_of<Url>},
    {sf_script, "SFScript", sf_script, zero_of<std::string>},
    {sf_command_buffer, "SFCommandBuffer", sf_command_buffer, zero_of<CommandBuffer>},
    {mf_bool, "MFBool", sf_bool, zero_of<std::vector<uint8_t>>},
    {mf_float, "MFFloat", sf_float, zero_of<std::vector<float>>},
    {mf_time, "MFTime", sf_time, zero_of<std::vector<double>>},
    {mf_int32, "MFInt32", sf_int32, zero_of<std::vector<int32_t>>},
    {mf_string, "MFString", sf_string, zero_of<std::vector<std::string>>},
    {mf_vec3f, "MFVec3f", sf_vec3f, zero_of<std::vector<glm::vec3>>},
    {mf_vec2f, "MFVec2f", sf_vec2f, zero_of<std::vector<glm::vec2>>},
    {mf_color, "MFColor", sf_color, zero_of<std::vector<glm::vec3>>},
    {mf_rotation, "MFRotation", sf_rotation, zero_of<std::vector<Rotation>>},
    {mf_image, "MFImage", sf_image, zero_of<std::vector<Image>>},
    {mf_node, "MFNode", sf_node, zero_of<std::vector<NodeId>>},
    {mf_vec4f, "MFVec4f", sf_vec4f, zero_of<std::vector<glm::vec4>>},
    {mf_url, "MFURL", sf_url, zero_of<std::vector<Url>>},
    {mf_script, "MFScript", sf_script, zero_of<std::vector<std::string>>},
};

const FieldTypeRow& row_of(FieldType type) {
  for (const FieldTypeRow& row : kFieldTypes)
    if (row.type == type) return row;
  return kFieldTypes[0];
}

template <class T>
struct IsVector : std::false_type {};
template <class T>
struct IsVector<std::vector<T>> : std::true_type {};

bool same(float a, float b) { return std::bit_cast<uint32_t>(a) == std::bit_cast<uint32_t>(b); }
bool same(double a, double b) { return std::bit_cast<uint64_t>(a) == std::bit_cast<uint64_t>(b); }
bool same(const glm::vec2& a, const glm::vec2& b) { return same(a.x, b.x) && same(a.y, b.y); }
bool same(const glm::vec3& a, const glm::vec3& b) {
  return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
}
bool same(const glm::vec4& a, const glm::vec4& b) {
  return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z) && same(a.w, b.w);
}
bool same(const Rotation& a, const Rotation& b) {
  return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z) && same(a.angle, b.angle);
}
template <class T>
bool same(const T& a, const T& b) {
  return a == b;
}
template <class T>
bool same(const std::vector<T>& a, const std::vector<T>& b) {
  if (a.size() != b.size()) return false;
  for (size_t i = 0; i < a.size(); ++i)
    if (!same(a[i], b[i])) return false;
  return true;
}

constexpr int32_t kLastDescriptor = 1023;  // object descriptor IDs have 10 bits

}  // namespace

std::string_view to_string(FieldType type) { return row_of(type).name; }

std::optional<FieldType> find_field_type(std::string_view name) {
  for (const FieldTypeRow& row : kFieldTypes)
    if (row.name == name) return row.type;
  return std::nullopt;
}

std::optional<FieldType> field_type_of_code(unsigned code) {
  for (const FieldTypeRow& row : kFieldTypes)
    if (static_cast<unsigned>(row.type) == code) return row.type;
  return std::nullopt;
}

FieldType element_type(FieldType type) { return row_of(type).element; }

Url Url::from_text(std::string_view text) {
  const std::string_view digits = text.substr(text.starts_with("od:") ? 3 : 0);
  int32_t number = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, failure] = std::from_chars(digits.data(), end, number);
  const bool is_number = failure == std::errc{} && stop == end && digits[0] != '-';
  if (is_number && number <= kLastDescriptor) return {{}, number};
  return {std::string(text), kNoDescriptor};
}

FieldValue zero_value(FieldType type) { return row_of(type).zero(); }

bool holds(FieldType type, const FieldValue& value) {
  return zero_value(type).index() == value.index();
}

size_t element_count(const FieldValue& value) {
  return std::visit(
      []<class T>(const T& v) -> size_t {
        if constexpr (IsVector<T>::value) {
          return v.size();
        } else {
          return 1;
        }
      },
      value);
}

bool same_bits(const FieldValue& a, const FieldValue& b) {
  if (a.index() != b.index()) return false;
  return std::visit([&b]<class T>(const T& v) { return same(v, *std::get_if<T>(&b)); }, a);
}

}  // namespace afx::nodes
