// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What the encoder refuses, and the example of spec/bifs.md 6.3 bit for bit.
#include "bifs/encoder.h"

#include <gtest/gtest.h>

#include "bifs/apply.h"

namespace afx::bifs {

namespace {

using nodes::NodeId;
using nodes::Scene;

struct SmallScene {
  Scene scene;
  NodeId group, image;
  SmallScene() {
    group = scene.add("Group").value();
    image = scene.add("DepthImage").value();
    EXPECT_TRUE(scene.append(group, "children", image).ok());
    EXPECT_TRUE(scene.set(image, "orthographic", false).ok());
  }
  [[nodiscard]] SceneReplacement replacement() const {
    SceneReplacement command;
    command.root = group;
    return command;
  }
};

BifsConfig four_bits() {
  BifsConfig config;
  config.node_id_bits = 4;
  return config;
}

}  // namespace

TEST(BifsEncoder, WritesTheWorkedExampleOfTheDescription) {
  SmallScene small;
  BifsEncoder encoder(four_bits());
  const auto bytes = encode_frame(encoder, small.scene, {small.replacement()});
  ASSERT_TRUE(bytes.ok());
  // 11 000000 | 0 0 0 001 0 1 | 1 0 1 0 0 000000 000 00 000 00011 0 0 0 101 0 1 1 0 0
  const std::vector<uint8_t> expected = {0xC0, 0x05, 0xA0, 0x00, 0x03, 0x15, 0x80};
  EXPECT_EQ(bytes.value(), expected);
}

TEST(BifsEncoder, RefusesACommandOnAFieldThatCannotBeAddressed) {
  // All fields of DepthImage are plain fields; GPAC writes such a command, which nobody can read.
  SmallScene small;
  small.scene.node(small.image).id = 1;
  BifsEncoder encoder(four_bits());
  const auto field = small.scene.node(small.image).definition->find("farPlane");
  const auto bytes = encode_frame(
      encoder, small.scene, {small.replacement(), FieldReplacement{{small.image, field}, 3.0F}});
  ASSERT_FALSE(bytes.ok());
  EXPECT_EQ(bytes.error().code, Errc::bad_argument);
  EXPECT_NE(bytes.error().text.find("DepthImage.farPlane cannot be addressed"), std::string::npos);
}

TEST(BifsEncoder, RefusesARouteOfANodeThatIsNotInTheStream) {
  SmallScene small;
  const NodeId lost = small.scene.add("TimeSensor").value();
  small.scene.node(lost).id = 1;
  nodes::Route route;
  route.from = route.to = lost;
  route.from_field = small.scene.node(lost).definition->find("isActive");
  route.to_field = small.scene.node(lost).definition->find("enabled");
  SceneReplacement command = small.replacement();
  command.routes = {route};
  BifsEncoder encoder(four_bits());
  const auto bytes = encode_frame(encoder, small.scene, {command});
  ASSERT_FALSE(bytes.ok());
  EXPECT_EQ(bytes.error().code, Errc::bad_argument);
  EXPECT_NE(bytes.error().text.find("the TimeSensor with the ID 1 is not in the stream"),
            std::string::npos);
}

TEST(BifsEncoder, RefusesIdsAndPositionsThatDoNotFit) {
  SmallScene small;
  small.scene.node(small.group).id = 16;  // 4 bits hold 1 to 15
  BifsEncoder encoder(four_bits());
  const auto no_room = encode_frame(encoder, small.scene, {small.replacement()});
  ASSERT_FALSE(no_room.ok());
  EXPECT_NE(no_room.error().text.find("the node ID 16 does not fit 4 bits"), std::string::npos);
  small.scene.node(small.group).id = 15;
  const NodeId child = small.scene.add("Group").value();
  const auto far = encode_frame(
      encoder, small.scene,
      {small.replacement(), NodeInsertion{small.group, {Position::Kind::index, 300}, child}});
  ASSERT_FALSE(far.ok());
  EXPECT_NE(far.error().text.find("300 does not fit 8 bits"), std::string::npos);
}

TEST(BifsEncoder, RefusesASecondPlaceOfANodeWithoutId) {
  SmallScene small;
  ASSERT_TRUE(small.scene.append(small.group, "children", small.image).ok());
  BifsEncoder encoder(four_bits());
  const auto bytes = encode_frame(encoder, small.scene, {small.replacement()});
  ASSERT_FALSE(bytes.ok());
  EXPECT_NE(bytes.error().text.find("the DepthImage has no ID"), std::string::npos);
}

TEST(ApplyCommand, ANodeThatWouldStandInsideItselfIsRefused) {
  SmallScene small;
  const NodeId inner = small.scene.add("Group").value();
  ASSERT_TRUE(small.scene.append(small.group, "children", inner).ok());
  const auto children = small.scene.node(inner).definition->find("children");
  const Status status = apply_command(
      small.scene, FieldReplacement{{inner, children}, std::vector<NodeId>{small.group}});
  ASSERT_FALSE(status.ok());
  EXPECT_TRUE(small.scene.get<std::vector<NodeId>>(inner, "children").empty());
}

TEST(ApplyCommand, DeletionTakesANodeFromEveryPlace) {
  SmallScene small;
  ASSERT_TRUE(apply_command(small.scene, small.replacement()).ok());
  ASSERT_TRUE(apply_command(small.scene, NodeDeletion{small.image, false}).ok());
  EXPECT_TRUE(small.scene.get<std::vector<NodeId>>(small.group, "children").empty());
  ASSERT_TRUE(apply_command(small.scene, NodeDeletion{small.group, false}).ok());
  EXPECT_TRUE(small.scene.roots().empty());
}

}  // namespace afx::bifs
