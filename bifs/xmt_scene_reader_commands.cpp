// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Insert, Replace and Delete of XMT-A.
#include <set>
#include <utility>

#include "bifs/top_node.h"
#include "bifs/xmt_names.h"
#include "bifs/xmt_scene_reader.h"
#include "nodes/definitions.h"
#include "nodes/nearest_name.h"
#include "nodes/text_cursor.h"

namespace afx::bifs {

using nodes::FieldDefinition;
using nodes::FieldIndex;
using nodes::FieldType;
using nodes::FieldValue;
using nodes::NodeDefinition;
using nodes::NodeId;
using nodes::quoted;

std::optional<Command> XmtSceneReader::read_command(Element element) {
  const std::string_view name = document_.name(element);
  if (!take(name, sizeof(Command))) return std::nullopt;
  std::optional<Command> command;
  if (name == "Insert") {
    command = read_insertion(element);
  } else if (name == "Replace") {
    command = read_replacement(element);
  } else if (name == "Delete") {
    command = read_deletion(element);
  } else {
    refuse(element, {"Insert", "Replace", "Delete"});
  }
  if (in_buffer_) return command;
  read_pending_buffers();
  if (document_.ok() && command) lists_.note(scene_, *command);
  return command;
}

void XmtSceneReader::read_pending_buffers() {
  const nodes::ScopeId outer = scope_;
  in_buffer_ = true;
  for (; !pending_.empty() && document_.ok(); pending_.pop_front()) {
    const PendingBuffer buffer = pending_.front();
    scope_ = buffer.scope;
    depth_ = buffer.depth;
    for (const Element child : buffer.element.children()) {
      std::optional<Command> command = read_command(child);
      if (!document_.ok()) break;
      buffer.content->commands.push_back(std::move(*command));
    }
  }
  in_buffer_ = false;
  depth_ = 0;
  scope_ = outer;
}

Command XmtSceneReader::read_insertion(Element element) {
  XmtAttributes attributes(document_, element);
  const std::string extended = attributes.text("extended");
  if (!extended.empty()) return read_extended(element, attributes, extended);
  if (!attributes.find("atNode")) {
    attributes.finish();
    const Element route = element.child("ROUTE");
    if (!route) document_.fail(attributes.where(), "an Insert without atNode or a ROUTE in it");
    return RouteInsertion{route ? read_route(route) : nodes::Route{}};
  }
  const Position position = read_position(attributes).value_or(Position{Position::Kind::last, 0});
  if (attributes.find("atField")) {
    const FieldRef target = read_field_ref(attributes, "atNode", "atField");
    if (!document_.ok()) return IndexedValueInsertion{};
    return IndexedValueInsertion{target, position,
                                 read_command_value(element, attributes, definition(target), true)};
  }
  const NodeId target = read_target(attributes);
  attributes.finish();
  if (!document_.ok()) return NodeInsertion{};
  const NodeDefinition& type = *scene_.node(target).definition;
  const auto child = type.insertion_type();
  if (!child) document_.fail(*attributes.find("atNode"), "a " + type.name + " has no children");
  if (!child) return NodeInsertion{};
  return NodeInsertion{target, position, read_one_node(element, *child)};
}

Command XmtSceneReader::read_deletion(Element element) {
  XmtAttributes attributes(document_, element);
  const std::string extended = attributes.text("extended");
  if (!extended.empty()) return read_extended(element, attributes, extended);
  if (attributes.find("atRoute")) {
    const RouteDeletion command{read_route_id(attributes)};
    attributes.finish();
    return command;
  }
  if (!attributes.find("atField")) {
    const NodeDeletion command{read_target(attributes), false};
    attributes.finish();
    return command;
  }
  const FieldRef target = read_field_ref(attributes, "atNode", "atField");
  const auto position = read_position(attributes);
  attributes.finish();
  if (document_.ok() && position && !is_multiple(definition(target).type))
    document_.fail(attributes.where(), definition(target).name + " is no list [expected one]");
  if (!document_.ok() || position)
    return IndexedValueDeletion{target, position.value_or(Position{})};
  if (definition(target).type != FieldType::sf_node)
    document_.fail(attributes.where(), "a deletion in a list without position [expected one]");
  return FieldReplacement{target, NodeId{}};
}

Command XmtSceneReader::read_replacement(Element element) {
  XmtAttributes attributes(document_, element);
  const std::string extended = attributes.text("extended");
  if (!extended.empty()) return read_extended(element, attributes, extended);
  if (const Element scene = element.child("Scene")) {
    attributes.finish();
    return read_scene_replacement(scene);
  }
  if (attributes.find("atRoute")) {
    RouteReplacement command{read_route_id(attributes), {}, {}};
    attributes.finish();
    const Element route_element = element.child("ROUTE");
    if (!route_element) document_.fail(attributes.where(), "atRoute without a ROUTE in it");
    XmtAttributes ends(document_, route_element);
    nodes::Route route;
    if (document_.ok()) read_route_ends(ends, route);
    ends.finish();
    command.from = {route.from, route.from_field};
    command.to = {route.to, route.to_field};
    return command;
  }
  if (!attributes.find("atField")) {
    NodeReplacement command{read_target(attributes), {}};
    attributes.finish();
    if (document_.ok()) command.node = read_one_node(element, nodes::kWorldNode);
    return command;
  }
  const FieldRef target = read_field_ref(attributes, "atNode", "atField");
  const auto position = read_position(attributes);
  if (!document_.ok()) return FieldReplacement{};
  FieldValue value =
      read_command_value(element, attributes, definition(target), position.has_value());
  if (position) return IndexedValueReplacement{target, *position, std::move(value)};
  return FieldReplacement{target, std::move(value)};
}

Command XmtSceneReader::read_scene_replacement(Element scene) {
  XmtAttributes attributes(document_, scene);
  SceneReplacement command;
  command.use_names = attributes.flag("USENAMES").value_or(false);
  attributes.finish();
  if (!in_buffer_) forget_scene();
  bool rooted = false;
  const auto root = [&](std::string_view where) {
    if (std::exchange(rooted, true))
      document_.fail(where, "a second node of the scene [expected one]");
  };
  for (const Element child : scene.children()) {
    if (!document_.ok()) break;
    const std::string_view name = document_.name(child);
    if (name == "ProtoDeclare") {
      command.protos.push_back(read_proto(child));
    } else if (name == "ROUTE") {
      command.routes.push_back(read_route(child));
    } else if (child.type() == pugi::node_element) {
      root(name);
      command.root = settled_root(read_node(child), name);
    } else {
      for (const std::string_view word : words_of(document_.value(child)))
        word == "NULL" ? root(word) : refuse(child, {"a node", "NULL"});
    }
  }
  return command;
}

/// The top node: a node that may not be that is put in a Group.
NodeId XmtSceneReader::settled_root(NodeId root, std::string_view where) {
  if (!document_.ok() || may_be_top_node(scene_, root)) return root;
  size_t refused = 0;
  const Result<NodeId> group = put_in_group(scene_, {&root, 1}, refused);
  if (!group.ok()) return document_.fail(where, group.error().text), root;
  document_.warn("top_nodes", where,
                 "a " + scene_.type_name(root) + " may not be the top node; it is put in a Group");
  return group.value();
}

/// Names and IDs mean the new scene from here on.
void XmtSceneReader::forget_scene() {
  finish();
  first_node_ = NodeId{scene_.node_count()};
  nodes::Scope& scope = scene_.scope();
  scope.names.clear();
  scope.proto_names.clear();
  scope.protos.clear();
  route_ids_.clear();
  proto_ids_ = {};
  told_proto_ids_.clear();
  lists_.clear();
}

Command XmtSceneReader::read_extended(Element element, XmtAttributes& attributes,
                                      std::string_view kind) {
  const std::string_view name = document_.name(element);
  if (name == "Replace") {
    if (kind == xmt_extended::kFields) return read_multiple_fields(element, attributes);
    if (kind == xmt_extended::kIndices) return read_multiple_indexed(element, attributes);
    if (kind == xmt_extended::kXReplace) return read_xreplace(element, attributes);
    if (kind == xmt_extended::kGlobalQuantizer) {
      attributes.finish();
      return GlobalQuantizer{read_one_node(element, nodes::kWorldNode)};
    }
  } else if (name == "Insert" && kind == xmt_extended::kProtos) {
    attributes.finish();
    ProtoInsertion command;
    for (const Element child : element.children()) {
      if (document_.name(child) != "ProtoDeclare") refuse(child, {"ProtoDeclare"});
      if (document_.ok()) command.protos.push_back(read_proto(child));
    }
    return command;
  } else if (name == "Delete") {
    if (kind == xmt_extended::kProtos) return read_proto_deletion(attributes);
    if (kind == xmt_extended::kAllProtos) {
      attributes.finish();
      if (!in_buffer_) scene_.scope().proto_names.clear();
      if (!in_buffer_) told_proto_ids_.clear();
      return AllProtoDeletion{};
    }
    if (kind == xmt_extended::kDeletion) {
      const NodeDeletion command{read_target(attributes), true};
      attributes.finish();
      return command;
    }
  }
  document_.fail(*attributes.find("extended"),
                 "no extended form " + quoted(kind) + " of " + std::string(name));
  return AllProtoDeletion{};
}

Command XmtSceneReader::read_multiple_fields(Element element, XmtAttributes& attributes) {
  MultipleFieldReplacement command;
  command.target = read_target(attributes);
  attributes.finish();
  for (const Element child : element.children()) {
    if (!document_.ok()) break;
    if (document_.name(child) != "repField") refuse(child, {"repField"});
    XmtAttributes field(document_, child);
    const std::string name = field.need("atField");
    if (!document_.ok()) break;
    const FieldIndex index =
        find_field(*scene_.node(command.target).definition, name, *field.find("atField"));
    if (!index.valid() || !take(field.where(), sizeof(nodes::FieldEntry))) break;
    command.values.push_back(
        {index, read_command_value(child, field, definition({command.target, index}), false)});
  }
  return command;
}

Command XmtSceneReader::read_multiple_indexed(Element element, XmtAttributes& attributes) {
  MultipleIndexedReplacement command;
  command.target = read_field_ref(attributes, "atNode", "atField");
  attributes.finish();
  for (const Element child : element.children()) {
    if (!document_.ok()) break;
    if (document_.name(child) != "repValue") refuse(child, {"repValue"});
    XmtAttributes value(document_, child);
    const auto position = value.number("position", UINT32_MAX);
    if (!position) document_.fail(value.where(), "repValue without position");
    if (!take(value.where(), sizeof(IndexedValue))) break;
    command.values.push_back({static_cast<uint32_t>(*position),
                              read_command_value(child, value, definition(command.target), true)});
  }
  return command;
}

Command XmtSceneReader::read_proto_deletion(XmtAttributes& attributes) {
  ProtoDeletion command;
  const std::string ids = attributes.need("protoID");
  attributes.finish();
  for (const std::string_view word : words_of(ids)) {
    const auto id = xmt_number(word, INT32_MAX);
    if (!id) document_.fail(*attributes.find("protoID"), quoted(word) + " [expected a number]");
    if (!id || !take(attributes.where(), sizeof(uint32_t))) break;
    command.proto_ids.push_back(static_cast<uint32_t>(*id));
    if (!in_buffer_) told_proto_ids_.erase({scope_, command.proto_ids.back()});
  }
  const std::set<uint32_t> gone(command.proto_ids.begin(), command.proto_ids.end());
  if (!in_buffer_)
    std::erase_if(scene_.scope().proto_names,
                  [&](const auto& entry) { return gone.contains(scene_.proto(entry.second).id); });
  return command;
}

Command XmtSceneReader::read_xreplace(Element element, XmtAttributes& attributes) {
  XReplace command;
  command.target = read_field_ref(attributes, "atNode", "atField");
  if (attributes.find("atIndexNode"))
    command.index_from = read_field_ref(attributes, "atIndexNode", "atIndexField", true);
  command.position = read_position(attributes);
  if (document_.ok() && attributes.find("atChildField")) {
    const NodeId child = read_child_type(attributes, command);
    if (!document_.ok()) return command;
    const FieldIndex field =
        find_field(*scene_.node(child).definition, attributes.text("atChildField"),
                   *attributes.find("atChildField"));
    command.child_field = FieldRef{child, field};
  }
  if (attributes.find("fromNode")) {
    command.value_from = read_field_ref(attributes, "fromNode", "fromField", true);
    attributes.finish();
    return command;
  }
  if (!document_.ok()) return command;
  const bool one = !command.child_field && (command.position || command.index_from);
  command.value = read_command_value(element, attributes,
                                     definition(command.child_field.value_or(command.target)), one);
  return command;
}

/// The node whose field an XReplace means: the one that stands there by now, or that the text put
/// there, if it is of the type that is told; otherwise one of that type stands for it.
NodeId XmtSceneReader::read_child_type(XmtAttributes& attributes, const XReplace& command) {
  const std::string type = attributes.text("atChildNode");
  const auto* now = lists_.list(scene_, command.target);
  const auto* first =
      std::get_if<std::vector<NodeId>>(&scene_.value(command.target.node, command.target.field));
  for (const auto* list : {now, first}) {
    const NodeId child = list != nullptr ? lists_.element(scene_, command, *list) : NodeId{};
    if (child.valid() && (type.empty() || scene_.type_name(child) == type)) return child;
  }
  const NodeDefinition* known = nodes::definitions().find(type);
  const nodes::ProtoId proto = scene_.find_proto(type, scope_);
  if (known == nullptr && !proto.valid())
    document_.fail(
        *attributes.find("atChildField"),
        "a field of a node that is not in the list [expected atChildNode with its type]");
  if (!take(attributes.where(), sizeof(nodes::Node))) return {};
  return known != nullptr ? scene_.add(*known, scope_) : scene_.add_instance(proto, scope_);
}

NodeId XmtSceneReader::read_target(XmtAttributes& attributes, const char* name) {
  const auto node = attributes.find(name);
  if (node) return find_node(*node);
  document_.fail(attributes.where(), std::string(attributes.where()) + " without " + name);
  return {};
}

FieldRef XmtSceneReader::read_field_ref(XmtAttributes& attributes, const char* node,
                                        const char* field, bool from) {
  FieldRef ref;
  ref.node = read_target(attributes, node);
  const std::string name = attributes.need(field);
  if (!document_.ok()) return ref;
  const NodeDefinition& type = *scene_.node(ref.node).definition;
  ref.field = type.find(name);
  if (!ref.field.valid()) ref.field = from ? type.find_event_out(name) : type.find_event_in(name);
  if (!ref.field.valid()) ref.field = find_field(type, name, *attributes.find(field));
  return ref;
}

std::optional<Position> XmtSceneReader::read_position(XmtAttributes& attributes) {
  const auto text = attributes.find("position");
  if (!text) return std::nullopt;
  if (*text == "BEGIN") return Position{Position::Kind::first, 0};
  if (*text == "END") return Position{Position::Kind::last, 0};
  const auto index = xmt_number(*text, UINT32_MAX);
  if (!index)
    document_.fail(*text, "position " + quoted(*text) + " [expected BEGIN, END or an index]");
  return Position{Position::Kind::index, static_cast<uint32_t>(index.value_or(0))};
}

uint32_t XmtSceneReader::read_route_id(XmtAttributes& attributes) {
  const std::string name = attributes.need("atRoute");
  auto id = route_ids_[scope_].find(name);
  // A command may name a ROUTE that was never there.
  if (!id) id = id_of_name('R', name);
  if (id) return *id;
  nodes::NearestName nearest(name);
  for (const auto& entry : route_ids_[scope_].names()) nearest.offer(entry.first);
  if (document_.ok())
    document_.fail(*attributes.find("atRoute"),
                   "no ROUTE " + quoted(name) + " before this" + nearest.hint());
  return 0;
}

/// The value of a command: an attribute, or what stands in the element. `one`: of an element.
FieldValue XmtSceneReader::read_command_value(Element element, XmtAttributes& attributes,
                                              const FieldDefinition& field, bool one) {
  FieldDefinition place = field;
  if (one && !is_multiple(field.type))
    document_.fail(attributes.where(), field.name + " is no list [expected one]");
  if (one) place.type = element_type(field.type);
  const bool content = is_node(place.type) || place.type == FieldType::sf_command_buffer;
  const auto value = content ? std::nullopt : attributes.find("value");
  attributes.finish();
  if (!document_.ok()) return false;
  if (content) return read_content(element, place);
  if (value) return values_.read(*value, place, {});
  document_.fail(attributes.where(), std::string(attributes.where()) + " without value");
  return false;
}

}  // namespace afx::bifs
