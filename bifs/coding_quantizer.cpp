// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/coding_quantizer.h"

#include <algorithm>
#include <array>

#include "nodes/definitions.h"

namespace afx::bifs {

namespace {

using nodes::FieldDefinition;
using nodes::FieldEntry;
using nodes::FieldIndex;
using nodes::FieldValue;
using nodes::Node;
using nodes::NodeDefinition;
using nodes::NodeId;
using nodes::Scene;

constexpr unsigned kIntegerBits = 32;  // of an SFInt32 without a quantizer

/// The fields that a coding quantizer gives: all are FALSE but the first.
constexpr const char* kGivenFields[] = {"isLocal",    "colorQuant", "textureCoordinateQuant",
                                        "angleQuant", "keyQuant",   "normalQuant"};

bool is_grouping_node(const NodeDefinition& definition) {
  static const auto kDefinitions = [] {
    const auto& all = nodes::definitions();
    return std::array{all.find("Group"),   all.find("Transform"), all.find("Transform2D"),
                      all.find("Anchor"),  all.find("Billboard"), all.find("Collision"),
                      all.find("Layer2D"), all.find("Layer3D")};
  }();
  return std::find(kDefinitions.begin(), kDefinitions.end(), &definition) != kDefinitions.end();
}

bool is_link(const Node& node, FieldIndex field) {
  return std::any_of(node.links.begin(), node.links.end(),
                     [&](const nodes::IsLink& link) { return link.field == field; });
}

/// What is written of a node, in the order of the stream: calls visit(field, value).
template <class Visit>
void for_each_written(const Scene& scene, NodeId id, Visit visit) {
  const Node& node = scene.node(id);
  for (size_t i = 0; i < node.definition->fields().size(); ++i) {
    const FieldIndex index{i};
    const FieldValue* value = scene.given(id, index);
    const FieldDefinition& field = node.definition->field(index);
    if (value == nullptr || !field.has_value() || is_link(node, index)) continue;
    if (!same_bits(*value, field.default_value)) visit(index, *value);
  }
}

template <class Visit>
void for_each_node(const FieldValue& value, Visit visit) {
  if (const auto* one = std::get_if<NodeId>(&value)) visit(*one);
  if (const auto* many = std::get_if<std::vector<NodeId>>(&value))
    for (const NodeId node : *many) visit(node);
}

}  // namespace

const CodingQuantizer& coding_quantizer() {
  static const CodingQuantizer kQuantizer = [] {
    CodingQuantizer made;
    made.node = made.scene.add(quantizer_definition());
    const NodeDefinition& definition = *made.scene.node(made.node).definition;
    for (const char* field : kGivenFields)
      made.scene.set_unchecked(made.node, definition.find(field), field == kGivenFields[0]);
    made.quantizer = Quantizer::from_node(made.scene, made.node);
    return made;
  }();
  return kQuantizer;
}

bool is_coding_quantizer(const Scene& scene, NodeId id) {
  if (!is_quantizer(scene, id)) return false;
  const Node& node = scene.node(id);
  const std::vector<FieldEntry>& pattern =
      coding_quantizer().scene.node(coding_quantizer().node).values;
  const auto is_given = [&](const FieldEntry& wanted) {
    const FieldValue* value = scene.given(id, wanted.field);
    return value != nullptr && same_bits(*value, wanted.value);
  };
  return node.id == 0 && node.name.empty() && node.links.empty() &&
         node.values.size() == pattern.size() &&
         std::all_of(pattern.begin(), pattern.end(), is_given);
}

bool is_free_list(const Scene& scene, NodeId holder, const FieldDefinition& field) {
  return holder.valid() && scene.node(holder).id == 0 && field.name == "children" &&
         is_grouping_node(*scene.node(holder).definition);
}

bool all_fit(const FieldValue& value, const ElementCoding& coding) {
  std::span<const int32_t> list;
  if (const auto* one = std::get_if<int32_t>(&value)) list = {one, 1};
  if (const auto* many = std::get_if<std::vector<int32_t>>(&value)) list = *many;
  return std::all_of(list.begin(), list.end(), [&](int32_t one) {
    const int64_t code = int64_t{one} - coding.offset;
    return code >= 0 && code < int64_t{1} << coding.bits;
  });
}

std::optional<uint64_t> integer_saving(const Scene& scene, NodeId node) {
  const NodeDefinition& definition = *scene.node(node).definition;
  std::vector<FieldEntry> before;  // the nodes so far, for the width of indices
  uint64_t bits = 0;
  bool possible = true;
  for_each_written(scene, node, [&](FieldIndex index, const FieldValue& value) {
    if (std::holds_alternative<NodeId>(value)) before.push_back({index, value});
    const FieldDefinition& field = definition.field(index);
    if (element_type(field.type) != nodes::FieldType::sf_int32 || !possible) return;
    const Result<ElementCoding> coding = element_coding(field, &coding_quantizer().quantizer,
                                                        point_count(scene, definition, before));
    possible = coding.ok();
    if (!possible || coding.value().kind != ElementCoding::Kind::integer) return;
    possible = all_fit(value, coding.value());
    bits += element_count(value) * (kIntegerBits - std::min(coding.value().bits, kIntegerBits));
  });
  if (!possible) return std::nullopt;
  return bits;
}

uint64_t IntegerSavings::below(const Scene& scene, const NodeSet& fresh, NodeId holder,
                               NodeId child) {
  if (!child.valid() || !fresh.contains(child.value)) return 0;
  const auto known = known_.find(child.value);
  const Saving saving = known == known_.end() ? walk(scene, fresh, holder, child) : known->second;
  return saving.possible && saving.holder == holder ? saving.bits : 0;
}

IntegerSavings::Saving IntegerSavings::walk(const Scene& scene, const NodeSet& fresh, NodeId holder,
                                            NodeId node) {
  Saving saving{holder, true, 0};
  if (!node.valid()) return saving;
  saving.possible = !is_quantizer(scene, node);
  // Used again, it costs only its ID.
  if (!fresh.contains(node.value) || !known_.emplace(node.value, saving).second) return saving;
  const std::optional<uint64_t> own = integer_saving(scene, node);
  const bool is_script = scene.node(node).own_definition != nullptr;
  saving.possible = saving.possible && own.has_value() && !is_script;
  saving.bits = own.value_or(0);
  for_each_written(scene, node, [&](FieldIndex, const FieldValue& value) {
    for_each_node(value, [&](NodeId inner) {
      const Saving part = walk(scene, fresh, node, inner);
      saving.possible = saving.possible && part.possible;
      saving.bits += part.bits;
    });
  });
  known_[node.value] = saving;
  return saving;
}

}  // namespace afx::bifs
