// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Nodes, PROTOs and ROUTEs in XMT-A.
#include "bifs/xmt_scene_writer.h"

#include <utility>

#include "bifs/xmt_names.h"
#include "bifs/xmt_values.h"
#include "nodes/definitions.h"
#include "nodes/value_writer.h"

namespace afx::bifs {

using nodes::FieldDefinition;
using nodes::FieldIndex;
using nodes::FieldType;
using nodes::FieldValue;
using nodes::NodeDefinition;
using nodes::NodeId;
using nodes::Scene;

namespace {

bool holds_content(const FieldValue& value) {
  return std::holds_alternative<NodeId>(value) ||
         std::holds_alternative<std::vector<NodeId>>(value) ||
         std::holds_alternative<nodes::CommandBuffer>(value);
}

/// The fields behind those of its type are those that a Script declares itself.
size_t own_begin(const nodes::Node& node) {
  if (node.own_definition == nullptr) return node.definition->fields().size();
  const NodeDefinition* type = nodes::definitions().find(node.definition->name);
  return type == nullptr ? 0 : type->fields().size();
}

}  // namespace

void XmtSceneWriter::write(const Command& command, const Scene& scene) {
  scene_ = &scene;
  // Within a buffer what is fresh around it stays so: there it is only named.
  NodeSet outer = std::exchange(fresh_, new_nodes(scene, command, known_));
  std::visit([&](const auto& c) { write(c); }, command);
  fresh_ = std::move(outer);
}

void XmtSceneWriter::write_node(NodeId id) {
  if (!out_.ok()) return;
  if (!id.valid()) return out_.line("NULL");
  const nodes::Node& node = scene_->node(id);
  const bool instance = node.proto.valid();
  out_.open(instance ? "ProtoInstance" : std::string_view(node.definition->name));
  if (instance) out_.attribute("name", node.definition->name);
  // Where another PROTO of that name is nearer, the ID tells which is meant.
  if (instance && nearest_proto(node.definition->name, node.scope) != node.proto)
    out_.attribute("protoID", scene_->proto(node.proto).id);
  if (fresh_.erase(id.value) == 0) {
    out_.attribute(kXmtUse, name_of(id));
  } else {
    write_def(id);
    write_fields(id);
  }
  out_.close();
}

std::string XmtSceneWriter::name_of(NodeId id) {
  const auto known = names_.find(id);
  if (known != names_.end()) return known->second;
  const nodes::Node& node = scene_->node(id);
  // A buffer may name what stands behind it.
  if (node.name.empty() && node.id == 0) {
    out_.fail("a " + node.definition->name +
              " that is meant twice has neither name nor ID (expected nodes::Node::id)");
    return {};
  }
  return names_[id] = choose_name(node);
}

/// The DEF name: its own, or what its ID is called. Two nodes of one name are the same ID given
/// twice.
std::string XmtSceneWriter::choose_name(const nodes::Node& node) {
  auto& taken = scopes_[node.scope].node_ids;
  const std::string own = node.name.empty() ? "N" + std::to_string(node.id - 1) : node.name;
  std::string name = own;
  for (auto found = taken.find(name); found != taken.end() && found->second != node.id;
       found = taken.find(name))
    name = own + '_' + std::to_string(++made_names_);
  taken[name] = node.id;
  return name;
}

void XmtSceneWriter::write_def(NodeId id) {
  const nodes::Node& node = scene_->node(id);
  if (node.name.empty() && node.id == 0) return;
  const std::string name = name_of(id);
  out_.attribute(kXmtDef, name);
  if (node.id == 0) return;
  say_ids_ = say_ids_ || buffer_depth_ > 0;
  TakenIds& ids = scopes_[node.scope].nodes;
  if (say_ids_ || ids.next(id_of_name('N', name)) != node.id) out_.attribute(kXmtId, node.id);
  ids.take(node.id);
}

void XmtSceneWriter::write_fields(NodeId id) {
  const nodes::Node& node = scene_->node(id);
  if (node.proto.valid()) return write_instance_fields(node);
  const size_t own = own_begin(node);
  for (const nodes::FieldEntry& entry : node.values) {
    const FieldDefinition& field = node.definition->field(entry.field);
    if (entry.field.value < own && !holds_content(entry.value))
      write_attribute(field.name, field, entry.value);
  }
  write_own_fields(id);
  write_links(node);
  for (const nodes::FieldEntry& entry : node.values) {
    if (entry.field.value >= own || !holds_content(entry.value)) continue;
    out_.open(node.definition->field(entry.field).name);
    write_content(entry.value);
    out_.close();
  }
}

void XmtSceneWriter::write_own_fields(NodeId script) {
  const nodes::Node& node = scene_->node(script);
  for (size_t i = own_begin(node); i < node.definition->fields().size(); ++i) {
    const FieldDefinition& field = node.definition->field(FieldIndex{i});
    out_.open("field");
    write_field_head(field);
    if (const FieldValue* value = scene_->given(script, FieldIndex{i}))
      write_typed_value(field, *value);
    out_.close();
  }
}

void XmtSceneWriter::write_links(const nodes::Node& node) {
  if (node.links.empty()) return;
  const NodeDefinition& interface = scene_->proto(scene_->scope(node.scope).proto).interface;
  out_.open("IS");
  for (const nodes::IsLink& link : node.links) {
    out_.open("connect");
    out_.attribute("nodeField", node.definition->field(link.field).name);
    out_.attribute("protoField", interface.field(link.interface_field).name);
    out_.close();
  }
  out_.close();
}

void XmtSceneWriter::write_instance_fields(const nodes::Node& node) {
  write_links(node);
  for (const nodes::FieldEntry& entry : node.values) {
    const FieldDefinition& field = node.definition->field(entry.field);
    out_.open("fieldValue");
    out_.attribute("name", field.name);
    write_typed_value(field, entry.value);
    out_.close();
  }
}

void XmtSceneWriter::write_typed_value(const FieldDefinition& field, const FieldValue& value) {
  const char* const name = xmt_type(field.type).value_attribute;
  if (!holds_content(value)) return write_attribute(name, field, value);
  out_.open(name);
  write_content(value);
  out_.close();
}

void XmtSceneWriter::write_attribute(std::string_view name, const FieldDefinition& field,
                                     const FieldValue& value) {
  std::string text;
  append_xmt_value(text, value, field.type, field.bytes);
  out_.attribute(name, text);
}

void XmtSceneWriter::write_content(const FieldValue& value) {
  if (const auto* one = std::get_if<NodeId>(&value)) write_node(*one);
  if (const auto* many = std::get_if<std::vector<NodeId>>(&value))
    for (const NodeId node : *many) write_node(node);
  if (const auto* buffer = std::get_if<nodes::CommandBuffer>(&value)) write_buffer(*buffer);
}

void XmtSceneWriter::write_buffer(const nodes::CommandBuffer& buffer) {
  const auto* content = dynamic_cast<const BufferedCommands*>(buffer.content.get());
  if (content == nullptr && !buffer.text.empty())
    return out_.fail({Errc::unsupported, {}, "a command buffer that is only text"});
  if (content == nullptr) return;
  ++buffer_depth_;
  for (const Command& command : content->commands) write(command, *scene_);
  --buffer_depth_;
}

/// The PROTO that a name means in what has been written.
nodes::ProtoId XmtSceneWriter::nearest_proto(std::string_view name, nodes::ScopeId scope) const {
  for (; scope.valid(); scope = scene_->scope(scope).parent) {
    const auto names = scopes_.find(scope);
    if (names == scopes_.end()) continue;
    const auto found = names->second.protos.find(name);
    if (found != names->second.protos.end()) return found->second;
  }
  return {};
}

void XmtSceneWriter::write_proto(nodes::ProtoId id) {
  const nodes::Proto& proto = scene_->proto(id);
  scopes_[proto.scope].protos[proto.interface.name] = id;
  out_.open("ProtoDeclare");
  out_.attribute("name", proto.interface.name);
  out_.attribute("protoID", proto.id);
  FieldDefinition locations;
  locations.type = FieldType::mf_url;
  if (proto.external) write_attribute("locations", locations, proto.urls);
  for (const FieldDefinition& field : proto.interface.fields()) write_interface_field(field);
  const nodes::Scope& body = scene_->scope(proto.body);
  for (const nodes::ProtoId inner : body.protos) write_proto(inner);
  for (const NodeId root : body.roots) write_node(root);
  for (const nodes::Route& route : body.routes) write_route(route, proto.body);
  out_.close();
}

void XmtSceneWriter::write_field_head(const FieldDefinition& field) {
  out_.attribute("name", field.name);
  out_.attribute("type", xmt_type(field.type).name);
  out_.attribute("vrml97Hint", to_string(field.kind));
}

void XmtSceneWriter::write_interface_field(const FieldDefinition& field) {
  out_.open("field");
  write_field_head(field);
  if (field.has_value()) write_typed_value(field, field.default_value);
  write_coding(field);
  out_.close();
}

void XmtSceneWriter::write_coding(const FieldDefinition& field) {
  if (field.quant_category == 0 && field.quant_bits == 0 && field.anim_category == 0 &&
      !field.bounds)
    return;
  out_.open("InterfaceCodingParameters");
  if (field.quant_category != 0)
    out_.attribute("quantCategoy", kXmtQuantCategories[field.quant_category & 15]);
  if (field.quant_bits != 0) out_.attribute("nbBits", field.quant_bits);
  if (field.bounds) {
    const bool whole = element_type(field.type) == FieldType::sf_int32;
    std::string lower, upper;
    nodes::append_number(lower, field.bounds->lower);
    nodes::append_number(upper, field.bounds->upper);
    out_.attribute(whole ? "intMin" : "floatMin", lower);
    out_.attribute(whole ? "intMax" : "floatMax", upper);
  }
  if (field.anim_category != 0) out_.attribute("animCategory", field.anim_category);
  out_.close();
}

void XmtSceneWriter::write_route(const nodes::Route& route, nodes::ScopeId scope) {
  out_.open("ROUTE");
  const bool named = !route.name.empty() || route.id != 0;
  const std::string name = route.name.empty() ? "R" + std::to_string(route.id - 1) : route.name;
  if (named) out_.attribute(kXmtDef, name);
  if (route.id != 0) {
    say_ids_ = say_ids_ || buffer_depth_ > 0;
    TakenIds& ids = scopes_[scope].routes;
    if (say_ids_ || ids.next(id_of_name('R', name)) != route.id) out_.attribute(kXmtId, route.id);
    ids.take(route.id);
    if (scope == Scene::kMain) route_names_[route.id] = name;
  }
  write_route_ends({route.from, route.from_field}, {route.to, route.to_field});
  out_.close();
}

void XmtSceneWriter::write_route_ends(const FieldRef& from, const FieldRef& to) {
  write_field_ref("fromNode", "fromField", from);
  write_field_ref("toNode", "toField", to);
}

}  // namespace afx::bifs
