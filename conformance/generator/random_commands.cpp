// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The commands of a presentation, each made for the scene as the ones before leave it.
#include <algorithm>
#include <array>
#include <utility>

#include "bifs/apply.h"
#include "bifs/quantizer.h"
#include "conformance/generator/scene_maker.h"
#include "nodes/definitions.h"

namespace afx::conformance {

using bifs::Command;
using bifs::FieldRef;
using bifs::Position;
using nodes::FieldDefinition;
using nodes::FieldIndex;
using nodes::FieldType;
using nodes::FieldValue;
using nodes::IndexMode;
using nodes::NodeDefinition;
using nodes::NodeId;
using nodes::Scene;

namespace {

/// Whether a text says an insertion into this field as one of a node.
bool is_children(const NodeDefinition& definition, const FieldDefinition& field) {
  return field.type == FieldType::mf_node && field.name == "children" &&
         definition.insertion_type() == field.data_type;
}

}  // namespace

/// One kind of command; none where the scene has nothing that it could be about.
std::optional<Command> SceneMaker::random_command() {
  static constexpr std::array kKinds{
      &SceneMaker::replace_field,    &SceneMaker::random_insertion, &SceneMaker::random_insertion,
      &SceneMaker::delete_element,   &SceneMaker::replace_element,  &SceneMaker::insert_route,
      &SceneMaker::delete_route,     &SceneMaker::replace_route,    &SceneMaker::delete_node,
      &SceneMaker::replace_node,     &SceneMaker::insert_protos,    &SceneMaker::delete_proto,
      &SceneMaker::delete_protos,    &SceneMaker::replace_elements, &SceneMaker::multiple_fields,
      &SceneMaker::global_quantizer, &SceneMaker::random_xreplace,  &SceneMaker::random_xreplace};
  return (this->*choices_.of(kKinds))();
}

std::optional<Command> SceneMaker::replace_field() {
  const auto target = random_target(false);
  if (!target) return std::nullopt;
  return bifs::FieldReplacement{*target,
                                value_of(field(*target), field(*target).type, Scene::kMain, 4)};
}

std::optional<Command> SceneMaker::delete_element() {
  const auto target = random_target(true);
  if (!target) return std::nullopt;
  return bifs::IndexedValueDeletion{*target, random_position()};
}

std::optional<Command> SceneMaker::replace_element() {
  const auto target = random_target(true);
  if (!target) return std::nullopt;
  const Position position = random_position();
  return bifs::IndexedValueReplacement{*target, position, element_for(*target)};
}

std::optional<Command> SceneMaker::replace_elements() {
  const auto target = random_target(true);
  if (!target) return std::nullopt;
  bifs::MultipleIndexedReplacement command{*target, {}};
  do {
    const uint32_t index = choices_.below(6);
    command.values.push_back({index, element_for(*target)});
  } while (choices_.below(3) != 0);
  return command;
}

std::optional<Command> SceneMaker::insert_route() {
  auto route = random_route(Scene::kMain);
  if (!route) return std::nullopt;
  return bifs::RouteInsertion{std::move(*route)};
}

std::optional<Command> SceneMaker::delete_route() {
  if (route_ids_.empty()) return std::nullopt;
  const uint32_t id = choices_.of(route_ids_);
  std::erase(route_ids_, id);
  return bifs::RouteDeletion{id};
}

std::optional<Command> SceneMaker::replace_route() {
  if (route_ids_.empty()) return std::nullopt;
  const auto from = out_of(Scene::kMain);
  const auto to = from ? into(Scene::kMain, field(*from).type) : std::nullopt;
  if (!to) return std::nullopt;
  return bifs::RouteReplacement{choices_.of(route_ids_), *from, *to};
}

std::optional<Command> SceneMaker::delete_node() {
  const auto target = gone_node();
  if (!target) return std::nullopt;
  return bifs::NodeDeletion{*target, choices_.below(2) != 0};
}

std::optional<Command> SceneMaker::insert_protos() {
  auto protos = random_protos(Scene::kMain, 0);
  if (protos.empty()) return std::nullopt;
  return bifs::ProtoInsertion{std::move(protos)};
}

std::optional<Command> SceneMaker::delete_proto() {
  auto& protos = known_[Scene::kMain].protos;
  if (protos.empty()) return std::nullopt;
  const nodes::ProtoId proto = choices_.of(protos);
  std::erase(protos, proto);
  return bifs::ProtoDeletion{{scene_.proto(proto).id}};
}

std::optional<Command> SceneMaker::delete_protos() {
  known_[Scene::kMain].protos.clear();
  return bifs::AllProtoDeletion{};
}

std::optional<Command> SceneMaker::global_quantizer() {
  const bool has_node = choices_.below(2) != 0 && !fits_;
  return bifs::GlobalQuantizer{has_node ? switched_off_quantizer() : NodeId{}};
}

/// A field that commands can change, of a node with an ID.
std::optional<FieldRef> SceneMaker::random_target(bool list) {
  const auto& known = known_[Scene::kMain].nodes;
  if (known.empty()) return std::nullopt;
  const NodeId node = choices_.of(known);
  std::vector<FieldIndex> fields;
  for (const FieldIndex index : definition(node).fields_in(IndexMode::in)) {
    const FieldDefinition& field = definition(node).field(index);
    if ((!list || is_multiple(field.type)) && !(fits_ && is_index(field))) fields.push_back(index);
  }
  if (fields.empty()) return std::nullopt;
  changed_ = node;
  return FieldRef{node, choices_.of(fields)};
}

FieldValue SceneMaker::element_for(const FieldRef& target) {
  const FieldDefinition& list = field(target);
  return value_of(list, element_type(list.type), Scene::kMain, 4);
}

Position SceneMaker::random_position() {
  switch (choices_.below(4)) {
    case 0:
      return {Position::Kind::first, 0};
    case 1:
      return {Position::Kind::last, 0};
    case 2:
      return {Position::Kind::index, choices_.below(5)};
    default:
      return {Position::Kind::index, choices_.below(256)};
  }
}

std::optional<Command> SceneMaker::random_insertion() {
  const auto target = random_target(true);
  if (!target) return std::nullopt;
  const Position position = random_position();
  FieldValue value = element_for(*target);
  if (is_children(definition(target->node), field(*target)))
    return bifs::NodeInsertion{target->node, position, std::get<NodeId>(value)};
  return bifs::IndexedValueInsertion{*target, position, std::move(value)};
}

/// A node that a command takes from the scene: nothing speaks of it from there on.
std::optional<NodeId> SceneMaker::gone_node() {
  auto& known = known_[Scene::kMain].nodes;
  if (known.empty()) return std::nullopt;
  const NodeId node = choices_.of(known);
  std::erase(known, node);
  changed_ = node;
  std::erase_if(route_ids_, [&](uint32_t id) {
    const auto& routes = scene_.scope().routes;
    return std::none_of(routes.begin(), routes.end(), [&](const nodes::Route& route) {
      return route.id == id && route.from != node && route.to != node;
    });
  });
  return node;
}

/// By NULL, or a node that may stand wherever the old one may.
std::optional<Command> SceneMaker::replace_node() {
  const auto gone = gone_node();
  if (!gone) return std::nullopt;
  const NodeId target = *gone;
  if (choices_.below(2) == 0 || nodes_left_ == 0) return bifs::NodeReplacement{target, {}};
  const nodes::Node& old = scene_.node(target);
  const NodeDefinition* standard = nodes::definitions().find(definition(target).name);
  --nodes_left_;
  const NodeId node = standard == nullptr || old.proto.valid()
                          ? NodeId{}
                          : fill(scene_.add(*standard, Scene::kMain), 4);
  return bifs::NodeReplacement{target, node};
}

std::optional<Command> SceneMaker::multiple_fields() {
  const auto& known = known_[Scene::kMain].nodes;
  if (known.empty()) return std::nullopt;
  bifs::MultipleFieldReplacement command{choices_.of(known), {}};
  changed_ = command.target;
  for (const FieldIndex index : definition(command.target).fields_in(IndexMode::def)) {
    const FieldDefinition& one = definition(command.target).field(index);
    const NodeDefinition* standard = nodes::definitions().find(definition(command.target).name);
    const bool is_own =
        definition(command.target).script && index.value >= standard->fields().size();
    if (choices_.below(3) == 0 || is_own || (fits_ && is_index(one))) continue;
    command.values.push_back({index, value_of(one, one.type, Scene::kMain, 4)});
  }
  return command;
}

/// A field whose value has that type.
std::optional<FieldRef> SceneMaker::source_of(FieldType type) {
  std::vector<FieldRef> found;
  for (const NodeId node : known_[Scene::kMain].nodes)
    for (const FieldIndex index : definition(node).fields_in(IndexMode::def))
      if (definition(node).field(index).type == type &&
          !reaches(scene_.value(node, index), changed_))
        found.push_back({node, index});
  if (found.empty()) return std::nullopt;
  return choices_.of(found);
}

std::optional<Command> SceneMaker::random_xreplace() {
  const auto target = random_target(choices_.below(2) != 0);
  if (!target) return std::nullopt;
  bifs::XReplace command;
  command.target = *target;
  FieldType type = field(*target).type;
  if (is_multiple(type) && choices_.below(3) != 0) {
    if (choices_.one_in(3)) command.index_from = source_of(FieldType::sf_int32);
    if (!command.index_from) command.position = random_position();
    type = element_type(type);
  }
  const FieldDefinition* written = &field(*target);
  const auto* list = std::get_if<std::vector<NodeId>>(&scene_.value(target->node, target->field));
  const bool is_indexed = command.position || command.index_from;
  if (list != nullptr && is_indexed && choices_.below(2) != 0) {
    const NodeId child = xreplace_element(scene_, command, *list);
    const auto* fields = child.valid() ? &definition(child).fields_in(IndexMode::in) : nullptr;
    if (fields != nullptr && !fields->empty()) {
      command.child_field = FieldRef{child, choices_.of(*fields)};
      written = &field(*command.child_field);
      changed_ = child;
      type = written->type;
    }
  }
  if (choices_.one_in(3)) command.value_from = source_of(type);
  if (!command.value_from) {
    if (fits_ && is_index(*written)) return std::nullopt;
    command.value = value_of(*written, type, Scene::kMain, 4);
  }
  return command;
}

/// A quantizer that quantizes nothing.
NodeId SceneMaker::switched_off_quantizer() {
  const NodeId node = scene_.add(bifs::quantizer_definition());
  for (const bifs::CategoryFields& row : bifs::category_fields())
    (void)scene_.set(node, row.switch_field, false);
  auto& values = scene_.node(node).values;
  std::erase_if(values, [&](const auto& entry) {
    return is_default(bifs::quantizer_definition().field(entry.field), entry.value);
  });
  std::sort(values.begin(), values.end(),
            [](const auto& a, const auto& b) { return a.field < b.field; });
  created_[node] = values;
  return node;
}

}  // namespace afx::conformance
