// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The inside of xmt_writer.h: commands, nodes, PROTOs and ROUTEs.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "bifs/command.h"
#include "bifs/id_assignment.h"
#include "bifs/node_walk.h"
#include "bifs/xmt_output.h"
#include "nodes/scene.h"

namespace afx::bifs {

class XmtSceneWriter {
 public:
  explicit XmtSceneWriter(XmtOutput& out) : out_(out) {}

  /// Writes a command; `scene` as it is before it.
  void write(const Command& command, const nodes::Scene& scene);

 private:
  // xmt_scene_writer.cpp: nodes, PROTOs and ROUTEs
  void write_node(nodes::NodeId node);
  void write_use(nodes::NodeId node);
  void write_def(nodes::NodeId node);
  std::string choose_name(const nodes::Node& node);
  void write_fields(nodes::NodeId node);
  void write_own_fields(nodes::NodeId script);
  void write_links(const nodes::Node& node);
  void write_instance_fields(const nodes::Node& node);
  /// The value of a `field` or `fieldValue` element at work: an attribute or an element.
  void write_typed_value(const nodes::FieldDefinition& field, const nodes::FieldValue& value);
  void write_attribute(std::string_view name, const nodes::FieldDefinition& field,
                       const nodes::FieldValue& value);
  /// Nodes or commands, into the element at work.
  void write_content(const nodes::FieldValue& value);
  void write_buffer(const nodes::CommandBuffer& buffer);
  nodes::ProtoId nearest_proto(std::string_view name, nodes::ScopeId scope) const;
  void write_proto(nodes::ProtoId proto);
  void write_interface_field(const nodes::FieldDefinition& field);
  void write_field_head(const nodes::FieldDefinition& field);
  void write_coding(const nodes::FieldDefinition& field);
  void write_route(const nodes::Route& route, nodes::ScopeId scope);
  void write_route_ends(const FieldRef& from, const FieldRef& to);
  std::string name_of(nodes::NodeId node);

  // xmt_scene_writer_commands.cpp
  void write(const NodeInsertion& c);
  void write(const IndexedValueInsertion& c);
  void write(const RouteInsertion& c);
  void write(const NodeDeletion& c);
  void write(const IndexedValueDeletion& c);
  void write(const RouteDeletion& c);
  void write(const NodeReplacement& c);
  void write(const FieldReplacement& c);
  void write(const IndexedValueReplacement& c);
  void write(const RouteReplacement& c);
  void write(const SceneReplacement& c);
  void write(const ProtoInsertion& c);
  void write(const ProtoDeletion& c);
  void write(const AllProtoDeletion& c);
  void write(const MultipleIndexedReplacement& c);
  void write(const MultipleFieldReplacement& c);
  void write(const GlobalQuantizer& c);
  void write(const XReplace& c);
  void write_target(nodes::NodeId node) { out_.attribute("atNode", name_of(node)); }
  void write_target(const FieldRef& target);
  void write_field_ref(const char* node, const char* field, const FieldRef& ref);
  void write_position(const Position& position);
  void write_value(const nodes::FieldDefinition& field, const nodes::FieldValue& value);
  std::string route_name(uint32_t id) const;
  void open_extended(std::string_view name, std::string_view form);
  void forget_scene();

  const nodes::FieldDefinition& definition(const FieldRef& ref) const {
    return scene_->node(ref.node).definition->field(ref.field);
  }

  /// What names and IDs a scope has so far, as the reader will see them.
  struct ScopeNames {
    std::map<std::string, uint32_t, std::less<>> node_ids;  ///< the ID of each DEF name; 0: none
    std::map<std::string, nodes::ProtoId, std::less<>> protos;
    TakenIds nodes, routes;
  };

  XmtOutput& out_;
  const nodes::Scene* scene_ = nullptr;
  NodeSet known_;  ///< written, or in the command at work
  NodeSet fresh_;  ///< in the command at work and not written yet
  std::map<nodes::NodeId, std::string> names_;
  std::map<nodes::ScopeId, ScopeNames> scopes_;
  std::map<uint32_t, std::string> route_names_;  ///< by ID
  unsigned buffer_depth_ = 0;
  uint64_t made_names_ = 0;
  /// The reader gives IDs to what stands in buffers later than to the rest: since there was such a
  /// thing, every ID is said.
  bool say_ids_ = false;
};

}  // namespace afx::bifs
