// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Commands of the scene in BT. Source: the dialect of the peer (spec/bifs.md 17).
#include <algorithm>
#include <utility>

#include "bifs/bt_text_reader.h"
#include "bifs/top_node.h"
#include "nodes/nearest_name.h"

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
using nodes::Route;
using nodes::Scene;
using nodes::TextCursor;

namespace {

/// A field as it is read, without its default.
FieldDefinition without_default(const FieldDefinition& field, FieldType type) {
  FieldDefinition read;
  read.name = field.name;
  read.type = type;
  read.data_type = field.data_type;
  read.bytes = field.bytes;
  return read;
}

}  // namespace

/// Reads a command if `word` begins one of the scene. What stands before the first is the scene
/// that the commands begin with.
bool BtTextReader::read_scene_command(std::string_view word, Commands& out) {
  using Read = void (BtTextReader::*)(Commands&);
  static constexpr std::pair<std::string_view, Read> kCommands[] = {
      {"INSERT", &BtTextReader::read_insert},
      {"APPEND", &BtTextReader::read_append},
      {"DELETE", &BtTextReader::read_delete},
      {"XDELETE", &BtTextReader::read_extended_delete},
      {"REPLACE", &BtTextReader::read_replace},
      {"GLOBALQP", &BtTextReader::read_global_quantizer},
      {"MULTIPLEREPLACE", &BtTextReader::read_multiple_replace},
      {"MULTIPLEINDREPLACE", &BtTextReader::read_multiple_indexed},
      {"XREPLACE", &BtTextReader::read_xreplace},
      {"INSERTPROTO", &BtTextReader::read_insert_proto},
      {"DELETEPROTO", &BtTextReader::read_delete_proto}};
  for (const auto& [name, read] : kCommands) {
    if (name != word) continue;
    end_scene();
    in_.take_word();
    const TextCursor::Context outer = std::exchange(in_.context, {name, {}});
    (this->*read)(out);
    if (in_.ok() && !out.empty() && buffer_depth_ == 0) lists_.note(scene_, out.back());
    in_.context = outer;
    return true;
  }
  return false;
}

void BtTextReader::read_extended_delete(Commands& out) {
  out.push_back(NodeDeletion{read_target_node(), true});
}

void BtTextReader::read_global_quantizer(Commands& out) {
  out.push_back(GlobalQuantizer{read_node_or_null(scope_)});
}

/// `INSERT AT n.field[i] value`, `INSERT ROUTE`.
void BtTextReader::read_insert(Commands& out) {
  if (in_.accept_word("ROUTE")) return read_insert_route(out);
  if (!expect_word("AT")) return;
  const FieldRef target = read_list_target();
  const std::optional<Position> position = read_position();
  if (in_.ok() && !position) return in_.fail_expected("'[' and an index");
  insertion(target, position.value_or(Position{}), out);
}

/// `APPEND TO n.field value`.
void BtTextReader::read_append(Commands& out) {
  if (!expect_word("TO")) return;
  insertion(read_list_target(), {Position::Kind::last, 0}, out);
}

/// Into `children` nodes are inserted, into other lists values.
void BtTextReader::insertion(const FieldRef& target, Position position, Commands& out) {
  if (!in_.ok()) return;
  FieldValue value = read_element(target);
  if (!in_.ok()) return;
  const NodeDefinition& definition = *scene_.node(target.node).definition;
  const FieldDefinition& field = definition.field(target.field);
  const bool is_first_list = field.type == FieldType::mf_node && field.name == "children" &&
                             definition.insertion_type() == field.data_type;
  if (is_first_list) {
    out.push_back(NodeInsertion{target.node, position, std::get<NodeId>(value)});
  } else {
    out.push_back(IndexedValueInsertion{target, position, std::move(value)});
  }
}

/// Whether `n.field` stands here.
bool BtTextReader::is_field_path() const {
  TextCursor ahead = in_;
  return !ahead.take_word().empty() && ahead.peek() == '.';
}

