// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// A scene in memory: nodes with field values, shared by DEF/USE, ROUTEs, PROTOs.
#pragma once

#include <cassert>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "codec/error.h"
#include "nodes/field_value.h"
#include "nodes/ids.h"
#include "nodes/node_definition.h"

namespace afx::nodes {

/// A field of a node that was given a value.
struct FieldEntry {
  FieldIndex field;
  FieldValue value;
};

/// `field IS interface_field`, in the body of a PROTO.
struct IsLink {
  FieldIndex field;
  FieldIndex interface_field;
};

struct Node {
  /// What it is; for an instance of a PROTO the interface of that. Never nullptr.
  const NodeDefinition* definition = nullptr;
  ProtoId proto;                   ///< valid: an instance of this PROTO
  ScopeId scope;                   ///< whose DEF names it belongs to
  std::string name;                ///< the DEF name, unique in its scope; empty = none
  uint32_t id = 0;                 ///< the BIFS node ID; 0 = none
  std::vector<FieldEntry> values;  ///< what was given, each field once, in the order given
  std::vector<IsLink> links;
  /// A Script with fields of its own: its definition, the static fields first.
  std::unique_ptr<NodeDefinition> own_definition;
};

struct Route {
  NodeId from;
  FieldIndex from_field;
  NodeId to;
  FieldIndex to_field;
  std::string name;  ///< the DEF name; empty = none
  uint32_t id = 0;   ///< the BIFS ROUTE ID; 0 = none
};

/// A PROTO or EXTERNPROTO declaration.
struct Proto {
  NodeDefinition
      interface;  ///< its name is the PROTO's; node values in defaults are in scope `body`
  ScopeId scope;  ///< where it is declared
  ScopeId body;   ///< its nodes, ROUTEs and own PROTOs; EXTERNPROTO: empty
  bool external = false;
  std::vector<Url> urls;  ///< EXTERNPROTO: where to find the declaration
  uint32_t id = 0;        ///< the BIFS PROTO ID; 0 = none yet
};

/// The scene itself or the body of a PROTO.
struct Scope {
  ScopeId parent;               ///< not valid: the scene itself
  ProtoId proto;                ///< valid: the body of this PROTO
  std::vector<NodeId> roots;    ///< top nodes, in order
  std::vector<ProtoId> protos;  ///< declared here, in order
  std::vector<Route> routes;
  std::map<std::string, NodeId, std::less<>> names;         ///< DEF names
  std::map<std::string, ProtoId, std::less<>> proto_names;  ///< of `protos`
};

/// Owns nodes, PROTOs and scopes; they refer to each other by number. Nodes of PROTO bodies live
/// here too, so a NodeId is enough to name any node. Can be moved, not copied. Functions that take
/// an id want a valid one of this scene.
class Scene {
 public:
  static constexpr ScopeId kMain{uint32_t{0}};

  Scene();
  Scene(Scene&&) = default;
  Scene& operator=(Scene&&) = default;
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  [[nodiscard]] size_t node_count() const { return nodes_.size(); }
  [[nodiscard]] const Node& node(NodeId id) const { return nodes_[id.value]; }
  [[nodiscard]] Node& node(NodeId id) { return nodes_[id.value]; }
  [[nodiscard]] const Scope& scope(ScopeId id = kMain) const { return *scopes_[id.value]; }
  [[nodiscard]] Scope& scope(ScopeId id = kMain) { return *scopes_[id.value]; }
  [[nodiscard]] const Proto& proto(ProtoId id) const { return *protos_[id.value]; }
  [[nodiscard]] Proto& proto(ProtoId id) { return *protos_[id.value]; }
  [[nodiscard]] size_t proto_count() const { return protos_.size(); }
  [[nodiscard]] size_t scope_count() const { return scopes_.size(); }

  /// The top nodes of the scene.
  [[nodiscard]] const std::vector<NodeId>& roots() const { return scope().roots; }
  void add_root(NodeId node, ScopeId scope_id = kMain) { scope(scope_id).roots.push_back(node); }

