// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The commands in XMT-A; see xmt_writer.h for the forms.
#include "bifs/xmt_names.h"
#include "bifs/xmt_scene_writer.h"
#include "bifs/xmt_values.h"

namespace afx::bifs {

using nodes::FieldDefinition;
using nodes::FieldValue;

void XmtSceneWriter::write_field_ref(const char* node, const char* field, const FieldRef& ref) {
  out_.attribute(node, name_of(ref.node));
  out_.attribute(field, definition(ref).name);
}

void XmtSceneWriter::write_target(const FieldRef& target) {
  write_field_ref("atNode", "atField", target);
}

void XmtSceneWriter::write_position(const Position& position) {
  const bool first = position.kind == Position::Kind::first;
  if (position.kind == Position::Kind::index) return out_.attribute("position", position.index);
  out_.attribute("position", first ? "BEGIN" : "END");
}

/// A value as attribute, or as content of the element at work. `field` with the type of the value
/// or of a list of it.
void XmtSceneWriter::write_value(const FieldDefinition& field, const FieldValue& value) {
  const auto type = holds(field.type, value) ? field.type : element_type(field.type);
  if (is_node(type) || type == nodes::FieldType::sf_command_buffer) return write_content(value);
  std::string text;
  append_xmt_value(text, value, type, field.bytes);
  out_.attribute("value", text);
}

void XmtSceneWriter::open_extended(std::string_view name, std::string_view form) {
  out_.open(name);
  out_.attribute("extended", form);
}

void XmtSceneWriter::write(const NodeInsertion& c) {
  out_.open("Insert");
  write_target(c.target);
  write_position(c.position);
  write_node(c.node);
  out_.close();
}

void XmtSceneWriter::write(const IndexedValueInsertion& c) {
  out_.open("Insert");
  write_target(c.target);
  write_position(c.position);
  write_value(definition(c.target), c.value);
  out_.close();
}

void XmtSceneWriter::write(const RouteInsertion& c) {
  out_.open("Insert");
  write_route(c.route, scene_->node(c.route.from).scope);
  out_.close();
}

void XmtSceneWriter::write(const NodeDeletion& c) {
  out_.open("Delete");
  if (c.extended) out_.attribute("extended", xmt_extended::kDeletion);
  write_target(c.target);
  out_.close();
}

void XmtSceneWriter::write(const IndexedValueDeletion& c) {
  out_.open("Delete");
  write_target(c.target);
  write_position(c.position);
  out_.close();
}

std::string XmtSceneWriter::route_name(uint32_t id) const {
  const auto known = route_names_.find(id);
  return known != route_names_.end() ? known->second : "R" + std::to_string(id - 1);
}

void XmtSceneWriter::write(const RouteDeletion& c) {
  out_.open("Delete");
  out_.attribute("atRoute", route_name(c.route_id));
  out_.close();
}

void XmtSceneWriter::write(const NodeReplacement& c) {
  out_.open("Replace");
  write_target(c.target);
  write_node(c.node);
  out_.close();
}

void XmtSceneWriter::write(const FieldReplacement& c) {
  out_.open("Replace");
  write_target(c.target);
  write_value(definition(c.target), c.value);
  out_.close();
}

void XmtSceneWriter::write(const IndexedValueReplacement& c) {
  out_.open("Replace");
  write_target(c.target);
  write_position(c.position);
  write_value(definition(c.target), c.value);
  out_.close();
}

void XmtSceneWriter::write(const RouteReplacement& c) {
  out_.open("Replace");
  out_.attribute("atRoute", route_name(c.route_id));
  out_.open("ROUTE");
  write_route_ends(c.from, c.to);
  out_.close();
  out_.close();
}

void XmtSceneWriter::write(const SceneReplacement& c) {
  if (buffer_depth_ == 0) forget_scene();
  out_.open("Replace");
  out_.open("Scene");
  if (c.use_names) out_.attribute("USENAMES", "true");
  for (const nodes::ProtoId proto : c.protos) write_proto(proto);
  write_node(c.root);
  for (const nodes::Route& route : c.routes) write_route(route, nodes::Scene::kMain);
  out_.close();
  out_.close();
}

void XmtSceneWriter::forget_scene() {
  names_.clear();
  scopes_.clear();
  route_names_.clear();
  say_ids_ = false;
}

void XmtSceneWriter::write(const ProtoInsertion& c) {
  open_extended("Insert", xmt_extended::kProtos);
  for (const nodes::ProtoId proto : c.protos) write_proto(proto);
  out_.close();
}

void XmtSceneWriter::write(const ProtoDeletion& c) {
  std::string ids;
  for (const uint32_t id : c.proto_ids) ids += (ids.empty() ? "" : " ") + std::to_string(id);
  open_extended("Delete", xmt_extended::kProtos);
  out_.attribute("protoID", ids);
  out_.close();
}

void XmtSceneWriter::write(const AllProtoDeletion&) {
  open_extended("Delete", xmt_extended::kAllProtos);
  out_.close();
}

void XmtSceneWriter::write(const MultipleIndexedReplacement& c) {
  open_extended("Replace", xmt_extended::kIndices);
  write_target(c.target);
  for (const IndexedValue& value : c.values) {
    out_.open("repValue");
    out_.attribute("position", value.index);
    write_value(definition(c.target), value.value);
    out_.close();
  }
  out_.close();
}

void XmtSceneWriter::write(const MultipleFieldReplacement& c) {
  open_extended("Replace", xmt_extended::kFields);
  write_target(c.target);
  for (const nodes::FieldEntry& entry : c.values) {
    const FieldDefinition& field = definition({c.target, entry.field});
    out_.open("repField");
    out_.attribute("atField", field.name);
    write_value(field, entry.value);
    out_.close();
  }
  out_.close();
}

void XmtSceneWriter::write(const GlobalQuantizer& c) {
  open_extended("Replace", xmt_extended::kGlobalQuantizer);
  write_node(c.node);
  out_.close();
}

void XmtSceneWriter::write(const XReplace& c) {
  open_extended("Replace", xmt_extended::kXReplace);
  write_target(c.target);
  if (c.position) write_position(*c.position);
  if (c.index_from) write_field_ref("atIndexNode", "atIndexField", *c.index_from);
  if (c.child_field) {
    out_.attribute("atChildNode", scene_->type_name(c.child_field->node));
    out_.attribute("atChildField", definition(*c.child_field).name);
  }
  if (c.value_from) {
    write_field_ref("fromNode", "fromField", *c.value_from);
  } else {
    write_value(definition(c.child_field.value_or(c.target)), c.value);
  }
  out_.close();
}

}  // namespace afx::bifs
