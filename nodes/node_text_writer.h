// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Nodes, PROTOs and ROUTEs as text. Writers of whole scenes and of commands (bifs/bt_writer.h)
// build on it; they differ in which node stands whole where, and in names.
#pragma once

#include <string>
#include <string_view>

#include "nodes/scene.h"
#include "nodes/text_out.h"

namespace afx::nodes {

/// What a writer of nodes asks.
class NodeNaming {
 public:
  virtual ~NodeNaming() = default;
  /// Whether a node stands whole here; otherwise it was written before and is USEd. Asked once for
  /// each place.
  virtual bool stands_here(NodeId id) = 0;
  /// The DEF name of a node; empty: none.
  virtual std::string_view name(NodeId id) = 0;
  /// The name of a ROUTE; empty: none.
  virtual std::string route_name(const Route& route) = 0;
  /// Whether both ends of a ROUTE have been written, so that it can be.
  virtual bool can_write(const Route& route) = 0;
};

class NodeTextWriter {
 public:
  NodeTextWriter(TextOut& out, NodeNaming& naming) : out_(out), naming_(naming) {}
  virtual ~NodeTextWriter() = default;

  /// The scene that nodes are of, from here on.
  void set_scene(const Scene& scene) { scene_ = &scene; }

  /// A node, `USE name` or NULL.
  void write_node(NodeId id);
  /// A value of a field, with what stands in front of it but a blank.
  void write_value(const FieldDefinition& field, const FieldValue& value);
  /// `PROTO name [ ... ] { ... }` on a line of its own.
  void write_proto(ProtoId id);
  /// `DEF name ROUTE a.b TO c.d` on a line of its own.
  void write_route(const Route& route);
  /// `a.b TO c.d`.
  void write_route_ends(const Route& route);
  /// PROTOs, nodes and ROUTEs of a scope.
  void write_scope(ScopeId id);

  /// Ends the line if it is not empty, and indents.
  void begin_line();
  void indent() { ++depth_; }
  void unindent() { --depth_; }
  [[nodiscard]] std::string& text() { return out_.text(); }

 protected:
  /// What stands in the braces of a command buffer.
  virtual void write_command_buffer(const CommandBuffer& buffer);
  [[nodiscard]] const Scene& scene() const { return *scene_; }

 private:
  void write_head(const FieldDefinition& field);
  void write_coding(const FieldDefinition& field);
  void write_fields(NodeId id);
  void write_own_fields(NodeId id);
  void write_is(const Node& node, const IsLink& link);
  void write_nodes(const std::vector<NodeId>& nodes);
  [[nodiscard]] std::string end_text(NodeId id, FieldIndex field);

  TextOut& out_;
  NodeNaming& naming_;
  const Scene* scene_ = nullptr;
  size_t depth_ = 0;
};

}  // namespace afx::nodes
