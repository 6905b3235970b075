// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "nodes/scene.h"

#include <utility>

#include "nodes/definitions.h"

namespace afx::nodes {

namespace {

Error bad_argument(std::string text) { return {Errc::bad_argument, {}, std::move(text), {}, {}}; }

}  // namespace

Scene::Scene() { scopes_.push_back(std::make_unique<Scope>()); }

NodeId Scene::add(const NodeDefinition& definition, ScopeId scope) {
  const NodeId id{nodes_.size()};
  Node& node = nodes_.emplace_back();
  node.definition = &definition;
  node.scope = scope;
  return id;
}

Result<NodeId> Scene::add(std::string_view type_name, ScopeId scope) {
  const NodeDefinition* definition = definitions().find(type_name);
  if (definition == nullptr)
    return bad_argument("there is no node '" + std::string(type_name) + "'");
  return add(*definition, scope);
}

NodeId Scene::add_instance(ProtoId proto_id, ScopeId scope) {
  const NodeId id = add(proto(proto_id).interface, scope);
  node(id).proto = proto_id;
  return id;
}

Result<ProtoId> Scene::add_proto(std::string name, bool external, ScopeId scope_id) {
  const ProtoId id{protos_.size()};
  if (!scope(scope_id).proto_names.emplace(name, id).second)
    return bad_argument("there is a PROTO '" + name + "' already");
  Proto& proto = *protos_.emplace_back(std::make_unique<Proto>());
  proto.interface.name = std::move(name);
  proto.interface.data_types = kAnyNode;
  proto.scope = scope_id;
  proto.body = ScopeId{scopes_.size()};
  proto.external = external;
  Scope& body = *scopes_.emplace_back(std::make_unique<Scope>());
  body.parent = scope_id;
  body.proto = id;
  scope(scope_id).protos.push_back(id);
  return id;
}

ProtoId Scene::find_proto(std::string_view name, ScopeId scope_id) const {
  for (; scope_id.valid(); scope_id = scope(scope_id).parent) {
    const auto& names = scope(scope_id).proto_names;
    const auto found = names.find(name);
    if (found != names.end()) return found->second;
  }
  return {};
}

void Scene::settle_data_types(ProtoId id) {
  const std::vector<NodeId>& roots = scope(proto(id).body).roots;
  const bool known = !proto(id).external && !roots.empty() && roots[0].valid();
  proto(id).interface.data_types = known ? node(roots[0]).definition->data_types : kAnyNode;
}

Status Scene::set_name(NodeId id, std::string name) {
  std::string& old = node(id).name;
  auto& names = scope(node(id).scope).names;
  if (old == name) return {};
  if (!name.empty() && !names.emplace(name, id).second)
    return bad_argument("there is a node '" + name + "' already");
  const auto entry = names.find(old);
  if (!old.empty() && entry != names.end() && entry->second == id) names.erase(entry);
  old = std::move(name);
  return {};
}

NodeId Scene::find_name(std::string_view name, ScopeId scope_id) const {
  const auto found = scope(scope_id).names.find(name);
  return found == scope(scope_id).names.end() ? NodeId{} : found->second;
}

const FieldValue* Scene::given(NodeId id, FieldIndex field) const {
  for (const FieldEntry& entry : node(id).values)
    if (entry.field == field) return &entry.value;
  return nullptr;
}

const FieldValue& Scene::value(NodeId id, FieldIndex field) const {
  const FieldValue* value = given(id, field);
  return value != nullptr ? *value : node(id).definition->field(field).default_value;
}

Status Scene::set(NodeId id, std::string_view field_name, FieldValue value) {
  const std::string place = type_name(id) + "." + std::string(field_name);
  const FieldIndex index = node(id).definition->find(field_name);
  if (!index.valid()) return bad_argument(place + ": there is no such field");
  const FieldDefinition& field = node(id).definition->field(index);
  if (!field.has_value()) return bad_argument(place + " is an event and keeps no value");
  if (!holds(field.type, value))
    return bad_argument(place + ": a value of another type [expected " +
                        std::string(to_string(field.type)) + "]");
  const auto fits = [&](NodeId child) { return may_stand(child, field); };
  const auto* one = std::get_if<NodeId>(&value);
  const auto* many = std::get_if<std::vector<NodeId>>(&value);
  bool all_fit = one == nullptr || fits(*one);
  for (size_t i = 0; many != nullptr && i < many->size(); ++i)
    all_fit = all_fit && fits((*many)[i]);
  if (!all_fit)
    return bad_argument(place + ": a node that may not stand here [expected " +
                        std::string(definitions().data_type_name(field.data_type)) + "]");
  set_unchecked(id, index, std::move(value));
  return {};
}

void Scene::set_unchecked(NodeId id, FieldIndex field, FieldValue value) {
  for (FieldEntry& entry : node(id).values) {
    if (entry.field != field) continue;
    entry.value = std::move(value);
    return;
  }
  node(id).values.push_back({field, std::move(value)});
}

Status Scene::append(NodeId parent, std::string_view field_name, NodeId child) {
  const FieldIndex index = node(parent).definition->find(field_name);
  const FieldDefinition* field = index.valid() ? &node(parent).definition->field(index) : nullptr;
  if (field == nullptr || field->type != FieldType::mf_node || !may_stand(child, *field))
    return set(parent, field_name, std::vector<NodeId>{child});  // finds out what is wrong
  for (FieldEntry& entry : node(parent).values) {
    if (entry.field != index) continue;
    std::get_if<std::vector<NodeId>>(&entry.value)->push_back(child);
    return {};
  }
  return set(parent, field_name, std::vector<NodeId>{child});
}

bool Scene::may_stand(NodeId child, const FieldDefinition& field) const {
  return !child.valid() || contains(node(child).definition->data_types, field.data_type);
}

NodeDefinition& Scene::own_definition(NodeId script) {
  Node& n = node(script);
  if (!n.own_definition) {
    n.own_definition = std::make_unique<NodeDefinition>(*n.definition);
    n.definition = n.own_definition.get();
  }
  return *n.own_definition;
}

void Scene::revert(const Mark& mark) {
  for (size_t i = mark.nodes; i < nodes_.size(); ++i) (void)set_name(NodeId{i}, {});
  nodes_.resize(mark.nodes);
  for (size_t i = protos_.size(); i-- > mark.protos;) {
    Scope& outer = scope(protos_[i]->scope);
    outer.proto_names.erase(protos_[i]->interface.name);
    outer.protos.pop_back();
  }
  protos_.resize(mark.protos);
  scopes_.resize(mark.scopes);
}

}  // namespace afx::nodes
