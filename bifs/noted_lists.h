// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "bifs/command.h"

namespace afx::bifs {

/// Lists of nodes, and the integers that may index them, as commands leave them, for who does not
/// carry the commands out: the scene given is the one that the commands are said for, with the
/// nodes as they come in their commands. What apply_command would refuse, but for nodes that would
/// stand inside themselves, changes nothing. Beyond 2^24 nodes, lists that are copied from other
/// fields are not followed.
class NotedLists {
 public:
  /// A command that comes after those noted so far.
  void note(const nodes::Scene& scene, const Command& command);
  /// The list that a field holds by now; nullptr where it is no list of nodes.
  const std::vector<nodes::NodeId>* list(const nodes::Scene& scene, const FieldRef& field);
  /// xreplace_element, with an index from a field as it is by now.
  nodes::NodeId element(const nodes::Scene& scene, XReplace command,
                        const std::vector<nodes::NodeId>& list) const;
  void clear();

 private:
  struct List {
    std::vector<nodes::NodeId> nodes;
    size_t seen = 0;  ///< of gone_
  };

  /// The integer that a field holds by now; none if it holds no index.
  std::optional<uint32_t> index(const nodes::Scene& scene, const FieldRef& field) const;
  List* find(const nodes::Scene& scene, const FieldRef& field);
  void set(const nodes::Scene& scene, const FieldRef& field, const nodes::FieldValue& value);
  void insert(const nodes::Scene& scene, const FieldRef& field, const Position& position,
              const nodes::FieldValue& value);
  /// Whether there is such an element.
  bool replace(const nodes::Scene& scene, const FieldRef& field, const Position& position,
               const nodes::FieldValue& value);
  void erase(const nodes::Scene& scene, const FieldRef& field, const Position& position);
  void note(const nodes::Scene& scene, const XReplace& command);

  using Key = std::pair<nodes::NodeId, nodes::FieldIndex>;
  std::map<Key, List> lists_;
  std::map<Key, int32_t> integers_;
  uint64_t copied_ = 0;                ///< nodes, from lists of other fields
  std::vector<NodeReplacement> gone_;  ///< by others, or NULL: from every list, in this order
};

}  // namespace afx::bifs
