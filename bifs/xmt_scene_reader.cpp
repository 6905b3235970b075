// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Nodes and their fields in XMT-A: values are attributes, nodes stand in an element for the field.
#include "bifs/xmt_scene_reader.h"

#include <utility>

#include "bifs/xmt_names.h"
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

namespace {

constexpr std::string_view kInstance = "ProtoInstance";

bool is_text(pugi::xml_node node) {
  return node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata;
}

}  // namespace

XmtSceneReader::Depth::Depth(XmtSceneReader& reader, Element element) : reader_(reader) {
  if (++reader_.depth_ > reader_.limits_.scene_depth)
    reader_.document_.fail(reader_.document_.name(element),
                           "nodes nested deeper than the limit scene_depth, " +
                               std::to_string(reader_.limits_.scene_depth),
                           Errc::limit_exceeded);
}

void XmtSceneReader::refuse(Element element, std::initializer_list<std::string_view> expected) {
  const std::string_view name =
      is_text(element) ? document_.value(element) : document_.name(element);
  nodes::NearestName nearest(name);
  std::string list;
  for (const std::string_view known : expected) {
    nearest.offer(known);
    list += (list.empty() ? "" : ", ") + std::string(known);
  }
  document_.fail(name, "found " + quoted(name) + nearest.hint() + " [expected " + list + "]");
}

NodeId XmtSceneReader::read_node(Element element) {
  const Depth depth(*this, element);
  if (!document_.ok()) return {};
  if (const auto use = element.attribute(kXmtUse)) return read_use(element, document_.value(use));
  const NodeId node =
      document_.name(element) == kInstance ? make_instance(element) : make_node(element);
  if (!document_.ok()) return {};
  open_nodes_.insert(node);
  read_def(element, node);
  std::set<FieldIndex> seen;
  read_attributes(element, node, seen);
  read_children(element, node, seen);
  open_nodes_.erase(node);
  return node;
}

NodeId XmtSceneReader::find_node(std::string_view attribute) {
  const std::string name = document_.decode(attribute);
  const NodeId node = scene_.find_name(name, scope_);
  if (node.valid()) return node;
  nodes::NearestName nearest(name);
  for (const auto& entry : scene_.scope(scope_).names) nearest.offer(entry.first);
  document_.fail(attribute, "no node " + quoted(name) + " before this" + nearest.hint() +
                                " [expected a name that DEF gave]");
  return {};
}

NodeId XmtSceneReader::read_use(Element element, std::string_view attribute) {
  const NodeId node = find_node(attribute);
  if (!document_.ok()) return {};
  const bool instance = document_.name(element) == kInstance;
  const std::string type = instance ? document_.decode(document_.value(element.attribute("name")))
                                    : std::string(document_.name(element));
  if (open_nodes_.contains(node)) {
    document_.fail(attribute, "the node would stand inside itself");
  } else if (type != scene_.type_name(node) || instance != scene_.node(node).proto.valid()) {
    document_.fail(attribute, "the node is a " + scene_.type_name(node) + " [expected a " + type +
                                  ", as the element says]");
  }
  return node;
}

NodeId XmtSceneReader::make_node(Element element) {
  const std::string_view type = document_.name(element);
  const NodeDefinition* definition = nodes::definitions().find(type);
  if (definition != nullptr)
    return take(type, sizeof(nodes::Node)) ? scene_.add(*definition, scope_) : NodeId{};
  nodes::NearestName nearest(type);
  for (const NodeDefinition& known : nodes::definitions().nodes()) nearest.offer(known.name);
  document_.fail(type, "no node " + quoted(type) + nearest.hint());
  return {};
}

void XmtSceneReader::read_def(Element element, NodeId node) {
  XmtAttributes attributes(document_, element);
  if (const auto id = attributes.number(kXmtId, INT32_MAX))
    scene_.node(node).id = static_cast<uint32_t>(*id);
  const auto def = attributes.find(kXmtDef);
  if (def && !def->empty() && take(*def, 2 * def->size()))
    give_name(node, document_.decode(*def), *def);
}

void XmtSceneReader::give_name(NodeId node, const std::string& name, std::string_view where) {
  auto& names = scene_.scope(scope_).names;
  std::string unique = name;
  const bool twice = names.contains(name);
  if (twice) {
    uint32_t& copies = name_copies_[std::to_string(scope_.value) + ' ' + name];
    do {
      unique = name + '_' + std::to_string(copies++ + 2);
    } while (names.contains(unique));
    document_.warn(
        "def_twice", where,
        "the name " + quoted(name) + " was given before; this node is called '" + unique + "'");
  }
  names.emplace(unique, node);
  if (twice) names[name] = node;  // the nearest before it is meant
  scene_.node(node).name = std::move(unique);
}

FieldIndex XmtSceneReader::find_field(const NodeDefinition& definition, std::string_view name,
                                      std::string_view where) {
  FieldIndex index = definition.find(name);
  // An exposedField also answers to set_x and x_changed.
  if (!index.valid()) index = definition.find_event_in(name);
  if (!index.valid()) index = definition.find_event_out(name);
  if (index.valid()) return index;
  nodes::NearestName nearest(name);
  for (const FieldDefinition& field : definition.fields()) nearest.offer(field.name);
  document_.fail(where, definition.name + ": no field " + quoted(name) + nearest.hint());
  return {};
}

