// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/node_walk.h"

#include <vector>

namespace afx::bifs {

namespace {

using nodes::FieldValue;
using nodes::NodeId;
using nodes::ProtoId;

class NewNodes {
 public:
  NewNodes(const nodes::Scene& scene, NodeSet& known) : scene_(scene), known_(known) {}

  void operator()(const NodeInsertion& c) { add(c.node); }
  void operator()(const IndexedValueInsertion& c) { add(c.value); }
  void operator()(const NodeReplacement& c) { add(c.node); }
  void operator()(const FieldReplacement& c) { add(c.value); }
  void operator()(const IndexedValueReplacement& c) { add(c.value); }
  void operator()(const SceneReplacement& c) {
    for (const ProtoId proto : c.protos) add(proto);
    add(c.root);
  }
  void operator()(const ProtoInsertion& c) {
    for (const ProtoId proto : c.protos) add(proto);
  }
  void operator()(const MultipleIndexedReplacement& c) {
    for (const IndexedValue& value : c.values) add(value.value);
  }
  void operator()(const MultipleFieldReplacement& c) {
    for (const nodes::FieldEntry& entry : c.values) add(entry.value);
  }
  void operator()(const GlobalQuantizer& c) { add(c.node); }
  void operator()(const XReplace& c) { add(c.value); }
  template <class Other>
  void operator()(const Other&) {}

  NodeSet finish() {
    while (!open_.empty()) {
      const NodeId node = open_.back();
      open_.pop_back();
      for (const nodes::FieldEntry& entry : scene_.node(node).values) add(entry.value);
    }
    return std::move(found_);
  }

 private:
  void add(NodeId node) {
    if (!node.valid() || !known_.insert(node.value).second) return;
    found_.insert(node.value);
    open_.push_back(node);
  }
  void add(const FieldValue& value) {
    if (const auto* one = std::get_if<NodeId>(&value)) add(*one);
    if (const auto* many = std::get_if<std::vector<NodeId>>(&value))
      for (const NodeId node : *many) add(node);
  }
  void add(ProtoId id) {
    const nodes::Proto& proto = scene_.proto(id);
    for (const nodes::FieldDefinition& field : proto.interface.fields()) add(field.default_value);
    const nodes::Scope& body = scene_.scope(proto.body);
    for (const ProtoId inner : body.protos) add(inner);
    for (const NodeId root : body.roots) add(root);
  }

  const nodes::Scene& scene_;
  NodeSet& known_;
  NodeSet found_;
  std::vector<NodeId> open_;
};

}  // namespace

NodeSet new_nodes(const nodes::Scene& scene, const Command& command, NodeSet& known) {
  NewNodes walk(scene, known);
  std::visit([&](const auto& c) { walk(c); }, command);
  return walk.finish();
}

}  // namespace afx::bifs