  /// A new node, not yet standing anywhere.
  NodeId add(const NodeDefinition& definition, ScopeId scope = kMain);
  /// The same by type name. Errors: bad_argument (no such node).
  Result<NodeId> add(std::string_view type_name, ScopeId scope = kMain);
  /// A new instance of a PROTO.
  NodeId add_instance(ProtoId proto, ScopeId scope = kMain);
  /// The type's name, or the PROTO's.
  [[nodiscard]] const std::string& type_name(NodeId id) const { return node(id).definition->name; }

  /// Declares a PROTO: gives it a body scope inside `scope` and its name there. The interface may
  /// be filled afterwards. Errors: bad_argument (the name is taken in this scope).
  Result<ProtoId> add_proto(std::string name, bool external, ScopeId scope = kMain);
  /// The PROTO of that name as seen from a scope: there or in a scope around it; may be not valid.
  [[nodiscard]] ProtoId find_proto(std::string_view name, ScopeId scope = kMain) const;
  /// Sets where instances may stand, from the first node of the body. Call when the body is
  /// complete.
  void settle_data_types(ProtoId proto);

  /// Gives a node its DEF name. Errors: bad_argument (the name is taken in the node's scope).
  Status set_name(NodeId id, std::string name);
  /// The node with that DEF name; not valid if there is none.
  [[nodiscard]] NodeId find_name(std::string_view name, ScopeId scope = kMain) const;

  /// The value of a field: what was given, else the default. IS links are not followed (NodeView in
  /// node_view.h follows them).
  [[nodiscard]] const FieldValue& value(NodeId id, FieldIndex field) const;
  /// The value that was given; nullptr if none was.
  [[nodiscard]] const FieldValue* given(NodeId id, FieldIndex field) const;
  /// The value of a field by name; nullptr if the node has no such field or its type is not stored
  /// as T (see FieldValue), e.g. find<glm::vec3>(node, "position").
  template <class T>
  [[nodiscard]] const T* find(NodeId id, std::string_view field) const;
  /// The same for a field that the node certainly has.
  template <class T>
  [[nodiscard]] const T& get(NodeId id, std::string_view field) const;

  /// Gives a field its value. Errors: bad_argument (no such field, an event, another type, a node
  /// that may not stand there).
  Status set(NodeId id, std::string_view field, FieldValue value);
  /// The same without any check, for readers that have done them.
  void set_unchecked(NodeId id, FieldIndex field, FieldValue value);
  /// Adds a node to the end of a list of nodes. Errors as set().
  Status append(NodeId parent, std::string_view field, NodeId child);
  /// Whether a node may stand in a field: the NULL node always, others by node data type.
  [[nodiscard]] bool may_stand(NodeId child, const FieldDefinition& field) const;

  /// Adds fields to a Script: returns its own definition, made at the first call.
  NodeDefinition& own_definition(NodeId script);

  /// How much there is, for revert().
  struct Mark {
    size_t nodes, scopes, protos;
  };
  [[nodiscard]] Mark mark() const { return {nodes_.size(), scopes_.size(), protos_.size()}; }
  /// Takes back the nodes and PROTOs added since, with their names. Nothing that was there before
  /// may speak of them: no field, ROUTE or list of top nodes.
  void revert(const Mark& mark);

 private:
  std::vector<Node> nodes_;
  std::vector<std::unique_ptr<Scope>> scopes_;
  std::vector<std::unique_ptr<Proto>> protos_;
};

template <class T>
const T* Scene::find(NodeId id, std::string_view field) const {
  const FieldIndex index = node(id).definition->find(field);
  return index.valid() ? std::get_if<T>(&value(id, index)) : nullptr;
}

template <class T>
const T& Scene::get(NodeId id, std::string_view field) const {
  static const T kZero{};
  const T* found = find<T>(id, field);
  assert(found != nullptr);
  return found != nullptr ? *found : kZero;
}

/// Whether two scenes are the same: the same nodes with the same values (floats by their bits, a
/// field not given equals its default), shared in the same way, with the same names, ROUTEs in the
/// same order and PROTOs. How nodes are numbered, and the BIFS IDs, do not matter.
bool equal(const Scene& a, const Scene& b);

}  // namespace afx::nodes
