// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <gtest/gtest.h>

#include "nodes/scene.h"

namespace afx::nodes {
namespace {

TEST(SceneRevert, WhatWasAddedSinceIsGoneAndItsNamesAreFree) {
  Scene scene;
  const NodeId kept = scene.add("Group").value();
  ASSERT_TRUE(scene.set_name(kept, "A").ok());
  const ProtoId first = scene.add_proto("P", false).value();
  const Scene::Mark mark = scene.mark();

  const NodeId dropped = scene.add("Shape").value();
  ASSERT_TRUE(scene.set_name(dropped, "B").ok());
  const ProtoId second = scene.add_proto("Q", false).value();
  ASSERT_TRUE(scene.add_proto("R", false, scene.proto(second).body).ok());
  ASSERT_TRUE(scene.add("Box", scene.proto(second).body).ok());
  scene.revert(mark);

  EXPECT_EQ(scene.node_count(), 1U);
  EXPECT_EQ(scene.proto_count(), 1U);
  EXPECT_EQ(scene.scope_count(), 2U);
  EXPECT_EQ(scene.find_name("A"), kept);
  EXPECT_FALSE(scene.find_name("B").valid());
  EXPECT_EQ(scene.find_proto("P"), first);
  EXPECT_FALSE(scene.find_proto("Q").valid());
  EXPECT_EQ(scene.scope().protos, std::vector<ProtoId>{first});
  EXPECT_TRUE(equal(scene, scene));
  EXPECT_TRUE(scene.set_name(scene.add("Shape").value(), "B").ok());
  EXPECT_EQ(scene.add_proto("Q", false).value(), second);
}

}  // namespace
}  // namespace afx::nodes
