// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The commands of BIFS in memory. They name nodes, fields and PROTOs of a nodes::Scene; nodes that
// a command brings along stand in that scene already, unconnected until the command is applied
// (bifs/apply.h).
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "nodes/scene.h"

namespace afx::bifs {

/// Where in a list. The three forms are coded differently: index 0 is not the same bits as first.
struct Position {
  enum class Kind : uint8_t { index, first, last };
  Kind kind = Kind::index;
  uint32_t index = 0;  ///< kind == index
};

/// A field of a node.
struct FieldRef {
  nodes::NodeId node;
  nodes::FieldIndex field;
};

/// One element of a list, by its index.
struct IndexedValue {
  uint32_t index = 0;
  nodes::FieldValue value;  ///< of the element type
};

/// Into the first list of nodes of a grouping node (`children`).
struct NodeInsertion {
  nodes::NodeId target;
  Position position;  ///< an index is 0..255
  nodes::NodeId node;
};
struct IndexedValueInsertion {
  FieldRef target;
  Position position;  ///< an index is 0..65535
  nodes::FieldValue value;
};
struct RouteInsertion {
  nodes::Route route;
};
struct NodeDeletion {
  nodes::NodeId target;
  bool extended = false;  ///< the extended form, that takes what refers to the node along
};
struct IndexedValueDeletion {
  FieldRef target;
  Position position;
};
struct RouteDeletion {
  uint32_t route_id = 0;
};
/// By the NULL node: removes it.
struct NodeReplacement {
  nodes::NodeId target;
  nodes::NodeId node;
};
struct FieldReplacement {
  FieldRef target;
  nodes::FieldValue value;
};
struct IndexedValueReplacement {
  FieldRef target;
  Position position;
  nodes::FieldValue value;
};
/// The ROUTE with that ID gets other ends.
struct RouteReplacement {
  uint32_t route_id = 0;
  FieldRef from;
  FieldRef to;
};
/// Everything before is dropped: nodes, IDs, PROTOs, ROUTEs and the global quantizer.
struct SceneReplacement {
  bool use_names = false;  ///< names are coded, here and later
  std::vector<nodes::ProtoId> protos;
  nodes::NodeId root;  ///< NULL: a library of PROTOs
  std::vector<nodes::Route> routes;
};
struct ProtoInsertion {
  std::vector<nodes::ProtoId> protos;
};
struct ProtoDeletion {
  std::vector<uint32_t> proto_ids;
};
struct AllProtoDeletion {};
struct MultipleIndexedReplacement {
  FieldRef target;
  std::vector<IndexedValue> values;
};
struct MultipleFieldReplacement {
  nodes::NodeId target;
  std::vector<nodes::FieldEntry> values;
};
/// By the NULL node: no quantizer.
struct GlobalQuantizer {
  nodes::NodeId node;
};
/// A replacement of a field, an element or a field of a node in a list, by a value or by that of
/// another field.
struct XReplace {
  FieldRef target;
  std::optional<Position> position;    ///< element of a list
  std::optional<FieldRef> index_from;  ///< or its index is the value of this field
  /// A field of the node that is the element: that node as the command was coded for it.
  std::optional<FieldRef> child_field;
  std::optional<FieldRef> value_from;  ///< the value, if it is another field's
  nodes::FieldValue value = false;     ///< else; of the element type for an element
};

using Command =
    std::variant<NodeInsertion, IndexedValueInsertion, RouteInsertion, NodeDeletion,
                 IndexedValueDeletion, RouteDeletion, NodeReplacement, FieldReplacement,
                 IndexedValueReplacement, RouteReplacement, SceneReplacement, ProtoInsertion,
                 ProtoDeletion, AllProtoDeletion, MultipleIndexedReplacement,
                 MultipleFieldReplacement, GlobalQuantizer, XReplace>;

/// The name of a command as messages and the JSON form have it, e.g. "FieldReplacement".
std::string_view command_name(const Command& command);

/// What a command buffer (SFCommandBuffer) holds after decoding.
struct BufferedCommands final : nodes::CommandBufferContent {
  std::vector<Command> commands;
};

/// Command buffers stand at most this deep in each other.
inline constexpr uint32_t kMaxBufferDepth = 16;

/// The element that an XReplace of a list of nodes speaks of, given that list: not valid if it is
/// not there, or its index comes from a field of another type.
nodes::NodeId xreplace_element(const nodes::Scene& scene, const XReplace& command,
                               const std::vector<nodes::NodeId>& list);

}  // namespace afx::bifs
