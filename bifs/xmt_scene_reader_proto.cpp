// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// PROTOs, their instances, the fields of Scripts, IS and ROUTE in XMT-A.
#include <algorithm>
#include <utility>

#include "bifs/xmt_names.h"
#include "bifs/xmt_scene_reader.h"
#include "nodes/nearest_name.h"
#include "nodes/text_cursor.h"

namespace afx::bifs {

using nodes::FieldDefinition;
using nodes::FieldIndex;
using nodes::FieldType;
using nodes::FieldValue;
using nodes::IndexMode;
using nodes::NodeDefinition;
using nodes::NodeId;
using nodes::ProtoId;
using nodes::quoted;

NodeId XmtSceneReader::make_instance(Element element) {
  XmtAttributes attributes(document_, element);
  const std::string name = attributes.need("name");
  if (!document_.ok()) return {};
  const ProtoId proto = find_proto(name, attributes.number("protoID", INT32_MAX));
  if (!proto.valid()) {
    nodes::NearestName nearest(name);
    for (nodes::ScopeId at = scope_; at.valid(); at = scene_.scope(at).parent)
      for (const auto& entry : scene_.scope(at).proto_names) nearest.offer(entry.first);
    document_.fail(*attributes.find("name"),
                   "no PROTO " + quoted(name) + " before this" + nearest.hint());
  } else if (open_protos_.contains(proto)) {
    document_.fail(*attributes.find("name"), "the PROTO would stand inside itself");
  }
  if (!take(attributes.where(), sizeof(nodes::Node))) return {};
  return scene_.add_instance(proto, scope_);
}

/// The nearest of that name, and of that ID where one is told.
ProtoId XmtSceneReader::find_proto(std::string_view name, std::optional<uint64_t> id) const {
  ProtoId proto = scene_.find_proto(name, scope_);
  while (proto.valid() && id && scene_.proto(proto).id != *id) {
    const nodes::ScopeId outer = scene_.scope(scene_.proto(proto).scope).parent;
    proto = outer.valid() ? scene_.find_proto(name, outer) : ProtoId{};
  }
  return proto;
}

ProtoId XmtSceneReader::read_proto(Element element) {
  const Depth depth(*this, element);
  const ProtoId proto = declare_proto(element);
  if (!document_.ok()) return {};
  open_protos_.insert(proto);
  const nodes::ScopeId outer = std::exchange(scope_, scene_.proto(proto).body);
  for (const Element field : element.children("field"))
    if (document_.ok()) read_interface_field(field, scene_.proto(proto).interface);
  if (document_.ok()) read_body(element, proto);
  scene_.settle_data_types(proto);
  scope_ = outer;
  open_protos_.erase(proto);
  return proto;
}

ProtoId XmtSceneReader::declare_proto(Element element) {
  XmtAttributes attributes(document_, element);
  const std::string name = attributes.need("name");
  const auto locations = attributes.find("locations");
  const auto id = attributes.number("protoID", INT32_MAX);
  attributes.finish();
  constexpr size_t kBytes = sizeof(nodes::Proto) + sizeof(nodes::Scope);
  if (!take(attributes.where(), kBytes + 2 * name.size())) return {};
  Result<ProtoId> proto = scene_.add_proto(name, locations.has_value(), scope_);
  if (!proto.ok())
    return document_.fail(*attributes.find("name"),
                          proto.error().text + " [expected another name]"),
           ProtoId{};
  nodes::Proto& declared = scene_.proto(proto.value());
  const bool told = id && told_proto_ids_.emplace(scope_, static_cast<uint32_t>(*id)).second;
  declared.id = told ? static_cast<uint32_t>(*id) : proto_ids_.next({});
  proto_ids_.take(declared.id);
  if (!locations) return proto.value();
  FieldDefinition url;
  url.name = "locations";
  url.type = FieldType::mf_url;
  FieldValue urls = values_.read(*locations, url, name);
  declared.urls = std::move(*std::get_if<std::vector<nodes::Url>>(&urls));
  return proto.value();
}

void XmtSceneReader::read_body(Element element, ProtoId proto) {
  const nodes::ScopeId body = scene_.proto(proto).body;
  for (const Element child : element.children()) {
    if (!document_.ok()) return;
    const std::string_view name = document_.name(child);
    if (name == "field") continue;
    if (scene_.proto(proto).external) return refuse(child, {"field"});
    if (name == "ProtoDeclare") {
      read_proto(child);
    } else if (name == "ROUTE") {
      scene_.scope(body).routes.push_back(read_route(child));
    } else if (child.type() == pugi::node_element) {
      scene_.add_root(read_node(child), body);
    } else {  // as GPAC writes an empty body
      for (const std::string_view word : words_of(document_.value(child)))
        word == "NULL" ? scene_.add_root({}, body) : refuse(child, {"a node", "NULL"});
    }
  }
}

FieldDefinition XmtSceneReader::read_field_head(XmtAttributes& attributes) {
  FieldDefinition field;
  field.name = attributes.need("name");
  const std::string type = attributes.need("type");
  const std::string kind = attributes.need("vrml97Hint");
  if (!document_.ok()) return field;
  nodes::NearestName nearest(type);
  const XmtType* found = nullptr;
  for (const XmtType& row : kXmtTypes) {
    nearest.offer(row.name);
    if (row.name == type) found = &row;
  }
  const auto event = nodes::find_event_kind(kind);
  if (found == nullptr)
    return document_.fail(*attributes.find("type"),
                          "no field type " + quoted(type) + nearest.hint()),
           field;
  if (!event)
    return document_.fail(
               *attributes.find("vrml97Hint"),
               "found " + quoted(kind) + " [expected field, exposedField, eventIn or eventOut]"),
           field;
  field.kind = *event;
  field.type = found->type;
  field.default_value = zero_value(field.type);
  return field;
}

std::optional<FieldValue> XmtSceneReader::read_field_value(Element element,
                                                           XmtAttributes& attributes,
                                                           const FieldDefinition& field) {
  const char* const where = xmt_type(field.type).value_attribute;
  if (is_node(field.type) || field.type == FieldType::sf_command_buffer) {
    const Element content = element.child(where);
    return content ? std::optional(read_content(content, field)) : std::nullopt;
  }
  const auto value = attributes.find(where);
  return value ? std::optional(values_.read(*value, field, document_.name(element))) : std::nullopt;
}

void XmtSceneReader::read_interface_field(Element element, NodeDefinition& interface) {
  XmtAttributes attributes(document_, element);
  FieldDefinition field = read_field_head(attributes);
  if (!document_.ok()) return;
  if (field.has_value())
    if (auto value = read_field_value(element, attributes, field))
      field.default_value = std::move(*value);
  attributes.finish();
  const char* const content = xmt_type(field.type).value_attribute;
  for (const Element child : element.children()) {
    if (document_.name(child) == "InterfaceCodingParameters") {
      read_coding(child, field);
    } else if (document_.name(child) != content) {
      return refuse(child, {"InterfaceCodingParameters", content});
    }
  }
  const std::string name = field.name;
  if (!take(attributes.where(), sizeof(FieldDefinition) + name.size())) return;
  if (!interface.add(std::move(field)).valid())
    document_.fail(attributes.where(),
                   "a second field " + quoted(name) + ", or more than 65535 fields");
}

void XmtSceneReader::read_coding(Element element, FieldDefinition& field) {
  XmtAttributes attributes(document_, element);
  constexpr const char* kCategory = "quantCategoy";  // GPAC's name for it
  auto category = attributes.find(kCategory);
  if (!category) category = attributes.find("quantCategory");
  if (category) {
    const auto known = std::find(kXmtQuantCategories.begin(), kXmtQuantCategories.end(), *category);
    if (known == kXmtQuantCategories.end())
      document_.fail(*category, "no quantization category " + quoted(*category));
    field.quant_category = static_cast<uint8_t>(known - kXmtQuantCategories.begin());
  }
  if (const auto bits = attributes.number("nbBits", 32))
    field.quant_bits = static_cast<uint8_t>(*bits);
  if (const auto animation = attributes.number("animCategory", 15))
    field.anim_category = static_cast<uint8_t>(*animation);
  const bool whole = element_type(field.type) == FieldType::sf_int32;
  const auto lower = attributes.find(whole ? "intMin" : "floatMin");
  const auto upper = attributes.find(whole ? "intMax" : "floatMax");
  if (lower && upper)
    field.bounds = nodes::Bounds{values_.read_double(*lower), values_.read_double(*upper)};
  attributes.finish();
}

/// A field that a Script declares itself.
void XmtSceneReader::read_own_field(Element element, NodeId script) {
  XmtAttributes attributes(document_, element);
  FieldDefinition field = read_field_head(attributes);
  if (document_.ok() && field.kind == nodes::EventKind::exposed_field)
    document_.fail(*attributes.find("vrml97Hint"),
                   "a Script has no exposedField [expected field, eventIn or eventOut]");
  if (!take(attributes.where(), sizeof(FieldDefinition) + field.name.size())) return;
  const FieldDefinition held = field;
  const FieldIndex index = scene_.own_definition(script).add(std::move(field));
  if (!index.valid())
    return document_.fail(attributes.where(),
                          "a second field " + quoted(held.name) + ", or more than 65535 fields");
  if (held.has_value())
    if (auto value = read_field_value(element, attributes, held))
      add_value(script, index, std::move(*value), attributes.where());
  attributes.finish();
}

void XmtSceneReader::read_instance_value(Element element, NodeId node, std::set<FieldIndex>& seen) {
  XmtAttributes attributes(document_, element);
  const std::string name = attributes.need("name");
  if (!document_.ok()) return;
  const FieldIndex index = new_field(node, name, *attributes.find("name"), seen);
  if (!index.valid()) return;
  const FieldDefinition field = scene_.node(node).definition->field(index);
  auto value = read_field_value(element, attributes, field);
  attributes.finish();
  if (!value)
    return document_.fail(attributes.where(),
                          "a fieldValue without value [expected " +
                              std::string(xmt_type(field.type).value_attribute) + "]");
  add_value(node, index, std::move(*value), attributes.where());
}

/// `<IS><connect nodeField protoField/></IS>`
void XmtSceneReader::read_links(Element element, NodeId node) {
  const ProtoId proto = scene_.scope(scope_).proto;
  if (!proto.valid())
    return document_.fail(document_.name(element),
                          "IS outside the body of a PROTO [expected a value]");
  for (const Element child : element.children()) {
    if (document_.name(child) != "connect") return refuse(child, {"connect"});
    XmtAttributes attributes(document_, child);
    const std::string name = attributes.need("nodeField");
    const std::string proto_name = attributes.need("protoField");
    attributes.finish();
    if (!document_.ok()) return;
    const NodeDefinition& own = *scene_.node(node).definition;
    const NodeDefinition& interface = scene_.proto(proto).interface;
    const FieldIndex field = find_field(own, name, *attributes.find("nodeField"));
    const FieldIndex outer = find_field(interface, proto_name, *attributes.find("protoField"));
    if (!take(attributes.where(), sizeof(nodes::IsLink))) return;
    const FieldType from = interface.field(outer).type, to = own.field(field).type;
    if (from != to)
      return document_.fail(attributes.where(),
                            quoted(proto_name) + " is an " + std::string(to_string(from)) +
                                " [expected an " + std::string(to_string(to)) + "]");
    scene_.node(node).links.push_back({field, outer});
  }
}

nodes::Route XmtSceneReader::read_route(Element element) {
  XmtAttributes attributes(document_, element);
  nodes::Route route;
  const auto id = attributes.number(kXmtId, INT32_MAX);
  route.name = attributes.text(kXmtDef);
  read_route_ends(attributes, route);
  attributes.finish();
  if (!take(attributes.where(), sizeof(nodes::Route) + 2 * route.name.size())) return {};
  RouteIds& ids = route_ids_[scope_];
  if (id) {
    route.id = static_cast<uint32_t>(*id);
    ids.note(route.name, route.id);
  } else if (!route.name.empty()) {
    route.id = ids.id_of_new(route.name);
  }
  return route;
}

void XmtSceneReader::read_route_ends(XmtAttributes& attributes, nodes::Route& route) {
  const FieldRef from = read_field_ref(attributes, "fromNode", "fromField", true);
  const FieldRef to = read_field_ref(attributes, "toNode", "toField");
  if (!document_.ok()) return;
  route = {from.node, from.field, to.node, to.field, route.name, route.id};
  const auto check = [&](const FieldRef& end, IndexMode mode, const char* name) {
    const NodeDefinition& type = *scene_.node(end.node).definition;
    if (!type.index_in(mode, end.field))
      document_.fail(*attributes.find(name), type.name + "." + type.field(end.field).name +
                                                 " is no " +
                                                 (mode == IndexMode::out ? "eventOut" : "eventIn") +
                                                 " [expected one, or an exposedField]");
  };
  check(from, IndexMode::out, "fromField");
  check(to, IndexMode::in, "toField");
}

}  // namespace afx::bifs
