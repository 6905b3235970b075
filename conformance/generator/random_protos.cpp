// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// PROTOs and ROUTEs.
#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "bifs/quantizer.h"
#include "conformance/generator/scene_maker.h"

namespace afx::conformance {

using nodes::EventKind;
using nodes::FieldDefinition;
using nodes::FieldIndex;
using nodes::FieldType;
using nodes::NodeId;
using nodes::ProtoId;
using nodes::ScopeId;

namespace {

constexpr std::array kKinds{EventKind::field, EventKind::exposed_field, EventKind::event_in,
                            EventKind::event_out};
constexpr std::array kTypes{
    FieldType::sf_bool,     FieldType::sf_float,    FieldType::sf_time,  FieldType::sf_int32,
    FieldType::sf_string,   FieldType::sf_vec3f,    FieldType::sf_vec2f, FieldType::sf_color,
    FieldType::sf_rotation, FieldType::sf_image,    FieldType::sf_node,  FieldType::sf_vec4f,
    FieldType::sf_url,      FieldType::mf_bool,     FieldType::mf_float, FieldType::mf_time,
    FieldType::mf_int32,    FieldType::mf_string,   FieldType::mf_vec3f, FieldType::mf_vec2f,
    FieldType::mf_color,    FieldType::mf_rotation, FieldType::mf_image, FieldType::mf_node,
    FieldType::mf_vec4f,    FieldType::mf_url};

bool is_numeric(FieldType type) {
  switch (element_type(type)) {
    case FieldType::sf_float:
    case FieldType::sf_time:
    case FieldType::sf_int32:
    case FieldType::sf_vec2f:
    case FieldType::sf_vec3f:
    case FieldType::sf_vec4f:
    case FieldType::sf_color:
    case FieldType::sf_rotation:
      return true;
    default:
      return false;
  }
}

}  // namespace

std::vector<ProtoId> SceneMaker::random_protos(ScopeId scope, unsigned depth) {
  std::vector<ProtoId> protos;
  while (choices_.one_in(5)) protos.push_back(random_proto(scope, depth));
  return protos;
}

ProtoId SceneMaker::random_proto(ScopeId scope, unsigned depth) {
  const uint32_t id = ++proto_ids_;
  const ProtoId outer = scene_.scope(scope).proto;
  const std::string made =
      outer.valid() ? scene_.proto(outer).interface.name + "_" : std::string("Proto");
  const bool is_external = choices_.one_in(5);
  const std::string name = own_names() ? "Type" : made;
  const ProtoId proto = scene_.add_proto(name + std::to_string(id), is_external, scope).value();
  scene_.proto(proto).id = id;
  while (choices_.below(3) != 0) {
    const EventKind kind = choices_.of(kKinds);
    scene_.proto(proto).interface.add(interface_field(proto, kind, choices_.of(kTypes)));
  }
  if (is_external) {
    const FieldDefinition url;
    const auto urls = random_value(choices_, url, FieldType::mf_url);
    scene_.proto(proto).urls = std::get<std::vector<nodes::Url>>(urls);
  } else {
    fill_body(proto, depth);
  }
  scene_.settle_data_types(proto);
  known_[scope].protos.push_back(proto);
  return proto;
}

void SceneMaker::fill_body(ProtoId proto, unsigned depth) {
  const ScopeId body = scene_.proto(proto).body;
  if (depth < 2) random_protos(body, depth + 1);
  do {
    const NodeId root = new_node(nodes::kWorldNode, body, depth + 4);
    scene_.add_root(root, body);
    if (root.valid()) link_fields(proto, root);
  } while (choices_.one_in(4));
  scene_.scope(body).routes = random_routes(body);
}

/// IS links of the fields of a node in the body, each to a new field of the interface.
void SceneMaker::link_fields(ProtoId proto, NodeId node) {
  const auto& fields = definition(node).fields();
  while (!fields.empty() && choices_.below(3) != 0) {
    const FieldIndex index{size_t{choices_.below(static_cast<uint32_t>(fields.size()))}};
    const FieldDefinition& linked = definition(node).field(index);
    const auto& links = scene_.node(node).links;
    const bool is_taken = scene_.given(node, index) != nullptr ||
                          std::any_of(links.begin(), links.end(),
                                      [&](const auto& link) { return link.field == index; });
    if (is_taken || std::find(kTypes.begin(), kTypes.end(), linked.type) == kTypes.end()) continue;
    const FieldIndex other =
        scene_.proto(proto).interface.add(interface_field(proto, linked.kind, linked.type));
    scene_.node(node).links.push_back({index, other});
  }
  auto& links = scene_.node(node).links;
  std::sort(links.begin(), links.end(),
            [](const auto& a, const auto& b) { return a.field < b.field; });
}

FieldDefinition SceneMaker::interface_field(ProtoId proto, EventKind kind, FieldType type) {
  FieldDefinition field;
  const size_t number = scene_.proto(proto).interface.fields().size();
  field.name = (own_names() ? "field" : "_field") + std::to_string(number);
  field.kind = kind;
  field.type = type;
  field.default_value = zero_value(type);
  random_coding(field);
  if (field.has_value() && !is_node(type))
    field.default_value = random_value(choices_, field, type, {.integers_fit = fits_});
  return field;
}

void SceneMaker::random_coding(FieldDefinition& field) {
  if (field.has_value() && choices_.one_in(4)) {
    // An index has no meaning in a PROTO.
    field.quant_category = static_cast<uint8_t>(1 + choices_.below(13));
    if (field.quant_category == bifs::kCategoryLinearScalar)
      field.quant_bits = static_cast<uint8_t>(choices_.below(32));
    if (is_numeric(field.type) && choices_.below(2) != 0) {
      static constexpr std::array<std::pair<double, double>, 4> kBounds{
          {{0, 1}, {-100, 100}, {-1, 65535}, {0, 0}}};
      const auto& [lower, upper] = choices_.of(kBounds);
      field.bounds = nodes::Bounds{lower, upper};
    }
  }
  const bool is_animatable =
      field.kind == EventKind::event_in || field.kind == EventKind::exposed_field;
  if (is_animatable && choices_.one_in(6))
    field.anim_category = static_cast<uint8_t>(1 + choices_.below(15));
}

std::vector<nodes::Route> SceneMaker::random_routes(ScopeId scope) {
  std::vector<nodes::Route> routes;
  while (choices_.below(3) != 0)
    if (auto route = random_route(scope)) routes.push_back(std::move(*route));
  return routes;
}

std::optional<nodes::Route> SceneMaker::random_route(ScopeId scope) {
  const auto from = out_of(scope);
  if (!from) return std::nullopt;
  const auto to = into(scope, field(*from).type);
  if (!to) return std::nullopt;
  nodes::Route route{from->node, from->field, to->node, to->field, {}, 0};
  if (choices_.below(2) == 0) return route;
  route.id = ++known_[scope].route_ids;
  if (scope == nodes::Scene::kMain) route_ids_.push_back(route.id);
  const uint32_t style = choices_.below(3);
  if (own_names() && style != 0)
    route.name =
        style == 1 ? "R" + std::to_string(route.id - 1) : "route_" + std::to_string(route.id);
  return route;
}

/// A field that sends events, of a node with an ID.
std::optional<bifs::FieldRef> SceneMaker::out_of(ScopeId scope) {
  const auto& known = known_[scope].nodes;
  if (known.empty()) return std::nullopt;
  const NodeId node = choices_.of(known);
  const auto& fields = definition(node).fields_in(nodes::IndexMode::out);
  if (fields.empty()) return std::nullopt;
  return bifs::FieldRef{node, choices_.of(fields)};
}

/// A field that takes events of a type.
std::optional<bifs::FieldRef> SceneMaker::into(ScopeId scope, FieldType type) {
  std::vector<bifs::FieldRef> found;
  for (const NodeId node : known_[scope].nodes)
    for (const FieldIndex index : definition(node).fields_in(nodes::IndexMode::in))
      if (definition(node).field(index).type == type) found.push_back({node, index});
  if (found.empty()) return std::nullopt;
  return choices_.of(found);
}

}  // namespace afx::conformance
