// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "nodes/scene_writer.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "nodes/byte_text.h"
#include "nodes/definitions.h"
#include "nodes/text_cursor.h"
#include "nodes/value_writer.h"

namespace afx::nodes {

namespace {

class SceneTextWriter {
 public:
  explicit SceneTextWriter(const Scene& scene)
      : scene_(scene), names_(scene.node_count()), written_(scene.node_count()) {
    choose_names();
  }

  std::string write(const SceneWriteOptions& options) {
    if (options.vrml_header) out_ = "#VRML V2.0 utf8\n";
    write_scope(Scene::kMain);
    return std::move(out_);
  }

 private:
  // Every node gets the name it has; where it has none but stands in several places, or the name is
  // no word or not its own, a made one.
  void choose_names() {
    std::vector<uint32_t> uses(scene_.node_count());
    const auto count = [&](NodeId id) {
      uses[id.value] += id.valid() && uses[id.value] < 2 ? 1 : 0;
    };
    for (size_t s = 0; s < scene_.scope_count(); ++s)
      for (const NodeId root : scene_.scope(ScopeId{s}).roots)
        if (root.valid()) count(root);
    for (size_t n = 0; n < scene_.node_count(); ++n)
      for (const FieldEntry& entry : scene_.node(NodeId{n}).values) each_node(entry.value, count);
    for (size_t p = 0; p < scene_.proto_count(); ++p)
      for (const FieldDefinition& field : scene_.proto(ProtoId{p}).interface.fields())
        each_node(field.default_value, count);
    for (size_t s = 0; s < scene_.scope_count(); ++s)
      for (const Route& route : scene_.scope(ScopeId{s}).routes)
        for (const NodeId end : {route.from, route.to})
          if (end.valid()) uses[end.value] = 2;
    std::vector<std::set<std::string>> taken(scene_.scope_count());
    for (const bool made : {false, true})
      for (size_t n = 0; n < scene_.node_count(); ++n) choose_name(NodeId{n}, made, uses[n], taken);
  }

  void choose_name(NodeId id, bool make, uint32_t uses, std::vector<std::set<std::string>>& taken) {
    const Node& node = scene_.node(id);
    std::set<std::string>& names = taken[node.scope.value];
    std::string& name = names_[id.value];
    if (!make && is_identifier(node.name) && names.insert(node.name).second) name = node.name;
    if (!make || !name.empty() || (node.name.empty() && uses < 2)) return;
    do name = "_N" + std::to_string(++made_names_);
    while (!names.insert(name).second);
  }

  template <class Count>
  static void each_node(const FieldValue& value, const Count& count) {
    if (const auto* one = std::get_if<NodeId>(&value)) {
      if (one->valid()) count(*one);
    } else if (const auto* many = std::get_if<std::vector<NodeId>>(&value)) {
      for (const NodeId id : *many)
        if (id.valid()) count(id);
    }
  }

  void write_scope(ScopeId id) {
    const Scope& scope = scene_.scope(id);
    for (const ProtoId proto : scope.protos) write_proto(scene_.proto(proto));
    for (const NodeId root : scope.roots) {
      begin_line();
      write_node(root);
    }
    for (const Route& route : scope.routes) write_route(route);
  }

  void write_proto(const Proto& proto) {
    begin_line();
    out_ += (proto.external ? "EXTERNPROTO " : "PROTO ") + proto.interface.name + " [";
    ++depth_;
    for (const FieldDefinition& field : proto.interface.fields()) {
      begin_line();
      write_head(field);
      if (field.has_value()) write_value(field, field.default_value);
      write_coding(field);
    }
    --depth_;
    begin_line();
    out_ += "] ";
    if (proto.external) return append_value(out_, proto.urls, 2 * depth_ + 2);
    out_ += '{';
    ++depth_;
    write_scope(proto.body);
    --depth_;
    begin_line();
    out_ += '}';
  }

  void write_head(const FieldDefinition& field) {
    out_ += to_string(field.kind);
    out_ += ' ';
    out_ += to_string(field.type);
    out_ += ' ' + field.name;
  }

  void write_coding(const FieldDefinition& field) {
    if (field.quant_category == 0 && field.quant_bits == 0 && field.anim_category == 0 &&
        !field.bounds)
      return;
    out_ += " {";
    if (field.quant_category != 0) out_ += " QP " + std::to_string(field.quant_category);
    if (field.quant_bits != 0) out_ += " nbBits " + std::to_string(field.quant_bits);
    if (field.bounds) {
      out_ += " b { ";
      append_number(out_, field.bounds->lower);
      out_ += ' ';
      append_number(out_, field.bounds->upper);
      out_ += " }";
      if (field.bounds->lower_open) out_ += " OPENMIN";
      if (field.bounds->upper_open) out_ += " OPENMAX";
    }
    if (field.anim_category != 0) out_ += " ANIM " + std::to_string(field.anim_category);
    out_ += " }";
  }

