// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/bt_writer.h"

#include <map>
#include <utility>

#include "bifs/bt_descriptor_writer.h"
#include "bifs/text_names.h"

namespace afx::bifs {

using nodes::FieldDefinition;
using nodes::FieldType;
using nodes::FieldValue;
using nodes::NodeDefinition;
using nodes::NodeId;

class BtWriter::State final : private nodes::NodeTextWriter {
 public:
  explicit State(nodes::TextSink sink) : NodeTextWriter(out_, names_), out_(std::move(sink)) {}

  Status begin(const InitialObjectDescriptor& initial) {
    if (initial.parts.empty()) return {};
    text() += bt_text(initial);
    text() += '\n';
    return {};
  }

  void begin_frame(uint64_t time, bool random_access) {
    time_ = time;
    random_access_ = random_access;
  }

  /// The scene that the presentation begins with stands for itself, all else in AT.
  void add(const Command& command, const nodes::Scene& before) {
    set_scene(before);
    NodeSet outer = names_.begin_command(before, command);
    const auto* scene = std::get_if<SceneReplacement>(&command);
    if (scene != nullptr && first_ && time_ == 0 && is_plain(*scene)) {
      write_scene_content(*scene);
      begin_line();
    } else {
      open_block();
      std::visit([&](const auto& c) { write(c); }, command);
    }
    first_ = false;
    names_.end_command(std::move(outer));
  }

  void end_frame() { close_block(); }

  void object_descriptors(uint64_t time, bool random_access, const OdCommands& commands) {
    begin_frame(time, random_access);
    first_ = false;
    open_block();
    for (const OdCommand& command : commands) {
      begin_whole_line();
      text() += bt_text(command, 1);
    }
    close_block();
  }

  Status end() {
    if (!out_.at_line_begin()) text() += '\n';
    return out_.finish();
  }

 private:
  static bool is_plain(const SceneReplacement& scene) {
    return scene.root.valid() || !scene.protos.empty();
  }

  void begin_whole_line() {
    if (!out_.at_line_begin()) text() += '\n';
  }
  void open_block() {
    if (std::exchange(open_, true)) return;
    begin_line();
    text() += (random_access_ ? "RAP AT " : "AT ") + std::to_string(time_) + " {";
    indent();
  }
  void close_block() {
    if (!std::exchange(open_, false)) return;
    unindent();
    begin_line();
    text() += '}';
    begin_line();
  }

  void write_scene_content(const SceneReplacement& c) {
    proto_names_.clear();
    write_protos(c.protos);
    if (c.root.valid() || open_) {  // a command wants a node, or NULL
      begin_line();
      write_node(c.root);
    }
    for (const nodes::Route& route : c.routes) write_route(route);
  }

  /// `word n.field[i] rest`.
  void word(std::string_view first) {
    begin_line();
    text() += first;
  }
  void target(NodeId node) { (text() += ' ') += names_.name(node); }
  void target(const FieldRef& ref) {
    target(ref.node);
    (text() += '.') += field(ref).name;
  }
  const FieldDefinition& field(const FieldRef& ref) const {
    return scene().node(ref.node).definition->field(ref.field);
  }
  void position(const Position& p) {
    text() += '[';
    if (p.kind == Position::Kind::last) {
      text() += "-1";
    } else {
      text() += std::to_string(p.kind == Position::Kind::first ? 0 : p.index);
    }
    text() += ']';
  }
  void value(const FieldRef& ref, const FieldValue& v) {
    text() += ' ';
    write_value(field(ref), v);
  }
  void by() { text() += " BY"; }
  void node(NodeId id) {
    text() += ' ';
    write_node(id);
  }

