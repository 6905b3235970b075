// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// PROTO, EXTERNPROTO, IS and ROUTE in scene text.
#include "nodes/definitions.h"
#include "nodes/nearest_name.h"
#include "nodes/scene_text_reader.h"

namespace afx::nodes {

ProtoId SceneTextReader::declare_proto(ScopeId scope, bool external) {
  if (in_.peek_word().empty()) return in_.fail_expected("the name of the PROTO"), ProtoId{};
  const size_t begin = in_.offset();
  const std::string name(in_.take_word());
  constexpr size_t kBytes = sizeof(Proto) + sizeof(Scope);
  if (!values_.budget().take(in_, 1, kBytes + 2 * name.size())) return {};
  // Such names would mean two things in one scope; what is written back could not be told apart.
  if (definitions().find(name) != nullptr || !is_identifier(name))
    return in_.fail(Errc::malformed, begin,
                    quoted(name) + " is the name of a node or a keyword [expected another]"),
           ProtoId{};
  if (outer_uses_.contains({scope, name}))
    return in_.fail(Errc::malformed, begin,
                    "the PROTO " + quoted(name) +
                        " of an outer scope was used here before [expected another name]"),
           ProtoId{};
  Result<ProtoId> proto = scene_.add_proto(name, external, scope);
  if (proto.ok()) return proto.value();
  in_.fail(Errc::malformed, begin, proto.error().text + " [expected another name]");
  return {};
}

void SceneTextReader::read_proto(ScopeId scope) {
  const Depth depth(*this);
  const ProtoId id = declare_proto(scope, false);
  if (!in_.ok()) return;
  const TextCursor::Context outer = std::exchange(in_.context, {});
  open_protos_.insert(id);
  const ScopeId body = scene_.proto(id).body;
  InterfaceRules rules;
  rules.read_nodes = [this, body](const FieldDefinition& field) { return read_nodes(field, body); };
  NodeDefinition& interface = scene_.proto(id).interface;
  in_.context.node = interface.name;
  InterfaceReader(in_, values_, rules).read_interface(interface);
  in_.context = {};
  read_proto_body(id);
  scene_.settle_data_types(id);
  open_protos_.erase(id);
  in_.context = outer;
}

void SceneTextReader::read_proto_body(ProtoId id) {
  const ScopeId body = scene_.proto(id).body;
  const size_t opened = (in_.skip_space(), in_.offset());
  if (!in_.expect('{', "the interface of the PROTO")) return;
  while (!in_.accept('}')) {
    if (in_.at_end()) return in_.fail_unclosed(opened, "'}'");
    if (in_.accept_word("NULL")) {  // what the peer writes for an empty body
      scene_.add_root(NodeId{}, body);
    } else {
      read_statement(body);
    }
  }
}

void SceneTextReader::read_extern_proto(ScopeId scope) {
  const Depth depth(*this);
  const ProtoId id = declare_proto(scope, true);
  if (!in_.ok()) return;
  const TextCursor::Context outer = std::exchange(in_.context, {});
  const ScopeId body = scene_.proto(id).body;
  InterfaceRules rules;
  rules.values_required = false;
  rules.read_nodes = [this, body](const FieldDefinition& field) { return read_nodes(field, body); };
  NodeDefinition& interface = scene_.proto(id).interface;
  in_.context.node = interface.name;
  InterfaceReader(in_, values_, rules).read_interface(interface);
  FieldValue urls = values_.read(FieldType::mf_url);
  if (auto* list = std::get_if<std::vector<Url>>(&urls)) scene_.proto(id).urls = std::move(*list);
  in_.context = outer;
}

void SceneTextReader::read_is(NodeId id, FieldIndex field) {
  const ProtoId proto = scene_.scope(scene_.node(id).scope).proto;
  if (!proto.valid())
    return in_.fail(Errc::malformed, in_.offset() - std::string_view("IS").size(),
                    "IS outside the body of a PROTO [expected a value]");
  if (in_.peek_word().empty()) return in_.fail_expected("a field of the PROTO after IS");
  const size_t begin = in_.offset();
  const std::string_view name = in_.take_word();
  const NodeDefinition& interface = scene_.proto(proto).interface;
  const FieldIndex interface_field = interface.find(name);
  if (!interface_field.valid()) {
    NearestName nearest(name);
    for (const FieldDefinition& known : interface.fields()) nearest.offer(known.name);
    return in_.fail(
        Errc::malformed, begin,
        "the PROTO " + quoted(interface.name) + " has no field " + quoted(name) + nearest.hint());
  }
  check_is(scene_.node(id).definition->field(field), interface.field(interface_field), begin);
  scene_.node(id).links.push_back({field, interface_field});
}

void SceneTextReader::check_is(const FieldDefinition& field, const FieldDefinition& interface_field,
                               size_t begin) {
  if (field.type != interface_field.type)
    return in_.fail(Errc::malformed, begin,
                    quoted(interface_field.name) + " is an " +
                        std::string(to_string(interface_field.type)) + " [expected an " +
                        std::string(to_string(field.type)) + "]");
  // VRML97: an exposedField of a node goes with any kind, the other kinds with their own only.
  if (field.kind != EventKind::exposed_field && field.kind != interface_field.kind)
    in_.warn("is_kind", begin,
             "the " + std::string(to_string(field.kind)) + " " + quoted(field.name) +
                 " is connected to the " + std::string(to_string(interface_field.kind)) + " " +
                 quoted(interface_field.name));
}

void SceneTextReader::read_route(ScopeId scope, std::string_view name) {
  const TextCursor::Context outer = std::exchange(in_.context, {"ROUTE", {}});
  Route route;
  route.name = std::string(name);
  route.from_field = read_route_end(scope, true, route.from);
  if (!in_.accept_word("TO")) in_.fail_expected("TO");
  const size_t begin = (in_.skip_space(), in_.offset());
  route.to_field = read_route_end(scope, false, route.to);
  if (in_.ok()) {
    const FieldType from = scene_.node(route.from).definition->field(route.from_field).type;
    const FieldType to = scene_.node(route.to).definition->field(route.to_field).type;
    if (from != to)
      in_.fail(Errc::malformed, begin,
               "an " + std::string(to_string(from)) + " cannot go to an " +
                   std::string(to_string(to)) + " [expected fields of one type]");
  }
  if (in_.ok() && values_.budget().take(in_, 1, sizeof(Route) + name.size()))
    scene_.scope(scope).routes.push_back(std::move(route));
  in_.context = outer;
}

/// `node.field`, an eventOut or eventIn.
FieldIndex SceneTextReader::read_route_end(ScopeId scope, bool source, NodeId& node) {
  if (in_.peek_word().empty()) return in_.fail_expected("the name of a node"), FieldIndex{};
  const size_t node_begin = in_.offset();
  const std::string_view node_name = in_.take_word();
  node = find_named(node_name, node_begin, scope);
  if (!node.valid()) return {};
  if (!in_.expect('.', "the name of the node")) return {};
  if (in_.peek_word().empty()) return in_.fail_expected("the name of a field"), FieldIndex{};
  const size_t begin = in_.offset();
  const std::string_view name = in_.take_word();
  const NodeDefinition& definition = *scene_.node(node).definition;
  const FieldIndex field =
      source ? definition.find_event_out(name) : definition.find_event_in(name);
  // Not x, nor set_x or x_changed where that is meant: unknown, or the other one of the two.
  if (!field.valid() && !find_field(definition, name, begin).valid()) return {};
  const IndexMode mode = source ? IndexMode::out : IndexMode::in;
  if (field.valid() && definition.index_in(mode, field)) return field;
  in_.fail(Errc::malformed, begin,
           quoted(name) + " of " + definition.name + " is no " + (source ? "eventOut" : "eventIn") +
               " [expected one, or an exposedField]");
  return {};
}

}  // namespace afx::nodes
