// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Nodes and their values.
#include <algorithm>
#include <array>
#include <utility>

#include "bifs/quantizer.h"
#include "conformance/generator/scene_maker.h"
#include "nodes/definitions.h"

namespace afx::conformance {

using nodes::FieldDefinition;
using nodes::FieldIndex;
using nodes::FieldType;
using nodes::FieldValue;
using nodes::NodeDataType;
using nodes::NodeDefinition;
using nodes::NodeId;
using nodes::ScopeId;

namespace {

constexpr unsigned kMostDepth = 8;

/// The nodes that may stand in a place, in the order of the definitions.
const std::vector<const NodeDefinition*>& nodes_of_type(NodeDataType type) {
  static const auto kNodes = [] {
    std::array<std::vector<const NodeDefinition*>, 64> table;
    for (const NodeDefinition& node : nodes::definitions().nodes())
      for (uint8_t number = 0; number < table.size(); ++number)
        if (!node.withdrawn && contains(node.data_types, NodeDataType{number}) &&
            &node != &bifs::quantizer_definition())
          table[number].push_back(&node);
    return table;
  }();
  return kNodes[type.number];
}

}  // namespace

/// A node for a place; not valid (NULL) where none can be made.
NodeId SceneMaker::random_node(NodeDataType type, ScopeId scope, unsigned depth) {
  const uint32_t draw = choices_.below(8);
  if (draw == 7)
    if (const auto used = used_node(type, scope)) return *used;
  if (draw == 6)
    if (const auto instance = new_instance(type, scope, depth)) return *instance;
  return new_node(type, scope, depth);
}

NodeId SceneMaker::new_node(NodeDataType type, ScopeId scope, unsigned depth) {
  const auto& candidates = nodes_of_type(type);
  if (candidates.empty() || nodes_left_ == 0 || depth > kMostDepth) return {};
  --nodes_left_;
  return fill(scene_.add(*choices_.of(candidates), scope), depth);
}

/// Whether a node stands in a value or below it, by now.
bool SceneMaker::reaches(const FieldValue& value, NodeId wanted) const {
  if (const auto* node = std::get_if<NodeId>(&value); node != nullptr && node->valid()) {
    const auto& values = scene_.node(*node).values;
    return *node == wanted || std::any_of(values.begin(), values.end(), [&](const auto& entry) {
      return reaches(entry.value, wanted);
    });
  }
  const auto* list = std::get_if<std::vector<NodeId>>(&value);
  return list != nullptr && std::any_of(list->begin(), list->end(),
                                        [&](NodeId node) { return reaches(node, wanted); });
}

std::optional<NodeId> SceneMaker::used_node(NodeDataType type, ScopeId scope) {
  std::vector<NodeId> candidates;
  for (const NodeId node : known_[scope].nodes)
    if (contains(definition(node).data_types, type) &&
        !(changed_.valid() && reaches(node, changed_)))
      candidates.push_back(node);
  if (candidates.empty()) return std::nullopt;
  return choices_.of(candidates);
}

std::optional<NodeId> SceneMaker::new_instance(NodeDataType type, ScopeId scope, unsigned depth) {
  std::vector<nodes::ProtoId> candidates;
  for (ScopeId at = scope; at.valid(); at = scene_.scope(at).parent)
    for (const nodes::ProtoId proto : known_[at].protos)
      if (contains(scene_.proto(proto).interface.data_types, type)) candidates.push_back(proto);
  if (candidates.empty() || nodes_left_ == 0) return std::nullopt;
  --nodes_left_;
  return fill(scene_.add_instance(choices_.of(candidates), scope), depth);
}

/// Gives a new node ID, name and values.
NodeId SceneMaker::fill(NodeId node, unsigned depth) {
  const bool has_id = choices_.below(3) != 0;
  if (has_id) give_id(node);
  if (definition(node).script) declare_fields(node);
  const NodeDefinition& type = definition(node);
  while (!type.fields().empty() && choices_.below(5) != 0)
    give_value(node,
               FieldIndex{size_t{choices_.below(static_cast<uint32_t>(type.fields().size()))}},
               depth);
  // The fields of a Script are coded with its first text.
  if (scene_.node(node).own_definition != nullptr &&
      element_count(scene_.value(node, type.find("url"))) == 0)
    scene_.set_unchecked(node, type.find("url"), std::vector<std::string>{"javascript:"});
  auto& values = scene_.node(node).values;
  std::sort(values.begin(), values.end(),
            [](const auto& a, const auto& b) { return a.field < b.field; });
  created_[node] = values;
  // A quantizer that is used again would count for what comes behind it there.
  if (has_id && !bifs::is_quantizer(scene_, node))
    known_[scene_.node(node).scope].nodes.push_back(node);
  return node;
}

void SceneMaker::give_id(NodeId node) {
  uint32_t& id = known_[scene_.node(node).scope].node_ids;
  id += choices_.one_in(50) ? 1 + choices_.below(3000) : 1;
  scene_.node(node).id = id;
  const uint32_t style = choices_.below(3);
  if (!own_names() || style == 0) return;
  (void)scene_.set_name(node,
                        style == 1 ? "N" + std::to_string(id - 1) : "node_" + std::to_string(id));
}

/// An index that only points can give a meaning.
bool SceneMaker::is_index(const FieldDefinition& field) const {
  return field.quant_category == bifs::kCategoryIndex &&
         element_type(field.type) == FieldType::sf_int32;
}

void SceneMaker::give_value(NodeId node, FieldIndex index, unsigned depth) {
  const FieldDefinition field = definition(node).field(index);
  if (!field.has_value() || scene_.given(node, index) != nullptr) return;
  if (fits_ && is_index(field)) return;
  FieldValue value = value_of(field, field.type, scene_.node(node).scope, depth);
  if (!is_default(field, value)) scene_.set_unchecked(node, index, std::move(value));
}

FieldValue SceneMaker::value_of(const FieldDefinition& field, FieldType type, ScopeId scope,
                                unsigned depth) {
  if (type == FieldType::mf_node) return nodes_of(field, scope, depth);
  if (type == FieldType::sf_node) return random_node(field.data_type, scope, depth + 1);
  if (type == FieldType::sf_command_buffer) return random_buffer(scope);
  return random_value(choices_, field, type, {.integers_fit = fits_});
}

FieldValue SceneMaker::nodes_of(const FieldDefinition& field, ScopeId scope, unsigned depth) {
  std::vector<NodeId> list;
  while (choices_.below(3) != 0) list.push_back(random_node(field.data_type, scope, depth + 1));
  // The last one: behind it there is nothing that it could count for.
  const bool takes_quantizer = contains(bifs::quantizer_definition().data_types, field.data_type);
  if (choices_.one_in(12) && takes_quantizer && !fits_ && nodes_left_ > 0) {
    --nodes_left_;
    list.push_back(fill(scene_.add(bifs::quantizer_definition(), scope), depth + 1));
  }
  return list;
}

/// Commands on nodes that are complete.
nodes::CommandBuffer SceneMaker::random_buffer(ScopeId scope) {
  auto content = std::make_shared<bifs::BufferedCommands>();
  while (choices_.below(3) != 0 && !known_[scope].nodes.empty()) {
    const NodeId node = choices_.of(known_[scope].nodes);
    std::vector<FieldIndex> fields;
    for (const FieldIndex index : definition(node).fields_in(nodes::IndexMode::in))
      if (!is_node(definition(node).field(index).type) &&
          definition(node).field(index).type != FieldType::sf_command_buffer)
        fields.push_back(index);
    if (fields.empty() || choices_.one_in(4)) {
      content->commands.push_back(bifs::NodeDeletion{node, choices_.below(2) != 0});
      continue;
    }
    const bifs::FieldRef target{node, choices_.of(fields)};
    content->commands.push_back(bifs::FieldReplacement{
        target,
        random_value(choices_, field(target), field(target).type, {.integers_fit = fits_})});
  }
  return {{}, std::move(content)};
}

/// The fields that a Script has of its own.
void SceneMaker::declare_fields(NodeId script) {
  static constexpr std::array kKinds{nodes::EventKind::field, nodes::EventKind::event_in,
                                     nodes::EventKind::event_out};
  static constexpr std::array kTypes{
      FieldType::sf_bool,   FieldType::sf_float, FieldType::sf_time,  FieldType::sf_int32,
      FieldType::sf_string, FieldType::sf_vec3f, FieldType::sf_color, FieldType::mf_int32,
      FieldType::mf_string, FieldType::mf_vec2f, FieldType::mf_bool,  FieldType::sf_rotation,
      FieldType::sf_node};
  for (size_t number = 0; choices_.below(3) != 0; ++number) {
    FieldDefinition field;
    field.name = "own" + std::to_string(number);
    field.kind = choices_.of(kKinds);
    field.type = choices_.of(kTypes);
    field.default_value = zero_value(field.type);
    const FieldIndex index = scene_.own_definition(script).add(field);
    if (!field.has_value()) continue;  // a text has a value for every field
    scene_.set_unchecked(script, index, random_value(choices_, field, field.type));
  }
}

}  // namespace afx::conformance