/// `DELETE n`, `n.field[i]`, `n.nodefield`, `ROUTE r`, `LAST n.field`.
void BtTextReader::read_delete(Commands& out) {
  if (in_.accept_word("ROUTE")) return out.push_back(RouteDeletion{read_route_id()});
  for (const auto& [word, kind] :
       {std::pair("LAST", Position::Kind::last), std::pair("FIRST", Position::Kind::first)}) {
    if (in_.peek_word() != word || is_field_path()) continue;
    in_.take_word();
    return out.push_back(IndexedValueDeletion{read_list_target(), {kind, 0}});
  }
  if (!is_field_path()) return out.push_back(NodeDeletion{read_target_node(), false});
  const FieldRef target = read_target(IndexMode::in);
  if (!in_.ok()) return;
  const FieldDefinition& field = scene_.node(target.node).definition->field(target.field);
  if (field.type == FieldType::sf_node)
    return out.push_back(FieldReplacement{target, FieldValue(NodeId{})});
  if (!is_multiple(field.type)) return in_.fail_expected("a list, or a field of a node");
  const std::optional<Position> position = read_position();
  if (in_.ok() && !position) return in_.fail_expected("'[' and an index");
  out.push_back(IndexedValueDeletion{target, position.value_or(Position{})});
}

/// `REPLACE SCENE BY`, `ROUTE r BY`, `n BY node`, `n.field BY value`, `n.field[i] BY value`.
void BtTextReader::read_replace(Commands& out) {
  if (in_.accept_word("ROUTE")) return read_replace_route(out);
  if (!is_field_path()) {
    if (in_.accept_word("SCENE")) return read_replace_scene(out);
    const NodeId target = read_target_node();
    if (!expect_word("BY")) return;
    return out.push_back(NodeReplacement{target, read_node_or_null(scope_)});
  }
  const FieldRef target = read_target(IndexMode::in);
  if (!in_.ok()) return;
  const FieldDefinition& field = scene_.node(target.node).definition->field(target.field);
  const bool indexed = in_.peek() == '[';
  if (indexed && !is_multiple(field.type))
    return in_.fail_expected("BY, for this field is no list");
  const std::optional<Position> position = indexed ? read_position() : std::optional<Position>();
  if (!expect_word("BY")) return;
  if (position)
    return out.push_back(IndexedValueReplacement{target, *position, read_element(target)});
  out.push_back(FieldReplacement{target, read_field(target)});
}

/// PROTOs, a node or NULL, ROUTEs.
void BtTextReader::read_replace_scene(Commands& out) {
  if (!expect_word("BY")) return;
  if (buffer_depth_ > 0)
    return in_.fail(Errc::unsupported, in_.offset(), "a scene replacement in a command buffer");
  end_epoch();
  begin_epoch();
  SceneReplacement command;
  while (in_.peek_word() == "PROTO" || in_.peek_word() == "EXTERNPROTO")
    read_declaration(Scene::kMain);
  in_.skip_space();
  const size_t begin = in_.offset();
  command.root = read_node_or_null(Scene::kMain);
  if (in_.ok() && !may_be_top_node(scene_, command.root))
    return in_.fail(Errc::malformed, begin,
                    "a " + scene_.type_name(command.root) + " may not be the top node [expected " +
                        kTopNodes + "]");
  while (in_.ok() && !in_.at_end() && in_.peek() != '}' && read_declaration(Scene::kMain)) {
  }
  nodes::Scope& scope = scene_.scope();
  command.protos = scope.protos;
  command.routes = std::exchange(scope.routes, {});
  for (Route& route : command.routes)
    if (!route.name.empty()) route.id = route_ids_.id_of_new(route.name, !like_gpac_);
  out.push_back(std::move(command));
}