FieldIndex XmtSceneReader::new_field(NodeId node, std::string_view name, std::string_view where,
                                     std::set<FieldIndex>& seen) {
  const NodeDefinition& definition = *scene_.node(node).definition;
  const FieldIndex index = find_field(definition, name, where);
  if (!index.valid()) return {};
  if (!definition.field(index).has_value())
    return document_.fail(where, definition.name + "." + std::string(name) +
                                     " is an event [expected a field, or IS]"),
           FieldIndex{};
  if (seen.insert(index).second) return index;
  document_.fail(where, definition.name + ": a second value for " + quoted(name));
  return {};
}

void XmtSceneReader::add_value(NodeId node, FieldIndex field, FieldValue value,
                               std::string_view where) {
  if (take(where, sizeof(nodes::FieldEntry)))
    scene_.node(node).values.push_back({field, std::move(value)});
}

void XmtSceneReader::read_attributes(Element element, NodeId node, std::set<FieldIndex>& seen) {
  const bool instance = scene_.node(node).proto.valid();
  for (const pugi::xml_attribute attribute : element.attributes()) {
    const std::string_view name = document_.name(attribute);
    if (name == kXmtDef || name == kXmtId) continue;
    if (instance && (name == "name" || name == "protoID")) continue;
    const FieldIndex index = new_field(node, name, name, seen);
    if (!index.valid()) return;
    const NodeDefinition& definition = *scene_.node(node).definition;
    const FieldDefinition& field = definition.field(index);
    if (is_node(field.type) || field.type == FieldType::sf_command_buffer)
      return document_.fail(name, definition.name + ": " + quoted(name) +
                                      " holds nodes [expected an element of that name]");
    add_value(node, index, values_.read(document_.value(attribute), field, definition.name), name);
    if (!document_.ok()) return;
  }
}

void XmtSceneReader::read_children(Element element, NodeId node, std::set<FieldIndex>& seen) {
  for (const Element child : element.children()) {
    if (!document_.ok()) return;
    if (is_text(child)) return refuse(child, {"an element for a field"});
    const std::string_view name = document_.name(child);
    if (name == "IS") {
      read_links(child, node);
    } else if (name == "field" && scene_.node(node).definition->script) {
      read_own_field(child, node);
    } else if (name == "fieldValue" && scene_.node(node).proto.valid()) {
      read_instance_value(child, node, seen);
    } else {
      const FieldIndex index = new_field(node, name, name, seen);
      if (!index.valid()) return;
      const FieldDefinition field = scene_.node(node).definition->field(index);
      if (!is_node(field.type) && field.type != FieldType::sf_command_buffer)
        return document_.fail(name, quoted(name) + " holds no nodes [expected an attribute]");
      add_value(node, index, read_content(child, field), name);
    }
  }
}

FieldValue XmtSceneReader::read_content(Element element, const FieldDefinition& field) {
  if (field.type == FieldType::sf_command_buffer) return read_buffer(element);
  if (field.type == FieldType::mf_node) return read_nodes(element, field.data_type);
  return read_one_node(element, field.data_type);
}

FieldValue XmtSceneReader::read_buffer(Element element) {
  const Depth depth(*this, element);
  auto content = std::make_shared<BufferedCommands>();
  if (take(document_.name(element), sizeof(BufferedCommands) + sizeof(PendingBuffer)))
    pending_.push_back({element, content, scope_, depth_});
  return nodes::CommandBuffer{{}, content};
}

/// The nodes that stand in an element; NULL is a word of text.
std::vector<NodeId> XmtSceneReader::read_nodes(Element element, nodes::NodeDataType type) {
  FieldDefinition place;
  place.data_type = type;
  std::vector<NodeId> list;
  for (const Element child : element.children()) {
    const bool text = is_text(child);
    const auto words = text ? words_of(document_.value(child)) : std::vector<std::string_view>{};
    for (const std::string_view word : words)
      if (word != "NULL")
        document_.fail(word, "found " + quoted(word) + " [expected a node or NULL]");
    const size_t count = text ? words.size() : 1;
    if (!values_.take(document_.name(element), count, sizeof(NodeId))) break;
    list.resize(list.size() + count);
    if (text) continue;
    const NodeId node = read_node(child);
    if (document_.ok() && !scene_.may_stand(node, place))
      document_.fail(document_.name(child),
                     "a " + scene_.type_name(node) +
                         " may not stand here [expected a node of type " +
                         std::string(nodes::definitions().data_type_name(type)) + "]");
    list.back() = node;
  }
  return list;
}

NodeId XmtSceneReader::read_one_node(Element element, nodes::NodeDataType type) {
  const std::vector<NodeId> list = read_nodes(element, type);
  if (list.size() != 1)
    document_.fail(document_.name(element), std::to_string(list.size()) + " nodes in " +
                                                quoted(document_.name(element)) +
                                                " [expected one, or NULL]");
  return list.size() == 1 ? list[0] : NodeId{};
}

}  // namespace afx::bifs
