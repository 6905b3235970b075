// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Source: ISO/IEC 14772-1:1997 (VRML97), grammar (clause not checked).
#include "nodes/scene_reader.h"

#include <algorithm>

#include "nodes/definitions.h"
#include "nodes/nearest_name.h"
#include "nodes/scene_text_reader.h"

namespace afx::nodes {

namespace {

/// Words that begin the parts of BT which are not scenes: object descriptors and timed commands.
constexpr std::string_view kCommandWords[] = {"APPEND",
                                              "AT",
                                              "DELETE",
                                              "DELETEPROTO",
                                              "GLOBALQP",
                                              "INSERT",
                                              "INSERTPROTO",
                                              "InitialObjectDescriptor",
                                              "MULTIPLEINDREPLACE",
                                              "MULTIPLEREPLACE",
                                              "RAP",
                                              "REMOVE",
                                              "REPLACE",
                                              "UPDATE",
                                              "XDELETE",
                                              "XREPLACE",
                                              "ObjectDescriptor"};

constexpr size_t kFewFields = 24;

}  // namespace

Result<Scene> read_scene_text(std::string_view text, const Limits& limits, Diagnostics& diagnostics,
                              const SceneReadOptions& options) {
  return SceneTextReader(text, limits, diagnostics, options).read();
}

bool SeenFields::note(FieldIndex field) {
  if (few_.size() < kFewFields) {
    if (std::find(few_.begin(), few_.end(), field) != few_.end()) return false;
    few_.push_back(field);
    return true;
  }
  return std::find(few_.begin(), few_.end(), field) == few_.end() && many_.insert(field).second;
}

SceneTextReader::Depth::Depth(SceneTextReader& reader) : reader_(reader) {
  if (++reader_.depth_ > reader_.limits_.scene_depth)
    reader_.in_.fail(Errc::limit_exceeded, reader_.in_.offset(),
                     "nodes nested deeper than the limit scene_depth, " +
                         std::to_string(reader_.limits_.scene_depth));
}

SceneTextReader::SceneTextReader(std::string_view text, const Limits& limits,
                                 Diagnostics& diagnostics, const SceneReadOptions& options)
    : limits_(limits),
      in_(text, diagnostics, &options.passed),
      values_(in_, limits, options.load_file),
      like_gpac_(options.like_gpac) {
  in_.keep_double_backslashes(like_gpac_);
}

Result<Scene> SceneTextReader::read() {
  read_header();
  while (!in_.at_end()) read_statement(Scene::kMain);
  if (!in_.ok()) return in_.error();
  return std::move(scene_);
}

void SceneTextReader::read_header() {
  const std::string_view text = in_.text();
  in_.skip_byte_order_mark();
  const std::string_view first = text.substr(in_.offset(), 40);
  if (first.starts_with("#VRML V1.0"))
    in_.fail(Errc::unsupported, in_.offset(),
             "this is VRML 1.0 [expected VRML 2.0 (VRML97) or BT]");
  if (first.starts_with("#X3D"))
    in_.fail(Errc::unsupported, in_.offset(),
             "this is X3D in the classic encoding [expected VRML97 or BT]");
}

void SceneTextReader::read_statement(ScopeId scope) {
  if (read_declaration(scope)) return;
  const NodeId root = read_node(scope);
  if (in_.ok()) scene_.add_root(root, scope);
}

/// PROTO, EXTERNPROTO and ROUTE may stand beside nodes and in nodes.
bool SceneTextReader::read_declaration(ScopeId scope) {
  if (in_.accept_word("PROTO")) return read_proto(scope), true;
  if (in_.accept_word("EXTERNPROTO")) return read_extern_proto(scope), true;
  if (in_.accept_word("ROUTE")) return read_route(scope, {}), true;
  if (in_.peek_word() != "DEF") return false;
  // Only the word after the name tells a ROUTE from a node.
  TextCursor ahead = in_;
  ahead.accept_word("DEF");
  if (ahead.peek_word().empty()) return false;
  (void)ahead.take_word();
  if (ahead.peek_word() != "ROUTE") return false;
  in_.accept_word("DEF");
  const std::string_view name = read_def_name("ROUTE");
  in_.accept_word("ROUTE");
  return read_route(scope, name), true;
}

NodeId SceneTextReader::read_node(ScopeId scope) {
  if (in_.accept_word("USE")) return read_use(scope);
  const std::string_view name = in_.accept_word("DEF") ? read_def_name("node") : "";
  return in_.ok() ? read_new_node(scope, name) : NodeId{};
}

NodeId SceneTextReader::read_node_or_null(ScopeId scope) {
  return in_.accept_word("NULL") ? NodeId{} : read_node(scope);
}

NodeId SceneTextReader::read_use(ScopeId scope) {
  if (in_.peek_word().empty()) return in_.fail_expected("the name of a node after USE"), NodeId{};
  const size_t begin = in_.offset();
  const std::string_view name = in_.take_word();
  const NodeId id = find_named(name, begin, scope);
  if (id.valid() && open_nodes_[id.value] != 0) {
    in_.fail(Errc::malformed, begin, "the node " + quoted(name) + " would stand inside itself");
    return {};
  }
  return id;
}

NodeId SceneTextReader::find_named(std::string_view name, size_t begin, ScopeId scope) {
  const NodeId id = scene_.find_name(name, scope);
  if (id.valid()) return id;
  NearestName nearest(name);
  for (const auto& entry : scene_.scope(scope).names) nearest.offer(entry.first);
  in_.fail(Errc::malformed, begin,
           "no node " + quoted(name) + " before this" + nearest.hint() +
               " [expected a name that DEF gave]");
  return {};
}

/// What comes after DEF.
std::string_view SceneTextReader::read_def_name(std::string_view of) {
  if (in_.peek_word().empty())
    return in_.fail_expected("the name of a " + std::string(of) + " after DEF"), "";
  const size_t begin = in_.offset();
  const std::string_view name = in_.take_word();
  if (!is_identifier(name))
    return in_.fail(Errc::malformed, begin, quoted(name) + " is a keyword [expected a name]"), "";
  return name;
}

NodeId SceneTextReader::read_new_node(ScopeId scope, std::string_view def_name) {
  const Depth depth(*this);
  const size_t name_begin = in_.offset() - def_name.size();
  if (in_.peek_word().empty()) return in_.fail_expected("a node"), NodeId{};
  const size_t begin = in_.offset();
  const std::string_view type = in_.take_word();
  const NodeId id = make_node(type, begin, scope);
  if (!in_.ok()) return {};
  if (!def_name.empty()) give_name(id, def_name, name_begin);
  open_nodes_.resize(scene_.node_count());
  open_nodes_[id.value] = 1;
  const TextCursor::Context outer = std::exchange(in_.context, {type, {}});
  read_body(id);
  in_.context = outer;
  open_nodes_[id.value] = 0;
  return id;
}

NodeId SceneTextReader::make_node(std::string_view type, size_t begin, ScopeId scope) {
  // No PROTO has the name of a node, so the order of the look-ups is free.
  const NodeDefinition* definition = definitions().find(type);
  const ProtoId proto = definition == nullptr ? scene_.find_proto(type, scope) : ProtoId{};
  if (!values_.budget().take(in_, 1, sizeof(Node))) return {};
  if (definition != nullptr) return scene_.add(*definition, scope);
  if (proto.valid() && !open_protos_.contains(proto)) {
    if (scene_.proto(proto).scope != scope) outer_uses_.emplace(scope, std::string(type));
    return scene_.add_instance(proto, scope);
  }
  if (proto.valid()) {
    in_.fail(Errc::malformed, begin, "the PROTO " + quoted(type) + " would stand inside itself");
  } else if (std::find(std::begin(kCommandWords), std::end(kCommandWords), type) !=
             std::end(kCommandWords)) {
    in_.fail(Errc::unsupported, begin,
             quoted(type) +
                 " is not read here: this is a scene without object descriptors and commands");
  } else {
    NearestName nearest(type);
    for (const NodeDefinition& node : definitions().nodes()) nearest.offer(node.name);
    for (ScopeId at = scope; at.valid(); at = scene_.scope(at).parent)
      for (const auto& entry : scene_.scope(at).proto_names) nearest.offer(entry.first);
    in_.fail(Errc::malformed, begin, "no node type " + quoted(type) + nearest.hint());
  }
  return {};
}

void SceneTextReader::give_name(NodeId id, std::string_view name, size_t begin) {
  auto& names = scene_.scope(scene_.node(id).scope).names;
  std::string unique(name);
  const bool twice = names.contains(name);
  if (twice) {
    const std::string scope_prefix = std::to_string(scene_.node(id).scope.value) + ' ';
    uint32_t& copies = name_copies_[scope_prefix + unique];
    do {
      unique = std::string(name) + '_' + std::to_string(copies++ + 2);
    } while (names.contains(unique));
    in_.warn(
        "def_twice", begin,
        "the name " + quoted(name) + " was given before; this node is called '" + unique + "'");
  }
  names.emplace(unique, id);
  if (twice) names[std::string(name)] = id;  // USE means the nearest before it
  scene_.node(id).name = std::move(unique);
}

void SceneTextReader::read_body(NodeId id) {
  const size_t opened = (in_.skip_space(), in_.offset());
  SeenFields seen;
  if (!in_.expect('{', "the node type")) return;
  while (!in_.accept('}')) {
    if (in_.at_end()) return in_.fail_unclosed(opened, "'}'");
    if (scene_.node(id).definition->script && find_event_kind(in_.peek_word())) {
      read_own_field(id);
    } else if (!read_declaration(scene_.node(id).scope)) {
      read_field(id, seen);
    }
  }
}

FieldIndex SceneTextReader::find_field(const NodeDefinition& definition, std::string_view name,
                                       size_t begin) {
  const FieldIndex index = definition.find(name);
  if (index.valid()) return index;
  // An exposedField also answers to set_x and x_changed, for IS.
  FieldIndex alias = definition.find_event_in(name);
  if (!alias.valid()) alias = definition.find_event_out(name);
  if (alias.valid()) return alias;
  NearestName nearest(name);
  for (const FieldDefinition& field : definition.fields()) nearest.offer(field.name);
  in_.context.field = {};
  in_.fail(Errc::malformed, begin, "no field " + quoted(name) + nearest.hint());
  return {};
}

void SceneTextReader::read_field(NodeId id, SeenFields& seen) {
  const std::string_view name = in_.peek_word();
  if (name.empty()) return in_.fail_expected("a field or '}'");
  const size_t begin = in_.offset();
  in_.take_word();
  const FieldIndex field = find_field(*scene_.node(id).definition, name, begin);
  if (!field.valid()) return;
  if (!seen.note(field))
    return in_.fail(Errc::malformed, begin, "a second value for " + quoted(name));
  const std::string_view outer = std::exchange(in_.context.field, name);
  read_field_value(id, field);
  in_.context.field = outer;
}

void SceneTextReader::read_field_value(NodeId id, FieldIndex index) {
  if (in_.accept_word("IS")) return read_is(id, index);
  const FieldDefinition& field = scene_.node(id).definition->field(index);
  if (!field.has_value())
    return in_.fail_expected("IS, for an " + std::string(to_string(field.kind)) + " has no value");
  if (!values_.budget().take(in_, 1, sizeof(FieldEntry))) return;
  FieldValue value = read_value(field, scene_.node(id).scope);
  scene_.node(id).values.push_back(
      {index, std::move(value)});  // read_field sees to it that there is one
}

FieldValue SceneTextReader::read_value(const FieldDefinition& field, ScopeId scope) {
  if (is_node(field.type)) return read_nodes(field, scope);
  if (field.bytes) return values_.read_bytes();
  if (field.type == FieldType::sf_command_buffer) return read_command_buffer(scope);
  return values_.read(field.type);
}

CommandBuffer SceneTextReader::read_command_buffer(ScopeId) {
  return {std::string(in_.braces()), nullptr};
}

/// A field that a Script declares: kind, type, name, then value or IS.
void SceneTextReader::read_own_field(NodeId script) {
  const InterfaceRules rules;
  const size_t begin = in_.offset();
  FieldDefinition field = InterfaceReader(in_, values_, rules).read_head();
  if (!in_.ok() || !values_.budget().take(in_, 1, sizeof(FieldDefinition) + field.name.size()))
    return;
  if (field.kind == EventKind::exposed_field)
    return in_.fail(Errc::malformed, begin,
                    "a Script has no exposedField [expected field, eventIn or eventOut]");
  const std::string name = field.name;
  const bool has_value = field.has_value();
  const FieldIndex index = scene_.own_definition(script).add(std::move(field));
  if (!index.valid())
    return in_.fail(Errc::malformed, begin,
                    "a second field " + quoted(name) + ", or more than 65535 fields");
  if (!has_value && in_.peek_word() != "IS") return;
  const std::string_view outer = std::exchange(in_.context.field, name);
  read_field_value(script, index);
  in_.context.field = outer;
}

FieldValue SceneTextReader::read_nodes(const FieldDefinition& field, ScopeId scope) {
  // The field may move while its nodes are read: a Script may get more fields.
  FieldDefinition held;
  held.name = field.name;
  held.data_type = field.data_type;
  const TextCursor::Context context = in_.context;
  if (!is_multiple(field.type)) return read_child(held, scope);
  std::vector<NodeId> list;
  const size_t opened = (in_.skip_space(), in_.offset());
  if (!in_.accept('[')) {
    list.push_back(read_child(held, scope));
    return list;
  }
  while (!in_.accept(']')) {
    if (in_.at_end()) {
      in_.fail_unclosed(opened, "']'");
      break;
    }
    if (!values_.budget().take(in_, 1, sizeof(NodeId))) break;
    list.push_back(read_child(held, scope));
    in_.context = context;
  }
  return list;
}

NodeId SceneTextReader::read_child(const FieldDefinition& field, ScopeId scope) {
  in_.skip_space();
  const size_t begin = in_.offset();
  const NodeId child = read_node_or_null(scope);
  if (!in_.ok() || scene_.may_stand(child, field)) return child;
  in_.fail(Errc::malformed, begin,
           "a " + scene_.type_name(child) + " may not stand here [expected a node of type " +
               std::string(definitions().data_type_name(field.data_type)) + "]");
  return {};
}

}  // namespace afx::nodes