/// `INSERT ROUTE [DEF r] a.b TO c.d`.
void BtTextReader::read_insert_route(Commands& out) {
  const std::string_view name = in_.accept_word("DEF") ? read_def_name("ROUTE") : "";
  Route route = read_new_route(name);
  if (!in_.ok()) return;
  if (!route.name.empty()) route.id = route_ids_.id_of_new(route.name, !like_gpac_);
  out.push_back(RouteInsertion{std::move(route)});
}

Route BtTextReader::read_new_route(std::string_view name) {
  read_route(scope_, name);
  if (!in_.ok()) return {};
  auto& routes = scene_.scope(scope_).routes;
  Route route = std::move(routes.back());
  routes.pop_back();
  return route;
}

/// `REPLACE ROUTE r BY a.b TO c.d`.
void BtTextReader::read_replace_route(Commands& out) {
  RouteReplacement command;
  command.route_id = read_route_id();
  if (!expect_word("BY")) return;
  const Route ends = read_new_route({});
  command.from = {ends.from, ends.from_field};
  command.to = {ends.to, ends.to_field};
  out.push_back(command);
}

uint32_t BtTextReader::read_route_id() {
  if (in_.peek_word().empty()) return in_.fail_expected("the name of a ROUTE"), 0;
  const size_t begin = in_.offset();
  const std::string_view name = in_.take_word();
  if (const auto id = route_ids_.find(name)) return *id;
  if (const auto id = id_of_name('R', name)) {  // what streams speak of need not be there
    in_.warn("no_route", begin, "no ROUTE " + quoted(name) + " before this; its ID is taken");
    return *id;
  }
  nodes::NearestName nearest(name);
  for (const auto& entry : route_ids_.names()) nearest.offer(entry.first);
  in_.fail(Errc::malformed, begin,
           "no ROUTE " + quoted(name) + " before this" + nearest.hint() +
               " [expected a name that DEF gave]");
  return 0;
}

/// `MULTIPLEREPLACE n { field value ... }`.
void BtTextReader::read_multiple_replace(Commands& out) {
  MultipleFieldReplacement command;
  command.target = read_target_node();
  const size_t opened = (in_.skip_space(), in_.offset());
  if (!in_.ok() || !in_.expect('{', "the node")) return;
  nodes::SeenFields seen;
  while (!in_.accept('}')) {
    if (in_.at_end()) return in_.fail_unclosed(opened, "'}'");
    in_.skip_space();
    const size_t begin = in_.offset();
    const FieldIndex field = read_target_field(command.target, IndexMode::def);
    if (!in_.ok()) return;
    if (!seen.note(field)) return in_.fail(Errc::malformed, begin, "a second value for this field");
    if (!values_.budget().take(in_, 1, sizeof(nodes::FieldEntry))) return;
    const FieldRef target{command.target, field};
    command.values.push_back({field, read_field(target)});
  }
  out.push_back(std::move(command));
}

/// `MULTIPLEINDREPLACE n.field [ i BY value ... ]`.
void BtTextReader::read_multiple_indexed(Commands& out) {
  MultipleIndexedReplacement command;
  command.target = read_list_target();
  const size_t opened = (in_.skip_space(), in_.offset());
  if (!in_.ok() || !in_.expect('[', "the field")) return;
  while (!in_.accept(']')) {
    if (in_.at_end()) return in_.fail_unclosed(opened, "']'");
    if (!values_.budget().take(in_, 1, sizeof(IndexedValue))) return;
    IndexedValue value;
    value.index = in_.uint32();
    if (!expect_word("BY")) return;
    value.value = read_element(command.target);
    command.values.push_back(std::move(value));
  }
  out.push_back(std::move(command));
}

/// `XREPLACE n.field BY value` and its other forms.
void BtTextReader::read_xreplace(Commands& out) {
  XReplace command;
  command.target = read_target(IndexMode::in);
  if (in_.ok() && in_.peek() == '[') read_xreplace_place(command);
  if (!in_.ok() || !expect_word("BY")) return;
  TextCursor ahead = in_;
  const std::string_view word = ahead.take_word();
  if (ahead.peek() == '.' && scene_.find_name(word, scope_).valid()) {
    command.value_from = read_target(IndexMode::def);
  } else if (command.child_field) {
    command.value = read_field(*command.child_field);
  } else {
    const bool is_element = command.position || command.index_from;
    command.value = is_element ? read_element(command.target) : read_field(command.target);
  }
  out.push_back(std::move(command));
}

