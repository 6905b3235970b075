// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/text_names.h"

#include "nodes/text_cursor.h"

namespace afx::bifs {

NodeSet TextNames::begin_command(const nodes::Scene& scene, const Command& command) {
  scene_ = &scene;
  if (std::holds_alternative<SceneReplacement>(command)) forget_scene();
  return std::exchange(fresh_, new_nodes(scene, command, known_));
}

/// Names mean the nodes of the new scene from here on.
void TextNames::forget_scene() {
  known_.clear();
  names_.clear();
  taken_.clear();
  routes_.clear();
  taken_routes_.clear();
}

std::string_view TextNames::name(nodes::NodeId id) {
  const auto known = names_.find(id);
  if (known != names_.end()) return known->second;
  const nodes::Node& node = scene_->node(id);
  if (node.name.empty() && node.id == 0) return {};
  return names_[id] = unique(taken_[node.scope], node.name, 'N', node.id);
}

std::string TextNames::route_name(const nodes::Route& route) {
  if (route.id == 0) return {};
  const nodes::ScopeId scope = scene_->node(route.from).scope;
  std::string name = unique(taken_routes_[scope], route.name, 'R', route.id);
  if (scope == nodes::Scene::kMain) routes_[route.id] = name;
  return name;
}

std::string TextNames::route_name(uint32_t id) const {
  const auto found = routes_.find(id);
  return found != routes_.end() ? found->second : "R" + std::to_string(id - 1);
}

/// The own name, or the letter and the ID minus 1, or that with a number behind it.
std::string TextNames::unique(Names& taken, std::string_view own, char letter, uint32_t id) {
  if (nodes::is_identifier(own) && taken.emplace(own).second) return std::string(own);
  const std::string made = letter + std::to_string(id == 0 ? 0 : id - 1);
  std::string name = made;
  while (!taken.insert(name).second) name = made + '_' + std::to_string(++copies_[made] + 1);
  return name;
}

}  // namespace afx::bifs
