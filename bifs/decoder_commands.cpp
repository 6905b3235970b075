// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Source: ISO/IEC 14496-11, BIFS commands (clauses not checked); spec/bifs.md 3 to 5 and 11.
#include <utility>

#include "bifs/command_codes.h"
#include "bifs/decoder_frame.h"
#include "bifs/node_codes.h"
#include "bifs/top_node.h"

namespace afx::bifs {

using nodes::FieldDefinition;
using nodes::FieldIndex;
using nodes::FieldType;
using nodes::FieldValue;
using nodes::IndexMode;
using nodes::NodeDefinition;
using nodes::NodeId;
using nodes::Route;

std::optional<Command> FrameDecoder::read_command() {
  switch (u(2, "commandType")) {
    case kInsertionCommand:
      return read_insertion();
    case kDeletionCommand:
      return read_deletion();
    case kReplacementCommand:
      return read_replacement();
    default:
      return read_scene_replacement();
  }
}

Command FrameDecoder::read_insertion() {
  switch (u(2, "insertionType")) {
    case kNodeSubtype: {
      const Part part(*this, "NodeInsertion");
      NodeInsertion command;
      command.target = read_node_id();
      if (!ok()) return command;
      const NodeDefinition& definition = *state_.scene.node(command.target).definition;
      const auto type = definition.insertion_type();
      if (!type) return fail(Errc::malformed, "a " + definition.name + " has no children"), command;
      command.position = read_position(kNodePositionBits);
      command.node = read_node(*type);
      return command;
    }
    case kExtendedSubtype:
      return read_extended_update();
    case kValueSubtype: {
      const Part part(*this, "IndexedValueInsertion");
      IndexedValueInsertion command;
      command.target = read_list_target();
      command.position = read_position(kValuePositionBits);
      command.value = read_target_value(command.target, true);
      return command;
    }
    default: {
      const Part part(*this, "ROUTEInsertion");
      return RouteInsertion{read_route()};
    }
  }
}

Command FrameDecoder::read_deletion() {
  switch (u(2, "deletionType")) {
    case kNodeSubtype: {
      const Part part(*this, "NodeDeletion");
      return NodeDeletion{read_node_id(), false};
    }
    case kValueSubtype: {
      const Part part(*this, "IndexedValueDeletion");
      IndexedValueDeletion command;
      command.target = read_list_target();
      command.position = read_position(kValuePositionBits);
      return command;
    }
    case kRouteSubtype: {
      const Part part(*this, "ROUTEDeletion");
      return RouteDeletion{read_route_id()};
    }
    default:
      fail(Errc::malformed, "deletion command of type 1, which is reserved");
      return NodeDeletion{};
  }
}

Command FrameDecoder::read_replacement() {
  switch (u(2, "replacementType")) {
    case kNodeSubtype: {
      const Part part(*this, "NodeReplacement");
      NodeReplacement command;
      command.target = read_node_id();
      command.node = read_node(nodes::kWorldNode);
      return command;
    }
    case kFieldSubtype: {
      const Part part(*this, "FieldReplacement");
      FieldReplacement command;
      command.target = read_target(IndexMode::in);
      command.value = read_target_value(command.target, false);
      return command;
    }
    case kValueSubtype: {
      const Part part(*this, "IndexedValueReplacement");
      IndexedValueReplacement command;
      command.target = read_list_target();
      command.position = read_position(kValuePositionBits);
      command.value = read_target_value(command.target, true);
      return command;
    }
    default: {
      const Part part(*this, "ROUTEReplacement");
      RouteReplacement command;
      command.route_id = read_route_id();
      Route ends;
      read_route_ends(ends);
      command.from = {ends.from, ends.from_field};
      command.to = {ends.to, ends.to_field};
      return command;
    }
  }
}

Command FrameDecoder::read_scene_replacement() {
  const Part part(*this, "SceneReplacement");
  SceneReplacement command;
  if (buffer_depth_ > 0)
    return fail(Errc::unsupported, "a scene replacement in a command buffer"), command;
  if (u(6, "reserved") != 0) warn("reserved_bits", "reserved bits that are not 0");
  state_.use_names = u(1, "USENAMES") != 0;
  command.use_names = state_.use_names;
  forget_scene();
  command.protos = read_protos();
  command.root = read_node(top_node_type());
  if (u(1, "hasROUTEs") != 0) command.routes = read_routes();
  return command;
}

/// IDs, names and the global quantizer mean the new scene from here on. The nodes stay in memory:
/// commands that were decoded before speak of them.
void FrameDecoder::forget_scene() {
  if (!ok()) return;
  state_.ids.clear();
  state_.first_lists.clear();
  state_.global_quantizer.reset();
  quantizer_ = nullptr;
  nodes::Scope& scope = state_.scene.scope();
  scope.names.clear();
  scope.proto_names.clear();
  scope.protos.clear();
}

Command FrameDecoder::read_extended_update() {
  const uint32_t type = u(8, "extendedUpdateType");
  switch (type) {
    case kProtoListInsertion: {
      const Part part(*this, "PROTOListInsertion");
      return ProtoInsertion{read_protos()};
    }
    case kProtoListDeletion:
      return read_proto_deletion();
    case kAllProtoDeletion:
      if (buffer_depth_ == 0) ids().protos.clear();
      return AllProtoDeletion{};
    case kMultipleIndexedReplacement:
      return read_multiple_indexed();
    case kMultipleFieldReplacement:
      return read_multiple_fields();
    case kGlobalQuantizer:
      return read_global_quantizer();
    case kNodeDeletionEx: {
      const Part part(*this, "NodeDeletionEx");
      return NodeDeletion{read_node_id(), true};
    }
    case kXReplace:
      return read_xreplace();
    default:
      fail(Errc::unsupported,
           "extended update of type " + std::to_string(type) + " [expected 0 to 7]");
      return AllProtoDeletion{};
  }
}

Command FrameDecoder::read_proto_deletion() {
  const Part part(*this, "PROTODeletion");
  ProtoDeletion command;
  const auto read_id = [&] {
    if (take(1, sizeof(uint32_t)))
      command.proto_ids.push_back(u(state_.config.proto_id_bits, "protoID"));
  };
  if (u(1, "isList") != 0) {
    while (u(1, "moreProtos") != 0 && ok()) read_id();
  } else {
    const uint32_t count = u(u(5, "nbBits"), "count");
    for (uint32_t i = 0; i < count && ok(); ++i) read_id();
  }
  if (buffer_depth_ == 0)
    for (const uint32_t id : command.proto_ids) ids().protos.erase(id);
  return command;
}

Command FrameDecoder::read_multiple_indexed() {
  const Part part(*this, "MultipleIndexedReplacement");
  MultipleIndexedReplacement command;
  command.target = read_list_target();
  const unsigned position_bits = u(5, "posBits");
  const uint32_t count = u(u(5, "countBits"), "count");
  for (uint32_t i = 0; i < count && take(1, sizeof(IndexedValue)); ++i) {
    IndexedValue value;
    value.index = u(position_bits, "position");
    value.value = read_target_value(command.target, true);
    command.values.push_back(std::move(value));
  }
  return command;
}

Command FrameDecoder::read_multiple_fields() {
  const Part part(*this, "MultipleFieldReplacement");
  MultipleFieldReplacement command;
  command.target = read_node_id();
  if (!ok()) return command;
  const NodeDefinition& layout = node_layout(*state_.scene.node(command.target).definition);
  read_fields(layout, {{}, &command.values}, false);
  return command;
}

Command FrameDecoder::read_global_quantizer() {
  const Part part(*this, "GlobalQuantizer");
  GlobalQuantizer command{read_node(nodes::kWorldNode)};
  if (!ok()) return command;
  if (command.node.valid() && !is_quantizer(state_.scene, command.node))
    return fail(Errc::malformed, "a " + state_.scene.type_name(command.node) +
                                     " [expected a QuantizationParameter or NULL]"),
           command;
  frame_quantizer_.reset();
  if (command.node.valid()) frame_quantizer_ = Quantizer::from_node(state_.scene, command.node);
  if (buffer_depth_ == 0) state_.global_quantizer = frame_quantizer_;
  quantizer_ = frame_quantizer_ ? &*frame_quantizer_ : nullptr;
  return command;
}

Command FrameDecoder::read_xreplace() {
  const Part part(*this, "XReplace");
  XReplace command;
  command.target = read_target(IndexMode::in);
  if (!ok()) return command;
  const NodeDefinition* holder = state_.scene.node(command.target.node).definition;
  const FieldDefinition& field = holder->field(command.target.field);
  if (is_multiple(field.type)) read_xreplace_place(command, field);
  if (!ok()) return command;
  if (u(1, "valueFromNode") != 0) {
    command.value_from = read_target(IndexMode::def);
    return command;
  }
  if (!command.child_field) {
    const bool element = command.position.has_value() || command.index_from.has_value();
    command.value = read_target_value(command.target, element);
    return command;
  }
  const NodeDefinition& child = *state_.scene.node(command.child_field->node).definition;
  const FieldDefinition& child_field = child.field(command.child_field->field);
  const auto& before = state_.scene.node(command.child_field->node).values;
  command.value = read_value(child_field, coding_of(child_field, child, before));
  return command;
}

void FrameDecoder::read_xreplace_place(XReplace& command, const FieldDefinition& field) {
  if (u(1, "isIndexed") == 0) return;
  if (u(1, "dynamicIndex") != 0) {
    command.index_from = read_target(IndexMode::def);
  } else {
    command.position = read_position(kValuePositionBits);
  }
  if (field.type != FieldType::mf_node || u(1, "hasChildField") == 0 || !ok()) return;
  const FieldRef& target = command.target;
  const auto* list =
      std::get_if<std::vector<NodeId>>(&state_.scene.value(target.node, target.field));
  const uint64_t begin = in_->bit();
  if (read_child_field(command, list)) return;
  // The peer codes for the node that stood there before any command (vector 25).
  const auto first = state_.first_lists.find({target.node, target.field});
  in_->seek(begin);
  if (first == state_.first_lists.end() || !read_child_field(command, &first->second))
    return fail(Errc::malformed, "a field of a node that is not in the list, or has no such field");
  warn("xreplace_child", "the field is not of the node that is there now, but of the one before");
}

/// Reads the number of the field of the node in a list; false, and no error, if there is none.
bool FrameDecoder::read_child_field(XReplace& command, const std::vector<NodeId>* list) {
  const NodeId child = list != nullptr ? xreplace_element(state_.scene, command, *list) : NodeId{};
  if (!child.valid()) return false;
  const NodeDefinition& definition = *state_.scene.node(child).definition;
  const uint32_t count = field_count(definition, IndexMode::in);
  const uint32_t index = count > 0 ? u(field_index_bits(definition, IndexMode::in), "fieldRef") : 0;
  if (index >= count) return false;
  command.child_field = FieldRef{child, definition.fields_in(IndexMode::in)[index]};
  return ok();
}

/// Remembers the lists of nodes that a command is about to change for the first time.
void FrameDecoder::keep_first_lists(const Command& command) {
  const auto keep = [&](const FieldRef& target) {
    const auto* list =
        std::get_if<std::vector<NodeId>>(&state_.scene.value(target.node, target.field));
    if (list == nullptr || state_.first_lists.contains({target.node, target.field})) return;
    if (take(list->size(), sizeof(NodeId))) state_.first_lists[{target.node, target.field}] = *list;
  };
  if (const auto* c = std::get_if<FieldReplacement>(&command)) keep(c->target);
  if (const auto* c = std::get_if<IndexedValueReplacement>(&command)) keep(c->target);
  if (const auto* c = std::get_if<MultipleIndexedReplacement>(&command)) keep(c->target);
  if (const auto* c = std::get_if<MultipleFieldReplacement>(&command))
    for (const nodes::FieldEntry& entry : c->values) keep({c->target, entry.field});
}

/// The node that a command is about.
NodeId FrameDecoder::read_node_id() {
  const uint32_t id = u(state_.config.node_id_bits, "nodeID") + 1;
  if (!ok()) return {};
  const auto& known = ids().nodes;
  const auto found = known.find(id);
  if (found != known.end()) return found->second;
  fail(Errc::malformed, "no node has the ID " + std::to_string(id));
  return {};
}

uint32_t FrameDecoder::read_route_id() { return u(state_.config.route_id_bits, "routeID") + 1; }

FieldIndex FrameDecoder::read_field_ref(NodeId node, IndexMode mode) {
  if (!ok()) return {};
  const NodeDefinition& definition = *state_.scene.node(node).definition;
  const uint32_t count = field_count(definition, mode);
  const uint32_t index = count > 0 ? u(field_index_bits(definition, mode), "fieldRef") : 0;
  if (!ok()) return {};
  if (index < count) return definition.fields_in(mode)[index];
  fail(Errc::malformed, "field " + std::to_string(index) + " of a " + definition.name +
                            ", which has " + std::to_string(count) + " of that kind");
  return {};
}

FieldRef FrameDecoder::read_target(IndexMode mode) {
  FieldRef target;
  target.node = read_node_id();
  target.field = read_field_ref(target.node, mode);
  return target;
}

FieldRef FrameDecoder::read_list_target() {
  const FieldRef target = read_target(IndexMode::in);
  if (!ok()) return target;
  const NodeDefinition& definition = *state_.scene.node(target.node).definition;
  const FieldDefinition& field = definition.field(target.field);
  if (!is_multiple(field.type))
    fail(Errc::malformed, definition.name + "." + field.name + " is no list [expected one]");
  return target;
}

Position FrameDecoder::read_position(unsigned bits) {
  switch (u(2, "position")) {
    case kPositionIndex:
      return {Position::Kind::index, u(bits, "index")};
    case kPositionFirst:
      return {Position::Kind::first, 0};
    case kPositionLast:
      return {Position::Kind::last, 0};
    default:
      fail(Errc::malformed, "position of kind 1, which is reserved");
      return {};
  }
}

FieldValue FrameDecoder::read_target_value(const FieldRef& target, bool element) {
  if (!ok()) return false;
  const NodeDefinition& definition = *state_.scene.node(target.node).definition;
  const FieldDefinition& field = definition.field(target.field);
  const Part part(*this, field.name);
  const ElementCoding coding = coding_of(field, definition, state_.scene.node(target.node).values);
  return element ? read_element(field, coding) : read_value(field, coding);
}

std::vector<Route> FrameDecoder::read_routes() {
  const Part part(*this, "ROUTEs");
  std::vector<Route> routes;
  const auto add = [&] {
    if (take(1, sizeof(Route))) routes.push_back(read_route());
  };
  if (u(1, "isList") != 0) {
    do {
      add();
    } while (ok() && u(1, "moreROUTEs") != 0);
  } else {
    const uint32_t count = u(u(5, "nbBits"), "count");
    for (uint32_t i = 0; i < count && ok(); ++i) add();
  }
  return routes;
}

Route FrameDecoder::read_route() {
  Route route;
  if (u(1, "isDEFed") != 0) {
    route.id = read_route_id();
    if (state_.use_names) route.name = read_name("routeName");
  }
  read_route_ends(route);
  return route;
}

void FrameDecoder::read_route_ends(Route& route) {
  const FieldRef from = read_target(IndexMode::out);
  const FieldRef to = read_target(IndexMode::in);
  route.from = from.node;
  route.from_field = from.field;
  route.to = to.node;
  route.to_field = to.field;
}

}  // namespace afx::bifs