void BtTextReader::read_xreplace_place(XReplace& command) {
  const FieldDefinition& field =
      scene_.node(command.target.node).definition->field(command.target.field);
  if (!is_multiple(field.type)) return in_.fail_expected("BY, for this field is no list");
  TextCursor ahead = in_;
  ahead.accept('[');
  const std::string_view word = ahead.take_word();
  if (!word.empty() && ahead.peek() == '.') {
    in_.accept('[');
    command.index_from = read_target(IndexMode::def);
    if (!in_.accept(']')) return in_.fail_expected("']'");
  } else {
    command.position = read_position();
  }
  if (in_.ok() && field.type == FieldType::mf_node && in_.accept('.')) read_child_field(command);
}

/// A field of the node in the list. Commands are not carried out here, but what they do to lists is
/// noted; the peer means the node that stood there first.
void BtTextReader::read_child_field(XReplace& command) {
  const FieldRef& target = command.target;
  const auto* now = lists_.list(scene_, target);
  const auto* first = std::get_if<std::vector<NodeId>>(&scene_.value(target.node, target.field));
  in_.skip_space();
  const size_t begin = in_.offset();
  const std::string_view name = in_.peek_word();
  for (const auto* list : {now, first}) {
    const NodeId child = list != nullptr ? lists_.element(scene_, command, *list) : NodeId{};
    if (!child.valid() || !scene_.node(child).definition->find_event_in(name).valid()) continue;
    command.child_field = FieldRef{child, read_target_field(child, IndexMode::in)};
    return;
  }
  in_.fail(Errc::malformed, begin, "no node there has a field " + quoted(name));
}

/// `INSERTPROTO [ PROTO ... ]`.
void BtTextReader::read_insert_proto(Commands& out) {
  const size_t before = scene_.scope(scope_).protos.size();
  const size_t opened = (in_.skip_space(), in_.offset());
  if (!in_.expect('[', "INSERTPROTO")) return;
  while (!in_.accept(']')) {
    if (in_.at_end()) return in_.fail_unclosed(opened, "']'");
    if (in_.peek_word() != "PROTO" && in_.peek_word() != "EXTERNPROTO")
      return in_.fail_expected("PROTO, EXTERNPROTO or ']'");
    read_declaration(scope_);
  }
  const auto& protos = scene_.scope(scope_).protos;
  out.push_back(ProtoInsertion{{protos.begin() + static_cast<ptrdiff_t>(before), protos.end()}});
}

/// `DELETEPROTO [ names ]` or ALL.
void BtTextReader::read_delete_proto(Commands& out) {
  proto_ids_.assign(scene_);
  if (in_.accept_word("ALL")) {
    forget_protos(scene_.scope(scope_).protos);
    return out.push_back(AllProtoDeletion{});
  }
  ProtoDeletion command;
  const size_t opened = (in_.skip_space(), in_.offset());
  if (!in_.expect('[', "DELETEPROTO")) return;
  while (!in_.accept(']')) {
    if (in_.at_end()) return in_.fail_unclosed(opened, "']'");
    if (in_.peek_word().empty()) return in_.fail_expected("the name of a PROTO");
    const size_t begin = in_.offset();
    const std::string_view name = in_.take_word();
    const ProtoId proto = scene_.find_proto(name, scope_);
    const std::optional<uint32_t> id =
        proto.valid() ? scene_.proto(proto).id : id_of_proto_name(name);
    if (!id) return in_.fail(Errc::malformed, begin, "no PROTO " + quoted(name));
    command.proto_ids.push_back(*id);
    if (proto.valid()) forget_protos({proto});
  }
  out.push_back(std::move(command));
}

