// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/id_assignment.h"

#include <gtest/gtest.h>

#include <vector>

namespace afx::bifs {

namespace {

using nodes::NodeId;
using nodes::Scene;
using nodes::ScopeId;

NodeId add_named(Scene& scene, std::string name, ScopeId scope = Scene::kMain) {
  const NodeId node = scene.add("Group", scope).value();
  EXPECT_TRUE(scene.set_name(node, std::move(name)).ok());
  return node;
}

/// The IDs of new Groups with these names, in their order.
std::vector<uint32_t> ids_of(const std::vector<std::string>& names) {
  Scene scene;
  std::vector<NodeId> nodes;
  for (const std::string& name : names) nodes.push_back(add_named(scene, name));
  assign_node_ids(scene);
  std::vector<uint32_t> ids;
  for (const NodeId node : nodes) ids.push_back(scene.node(node).id);
  return ids;
}

}  // namespace

TEST(IdOfName, IsOneMoreThanTheNumberBehindTheLetter) {
  EXPECT_EQ(id_of_name('N', "N0"), 1U);
  EXPECT_EQ(id_of_name('N', "N41"), 42U);
  EXPECT_EQ(id_of_name('R', "R7"), 8U);
  EXPECT_EQ(id_of_name('N', "N2147483646"), 2147483647U);
}

TEST(IdOfName, HoldsForNoOtherForm) {
  for (const char* name :
       {"", "N", "n0", "R0", "N01", "N1a", "N-1", "N+1", "N 1", "N2147483647", "N99999999999"})
    EXPECT_EQ(id_of_name('N', name), std::nullopt) << name;
}

TEST(NodeIds, AreCountedInTheOrderOfTheNodesThatHaveNames) {
  EXPECT_EQ(ids_of({"front", "", "back"}), (std::vector<uint32_t>{1, 0, 2}));
}

TEST(NodeIds, AreThoseThatTheNamesStandForWhereTheyAreFree) {
  EXPECT_EQ(ids_of({"N4", "a", "N1", "b"}), (std::vector<uint32_t>{5, 1, 2, 3}));
  EXPECT_EQ(ids_of({"a", "N0", "b"}), (std::vector<uint32_t>{1, 2, 3}));
}

TEST(NodeIds, LeaveOutThoseThatNodesBeforeHaveAlready) {
  Scene scene;
  scene.node(scene.add("Group").value()).id = 1;
  const NodeId a = add_named(scene, "a");
  scene.node(add_named(scene, "b")).id = 3;
  const NodeId c = add_named(scene, "N2");
  assign_node_ids(scene);
  EXPECT_EQ(scene.node(a).id, 2U);
  EXPECT_EQ(scene.node(c).id, 4U);
}

TEST(NodeIds, MayBeGivenAgainByWhoeverSaysThem) {
  Scene scene;
  const NodeId gone = add_named(scene, "N0");
  const NodeId later = add_named(scene, "N0_2");
  scene.node(later).id = 1;  // as an update of a stream does that inserts where it has deleted
  assign_node_ids(scene);
  EXPECT_EQ(scene.node(gone).id, 1U);
  EXPECT_EQ(scene.node(later).id, 1U);
}

TEST(NodeIds, AreTheirOwnInEachScope) {
  Scene scene;
  const ScopeId body = scene.proto(scene.add_proto("P", false).value()).body;
  const NodeId inner = add_named(scene, "inner", body);
  const NodeId outer = add_named(scene, "outer");
  assign_node_ids(scene);
  EXPECT_EQ(scene.node(inner).id, 1U);
  EXPECT_EQ(scene.node(outer).id, 1U);
}

TEST(NodeIds, BeginAgainBehindASceneReplacement) {
  Scene scene;
  const NodeId old_node = add_named(scene, "old");
  assign_node_ids(scene);
  const NodeId new_node = add_named(scene, "new");
  assign_node_ids(scene, new_node);
  EXPECT_EQ(scene.node(old_node).id, 1U);
  EXPECT_EQ(scene.node(new_node).id, 1U);
}

TEST(RouteIds, AreGivenAsTheNodesAreAndFoundByName) {
  RouteIds routes;
  EXPECT_EQ(routes.id_of_new("R2"), 3U);
  EXPECT_EQ(routes.id_of_new("fade"), 1U);
  routes.note("told", 2);
  EXPECT_EQ(routes.id_of_new("next"), 4U);
  EXPECT_EQ(routes.find("R2"), 3U);
  EXPECT_EQ(routes.find("told"), 2U);
  EXPECT_EQ(routes.find("none"), std::nullopt);
}

TEST(RouteIds, GoToTheLastRouteOfAName) {
  RouteIds routes;
  EXPECT_EQ(routes.id_of_new("R0"), 1U);
  EXPECT_EQ(routes.id_of_new("R0"), 2U);
  EXPECT_EQ(routes.find("R0"), 2U);
}

}  // namespace afx::bifs
