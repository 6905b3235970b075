// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The BIFS IDs of what a text names. Text (BT, XMT-A) has names where streams have numbers; GPAC
// writes the node of ID k + 1 as N<k>, the ROUTE likewise as R<k>.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "nodes/scene.h"

namespace afx::bifs {

/// The ID that a name stands for: letter, then k in decimal without leading zeros gives k + 1. None
/// for other names and for IDs that no stream can hold (2^31 and more).
std::optional<uint32_t> id_of_name(char letter, std::string_view name);

/// The ID of a PROTO that a stream had no name for: Proto<k> is k. None for other names, and for 0.
std::optional<uint32_t> id_of_proto_name(std::string_view name);

/// IDs of one kind that are taken in one scope.
class TakenIds {
 public:
  void take(uint32_t id) { taken_.insert(id); }
  /// The wanted ID if it is free, otherwise the smallest free one, from 1. Takes nothing.
  uint32_t next(std::optional<uint32_t> wanted);
  /// Takes that.
  uint32_t take_new(std::optional<uint32_t> wanted);

 private:
  std::set<uint32_t> taken_;
  uint32_t next_ = 1;  ///< all below are taken
};

/// Gives IDs to the nodes that have a DEF name and none yet, in the order of their numbers, scope
/// by scope: that of the name (N<k>) if it is free there, otherwise the smallest free one. IDs that
/// nodes have already are taken from there on.
///
/// first  the nodes before it are left alone and their IDs count as free: they belong to a scene
///        that a scene replacement dropped
void assign_node_ids(nodes::Scene& scene, nodes::NodeId first = nodes::NodeId{uint32_t{0}});

/// The IDs of PROTOs, given in the order of their declaration: no two PROTOs of a scene have the
/// same. One whose name is Proto<k> takes the ID k if it is free.
class ProtoIds {
 public:
  /// Gives IDs to those that have been declared since the last call and have none.
  void assign(nodes::Scene& scene);

 private:
  TakenIds taken_;
  uint32_t seen_ = 0;  ///< PROTOs of the scene
};

/// The IDs of ROUTEs, given as they are read: commands name a ROUTE by its ID. One for a scope.
class RouteIds {
 public:
  /// The ID of a new ROUTE with that name: that of the name (R<k>) if it is free, otherwise the
  /// smallest free one. From now on the name means this ROUTE.
  /// by_name  false: the smallest free one whatever the name, as GPAC reads
  uint32_t id_of_new(std::string_view name, bool by_name = true);
  /// The same for a ROUTE whose ID is known.
  void note(std::string_view name, uint32_t id);
  /// The ID of the ROUTE with that name; none if there is none.
  [[nodiscard]] std::optional<uint32_t> find(std::string_view name) const;
  [[nodiscard]] const std::map<std::string, uint32_t, std::less<>>& names() const { return names_; }

 private:
  TakenIds taken_;
  std::map<std::string, uint32_t, std::less<>> names_;
};

}  // namespace afx::bifs
