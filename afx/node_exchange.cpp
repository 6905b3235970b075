// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/node_exchange.h"

namespace afx {
namespace {

using nodes::FieldEntry;
using nodes::NodeId;
using nodes::Scene;
using nodes::ScopeId;

/// Calls visit(node) for each place of a scene (const or not).
template <class AnyScene, class Visit>
void for_each_place(AnyScene& scene, Visit visit) {
  for (uint32_t i = 0; i < scene.node_count(); ++i) {
    for (auto& entry : scene.node(NodeId(i)).values) for_each_node(entry.value, visit);
  }
  for (uint32_t i = 0; i < scene.scope_count(); ++i) {
    for (auto& root : scene.scope(ScopeId(i)).roots) visit(root);
  }
}

}  // namespace

std::vector<bool> standing_nodes(const Scene& scene, NodeId root) {
  std::vector<bool> standing(scene.node_count());
  std::vector<NodeId> open;
  const auto meet = [&](NodeId node) {
    if (!node.valid() || standing[node.value]) return;
    standing[node.value] = true;
    open.push_back(node);
  };
  meet(root);
  for (uint32_t i = 0; i < scene.scope_count(); ++i) {
    for (const NodeId top : scene.scope(ScopeId(i)).roots) meet(top);
  }
  for (uint32_t i = 0; i < scene.proto_count(); ++i) {
    for (const auto& field : scene.proto(nodes::ProtoId(i)).interface.fields())
      for_each_node(field.default_value, meet);
  }
  while (!open.empty()) {
    const NodeId node = open.back();
    open.pop_back();
    for (const FieldEntry& entry : scene.node(node).values) for_each_node(entry.value, meet);
  }
  return standing;
}

std::vector<uint32_t> count_places(const Scene& scene) {
  std::vector<uint32_t> places(scene.node_count());
  for_each_place(scene, [&](NodeId node) {
    if (node.valid()) ++places[node.value];
  });
  return places;
}

NodeId exchanged(const NodeExchange& exchange, NodeId node) {
  const auto found = exchange.find(node);
  return found == exchange.end() ? node : found->second;
}

void exchange_nodes(Scene& scene, const NodeExchange& exchange) {
  if (exchange.empty()) return;
  for_each_place(scene, [&](NodeId& node) { node = exchanged(exchange, node); });
}

}  // namespace afx
