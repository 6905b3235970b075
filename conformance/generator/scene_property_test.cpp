// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "conformance/generator/scene_property.h"

#include <gmock/gmock.h>

#include <map>
#include <set>

#include "bifs/bt_writer.h"
#include "conformance/conformance_test_support.h"
#include "conformance/generator/random_scene.h"
#include "conformance/generator/shrink.h"
#include "nodes/definitions.h"

namespace afx::conformance {
namespace {

using bifs::Presentation;
using nlohmann::json;
using testing::HasSubstr;

std::string bt_text(Presentation presentation) {
  std::string text;
  bifs::BtWriter writer([&text](std::string_view piece) {
    text += piece;
    return Status();
  });
  Diagnostics ignored;
  EXPECT_TRUE(play(presentation, writer, ignored).ok());
  return text;
}

TEST(SceneGenerator, OurCodersAndTextsHold) {
  const auto failed = find_failure(scene_property(), {.cases = 2000, .threads = 0});
  EXPECT_FALSE(failed) << failed->number << ": " << failed->failure.text;
}

TEST(SceneGenerator, PlayedDrawsMakeTheSameScene) {
  for (uint64_t number = 0; number < 100; ++number) {
    Choices made(3, number);
    const std::string text = bt_text(random_scene(made, SceneNames::own));
    Choices played(made.draws());
    EXPECT_EQ(bt_text(random_scene(played, SceneNames::own)), text);
    Choices unnamed(made.draws());
    (void)random_scene(unnamed, SceneNames::made);
    EXPECT_EQ(unnamed.draws(), made.draws());
  }
}

TEST(SceneGenerator, NoDrawsMakeAnEmptyGroup) {
  Choices none(std::vector<uint32_t>{});
  EXPECT_EQ(bt_text(random_scene(none, SceneNames::own)), "Group {}\n");
}

/// What occurs in presentations.
struct Coverage {
  std::set<std::string> nodes;
  std::map<nodes::FieldType, int> types;
  std::set<std::string_view> commands;
  int links = 0, routes = 0, external = 0, nested = 0, instances = 0;

  void add(const Presentation& presentation) {
    const nodes::Scene& scene = presentation.scene;
    for (size_t i = 0; i < scene.node_count(); ++i) add(scene.node(nodes::NodeId{i}));
    for (size_t i = 0; i < scene.proto_count(); ++i) {
      const nodes::Proto& proto = scene.proto(nodes::ProtoId{i});
      external += proto.external ? 1 : 0;
      nested += proto.scope != nodes::Scene::kMain ? 1 : 0;
      routes += static_cast<int>(scene.scope(proto.body).routes.size());
      for (const auto& field : proto.interface.fields()) ++types[field.type];
    }
    for (const bifs::AccessUnit& unit : presentation.units)
      for (const bifs::Command& command : std::get<std::vector<bifs::Command>>(unit.commands))
        commands.insert(bifs::command_name(command));
  }
  void add(const nodes::Node& node) {
    if (!node.proto.valid()) nodes.insert(node.definition->name);
    instances += node.proto.valid() ? 1 : 0;
    links += static_cast<int>(node.links.size());
    for (const nodes::FieldEntry& entry : node.values)
      ++types[node.definition->field(entry.field).type];
  }
};

TEST(SceneGenerator, EveryNodeFieldTypeAndCommandOccurs) {
  Coverage found;
  for (uint64_t number = 0; number < 4000; ++number) {
    Choices choices(1, number);
    found.add(random_scene(choices, SceneNames::own));
  }
  for (const nodes::NodeDefinition& node : nodes::definitions().nodes()) {
    if (node.withdrawn) continue;
    EXPECT_TRUE(found.nodes.contains(node.name)) << node.name;
  }
  for (unsigned code = 0; code < 64; ++code) {
    const auto type = nodes::field_type_of_code(code);
    if (!type || type == nodes::FieldType::sf_script) continue;  // scripts stand in lists alone
    EXPECT_GT(found.types[*type], 0) << to_string(*type);
  }
  EXPECT_EQ(found.commands.size(), 19U);  // of 18 kinds, NodeDeletion has two
  for (const int count : {found.links, found.routes, found.external, found.nested, found.instances})
    EXPECT_GT(count, 20);
}

TEST(Shrink, OfASceneLeavesTheFieldThatMatters) {
  const auto has_scale = [](const Presentation& presentation) {
    for (size_t i = 0; i < presentation.scene.node_count(); ++i) {
      const nodes::NodeId node{i};
      if (presentation.scene.type_name(node) != "Transform") continue;
      const auto field = presentation.scene.node(node).definition->find("scale");
      if (presentation.scene.given(node, field) != nullptr) return true;
    }
    return false;
  };
  const Fails fails = [&](Choices& choices) {
    return has_scale(random_scene(choices, SceneNames::own));
  };
  int found = 0;
  for (uint64_t number = 0; found < 3; ++number) {
    Choices choices(1, number);
    if (!fails(choices)) continue;
    ++found;
    Choices smallest(shrink(choices.draws(), fails));
    const std::string text = bt_text(random_scene(smallest, SceneNames::own));
    EXPECT_THAT(text, HasSubstr("scale 0 0 0"));
    // Where it stands, in the scene, a command or a PROTO, may differ; nothing else is left.
    EXPECT_LE(std::count(text.begin(), text.end(), '{'), 3) << text;
    EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 8) << text;
  }
}

/// Every Transform loses its scale on the way.
SceneFault lost_scale() {
  return {[](std::string& commands) {
    const size_t at = commands.find("\"scale\": [");
    if (at != std::string::npos) commands.replace(at, 10, "\"scala\": [");
  }};
}

TEST(SceneGenerator, FindsAFaultTheSameForAnyNumberOfThreads) {
  const auto one = find_failure(scene_property(lost_scale()), {.cases = 2000, .threads = 1});
  const auto many = find_failure(scene_property(lost_scale()), {.cases = 2000, .threads = 4});
  ASSERT_TRUE(one && many);
  EXPECT_EQ(one->number, many->number);
  EXPECT_EQ(one->draws, many->draws);
  EXPECT_THAT(one->failure.text, HasSubstr("/scale"));
}

TEST(SceneGenerator, AKeptCaseFailsInTheRunnerInTheSameWay) {
  const auto failed = find_failure(scene_property(lost_scale()), {.cases = 2000});
  ASSERT_TRUE(failed);
  const TemporaryFolder folder = std::move(TemporaryFolder::make().value());
  ASSERT_TRUE(keep_case(folder.path(), "scene-1-2", "about", failed->failure.kept).ok());
  const std::vector<Suite> suites{read_suite(folder.path()).value()};
  json right = failed->failure.kept.checks[0].expected;
  std::string text = right.dump();
  const size_t at = text.find("\"scale\":[");
  ASSERT_NE(at, std::string::npos);
  text.replace(at, 9, "\"scala\":[");
  const json wrong = json::parse(text);
  const auto outcome = [&](const json& values) {
    const ToldDecoder decoder([&](const Question&) -> Answer { return {.values = values}; });
    return run_suites(suites, decoder, {}).cases.at(0).checks.at(0);
  };
  EXPECT_EQ(outcome(right).verdict, Verdict::passed);
  ASSERT_TRUE(outcome(wrong).difference);
  EXPECT_THAT(outcome(wrong).difference->path, HasSubstr("/scal"));
}

}  // namespace
}  // namespace afx::conformance
