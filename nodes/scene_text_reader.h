// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The inside of scene_reader.h: the grammar of scene text, a function for each rule.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "codec/diagnostics.h"
#include "codec/limits.h"
#include "nodes/interface_reader.h"
#include "nodes/scene.h"
#include "nodes/scene_reader.h"
#include "nodes/text_cursor.h"
#include "nodes/value_reader.h"

namespace afx::nodes {

/// The fields of one node that have been read, to find one that comes twice. Few are searched, many
/// looked up.
class SeenFields {
 public:
  /// Notes a field; false if it has been noted before.
  bool note(FieldIndex field);

 private:
  std::vector<FieldIndex> few_;
  std::set<FieldIndex> many_;
};

/// Reads a scene; the reader of BT's commands and descriptors (bifs/bt_text_reader.h) derives from
/// it.
class SceneTextReader {
 public:
  SceneTextReader(std::string_view text, const Limits& limits, Diagnostics& diagnostics,
                  const SceneReadOptions& options);
  SceneTextReader(const SceneTextReader&) = delete;
  SceneTextReader& operator=(const SceneTextReader&) = delete;
  virtual ~SceneTextReader() = default;
  Result<Scene> read();

 protected:
  /// What stands in the braces of a command buffer.
  virtual CommandBuffer read_command_buffer(ScopeId scope);

  // scene_reader.cpp: statements and nodes
  void read_header();
  void read_statement(ScopeId scope);
  bool read_declaration(ScopeId scope);
  NodeId read_node(ScopeId scope);
  NodeId read_node_or_null(ScopeId scope);
  NodeId read_use(ScopeId scope);
  NodeId find_named(std::string_view name, size_t begin, ScopeId scope);
  std::string_view read_def_name(std::string_view of);
  NodeId read_new_node(ScopeId scope, std::string_view def_name);
  NodeId make_node(std::string_view type, size_t begin, ScopeId scope);
  void give_name(NodeId id, std::string_view name, size_t begin);
  void read_body(NodeId id);
  void read_field(NodeId id, SeenFields& seen);
  void read_own_field(NodeId script);
  void read_field_value(NodeId id, FieldIndex field);
  FieldValue read_value(const FieldDefinition& field, ScopeId scope);
  FieldValue read_nodes(const FieldDefinition& field, ScopeId scope);
  NodeId read_child(const FieldDefinition& field, ScopeId scope);
  FieldIndex find_field(const NodeDefinition& definition, std::string_view name, size_t begin);

  // scene_reader_proto.cpp: PROTO, IS and ROUTE
  void read_proto(ScopeId scope);
  void read_extern_proto(ScopeId scope);
  ProtoId declare_proto(ScopeId scope, bool external);
  void read_proto_body(ProtoId proto);
  void read_is(NodeId id, FieldIndex field);
  void check_is(const FieldDefinition& field, const FieldDefinition& interface_field, size_t begin);
  void read_route(ScopeId scope, std::string_view name);
  FieldIndex read_route_end(ScopeId scope, bool source, NodeId& node);

  /// Counts nesting; fails beyond limits.scene_depth.
  class Depth {
   public:
    explicit Depth(SceneTextReader& reader);
    ~Depth() { --reader_.depth_; }
    Depth(const Depth&) = delete;
    Depth& operator=(const Depth&) = delete;

   private:
    SceneTextReader& reader_;
  };

  const Limits& limits_;
  TextCursor in_;
  ValueReader values_;
  Scene scene_;
  bool like_gpac_;
  uint32_t depth_ = 0;
  std::vector<uint8_t> open_nodes_;              ///< by node number: its `}` has not been read yet
  std::set<ProtoId> open_protos_;                ///< likewise
  std::map<std::string, uint32_t> name_copies_;  ///< of DEF names given twice: copies so far
  /// PROTOs of outer scopes that a scope has used by that name already.
  std::set<std::pair<ScopeId, std::string>> outer_uses_;
};

}  // namespace afx::nodes