/// Their names may be given again.
void BtTextReader::forget_protos(const std::vector<ProtoId>& deleted) {
  if (buffer_depth_ > 0) return;
  auto& names = scene_.scope(scope_).proto_names;
  for (const ProtoId proto : deleted) {
    const auto name = names.find(scene_.proto(proto).interface.name);
    if (name != names.end() && name->second == proto) names.erase(name);
  }
}

NodeId BtTextReader::read_target_node() {
  if (in_.peek_word().empty()) return in_.fail_expected("the name of a node"), NodeId{};
  const size_t begin = in_.offset();
  return find_named(in_.take_word(), begin, scope_);
}

FieldRef BtTextReader::read_target(IndexMode mode) {
  FieldRef target;
  target.node = read_target_node();
  if (!in_.ok() || !in_.expect('.', "the name of the node")) return target;
  target.field = read_target_field(target.node, mode);
  return target;
}

FieldRef BtTextReader::read_list_target() {
  const FieldRef target = read_target(IndexMode::in);
  if (!in_.ok()) return target;
  const FieldDefinition& field = scene_.node(target.node).definition->field(target.field);
  if (!is_multiple(field.type)) in_.fail_expected("a list: " + field.name + " is none");
  return target;
}

FieldIndex BtTextReader::read_target_field(NodeId node, IndexMode mode) {
  if (in_.peek_word().empty()) return in_.fail_expected("the name of a field"), FieldIndex{};
  const size_t begin = in_.offset();
  const std::string_view name = in_.take_word();
  const NodeDefinition& definition = *scene_.node(node).definition;
  FieldIndex field = mode == IndexMode::in ? definition.find_event_in(name) : FieldIndex{};
  if (!field.valid()) field = find_field(definition, name, begin);
  if (!in_.ok() || definition.index_in(mode, field)) return field;
  in_.fail(Errc::malformed, begin,
           quoted(name) + " of " + definition.name +
               (definition.field(field).kind == nodes::EventKind::field ? " is a " : " is an ") +
               std::string(to_string(definition.field(field).kind)) +
               (mode == IndexMode::in
                    ? " [expected an exposedField or eventIn; MULTIPLEREPLACE reaches fields]"
                    : " [expected a field or exposedField]"));
  return {};
}

/// `[i]`, `[-1]`, `[LAST]`, `[FIRST]`; none if no bracket stands here.
std::optional<Position> BtTextReader::read_position() {
  if (!in_.accept('[')) return std::nullopt;
  Position position;
  if (in_.accept_word("LAST")) {
    position.kind = Position::Kind::last;
  } else if (in_.accept_word("FIRST")) {
    position.kind = Position::Kind::first;
  } else {
    in_.skip_space();
    const size_t begin = in_.offset();
    const int32_t index = in_.int32();
    if (index < -1)
      in_.fail(
          Errc::malformed, begin,
          "an index of " + std::to_string(index) + " [expected 0 or more, or -1 for the last]");
    if (index == -1) position.kind = Position::Kind::last;
    if (index == 0) position.kind = Position::Kind::first;
    if (index > 0) position.index = static_cast<uint32_t>(index);
  }
  if (!in_.accept(']')) in_.fail_expected("']'");
  return position;
}

bool BtTextReader::expect_word(std::string_view word) {
  if (in_.ok() && in_.accept_word(word)) return true;
  in_.fail_expected(word);
  return false;
}

FieldValue BtTextReader::read_field(const FieldRef& target) {
  if (!in_.ok()) return false;
  const FieldDefinition& field = scene_.node(target.node).definition->field(target.field);
  return read_value(without_default(field, field.type), scope_);
}

FieldValue BtTextReader::read_element(const FieldRef& target) {
  if (!in_.ok()) return false;
  const FieldDefinition& field = scene_.node(target.node).definition->field(target.field);
  return read_value(without_default(field, element_type(field.type)), scope_);
}

}  // namespace afx::bifs
