// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/quantizer.h"

#include <algorithm>
#include <limits>
#include <string>

#include "bifs/node_codes.h"
#include "nodes/definitions.h"

namespace afx::bifs {

namespace {

using nodes::FieldDefinition;
using nodes::FieldType;
using nodes::NodeId;
using nodes::Scene;

constexpr float kLargest = std::numeric_limits<float>::max();

constexpr CategoryFields kCategoryFields[] = {
    {1, "position3DQuant", "position3D"},
    {2, "position2DQuant", "position2D"},
    {3, "drawOrderQuant", "drawOrder"},
    {4, "colorQuant", "color"},
    {5, "textureCoordinateQuant", "textureCoordinate"},
    {6, "angleQuant", "angle"},
    {7, "scaleQuant", "scale"},
    {8, "keyQuant", "key"},
    {kCategoryNormal, "normalQuant", "normal"},
    {kCategoryRotation, "normalQuant", "normal"},
    {11, "sizeQuant", "size"},
    {12, "sizeQuant", "size"},
};

std::array<float, 3> bound_of(const Scene& scene, NodeId node, const std::string& field) {
  if (const auto* v = scene.find<glm::vec3>(node, field)) return {v->x, v->y, v->z};
  if (const auto* v = scene.find<glm::vec2>(node, field)) return {v->x, v->y, 0};
  if (const auto* v = scene.find<float>(node, field)) return {*v, *v, *v};
  return {};
}

float finite(double bound) {
  return static_cast<float>(std::clamp(bound, -double{kLargest}, double{kLargest}));
}

/// Types that are quantized linearly. Category 15 (SFVec4f) has no rule.
bool is_linear(FieldType type, uint8_t category) {
  const bool has_range = (category >= 1 && category <= 8) || category == 11 || category == 12;
  return has_range && (type == FieldType::sf_float || type == FieldType::sf_vec2f ||
                       type == FieldType::sf_vec3f || type == FieldType::sf_color);
}

void set_range(ElementCoding& coding, const FieldDefinition& field, const Quantizer::Rule& rule) {
  for (size_t i = 0; i < 3; ++i) {
    coding.lo[i] = finite(rule.min[i]);
    coding.hi[i] = finite(rule.max[i]);
    if (!field.bounds) continue;  // none stated: infinite
    coding.lo[i] = std::max(coding.lo[i], finite(field.bounds->lower));
    coding.hi[i] = std::min(coding.hi[i], finite(field.bounds->upper));
  }
}

int32_t integer_offset(const FieldDefinition& field) {
  if (!field.bounds) return 0;
  return static_cast<int32_t>(
      std::clamp(field.bounds->lower, double{INT32_MIN}, double{INT32_MAX}));
}

Result<ElementCoding> integer_coding(const FieldDefinition& field, const Quantizer& quantizer,
                                     std::optional<uint64_t> points) {
  ElementCoding coding;
  coding.kind = ElementCoding::Kind::integer;
  coding.offset = integer_offset(field);
  if (field.quant_category == kCategoryLinearScalar) {
    coding.bits = field.quant_bits;
    return coding;
  }
  if (field.quant_category == kCategoryIndex) {
    if (!points)
      return Error{Errc::malformed,
                   {},
                   "an index under a quantizer and no coordinates before it in its node"};
    coding.bits = std::min(bits_for(*points), 31U);
    return coding;
  }
  if (quantizer.rule(field.quant_category).on)
    return Error{Errc::malformed,
                 {},
                 "an SFInt32 of quantization category " + std::to_string(field.quant_category) +
                     " under a quantizer that switches it on [expected category 13 or 14]"};
  return ElementCoding{};
}

}  // namespace

std::span<const CategoryFields> category_fields() { return kCategoryFields; }

const nodes::NodeDefinition& quantizer_definition() {
  static const nodes::NodeDefinition* const kDefinition =
      nodes::definitions().find("QuantizationParameter");
  return *kDefinition;
}

bool is_quantizer(const Scene& scene, NodeId node) {
  return node.valid() && scene.node(node).definition == &quantizer_definition();
}

Quantizer Quantizer::from_node(const Scene& scene, NodeId node) {
  Quantizer quantizer;
  for (const CategoryFields& row : kCategoryFields) {
    const std::string prefix = row.prefix;
    Rule& rule = quantizer.rules_[row.category];
    rule.on = scene.get<bool>(node, row.switch_field);
    const int32_t bits = scene.get<int32_t>(node, prefix + "NbBits");
    rule.bits = static_cast<unsigned>(std::clamp(bits, 0, 31));
    rule.min = bound_of(scene, node, prefix + "Min");
    rule.max = bound_of(scene, node, prefix + "Max");
  }
  quantizer.efficient_floats_ = scene.get<bool>(node, "useEfficientCoding");
  quantizer.is_local_ = scene.get<bool>(node, "isLocal");
  return quantizer;
}

Result<ElementCoding> element_coding(const FieldDefinition& field, const Quantizer* quantizer,
                                     std::optional<uint64_t> points) {
  ElementCoding coding;
  if (quantizer == nullptr) return coding;
  coding.efficient_floats = quantizer->efficient_floats();
  const uint8_t category = field.quant_category;
  const FieldType type = element_type(field.type);
  if (category == 0) return coding;
  if (type == FieldType::sf_int32) return integer_coding(field, *quantizer, points);
  const Quantizer::Rule& rule = quantizer->rule(category);
  if (!rule.on) return coding;
  if (is_linear(type, category)) {
    coding.kind = ElementCoding::Kind::linear;
    set_range(coding, field, rule);
  } else if (category == kCategoryNormal && type == FieldType::sf_vec3f) {
    coding.kind = ElementCoding::Kind::normal;
  } else if (category == kCategoryRotation && type == FieldType::sf_rotation) {
    coding.kind = ElementCoding::Kind::rotation;
  } else {
    return coding;
  }
  coding.bits = rule.bits;
  return coding;
}

std::optional<uint64_t> point_count(const Scene& scene, const nodes::NodeDefinition& definition,
                                    std::span<const nodes::FieldEntry> values) {
  static const auto kTypes = [] {
    const auto& definitions = nodes::definitions();
    return std::array{definitions.find_data_type("SFCoordinateNode"),
                      definitions.find_data_type("SFCoordinate2DNode")};
  }();
  for (const nodes::FieldEntry& entry : values) {
    const FieldDefinition& field = definition.field(entry.field);
    const auto* node = std::get_if<NodeId>(&entry.value);
    const bool coordinates =
        std::find(kTypes.begin(), kTypes.end(), std::optional(field.data_type)) != kTypes.end();
    if (node == nullptr || !node->valid() || !coordinates) continue;
    const nodes::FieldIndex point = scene.node(*node).definition->find("point");
    if (point.valid()) return element_count(scene.value(*node, point));
  }
  return std::nullopt;
}

}  // namespace afx::bifs