  void write(const NodeInsertion& c) {
    const NodeDefinition& definition = *scene().node(c.target).definition;
    for (size_t i = 0; i < definition.fields().size(); ++i) {
      const FieldDefinition& f = definition.fields()[i];
      if (f.type != FieldType::mf_node || !f.has_value()) continue;
      return insertion({c.target, nodes::FieldIndex{i}}, c.position, c.node);
    }
  }
  void write(const IndexedValueInsertion& c) { insertion(c.target, c.position, c.value); }
  void insertion(const FieldRef& ref, const Position& at, const FieldValue& v) {
    const bool last = at.kind == Position::Kind::last;
    word(last ? "APPEND TO" : "INSERT AT");
    target(ref);
    if (!last) position(at);
    value(ref, v);
  }
  void write(const RouteInsertion& c) {
    word("INSERT ROUTE ");
    const std::string name = names_.route_name(c.route);
    if (!name.empty()) text() += "DEF " + name + ' ';
    write_route_ends(c.route);
  }
  void write(const NodeDeletion& c) {
    word(c.extended ? "XDELETE" : "DELETE");
    target(c.target);
  }
  void write(const IndexedValueDeletion& c) {
    word("DELETE");
    target(c.target);
    position(c.position);
  }
  void write(const RouteDeletion& c) { word("DELETE ROUTE " + names_.route_name(c.route_id)); }
  void write(const NodeReplacement& c) {
    word("REPLACE");
    target(c.target);
    by();
    node(c.node);
  }
  void write(const FieldReplacement& c) {
    word("REPLACE");
    target(c.target);
    by();
    value(c.target, c.value);
  }
  void write(const IndexedValueReplacement& c) {
    word("REPLACE");
    target(c.target);
    position(c.position);
    by();
    value(c.target, c.value);
  }
  void write(const RouteReplacement& c) {
    word("REPLACE ROUTE " + names_.route_name(c.route_id) + " BY ");
    write_route_ends({c.from.node, c.from.field, c.to.node, c.to.field, {}, 0});
  }
  void write(const SceneReplacement& c) {
    word("REPLACE SCENE BY");
    indent();
    write_scene_content(c);
    unindent();
  }
  void write(const ProtoInsertion& c) {
    word("INSERTPROTO [");
    indent();
    write_protos(c.protos);
    unindent();
    word("]");
  }
  void write(const ProtoDeletion& c) {
    word("DELETEPROTO [");
    for (const uint32_t id : c.proto_ids) (text() += ' ') += proto_name(id);
    text() += " ]";
  }
  void write(const AllProtoDeletion&) { word("DELETEPROTO ALL"); }
  void write(const MultipleIndexedReplacement& c) {
    word("MULTIPLEINDREPLACE");
    target(c.target);
    text() += " [";
    indent();
    for (const IndexedValue& v : c.values) {
      word(std::to_string(v.index) + " BY");
      value(c.target, v.value);
    }
    unindent();
    word("]");
  }
  void write(const MultipleFieldReplacement& c) {
    word("MULTIPLEREPLACE");
    target(c.target);
    text() += " {";
    indent();
    for (const nodes::FieldEntry& entry : c.values) {
      word(field({c.target, entry.field}).name);
      value({c.target, entry.field}, entry.value);
    }
    unindent();
    word("}");
  }
  void write(const GlobalQuantizer& c) {
    word("GLOBALQP");
    node(c.node);
  }
  void write(const XReplace& c) {
    word("XREPLACE");
    target(c.target);
    if (c.index_from) {
      text() += '[';
      (text() += names_.name(c.index_from->node)) += '.';
      text() += field(*c.index_from).name + ']';
    } else if (c.position) {
      position(*c.position);
    }
    if (c.child_field) text() += '.' + field(*c.child_field).name;
    by();
    if (c.value_from) return target(*c.value_from);
    value(c.child_field ? *c.child_field : c.target, c.value);
  }

  std::string proto_name(uint32_t id) const {
    const auto found = proto_names_.find(id);
    return found != proto_names_.end() ? found->second : "Proto" + std::to_string(id);
  }
  void write_protos(const std::vector<nodes::ProtoId>& protos) {
    for (const nodes::ProtoId proto : protos) {
      proto_names_[scene().proto(proto).id] = scene().proto(proto).interface.name;
      write_proto(proto);
    }
  }

  void write_command_buffer(const nodes::CommandBuffer& buffer) override {
    const auto* commands = dynamic_cast<const BufferedCommands*>(buffer.content.get());
    if (commands == nullptr) return NodeTextWriter::write_command_buffer(buffer);
    if (commands->commands.empty()) return;
    indent();
    for (const Command& command : commands->commands) {
      NodeSet outer = names_.begin_command(scene(), command);
      std::visit([&](const auto& c) { write(c); }, command);
      names_.end_command(std::move(outer));
    }
    unindent();
    begin_line();
  }

  TextNames names_;
  nodes::TextOut out_;
  std::map<uint32_t, std::string> proto_names_;  ///< of the scene, by ID
  uint64_t time_ = 0;
  bool random_access_ = true;
  bool first_ = true;  ///< no command has been written
  bool open_ = false;  ///< in AT
};

BtWriter::BtWriter(nodes::TextSink sink) : state_(std::make_unique<State>(std::move(sink))) {}
BtWriter::~BtWriter() = default;

Status BtWriter::begin(const InitialObjectDescriptor& initial) { return state_->begin(initial); }
Status BtWriter::begin_frame(uint64_t time, bool random_access) {
  state_->begin_frame(time, random_access);
  return {};
}
Status BtWriter::add(const Command& command, const nodes::Scene& before) {
  state_->add(command, before);
  return {};
}
Status BtWriter::end_frame() {
  state_->end_frame();
  return {};
}
Status BtWriter::object_descriptors(uint64_t time, bool random_access, const OdCommands& commands) {
  state_->object_descriptors(time, random_access, commands);
  return {};
}
Status BtWriter::end() { return state_->end(); }

}  // namespace afx::bifs
