// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The places where nodes stand, and other nodes for them.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "nodes/scene.h"

namespace afx {

/// Calls visit(node) for each node in a field value (const or not), the NULL node too.
template <class Value, class Visit>
void for_each_node(Value& value, Visit visit) {
  if (auto* one = std::get_if<nodes::NodeId>(&value)) visit(*one);
  if (auto* many = std::get_if<std::vector<nodes::NodeId>>(&value)) {
    for (auto& node : *many) visit(node);
  }
}

/// Which nodes stand in a scene or in PROTOs, below their top nodes and `root` (may be NULL), by
/// number. The others are what commands have replaced or deleted.
std::vector<bool> standing_nodes(const nodes::Scene& scene, nodes::NodeId root = {});

/// In how many places of fields and among top nodes each node stands, by number. The defaults in
/// the interfaces of PROTOs do not count.
std::vector<uint32_t> count_places(const nodes::Scene& scene);

/// Which node is to stand in the places of which.
using NodeExchange = std::map<nodes::NodeId, nodes::NodeId>;

/// What is to stand where `node` stands.
nodes::NodeId exchanged(const NodeExchange& exchange, nodes::NodeId node);

/// Exchanges nodes in all their places (as count_places has them).
void exchange_nodes(nodes::Scene& scene, const NodeExchange& exchange);

}  // namespace afx
