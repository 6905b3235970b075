// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The types that fields have, and values of them. Code is written per type, never per node.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "nodes/ids.h"

namespace afx::nodes {

/// The types of fields. The numbers up to 10, and 32 + those, are the ones that BIFS writes in
/// PROTO interfaces; the rest are the numbers that the peer uses there.
enum class FieldType : uint8_t {
  sf_bool = 0,
  sf_float = 1,
  sf_time = 2,
  sf_int32 = 3,
  sf_string = 4,
  sf_vec3f = 5,
  sf_vec2f = 6,
  sf_color = 7,
  sf_rotation = 8,
  sf_image = 9,
  sf_node = 10,
  sf_vec4f = 11,
  sf_url = 12,
  sf_script = 13,
  sf_command_buffer = 14,
  mf_bool = 32,
  mf_float = 33,
  mf_time = 34,
  mf_int32 = 35,
  mf_string = 36,
  mf_vec3f = 37,
  mf_vec2f = 38,
  mf_color = 39,
  mf_rotation = 40,
  mf_image = 41,
  mf_node = 42,
  mf_vec4f = 43,
  mf_url = 47,
  mf_script = 48,
};

/// The name as it is written in interfaces, e.g. "MFVec3f".
std::string_view to_string(FieldType type);
/// The type of that name; none for an unknown name (and for node types such as "SF3DNode").
std::optional<FieldType> find_field_type(std::string_view name);
/// The type with that number, see FieldType; none for other numbers.
std::optional<FieldType> field_type_of_code(unsigned code);
/// Whether a field of this type holds a list.
constexpr bool is_multiple(FieldType type) { return static_cast<uint8_t>(type) >= 32; }
/// The type of one element: mf_vec3f -> sf_vec3f; SF types give themselves.
FieldType element_type(FieldType type);
constexpr bool is_node(FieldType type) {
  return type == FieldType::sf_node || type == FieldType::mf_node;
}

/// SFRotation: axis (as written, not normalised) and angle in radians.
struct Rotation {
  float x = 0, y = 0, z = 1, angle = 0;
};

/// SFURL: the number of an object descriptor, or text.
struct Url {
  static constexpr int32_t kNoDescriptor = -1;
  std::string text;                           ///< empty if it is a descriptor
  int32_t object_descriptor = kNoDescriptor;  ///< 0..1023

  /// What BT text means by the string: "od:10" and "10" are descriptor 10, the rest is text.
  static Url from_text(std::string_view text);
  [[nodiscard]] bool is_descriptor() const { return object_descriptor >= 0; }
  bool operator==(const Url&) const = default;
};

/// SFImage: width * height * components bytes, the bottom row first, each row from the left,
/// components interleaved. Components: 0 none, 1 grey, 2 grey + alpha, 3 RGB, 4 RGBA.
struct Image {
  uint32_t width = 0;
  uint32_t height = 0;
  uint32_t components = 0;
  std::vector<uint8_t> samples;
  bool operator==(const Image&) const = default;
};

/// The commands of a command buffer as a layer above has them (bifs/command.h).
class CommandBufferContent {
 public:
  virtual ~CommandBufferContent() = default;
};

/// SFCommandBuffer: the BT text between its braces, exactly as written, or, if it comes from a
/// bitstream, the decoded commands.
struct CommandBuffer {
  std::string text;
  std::shared_ptr<const CommandBufferContent> content = nullptr;
  bool operator==(const CommandBuffer&) const = default;
};

/// A value of a field. Types that are alike share their storage:
/// SFBool bool; SFInt32 int32_t; SFFloat float; SFTime double; SFString, SFScript std::string
/// (UTF-8; where the definition says `bytes`, any bytes); SFURL Url; SFVec2f glm::vec2; SFVec3f and
/// SFColor glm::vec3; SFVec4f glm::vec4; SFRotation Rotation; SFImage Image; SFNode NodeId;
/// SFCommandBuffer CommandBuffer; MF: std::vector of those, flat (MFBool of uint8_t).
using FieldValue =
    std::variant<bool, int32_t, float, double, std::string, Url, glm::vec2, glm::vec3, glm::vec4,
                 Rotation, Image, NodeId, CommandBuffer, std::vector<uint8_t>, std::vector<int32_t>,
                 std::vector<float>, std::vector<double>, std::vector<std::string>,
                 std::vector<Url>, std::vector<glm::vec2>, std::vector<glm::vec3>,
                 std::vector<glm::vec4>, std::vector<Rotation>, std::vector<Image>,
                 std::vector<NodeId>>;

/// The zero value of a type: 0, FALSE, "", an empty list, the NULL node, rotation 0 0 1 0.
FieldValue zero_value(FieldType type);
/// Whether the value is stored as values of this type are.
bool holds(FieldType type, const FieldValue& value);
/// Number of elements of a list; 1 for SF values.
size_t element_count(const FieldValue& value);

/// Whether two values are the same, floats by their bits (so a NaN equals itself and 0 differs from
/// -0). Node numbers are compared as numbers; scenes are compared by equal() in scene.h.
bool same_bits(const FieldValue& a, const FieldValue& b);

}  // namespace afx::nodes