  void write_node(NodeId id) {
    if (!id.valid()) {
      out_ += "NULL";
      return;
    }
    if (written_[id.value] != 0) {
      out_ += "USE " + names_[id.value];
      return;
    }
    written_[id.value] = 1;
    if (!names_[id.value].empty()) out_ += "DEF " + names_[id.value] + ' ';
    out_ += scene_.type_name(id) + " {";
    const Node& node = scene_.node(id);
    const size_t before = out_.size();
    ++depth_;
    write_own_fields(id);
    for (const FieldEntry& entry : node.values)
      if (!is_own(node, entry.field)) write_field(node.definition->field(entry.field), entry.value);
    for (const IsLink& link : node.links)
      if (!is_own(node, link.field)) write_link(node, link);
    --depth_;
    if (out_.size() != before) begin_line();
    out_ += '}';
  }

  void write_field(const FieldDefinition& field, const FieldValue& value) {
    begin_line();
    out_ += field.name;
    write_value(field, value);
  }

  void write_link(const Node& node, const IsLink& link) {
    begin_line();
    out_ += node.definition->field(link.field).name;
    write_is(node, link);
  }

  void write_is(const Node& node, const IsLink& link) {
    const Proto& proto = scene_.proto(scene_.scope(node.scope).proto);
    out_ += " IS " + proto.interface.field(link.interface_field).name;
  }

  /// Whether it is one that the Script declares itself: those stand behind the ones of its type.
  static bool is_own(const Node& node, FieldIndex field) {
    return node.own_definition && field.value >= own_begin(node);
  }
  static size_t own_begin(const Node& node) {
    const NodeDefinition* type = definitions().find(node.definition->name);
    return type == nullptr ? 0 : type->fields().size();
  }

  /// The declarations of a Script, in their order, with value or IS.
  void write_own_fields(NodeId id) {
    const Node& node = scene_.node(id);
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
        write_value(field, scene_.value(id, index));
      }
    }
  }

  void write_value(const FieldDefinition& field, const FieldValue& value) {
    out_ += ' ';
    if (const auto* one = std::get_if<NodeId>(&value)) return write_node(*one);
    if (const auto* many = std::get_if<std::vector<NodeId>>(&value)) return write_nodes(*many);
    if (field.bytes) return append_string(out_, text_of_bytes(*std::get_if<std::string>(&value)));
    append_value(out_, value, 2 * depth_ + 2);
  }

  void write_nodes(const std::vector<NodeId>& nodes) {
    out_ += '[';
    ++depth_;
    for (const NodeId node : nodes) {
      begin_line();
      write_node(node);
    }
    --depth_;
    if (!nodes.empty()) begin_line();
    out_ += ']';
  }

  void write_route(const Route& route) {
    if (!can_be_named(route.from) || !can_be_named(route.to)) return;
    begin_line();
    if (is_identifier(route.name)) out_ += "DEF " + route.name + ' ';
    out_ += "ROUTE " + end_text(route.from, route.from_field) + " TO " +
            end_text(route.to, route.to_field);
  }
  [[nodiscard]] bool can_be_named(NodeId id) const { return id.valid() && written_[id.value] != 0; }
  [[nodiscard]] std::string end_text(NodeId id, FieldIndex field) const {
    return names_[id.value] + '.' + scene_.node(id).definition->field(field).name;
  }

  void begin_line() {
    if (!out_.empty() && out_.back() != '\n') out_ += '\n';
    out_.append(2 * depth_, ' ');
  }

  const Scene& scene_;
  std::vector<std::string> names_;  ///< by node number; empty = none needed
  std::vector<uint8_t> written_;    ///< by node number
  std::string out_;
  size_t depth_ = 0;
  uint64_t made_names_ = 0;
};

}  // namespace

std::string write_scene_text(const Scene& scene, const SceneWriteOptions& options) {
  std::string text = SceneTextWriter(scene).write(options);
  if (!text.empty() && text.back() != '\n') text += '\n';
  return text;
}

std::string value_text(const FieldValue& value) {
  std::string out;
  append_value(out, value);
  return out;
}

}  // namespace afx::nodes
