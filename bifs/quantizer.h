// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The arithmetic of quantization, for decoder and encoder: both call the same functions, so a value
// that was decoded is encoded to the same bits.
// Source: ISO/IEC 14496-11, QuantizationParameter (clauses not checked); spec/bifs.md 9.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "codec/error.h"
#include "nodes/scene.h"

namespace afx::bifs {

/// The quantization categories that have rules of their own.
inline constexpr uint8_t kCategoryNormal = 9;
inline constexpr uint8_t kCategoryRotation = 10;
inline constexpr uint8_t kCategoryLinearScalar = 13;
inline constexpr uint8_t kCategoryIndex = 14;
inline constexpr size_t kCategories = 16;

/// The fields of a QuantizationParameter for a category: a switch, and prefix + "Min", "Max" and
/// "NbBits". Some share: normal is 9 and 10, size 11 and 12; normals have no Min and Max.
struct CategoryFields {
  uint8_t category;
  const char* switch_field;
  const char* prefix;
};
std::span<const CategoryFields> category_fields();

/// What a QuantizationParameter node says.
class Quantizer {
 public:
  /// Of one category.
  struct Rule {
    bool on = false;
    unsigned bits = 0;  ///< 0..31
    std::array<float, 3> min{}, max{};
  };

  /// Reads the fields of the node. IS links are not followed: the values that were coded count.
  static Quantizer from_node(const nodes::Scene& scene, nodes::NodeId node);

  [[nodiscard]] const Rule& rule(uint8_t category) const { return rules_[category % kCategories]; }
  [[nodiscard]] bool efficient_floats() const { return efficient_floats_; }
  [[nodiscard]] bool is_local() const { return is_local_; }

 private:
  std::array<Rule, kCategories> rules_{};
  bool efficient_floats_ = false;
  bool is_local_ = false;
};

/// The definition of QuantizationParameter.
const nodes::NodeDefinition& quantizer_definition();
/// Whether a node is a QuantizationParameter.
bool is_quantizer(const nodes::Scene& scene, nodes::NodeId node);

/// How the elements of a field are coded at one place of a stream.
struct ElementCoding {
  enum class Kind : uint8_t { plain, linear, normal, rotation, integer };
  Kind kind = Kind::plain;
  bool efficient_floats = false;    ///< plain: floats are written as efficient floats
  unsigned bits = 0;                ///< of a component, 0..31; not for plain
  std::array<float, 3> lo{}, hi{};  ///< linear: the range of each component
  int32_t offset = 0;               ///< integer: what is written is value - offset
};

/// The coding of a field under the active quantizer (nullptr: none).
///
/// points  number of points that an index (category 14) may mean; none if no coordinates came
///         before it in its node
/// Errors  malformed: an index without coordinates before it; an integer of a category for numbers
///         with a fraction that is switched on
Result<ElementCoding> element_coding(const nodes::FieldDefinition& field,
                                     const Quantizer* quantizer, std::optional<uint64_t> points);

/// The number of points of the coordinates that a node has so far: elements of `point` of its first
/// field of data type SFCoordinateNode or SFCoordinate2DNode that has a node.
std::optional<uint64_t> point_count(const nodes::Scene& scene,
                                    const nodes::NodeDefinition& definition,
                                    std::span<const nodes::FieldEntry> values);

/// The linear quantizer, in binary32 and in this order of operations as the peer has it.
/// value -> 0 .. 2^bits - 1; outside the range it is the nearer end, NaN is 0.
uint32_t quantize(float value, float lo, float hi, unsigned bits);
float dequantize(uint32_t code, float lo, float hi, unsigned bits);

/// A quantized unit vector of 3 (normal) or 4 (rotation as quaternion w x y z) components: which
/// component is the greatest, its sign, and the others relative to it.
struct QuantizedDirection {
  bool negative = false;                 ///< normals only: the greatest component is below 0
  uint32_t orientation = 0;              ///< the greatest component, 0..2 or 0..3
  std::array<uint32_t, 3> components{};  ///< 2 or 3 of `bits` bits; 2^(bits-1) is zero
};

/// Errors of the two inverse functions: malformed (orientation 3 of a normal; 0 or 1 bits, which
/// cannot hold a component).
QuantizedDirection quantize_normal(const glm::vec3& normal, unsigned bits);
Result<glm::vec3> dequantize_normal(const QuantizedDirection& quantized, unsigned bits);
QuantizedDirection quantize_rotation(const nodes::Rotation& rotation, unsigned bits);
Result<nodes::Rotation> dequantize_rotation(const QuantizedDirection& quantized, unsigned bits);

/// The parts of an efficient float; mantissa_length 0 is the value 0.
struct EfficientFloat {
  unsigned mantissa_length = 0;  ///< with its sign, 0..15
  unsigned exponent_length = 0;  ///< with its sign, 0..7
  bool negative = false;
  uint32_t mantissa = 0;  ///< mantissa_length - 1 bits
  bool exponent_negative = false;
  uint32_t exponent = 0;  ///< exponent_length - 1 bits
};

/// As the peer has it: the 14 most significant bits of the binary32 mantissa, cut off.
/// Errors: bad_argument (an infinity or NaN, which it cannot hold).
Result<EfficientFloat> to_efficient_float(float value);
float from_efficient_float(const EfficientFloat& parts);

}  // namespace afx::bifs
