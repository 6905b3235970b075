// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "nodes/node_text_writer.h"

#include <algorithm>

#include "nodes/byte_text.h"
#include "nodes/definitions.h"
#include "nodes/text_cursor.h"
#include "nodes/value_writer.h"

namespace afx::nodes {

namespace {

size_t own_begin(const Node& node) {
  const NodeDefinition* type = definitions().find(node.definition->name);
  return type == nullptr ? 0 : type->fields().size();
}

/// Whether it is one that the Script declares itself: those stand behind the ones of its type.
bool is_own(const Node& node, FieldIndex field) {
  return node.own_definition && field.value >= own_begin(node);
}

}  // namespace

void NodeTextWriter::begin_line() {
  if (!out_.at_line_begin()) text() += '\n';
  out_.piece();
  text().append(2 * depth_, ' ');
}

void NodeTextWriter::write_scope(ScopeId id) {
  const Scope& scope = scene_->scope(id);
  for (const ProtoId proto : scope.protos) write_proto(proto);
  for (const NodeId root : scope.roots) {
    begin_line();
    write_node(root);
  }
  for (const Route& route : scope.routes) write_route(route);
}

void NodeTextWriter::write_proto(ProtoId id) {
  const Proto& proto = scene_->proto(id);
  begin_line();
  text() += (proto.external ? "EXTERNPROTO " : "PROTO ") + proto.interface.name + " [";
  ++depth_;
  for (const FieldDefinition& field : proto.interface.fields()) {
    begin_line();
    write_head(field);
    if (field.has_value()) {
      text() += ' ';
      write_value(field, field.default_value);
    }
    write_coding(field);
  }
  --depth_;
  begin_line();
  text() += "] ";
  if (proto.external) return append_value(text(), proto.urls, 2 * depth_ + 2);
  text() += '{';
  ++depth_;
  write_scope(proto.body);
  --depth_;
  begin_line();
  text() += '}';
}

void NodeTextWriter::write_head(const FieldDefinition& field) {
  text() += to_string(field.kind);
  text() += ' ';
  text() += to_string(field.type);
  text() += ' ' + field.name;
}

void NodeTextWriter::write_coding(const FieldDefinition& field) {
  if (field.quant_category == 0 && field.quant_bits == 0 && field.anim_category == 0 &&
      !field.bounds)
    return;
  std::string& out = text();
  out += " {";
  if (field.quant_category != 0) out += " QP " + std::to_string(field.quant_category);
  if (field.quant_bits != 0) out += " nbBits " + std::to_string(field.quant_bits);
  if (field.bounds) {
    out += " b { ";
    append_number(out, field.bounds->lower);
    out += ' ';
    append_number(out, field.bounds->upper);
    out += " }";
    if (field.bounds->lower_open) out += " OPENMIN";
    if (field.bounds->upper_open) out += " OPENMAX";
  }
  if (field.anim_category != 0) out += " ANIM " + std::to_string(field.anim_category);
  out += " }";
}

void NodeTextWriter::write_node(NodeId id) {
  if (!id.valid()) {
    text() += "NULL";
    return;
  }
  const bool whole = naming_.stands_here(id);
  const std::string_view name = naming_.name(id);
  if (!whole) {
    (text() += "USE ") += name;
    return;
  }
  if (!name.empty()) ((text() += "DEF ") += name) += ' ';
  text() += scene_->type_name(id) + " {";
  ++depth_;
  write_fields(id);
  --depth_;
  const Node& node = scene_->node(id);
  const bool empty = node.values.empty() && node.links.empty() && !node.own_definition;
  if (!empty) begin_line();
  text() += '}';
}

void NodeTextWriter::write_fields(NodeId id) {
  const Node& node = scene_->node(id);
  write_own_fields(id);
  for (const FieldEntry& entry : node.values) {
    if (is_own(node, entry.field)) continue;
    const FieldDefinition& field = node.definition->field(entry.field);
    begin_line();
    text() += field.name + ' ';
    write_value(field, entry.value);
  }
  for (const IsLink& link : node.links) {
    if (is_own(node, link.field)) continue;
    begin_line();
    text() += node.definition->field(link.field).name;
    write_is(node, link);
  }
}

void NodeTextWriter::write_is(const Node& node, const IsLink& link) {
  const Proto& proto = scene_->proto(scene_->scope(node.scope).proto);
  text() += " IS " + proto.interface.field(link.interface_field).name;
}

/// The declarations of a Script, in their order, with value or IS.
void NodeTextWriter::write_own_fields(NodeId id) {
  const Node& node = scene_->node(id);
  if (!node.own_definition) return;
  for (size_t i = own_begin(node); i < node.definition->fields().size(); ++i) {
    const FieldIndex index{i};
    const FieldDefinition& field = node.definition->field(index);
    begin_line();
    write_head(field);
    const auto link = std::find_if(node.links.begin(), node.links.end(),
                                   [&](const IsLink& l) { return l.field == index; });
    if (link != node.links.end()) {
      write_is(node, *link);
    } else if (field.has_value()) {
      text() += ' ';
      write_value(field, scene_->value(id, index));
    }
  }
}

void NodeTextWriter::write_value(const FieldDefinition& field, const FieldValue& value) {
  if (const auto* one = std::get_if<NodeId>(&value)) return write_node(*one);
  if (const auto* many = std::get_if<std::vector<NodeId>>(&value)) return write_nodes(*many);
  if (field.bytes) return append_string(text(), text_of_bytes(*std::get_if<std::string>(&value)));
  if (const auto* buffer = std::get_if<CommandBuffer>(&value)) {
    text() += '{';
    write_command_buffer(*buffer);
    text() += '}';
    return;
  }
  append_value(out_, value, 2 * depth_ + 2);
}

void NodeTextWriter::write_command_buffer(const CommandBuffer& buffer) { text() += buffer.text; }

void NodeTextWriter::write_nodes(const std::vector<NodeId>& nodes) {
  text() += '[';
  ++depth_;
  for (const NodeId node : nodes) {
    begin_line();
    write_node(node);
  }
  --depth_;
  if (!nodes.empty()) begin_line();
  text() += ']';
}

void NodeTextWriter::write_route(const Route& route) {
  if (!naming_.can_write(route)) return;
  begin_line();
  const std::string name = naming_.route_name(route);
  if (!name.empty()) text() += "DEF " + name + ' ';
  text() += "ROUTE ";
  write_route_ends(route);
}

void NodeTextWriter::write_route_ends(const Route& route) {
  text() += end_text(route.from, route.from_field) + " TO " + end_text(route.to, route.to_field);
}

std::string NodeTextWriter::end_text(NodeId id, FieldIndex field) {
  return std::string(naming_.name(id)) + '.' + scene_->node(id).definition->field(field).name;
}

}  // namespace afx::nodes
