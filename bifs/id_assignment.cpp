// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/id_assignment.h"

#include <charconv>
#include <vector>

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

/// Proto<k> has the ID k; 0 is none here.
std::optional<uint32_t> id_of_proto_name(std::string_view name) {
  const std::optional<uint32_t> number = number_behind("Proto", name);
  return number && *number > 0 ? number : std::nullopt;
}

}  // namespace

std::optional<uint32_t> id_of_name(char letter, std::string_view name) {
  const std::optional<uint32_t> number = number_behind({&letter, 1}, name);
  return number ? std::optional(*number + 1) : std::nullopt;
}

uint32_t TakenIds::take_new(std::optional<uint32_t> wanted) {
  if (wanted && taken_.insert(*wanted).second) return *wanted;
  while (!taken_.insert(next_).second) ++next_;
  return next_++;
}

void assign_node_ids(nodes::Scene& scene, NodeId first) {
  std::vector<TakenIds> taken(scene.scope_count());  // since `first`
  std::vector<TakenIds> ever(scene.scope_count());
  for (NodeId id{uint32_t{0}}; id.value < scene.node_count(); ++id.value) {
    const nodes::Node& node = scene.node(id);
    if (node.id == 0) continue;
    ever[node.scope.value].take(node.id);
    if (id >= first) taken[node.scope.value].take(node.id);
  }
  for (NodeId id = first; id.value < scene.node_count(); ++id.value) {
    nodes::Node& node = scene.node(id);
    if (node.name.empty() || node.id != 0) continue;
    const size_t scope = node.scope.value;
    const std::optional<uint32_t> wanted = id_of_name('N', node.name);
    const bool free = wanted && !taken[scope].is_taken(*wanted);
    node.id = free ? *wanted : ever[scope].take_new(std::nullopt);
    taken[scope].take(node.id);
    ever[scope].take(node.id);
  }
}

void assign_proto_ids(nodes::Scene& scene) {
  TakenIds taken;
  for (size_t i = 0; i < scene.proto_count(); ++i)
    if (const uint32_t id = scene.proto(nodes::ProtoId{i}).id; id != 0) taken.take(id);
  for (size_t i = 0; i < scene.proto_count(); ++i) {
    nodes::Proto& proto = scene.proto(nodes::ProtoId{i});
    if (proto.id == 0) proto.id = taken.take_new(id_of_proto_name(proto.interface.name));
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
