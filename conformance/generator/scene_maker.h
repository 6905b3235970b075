// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The inside of random_scene.h.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bifs/command.h"
#include "conformance/generator/random_scene.h"
#include "conformance/generator/random_values.h"

namespace afx::conformance {

class SceneMaker {
 public:
  SceneMaker(Choices& choices, SceneNames names);
  bifs::Presentation make();

 private:
  using NodeId = nodes::NodeId;

  /// What stands in the scene itself or in the body of a PROTO, complete.
  struct Known {
    std::vector<NodeId> nodes;  ///< with IDs
    std::vector<nodes::ProtoId> protos;
    uint32_t node_ids = 0;  ///< the greatest that was given
    uint32_t route_ids = 0;
  };

  // random_nodes.cpp
  NodeId random_node(nodes::NodeDataType type, nodes::ScopeId scope, unsigned depth);
  NodeId new_node(nodes::NodeDataType type, nodes::ScopeId scope, unsigned depth);
  NodeId fill(NodeId node, unsigned depth);
  [[nodiscard]] bool reaches(const nodes::FieldValue& value, NodeId wanted) const;
  std::optional<NodeId> used_node(nodes::NodeDataType type, nodes::ScopeId scope);
  std::optional<NodeId> new_instance(nodes::NodeDataType type, nodes::ScopeId scope,
                                     unsigned depth);
  void give_id(NodeId node);
  void give_value(NodeId node, nodes::FieldIndex field, unsigned depth);
  nodes::FieldValue value_of(const nodes::FieldDefinition& field, nodes::FieldType type,
                             nodes::ScopeId scope, unsigned depth);
  nodes::FieldValue nodes_of(const nodes::FieldDefinition& field, nodes::ScopeId scope,
                             unsigned depth);
  nodes::CommandBuffer random_buffer(nodes::ScopeId scope);
  void declare_fields(NodeId script);
  [[nodiscard]] bool is_index(const nodes::FieldDefinition& field) const;

  // random_protos.cpp: PROTOs and ROUTEs
  nodes::ProtoId random_proto(nodes::ScopeId scope, unsigned depth);
  std::vector<nodes::ProtoId> random_protos(nodes::ScopeId scope, unsigned depth);
  void fill_body(nodes::ProtoId proto, unsigned depth);
  void link_fields(nodes::ProtoId proto, NodeId node);
  nodes::FieldDefinition interface_field(nodes::ProtoId proto, nodes::EventKind kind,
                                         nodes::FieldType type);
  void random_coding(nodes::FieldDefinition& field);
  std::optional<nodes::Route> random_route(nodes::ScopeId scope);
  std::vector<nodes::Route> random_routes(nodes::ScopeId scope);
  std::optional<bifs::FieldRef> out_of(nodes::ScopeId scope);
  std::optional<bifs::FieldRef> into(nodes::ScopeId scope, nodes::FieldType type);

  // scene_maker.cpp: the access units
  bifs::SceneReplacement new_scene();
  void add_command(std::vector<bifs::Command>& commands);
  void apply(const bifs::Command& command);

  // random_commands.cpp
  using MaybeCommand = std::optional<bifs::Command>;
  MaybeCommand random_command();
  MaybeCommand replace_field();
  MaybeCommand random_insertion();
  MaybeCommand delete_element();
  MaybeCommand replace_element();
  MaybeCommand replace_elements();
  MaybeCommand insert_route();
  MaybeCommand delete_route();
  MaybeCommand replace_route();
  MaybeCommand delete_node();
  MaybeCommand replace_node();
  MaybeCommand insert_protos();
  MaybeCommand delete_proto();
  MaybeCommand delete_protos();
  MaybeCommand multiple_fields();
  MaybeCommand global_quantizer();
  MaybeCommand random_xreplace();
  std::optional<bifs::FieldRef> random_target(bool list);
  std::optional<bifs::FieldRef> source_of(nodes::FieldType type);
  std::optional<NodeId> gone_node();
  bifs::Position random_position();
  nodes::FieldValue element_for(const bifs::FieldRef& target);
  NodeId switched_off_quantizer();

  [[nodiscard]] const nodes::FieldDefinition& field(const bifs::FieldRef& ref) const {
    return scene_.node(ref.node).definition->field(ref.field);
  }
  [[nodiscard]] const nodes::NodeDefinition& definition(NodeId node) const {
    return *scene_.node(node).definition;
  }
  [[nodiscard]] bool own_names() const { return names_ == SceneNames::own; }

  Choices& choices_;
  SceneNames names_;
  bool fits_ = true;  ///< a quantizer can be put into the presentation
  bifs::Presentation out_;
  nodes::Scene& scene_ = out_.scene;
  std::map<nodes::ScopeId, Known> known_;
  std::vector<uint32_t> route_ids_;  ///< of ROUTEs that are there
  NodeId changed_;  ///< what the command at work changes: nodes that hold it may not come into it
  uint32_t proto_ids_ = 0;
  uint32_t nodes_left_ = 0;  ///< that may be made before it ends
  /// Nodes as they come in their command, before later commands change them; by node number.
  std::map<NodeId, std::vector<nodes::FieldEntry>> created_;
};

}  // namespace afx::conformance
