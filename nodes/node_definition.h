// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What a node (or the interface of a PROTO) has: its fields, and what BIFS needs to know of them.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nodes/field_value.h"
#include "nodes/ids.h"

namespace afx::nodes {

/// What may be done with a field. The numbers are those of BIFS.
enum class EventKind : uint8_t { field = 0, exposed_field = 1, event_in = 2, event_out = 3 };
std::string_view to_string(EventKind kind);  ///< "exposedField" and so on
std::optional<EventKind> find_event_kind(std::string_view name);

/// A class of nodes that may stand in one kind of place (SF3DNode, SFTextureNode, ...); a number
/// given by Definitions. Number 0 is SFWorldNode, which every node is.
struct NodeDataType {
  uint8_t number = 0;
  bool operator==(const NodeDataType&) const = default;
};
inline constexpr NodeDataType kWorldNode{0};

/// A set of node data types: bit n stands for number n.
using NodeDataTypes = uint64_t;
inline constexpr NodeDataTypes kAnyNode = ~NodeDataTypes{0};
constexpr bool contains(NodeDataTypes set, NodeDataType type) {
  return (set >> type.number & 1) != 0;
}

/// The range that values of a field have when they are quantized; infinities where none is stated.
/// An open end excludes the bound itself; that has no effect on the coding.
struct Bounds {
  double lower = 0, upper = 0;
  bool lower_open = false, upper_open = false;
  bool operator==(const Bounds&) const = default;
};

struct FieldDefinition {
  std::string name;
  EventKind kind = EventKind::field;
  FieldType type = FieldType::sf_bool;
  NodeDataType data_type = kWorldNode;  ///< node types: which nodes may stand here
  FieldValue default_value = false;     ///< of eventIn and eventOut: the zero value
  uint8_t quant_category = 0;           ///< 0 none, 1..15 as QuantizationParameter has them
  uint8_t quant_bits = 0;               ///< category 13: the width
  uint8_t anim_category = 0;            ///< 0 not animated
  std::optional<Bounds> bounds;         ///< none stated: treat as infinite
  bool bytes = false;  ///< SFString that holds any bytes, in text as a data URL (BitWrapper.buffer)

  /// Whether it keeps a value: field and exposedField.
  [[nodiscard]] bool has_value() const {
    return kind == EventKind::field || kind == EventKind::exposed_field;
  }
};

/// The modes in which BIFS numbers fields: every field; those with a value; those that take events;
/// those that send events; those that take events and can be animated.
enum class IndexMode : uint8_t { all, def, in, out, dyn };
inline constexpr size_t kIndexModes = 5;

/// A node type, or the interface of a PROTO. Fields are in declared order and stay there.
class NodeDefinition {
 public:
  std::string name;
  uint8_t version = 0;  ///< BIFS version 1..9; 0 for a PROTO interface
  NodeDataTypes data_types =
      0;  ///< where it may stand. PROTO: where its first node may; EXTERNPROTO: all
  bool withdrawn = false;  ///< keeps its code values, but was never published
  bool script = false;     ///< declares fields of its own in each instance (Script)

  [[nodiscard]] const std::vector<FieldDefinition>& fields() const { return fields_; }
  [[nodiscard]] const FieldDefinition& field(FieldIndex i) const { return fields_[i.value]; }
  /// The field of that name; not valid if there is none.
  [[nodiscard]] FieldIndex find(std::string_view field_name) const;
  /// The same for ROUTEs and commands, where an exposedField x answers to set_x and x_changed too.
  [[nodiscard]] FieldIndex find_event_in(std::string_view field_name) const;
  [[nodiscard]] FieldIndex find_event_out(std::string_view field_name) const;
  /// The fields of a mode, in declared order: position = index in that mode.
  [[nodiscard]] const std::vector<FieldIndex>& fields_in(IndexMode mode) const {
    return modes_[static_cast<size_t>(mode)];
  }
  /// The index of a field in a mode; none if the field is not in that mode.
  [[nodiscard]] std::optional<uint32_t> index_in(IndexMode mode, FieldIndex field) const;
  /// The node data type that node insertion into this node uses: that of its first MFNode field.
  [[nodiscard]] std::optional<NodeDataType> insertion_type() const;

  /// Adds a field behind the others. Not valid, and nothing is added, if the name is taken or there
  /// are kMaxFields already.
  FieldIndex add(FieldDefinition field);
  static constexpr size_t kMaxFields = 65535;

 private:
  [[nodiscard]] FieldIndex find_alias(std::string_view prefix, std::string_view suffix,
                                      std::string_view field_name) const;

  std::vector<FieldDefinition> fields_;
  std::map<std::string, FieldIndex, std::less<>> by_name_;
  std::array<std::vector<FieldIndex>, kIndexModes> modes_;
};

}  // namespace afx::nodes
