// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The inside of xmt_reader.h: nodes, PROTOs, ROUTEs and the commands that hold them.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bifs/command.h"
#include "bifs/id_assignment.h"
#include "bifs/noted_lists.h"
#include "bifs/xmt_document.h"
#include "bifs/xmt_values.h"
#include "codec/limits.h"
#include "nodes/scene.h"

namespace afx::bifs {

class XmtSceneReader {
 public:
  XmtSceneReader(XmtDocument& document, nodes::Scene& scene, const Limits& limits)
      : document_(document), scene_(scene), limits_(limits), values_(document, limits) {}

  /// Reads a command of the scene stream: Insert, Replace or Delete, with its command buffers.
  std::optional<Command> read_command(pugi::xml_node element);
  /// Comes last: the nodes get their IDs.
  void finish() { assign_node_ids(scene_, first_node_); }
  [[nodiscard]] XmtValueReader& values() { return values_; }

 private:
  using Element = pugi::xml_node;

  // xmt_scene_reader.cpp: nodes and fields
  nodes::NodeId read_node(Element element);
  nodes::NodeId read_use(Element element, std::string_view attribute);
  nodes::NodeId make_node(Element element);
  nodes::NodeId make_instance(Element element);
  void read_def(Element element, nodes::NodeId node);
  void give_name(nodes::NodeId node, const std::string& name, std::string_view where);
  void read_attributes(Element element, nodes::NodeId node, std::set<nodes::FieldIndex>& seen);
  void read_children(Element element, nodes::NodeId node, std::set<nodes::FieldIndex>& seen);
  nodes::FieldIndex find_field(const nodes::NodeDefinition& definition, std::string_view name,
                               std::string_view where);
  /// A field of a node that holds a value and has none yet.
  nodes::FieldIndex new_field(nodes::NodeId node, std::string_view name, std::string_view where,
                              std::set<nodes::FieldIndex>& seen);
  void add_value(nodes::NodeId node, nodes::FieldIndex field, nodes::FieldValue value,
                 std::string_view where);
  /// Nodes, or the commands of a buffer, that stand in an element.
  nodes::FieldValue read_content(Element element, const nodes::FieldDefinition& field);
  nodes::FieldValue read_buffer(Element element);
  std::vector<nodes::NodeId> read_nodes(Element element, nodes::NodeDataType type);
  nodes::NodeId read_one_node(Element element, nodes::NodeDataType type);

  // xmt_scene_reader_proto.cpp: PROTOs, their instances, Scripts, IS and ROUTE
  nodes::ProtoId find_proto(std::string_view name, std::optional<uint64_t> id) const;
  nodes::ProtoId read_proto(Element element);
  nodes::ProtoId declare_proto(Element element);
  void read_body(Element element, nodes::ProtoId proto);
  nodes::FieldDefinition read_field_head(XmtAttributes& attributes);
  void read_interface_field(Element element, nodes::NodeDefinition& interface);
  void read_coding(Element element, nodes::FieldDefinition& field);
  /// The value of a `field` or `fieldValue`; none if none stands there.
  std::optional<nodes::FieldValue> read_field_value(Element element, XmtAttributes& attributes,
                                                    const nodes::FieldDefinition& field);
  void read_own_field(Element element, nodes::NodeId script);
  void read_instance_value(Element element, nodes::NodeId node, std::set<nodes::FieldIndex>& seen);
  void read_links(Element element, nodes::NodeId node);
  nodes::Route read_route(Element element);
  void read_route_ends(XmtAttributes& attributes, nodes::Route& route);

  // xmt_scene_reader_commands.cpp
  Command read_insertion(Element element);
  Command read_deletion(Element element);
  Command read_replacement(Element element);
  Command read_scene_replacement(Element scene);
  nodes::NodeId settled_root(nodes::NodeId root, std::string_view where);
  void forget_scene();
  Command read_extended(Element element, XmtAttributes& attributes, std::string_view kind);
  Command read_multiple_fields(Element element, XmtAttributes& attributes);
  Command read_multiple_indexed(Element element, XmtAttributes& attributes);
  Command read_proto_deletion(XmtAttributes& attributes);
  Command read_xreplace(Element element, XmtAttributes& attributes);
  nodes::NodeId read_child_type(XmtAttributes& attributes, const XReplace& command);
  void read_pending_buffers();

  nodes::NodeId read_target(XmtAttributes& attributes, const char* name = "atNode");
  FieldRef read_field_ref(XmtAttributes& attributes, const char* node, const char* field,
                          bool from = false);
  std::optional<Position> read_position(XmtAttributes& attributes);
  uint32_t read_route_id(XmtAttributes& attributes);
  nodes::FieldValue read_command_value(Element element, XmtAttributes& attributes,
                                       const nodes::FieldDefinition& field, bool one);
  const nodes::FieldDefinition& definition(const FieldRef& ref) const {
    return scene_.node(ref.node).definition->field(ref.field);
  }
  nodes::NodeId find_node(std::string_view attribute);
  /// Fails: this element does not belong here.
  void refuse(Element element, std::initializer_list<std::string_view> expected);
  bool take(std::string_view where, uint64_t bytes) { return values_.take(where, 1, bytes); }

  /// Counts nesting; fails beyond limits.scene_depth.
  class Depth {
   public:
    Depth(XmtSceneReader& reader, Element element);
    ~Depth() { --reader_.depth_; }
    Depth(const Depth&) = delete;
    Depth& operator=(const Depth&) = delete;

   private:
    XmtSceneReader& reader_;
  };

  /// Commands in a buffer are read when the command around them is known: they may speak of nodes
  /// that come later.
  struct PendingBuffer {
    Element element;
    std::shared_ptr<BufferedCommands> content;
    nodes::ScopeId scope;
    uint32_t depth;
  };

  XmtDocument& document_;
  nodes::Scene& scene_;
  const Limits& limits_;
  XmtValueReader values_;
  nodes::ScopeId scope_ = nodes::Scene::kMain;
  uint32_t depth_ = 0;
  bool in_buffer_ = false;
  nodes::NodeId first_node_{uint32_t{0}};  ///< of the scene since the last replacement
  std::set<nodes::NodeId> open_nodes_;     ///< their ends have not been read yet
  std::set<nodes::ProtoId> open_protos_;
  std::map<std::string, uint32_t> name_copies_;  ///< of DEF names given twice: copies so far
  std::map<nodes::ScopeId, RouteIds> route_ids_;
  TakenIds proto_ids_;  ///< of all scopes
  std::set<std::pair<nodes::ScopeId, uint32_t>> told_proto_ids_;
  std::deque<PendingBuffer> pending_;
  NotedLists lists_;  ///< what an XReplace of a child may mean
};

}  // namespace afx::bifs
