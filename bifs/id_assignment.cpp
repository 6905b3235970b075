// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/id_assignment.h"

#include <charconv>

namespace afx::bifs {

using nodes::NodeId;

namespace {

/// The number behind a prefix, in decimal without leading zeros.
std::optional<uint32_t> number_behind(std::string_view prefix, std::string_view name) {
  if (!name.starts_with(prefix)) return std::nullopt;
  name.remove_prefix(prefix.size());
  if (name.starts_with('0') && name.size() > 1) return std::nullopt;
  uint32_t number = 0;
  const auto [stop, failure] = std::from_chars(name.data(), name.data() + name.size(), number);
  const bool whole = failure == std::errc{} && stop == name.data() + name.size();
  if (!whole || number >= (uint32_t{1} << 31) - 1) return std::nullopt;
  return number;
}

}  // namespace

std::optional<uint32_t> id_of_name(char letter, std::string_view name) {
  const std::optional<uint32_t> number = number_behind({&letter, 1}, name);
  return number ? std::optional(*number + 1) : std::nullopt;
}

std::optional<uint32_t> id_of_proto_name(std::string_view name) {
  const std::optional<uint32_t> number = number_behind("Proto", name);
  return number && *number > 0 ? number : std::nullopt;
}

uint32_t TakenIds::next(std::optional<uint32_t> wanted) {
  if (wanted && !taken_.contains(*wanted)) return *wanted;
  while (taken_.contains(next_)) ++next_;
  return next_;
}

uint32_t TakenIds::take_new(std::optional<uint32_t> wanted) {
  const uint32_t id = next(wanted);
  take(id);
  return id;
}

void assign_node_ids(nodes::Scene& scene, NodeId first) {
  std::map<nodes::ScopeId, TakenIds> taken;
  for (NodeId id = first; id.value < scene.node_count(); ++id.value) {
    nodes::Node& node = scene.node(id);
    TakenIds& of_scope = taken[node.scope];
    if (node.id == 0 && !node.name.empty()) node.id = of_scope.next(id_of_name('N', node.name));
    if (node.id != 0) of_scope.take(node.id);
  }
}

void ProtoIds::assign(nodes::Scene& scene) {
  for (; seen_ < scene.proto_count(); ++seen_) {
    nodes::Proto& proto = scene.proto(nodes::ProtoId{seen_});
    if (proto.id == 0) proto.id = taken_.next(id_of_proto_name(proto.interface.name));
    taken_.take(proto.id);
  }
}

uint32_t RouteIds::id_of_new(std::string_view name, bool by_name) {
  const uint32_t id = taken_.take_new(by_name ? id_of_name('R', name) : std::nullopt);
  names_[std::string(name)] = id;
  return id;
}

void RouteIds::note(std::string_view name, uint32_t id) {
  taken_.take(id);
  names_[std::string(name)] = id;
}

std::optional<uint32_t> RouteIds::find(std::string_view name) const {
  const auto found = names_.find(name);
  return found == names_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace afx::bifs
