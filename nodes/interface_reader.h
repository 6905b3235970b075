// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The interface declarations of PROTOs, EXTERNPROTOs, Scripts and of the node definitions.
#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include "nodes/node_definition.h"
#include "nodes/text_cursor.h"
#include "nodes/value_reader.h"

namespace afx::nodes {

/// What those who declare differ in.
struct InterfaceRules {
  /// Reads the value of a node field: they need to know the scene.
  std::function<FieldValue(const FieldDefinition&)> read_nodes;
  /// The node data type of that name; empty where only SFNode and MFNode may be written.
  std::function<std::optional<NodeDataType>(std::string_view)> data_type;
  /// Whether field and exposedField must have a value (EXTERNPROTO: need not).
  bool values_required = true;
};

class InterfaceReader {
 public:
  InterfaceReader(TextCursor& in, ValueReader& values, const InterfaceRules& rules)
      : in_(in), values_(values), rules_(rules) {}

  /// `[ declarations ]`, added to `out`.
  void read_interface(NodeDefinition& out);
  /// `exposedField SFColor tint`, without value; fails if no event kind stands here.
  FieldDefinition read_head();
  /// The value of a field and then `{ QP 4 nbBits 5 b { 0 1 } }`, where they stand.
  void read_value_and_coding(FieldDefinition& field);

 private:
  void read_type(FieldDefinition& field);
  [[nodiscard]] bool value_follows(FieldType type);
  void read_coding(FieldDefinition& field);
  void read_bounds(FieldDefinition& field);
  uint8_t read_number(int32_t largest, std::string_view what);

  TextCursor& in_;
  ValueReader& values_;
  const InterfaceRules& rules_;
};

}  // namespace afx::nodes
