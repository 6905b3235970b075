// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Statements of BT, their times, and the scene that the commands begin with.
#include "bifs/bt_reader.h"

#include <algorithm>
#include <iterator>

#include "bifs/bt_text_reader.h"
#include "bifs/top_node.h"

namespace afx::bifs {

using nodes::NodeId;
using nodes::ProtoId;
using nodes::quoted;
using nodes::Scene;
using nodes::ScopeId;
using nodes::TextCursor;

Result<Presentation> read_bt(std::string_view text, const Limits& limits, Diagnostics& diagnostics,
                             const nodes::SceneReadOptions& options) {
  return BtTextReader(text, limits, diagnostics, options).read_presentation();
}

Result<Presentation> BtTextReader::read_presentation() {
  read_header();
  begin_epoch();
  while (!in_.at_end()) read_top();
  end_scene();
  end_epoch();
  if (!in_.ok()) return in_.error();
  merge_units();
  out_.scene = std::move(scene_);
  return std::move(out_);
}

void BtTextReader::read_top() {
  in_.skip_space();
  const size_t begin = in_.offset();
  command_begin_ = begin;
  const std::string_view word = in_.peek_word();
  if (is_instance(word)) return read_scene_statement(begin);
  if (word == "InitialObjectDescriptor" || word == "ObjectDescriptor") {
    if (has_initial_ || !scene_units_.empty() || !descriptor_units_.empty() ||
        scene_.node_count() > 0)
      return in_.fail(Errc::malformed, begin,
                      quoted(word) + " behind the beginning [expected it first, and once]");
    in_.take_word();
    has_initial_ = true;
    out_.initial = read_initial_object();
  } else if (word == "AT" || word == "RAP") {
    end_scene();
    read_timed();
  } else {
    read_scene_statement(begin);
  }
}

/// Whether an instance of a PROTO of that name stands here, which may be called as a command is.
bool BtTextReader::is_instance(std::string_view word) const {
  TextCursor ahead = in_;
  ahead.take_word();
  return ahead.peek() == '{' && scene_.find_proto(word).valid();
}

/// A command outside of AT, or a part of the scene that no command begins.
void BtTextReader::read_scene_statement(size_t begin) {
  Commands commands;
  OdCommands descriptors;
  const std::string_view word = in_.peek_word();
  const bool is_node = is_instance(word);
  if (!is_node && read_descriptor_command(word, descriptors)) {
    if (!in_.ok()) return;
    auto& unit = std::get<OdCommands>(unit_at(0, true, true).commands);
    unit.insert(unit.end(), descriptors.begin(), descriptors.end());
    return;
  }
  if (!is_node && read_scene_command(word, commands)) {
    if (!in_.ok()) return;
    auto& unit = std::get<Commands>(unit_at(0, false, true).commands);
    std::move(commands.begin(), commands.end(), std::back_inserter(unit));
    return;
  }
  if (!scene_open_)
    return in_.fail(Errc::malformed, begin,
                    "found " + quoted(word.empty() ? in_.text().substr(begin, 1) : word) +
                        " behind the scene [expected AT or a command]");
  read_statement(Scene::kMain);
  if (scene_.roots().size() > root_begins_.size()) root_begins_.push_back(begin);
}

/// What has been read of the scene becomes a command of time 0.
void BtTextReader::end_scene() {
  if (!scene_open_ || !in_.ok()) return;
  scene_open_ = false;
  nodes::Scope& scope = scene_.scope();
  if (scope.roots.empty() && scope.routes.empty() && scope.protos.empty()) return;
  read_buffers();
  SceneReplacement command;
  settle_roots(command);
  command.protos = scope.protos;
  command.routes = std::exchange(scope.routes, {});
  for (nodes::Route& route : command.routes)
    if (!route.name.empty()) route.id = route_ids_.id_of_new(route.name, !like_gpac_);
  auto& commands = std::get<Commands>(unit_at(0, false, true).commands);
  commands.insert(commands.begin(), std::move(command));
}

/// A scene has one top node, of a type that may stand there: others go under a Group.
void BtTextReader::settle_roots(SceneReplacement& command) {
  std::vector<NodeId> roots = std::exchange(scene_.scope().roots, {});
  if (roots.empty()) return;
  if (roots.size() == 1 && may_be_top_node(scene_, roots[0])) {
    command.root = roots[0];
    return;
  }
  size_t refused = 0;
  const Result<NodeId> group = put_in_group(scene_, roots, refused);
  if (!group.ok()) return in_.fail(group.error().code, root_begins_[refused], group.error().text);
  command.root = group.value();
  in_.warn("top_nodes", root_begins_.back(),
           roots.size() == 1 ? "a " + scene_.type_name(roots[0]) +
                                   " may not be the top node; it is put in a Group"
                             : std::to_string(roots.size()) + " top nodes are put in a Group");
}

/// `[RAP] AT [D]time [IN stream] { commands }`.
void BtTextReader::read_timed() {
  const bool random_access = in_.accept_word("RAP");
  if (!expect_word("AT")) return;
  const uint64_t time = read_time();
  if (in_.accept_word("IN") || in_.accept_word("in")) {
    in_.skip_space();
    const size_t begin = in_.offset();
    const uint32_t stream = in_.uint32();
    const EsDescriptor* const scene = scene_stream(out_.initial);
    const EsDescriptor* const descriptors = object_descriptor_stream(out_.initial);
    const bool known = stream == (scene != nullptr ? scene->es_id : 1U) ||
                       (descriptors != nullptr && stream == descriptors->es_id);
    if (!known)
      in_.fail(Errc::unsupported, begin,
               "commands in the stream " + std::to_string(stream) +
                   " [expected the first scene stream or that of object descriptors]");
  }
  last_time_ = time;
  read_commands(time, random_access);
}

uint64_t BtTextReader::read_time() {
  in_.skip_space();
  const size_t begin = in_.offset();
  const bool relative = in_.peek() == 'D';
  if (relative) in_.seek(begin + 1);
  const uint64_t time = in_.uint64();
  constexpr uint64_t kMostTime = uint64_t{1} << 62;
  if (time > kMostTime || (relative && last_time_ > kMostTime - time))
    in_.fail(Errc::malformed, begin, "a time beyond 2^62 ticks");
  return relative ? last_time_ + time : time;
}

void BtTextReader::read_commands(uint64_t time, bool random_access) {
  const size_t opened = (in_.skip_space(), in_.offset());
  if (!in_.expect('{', "the time")) return;
  Commands commands;
  OdCommands descriptors;
  while (!in_.accept('}')) {
    if (in_.at_end()) return in_.fail_unclosed(opened, "'}'");
    const std::string_view word = in_.peek_word();
    if (!read_descriptor_command(word, descriptors) && !read_scene_command(word, commands))
      return in_.fail_expected("a command or '}'");
    if (!values_.budget().take(in_, 1, sizeof(Command))) return;
  }
  read_buffers();
  if (!in_.ok()) return;
  if (!descriptors.empty()) {
    auto& unit = std::get<OdCommands>(unit_at(time, true, random_access).commands);
    std::move(descriptors.begin(), descriptors.end(), std::back_inserter(unit));
  }
  if (!commands.empty()) {
    auto& unit = std::get<Commands>(unit_at(time, false, random_access).commands);
    std::move(commands.begin(), commands.end(), std::back_inserter(unit));
  }
}

/// The last access unit of a stream if it is of that time, or a new one behind it.
AccessUnit& BtTextReader::unit_at(uint64_t time, bool descriptors, bool random_access) {
  std::vector<AccessUnit>& units = descriptors ? descriptor_units_ : scene_units_;
  if (!units.empty() && time < units.back().time)
    in_.fail(Errc::malformed, command_begin_,
             "commands at " + std::to_string(time) + " behind those at " +
                 std::to_string(units.back().time) + " [expected times that do not go back]");
  if (!units.empty() && units.back().time == time) return units.back();
  AccessUnit& unit = units.emplace_back();
  unit.time = time;
  unit.random_access = random_access || units.size() == 1;  // a stream can be begun at its begin
  if (descriptors) unit.commands = OdCommands();
  return unit;
}

/// The units of both streams by time, at the same time the scene's first.
void BtTextReader::merge_units() {
  std::merge(std::move_iterator(scene_units_.begin()), std::move_iterator(scene_units_.end()),
             std::move_iterator(descriptor_units_.begin()),
             std::move_iterator(descriptor_units_.end()), std::back_inserter(out_.units),
             [](const AccessUnit& a, const AccessUnit& b) { return a.time < b.time; });
}

/// From here on IDs and names are those of a new scene.
void BtTextReader::begin_epoch() {
  epoch_ = NodeId{scene_.node_count()};
  nodes::Scope& scope = scene_.scope();
  scope.names.clear();
  scope.proto_names.clear();
  scope.protos.clear();
  scope.routes.clear();
  scope.roots.clear();
  route_ids_ = {};
  lists_.clear();
}

void BtTextReader::end_epoch() {
  read_buffers();
  if (!in_.ok()) return;
  assign_node_ids(scene_, like_gpac_ ? NodeId{uint32_t{0}} : epoch_);  // GPAC goes on counting
  proto_ids_.assign(scene_);
  assign_body_route_ids();
}

/// The ROUTEs in the bodies of PROTOs that have been declared since: IDs count for themselves
/// there.
void BtTextReader::assign_body_route_ids() {
  for (; bodies_seen_ < scene_.proto_count(); ++bodies_seen_) {
    RouteIds ids;
    for (nodes::Route& route : scene_.scope(scene_.proto(ProtoId{bodies_seen_}).body).routes)
      if (!route.name.empty()) route.id = ids.id_of_new(route.name, !like_gpac_);
  }
}

nodes::CommandBuffer BtTextReader::read_command_buffer(ScopeId scope) {
  in_.skip_space();
  const size_t begin = in_.offset() + 1;
  const std::string_view text = in_.braces();
  TextCursor inside = in_;
  inside.seek(begin);
  inside.skip_space();
  if (!in_.ok() || inside.offset() >= begin + text.size()) return {};  // nothing in it
  if (buffer_depth_ >= kMaxBufferDepth) {
    in_.fail(Errc::limit_exceeded, begin,
             "command buffers nested deeper than " + std::to_string(kMaxBufferDepth));
    return {};
  }
  auto commands = std::make_shared<BufferedCommands>();
  buffers_.push_back({begin, scope, buffer_depth_ + 1, commands});
  return {{}, std::move(commands)};
}

/// Command buffers may speak of nodes that come after them.
void BtTextReader::read_buffers() {
  while (!buffers_.empty() && in_.ok()) {
    const Buffer buffer = buffers_.front();
    buffers_.pop_front();
    const TextCursor behind = in_;
    const ScopeId scope = std::exchange(scope_, buffer.scope);
    buffer_depth_ = buffer.depth;
    in_.seek(buffer.begin);
    while (!in_.accept('}') && in_.ok()) {
      if (!read_scene_command(in_.peek_word(), buffer.commands->commands))
        return in_.fail_expected("a command of the scene or '}'");
      if (!values_.budget().take(in_, 1, sizeof(Command))) return;
    }
    buffer_depth_ = 0;
    scope_ = scope;
    if (in_.ok()) in_ = behind;
  }
}

}  // namespace afx::bifs
