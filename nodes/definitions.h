// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "codec/error.h"
#include "nodes/definition_texts.h"
#include "nodes/node_definition.h"

namespace afx::nodes {

/// Every public MPEG-4 node of BIFS versions 1 to 9, and the node data types.
class Definitions {
 public:
  /// The node of that name; nullptr if there is none. The pointer stays valid.
  [[nodiscard]] const NodeDefinition* find(std::string_view name) const;
  /// All nodes: by version, in a version in the order of the code tables.
  [[nodiscard]] const std::deque<NodeDefinition>& nodes() const { return nodes_; }

  /// The names of the node data types; position = number.
  [[nodiscard]] const std::vector<std::string>& data_types() const { return data_types_; }
  [[nodiscard]] std::string_view data_type_name(NodeDataType type) const {
    return data_types_[type.number];
  }
  [[nodiscard]] std::optional<NodeDataType> find_data_type(std::string_view name) const;

  /// The same, giving the name the next number if it is new; none if there are 64 already.
  std::optional<NodeDataType> intern_data_type(std::string_view name);
  /// Adds a node. False if the name is taken.
  bool add(NodeDefinition node);

 private:
  std::deque<NodeDefinition> nodes_;
  std::map<std::string, const NodeDefinition*, std::less<>> by_name_;
  std::vector<std::string> data_types_{"SFWorldNode"};
};

/// Reads definition files: `NODE Name { NDT types flags } [ interface ]`, the interface as in a
/// PROTO. Version = the number in the file's name. Errors: malformed, with place and excerpt.
Result<Definitions> read_definitions(std::span<const DefinitionText> texts);

/// The definitions that are compiled in, read when first asked for (about a millisecond). Safe to
/// call from any thread.
const Definitions& definitions();

}  // namespace afx::nodes
