// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The access units of a presentation.
#include "conformance/generator/scene_maker.h"

#include <utility>

#include "bifs/apply.h"
#include "nodes/definitions.h"

namespace afx::conformance {

using bifs::Command;
using nodes::Scene;

namespace {

nodes::NodeDataType top_node() {
  return nodes::definitions().find_data_type("SFTopNode").value_or(nodes::kWorldNode);
}

}  // namespace

bifs::Presentation random_scene(Choices& choices, SceneNames names) {
  return SceneMaker(choices, names).make();
}

SceneMaker::SceneMaker(Choices& choices, SceneNames names) : choices_(choices), names_(names) {}

bifs::Presentation SceneMaker::make() {
  fits_ = choices_.below(2) == 0;
  nodes_left_ = choices_.one_in(32) ? 300 : 30;
  uint64_t time = choices_.one_in(8) ? choices_.below(5000) : 0;
  do {
    std::vector<Command> commands;
    if (out_.units.empty() || choices_.one_in(10)) {
      commands.emplace_back(new_scene());
      apply(commands.back());
    }
    while (commands.empty() || choices_.below(3) != 0) add_command(commands);
    const bool random_access = out_.units.empty() || choices_.one_in(3);
    out_.units.push_back({time, random_access, std::move(commands)});
    time += 1 + choices_.below(2000);
  } while (choices_.below(3) != 0);
  for (const auto& [node, values] : created_) scene_.node(node).values = values;
  scene_.scope().roots.clear();
  scene_.scope().routes.clear();
  return std::move(out_);
}

bifs::SceneReplacement SceneMaker::new_scene() {
  known_.clear();
  changed_ = {};
  route_ids_.clear();
  scene_.scope().names.clear();  // IDs and names begin anew
  bifs::SceneReplacement scene;
  scene.protos = random_protos(Scene::kMain, 0);
  if (!choices_.one_in(30)) scene.root = random_node(top_node(), Scene::kMain, 0);
  scene.routes = random_routes(Scene::kMain);
  return scene;
}

/// Adds one command, or a pair; where the scene has nothing to be changed, one that does nothing.
void SceneMaker::add_command(std::vector<Command>& commands) {
  changed_ = {};
  if (auto command = random_command()) {
    commands.push_back(std::move(*command));
    apply(commands.back());
    const auto* quantizer = std::get_if<bifs::GlobalQuantizer>(&commands.back());
    // Nothing is to be coded under it.
    if (quantizer != nullptr && quantizer->node.valid())
      commands.emplace_back(bifs::GlobalQuantizer{});
  } else if (commands.empty()) {
    commands.emplace_back(bifs::GlobalQuantizer{});
  }
}

void SceneMaker::apply(const Command& command) {
  // Names of PROTOs stay, so that none comes twice.
  if (!std::holds_alternative<bifs::ProtoDeletion>(command) &&
      !std::holds_alternative<bifs::AllProtoDeletion>(command))
    (void)bifs::apply_command(scene_, command);
}

}  // namespace afx::conformance
