// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/coding_quantizer.h"

#include <gtest/gtest.h>

#include "bifs/decoder.h"
#include "bifs/encoder.h"
#include "codec/diagnostics.h"

namespace afx::bifs {

namespace {

using nodes::NodeId;
using nodes::Scene;
using Bytes = std::vector<uint8_t>;

/// 0 1 (1 + 6 bits) 1 | mask of 40 fields | 6 values, and the endFlag of one more element.
constexpr uint64_t kQuantizerBits = 1 + 6 + 1 + 1 + 40 + 6 + 1;

BifsConfig four_bits() {
  BifsConfig config;
  config.node_id_bits = 4;
  return config;
}

EncodeOptions short_integers() {
  EncodeOptions options;
  options.short_integers = true;
  return options;
}

NodeId add_octree(Scene& scene, NodeId parent, size_t entries, int32_t last = 255) {
  const NodeId image = scene.add("OctreeImage").value();
  std::vector<int32_t> octree(entries);
  for (size_t i = 0; i < entries; ++i) octree[i] = static_cast<int32_t>(i * 7 % 256);
  octree.back() = last;
  EXPECT_TRUE(scene.set(image, "octree", octree).ok());
  EXPECT_TRUE(scene.append(parent, "children", image).ok());
  return image;
}

NodeId add_child(Scene& scene, NodeId parent, const char* type) {
  const NodeId node = scene.add(type).value();
  EXPECT_TRUE(scene.append(parent, "children", node).ok());
  return node;
}

/// Encodes a scene with this root, which becomes its root.
Bytes encode(Scene& scene, NodeId root, const EncodeOptions& options = short_integers(),
             const BifsConfig& config = four_bits()) {
  BifsEncoder encoder(config, options);
  SceneReplacement command;
  command.root = root;
  const auto bytes = encode_frame(encoder, scene, {command});
  EXPECT_TRUE(bytes.ok()) << to_string(bytes.error());
  return bytes.ok() ? bytes.value() : Bytes{};
}

struct Decoded {
  uint64_t bits = 0;
  Scene scene;
};

Decoded decode(const Bytes& bytes, const DecodeOptions& options = {}) {
  BifsDecoder decoder(four_bits(), {}, options);
  Diagnostics diagnostics;
  const auto frame = decoder.decode(bytes, diagnostics);
  EXPECT_TRUE(frame.ok()) << to_string(frame.error());
  EXPECT_TRUE(diagnostics.warnings().empty());
  return {frame.ok() ? frame.value().bits_used : 0, decoder.take_scene()};
}

Decoded decode_all(const Bytes& bytes) {
  DecodeOptions options;
  options.keep_coding_quantizers = true;
  return decode(bytes, options);
}

const std::vector<NodeId>& children(const Scene& scene, NodeId node) {
  return scene.get<std::vector<NodeId>>(node, "children");
}

size_t quantizers(const Scene& scene) {
  size_t count = 0;
  for (size_t i = 0; i < scene.node_count(); ++i) count += is_quantizer(scene, NodeId{i}) ? 1 : 0;
  return count;
}

/// The bits that coding quantizers save, and whether the scene comes back equal.
int64_t saving(Scene& scene, NodeId root, EncodeOptions options = {}) {
  const Decoded plain = decode(encode(scene, root, options));
  options.short_integers = true;
  const Decoded with = decode(encode(scene, root, options));
  EXPECT_TRUE(nodes::equal(scene, plain.scene));
  EXPECT_TRUE(nodes::equal(scene, with.scene));
  return static_cast<int64_t>(plain.bits) - static_cast<int64_t>(with.bits);
}

}  // namespace

TEST(CodingQuantizer, TenThousandOctreeEntriesCostEightBitsEach) {
  Scene scene;
  const NodeId group = scene.add("Group").value();
  add_octree(scene, group, 10000);
  EXPECT_EQ(saving(scene, group), 10000 * 24 - static_cast<int64_t>(kQuantizerBits));
}

TEST(CodingQuantizer, IsLeftOutByTheDecoderUnlessItIsAskedFor) {
  Scene scene;
  const NodeId group = scene.add("Group").value();
  add_octree(scene, group, 100);
  const Bytes bytes = encode(scene, group);
  const Scene without = decode(bytes).scene;
  EXPECT_EQ(children(without, without.roots()[0]).size(), 1U);
  const Scene with = decode_all(bytes).scene;
  const auto& list = children(with, with.roots()[0]);
  ASSERT_EQ(list.size(), 2U);
  EXPECT_TRUE(is_coding_quantizer(with, list[0]));
  EXPECT_FALSE(is_coding_quantizer(with, list[1]));
}

TEST(CodingQuantizer, TheDecodedSceneIsEncodedToTheSameBytes) {
  Scene scene;
  const NodeId group = scene.add("Group").value();
  add_octree(scene, add_child(scene, group, "Transform"), 100);
  const Bytes bytes = encode(scene, group);
  Scene decoded = decode(bytes).scene;
  EXPECT_EQ(encode(decoded, decoded.roots()[0]), bytes);
}

TEST(CodingQuantizer, StandsOnlyWhereItSavesMoreThanItCosts) {
  // n entries save 24 n bits; the quantizer costs 56, and is counted in whole bytes.
  for (size_t entries = 1; entries < 6; ++entries) {
    Scene scene;
    const NodeId group = scene.add("Group").value();
    add_octree(scene, group, entries);
    const int64_t expected =
        entries < 3 ? 0 : static_cast<int64_t>(24 * entries) - static_cast<int64_t>(kQuantizerBits);
    EXPECT_EQ(saving(scene, group), expected) << entries;
  }
}

TEST(CodingQuantizer, TheListFormCountsAsACost) {
  // 40 children: 41 bits as a list, 11 as a vector. 2 quantizers more than pay for it, or do not.
  for (const size_t entries : {size_t{3}, size_t{20}}) {
    Scene scene;
    const NodeId group = scene.add("Group").value();
    for (int i = 0; i < 40; ++i) {
      if (i % 20 == 7) {
        add_octree(scene, group, entries);
      } else {
        add_child(scene, group, "Group");
      }
    }
    const int64_t gain =
        2 * (static_cast<int64_t>(24 * entries) - static_cast<int64_t>(kQuantizerBits)) - 30;
    EXPECT_EQ(saving(scene, group), entries == 3 ? 0 : gain);
  }
}

TEST(CodingQuantizer, IsInAListEvenWhereVectorsAreAskedFor) {
  Scene scene;
  const NodeId group = scene.add("Group").value();
  add_octree(scene, group, 100);
  EncodeOptions options;
  options.lists = EncodeOptions::Form::compact;
  // One child: 2 bits as a list, 6 as a vector, which falls away.
  EXPECT_EQ(saving(scene, group, options), 2400 - static_cast<int64_t>(kQuantizerBits) + 4);
}

TEST(CodingQuantizer, OneStandsBeforeAGroupOfSeveral) {
  Scene scene;
  const NodeId root = scene.add("Group").value();
  const NodeId inner = add_child(scene, root, "Transform");
  for (int i = 0; i < 3; ++i) add_octree(scene, inner, 100);
  EXPECT_EQ(quantizers(decode_all(encode(scene, root)).scene), 1U);
  EXPECT_EQ(saving(scene, root), 3 * 2400 - static_cast<int64_t>(kQuantizerBits));
}

TEST(CodingQuantizer, ValuesOutsideTheRangeStayAsTheyAre) {
  for (const int32_t value : {-1, 256, INT32_MIN, INT32_MAX}) {
    Scene scene;
    const NodeId group = scene.add("Group").value();
    add_octree(scene, group, 100, value);
    EXPECT_EQ(saving(scene, group), 0) << value;
  }
}

TEST(CodingQuantizer, IsPutDeeperWhereASiblingDoesNotFit) {
  Scene scene;
  const NodeId root = scene.add("Group").value();
  const NodeId inner = add_child(scene, root, "Transform");
  add_octree(scene, inner, 100, 256);
  add_octree(scene, inner, 100);
  EXPECT_EQ(saving(scene, root), 2400 - static_cast<int64_t>(kQuantizerBits));
  const Scene with = decode_all(encode(scene, root)).scene;
  const NodeId transform = children(with, with.roots()[0])[0];
  ASSERT_EQ(children(with, transform).size(), 3U);
  EXPECT_TRUE(is_coding_quantizer(with, children(with, transform)[1]));
}

TEST(CodingQuantizer, AListThatCommandsCanAddressIsLeftAlone) {
  Scene scene;
  const NodeId group = scene.add("Group").value();
  add_octree(scene, group, 100);
  scene.node(group).id = 1;
  EXPECT_EQ(saving(scene, group), 0);
}

TEST(CodingQuantizer, ChildrenThatOtherFieldsCountAreLeftAlone) {
  Scene scene;
  const NodeId group = scene.add("OrderedGroup").value();
  add_octree(scene, group, 100);
  EXPECT_EQ(saving(scene, group), 0);
}

TEST(CodingQuantizer, ANodeThatIsUsedAgainSavesOnlyAtItsFirstPlace) {
  Scene scene;
  const NodeId root = scene.add("Group").value();
  const NodeId image = add_octree(scene, add_child(scene, root, "Group"), 100);
  scene.node(image).id = 2;
  ASSERT_TRUE(scene.append(root, "children", image).ok());
  ASSERT_TRUE(scene.append(root, "children", image).ok());
  EXPECT_EQ(quantizers(decode_all(encode(scene, root)).scene), 1U);
  EXPECT_EQ(saving(scene, root), 2400 - static_cast<int64_t>(kQuantizerBits));
}

TEST(CodingQuantizer, IndicesAreAsWideAsTheirPointsNeed) {
  Scene scene;
  const NodeId root = scene.add("Group").value();
  const NodeId shape = add_child(scene, root, "Shape");
  const NodeId faces = scene.add("IndexedFaceSet").value();
  const NodeId coord = scene.add("Coordinate").value();
  ASSERT_TRUE(scene.set(shape, "geometry", faces).ok());
  ASSERT_TRUE(scene.set(faces, "coord", coord).ok());
  ASSERT_TRUE(scene.set(coord, "point", std::vector<glm::vec3>(7)).ok());
  ASSERT_TRUE(scene.set(faces, "coordIndex", std::vector<int32_t>{0, 1, 6, -1, 2, 3, 4, -1}).ok());
  // 7 points: -1..6 in 3 bits.
  EXPECT_EQ(saving(scene, root), 8 * 29 - static_cast<int64_t>(kQuantizerBits));
  ASSERT_TRUE(scene.set(faces, "colorIndex", std::vector<int32_t>{7}).ok());
  EXPECT_EQ(saving(scene, root), 0);  // more colours than points
  ASSERT_TRUE(scene.set(faces, "colorIndex", std::vector<int32_t>{6}).ok());
  ASSERT_TRUE(scene.set(faces, "coord", NodeId{}).ok());
  EXPECT_EQ(saving(scene, root), 0);  // no points
}

TEST(CodingQuantizer, IsNotPutAmongOrUnderOtherQuantizers) {
  Scene scene;
  const NodeId root = scene.add("Group").value();
  add_child(scene, root, "QuantizationParameter");
  add_octree(scene, add_child(scene, root, "Group"), 100);
  EXPECT_EQ(saving(scene, root), 0);
  Scene other;
  const NodeId top = other.add("Group").value();
  const NodeId inner = add_child(other, top, "Group");
  add_octree(other, inner, 100);
  add_child(other, inner, "QuantizationParameter");
  EXPECT_EQ(saving(other, top), 2400 - static_cast<int64_t>(kQuantizerBits));  // before the image
  EXPECT_EQ(quantizers(decode_all(encode(other, top)).scene), 2U);
}

TEST(CodingQuantizer, SomeoneElsesLocalQuantizerStaysInTheScene) {
  Scene scene;
  const NodeId root = scene.add("Group").value();
  const NodeId local = add_child(scene, root, "QuantizationParameter");
  ASSERT_TRUE(scene.set(local, "isLocal", true).ok());
  add_octree(scene, root, 4);
  EXPECT_TRUE(nodes::equal(scene, decode(encode(scene, root)).scene));
}

TEST(CodingQuantizer, IsNotUsedWithPredictiveFields) {
  Scene scene;
  const NodeId group = scene.add("Group").value();
  add_octree(scene, group, 100);
  BifsConfig config = four_bits();
  config.use_predictive_field = true;
  EXPECT_EQ(encode(scene, group, short_integers(), config), encode(scene, group, {}, config));
}

TEST(CodingQuantizer, StandsInTheBodiesOfProtosToo) {
  Scene scene;
  const nodes::ProtoId proto = scene.add_proto("Tree", false).value();
  scene.proto(proto).id = 1;
  const nodes::ScopeId body = scene.proto(proto).body;
  const NodeId group = scene.add("Group", body).value();
  scene.add_root(group, body);
  const NodeId image = scene.add("OctreeImage", body).value();
  ASSERT_TRUE(scene.set(image, "octree", std::vector<int32_t>(100, 1)).ok());
  ASSERT_TRUE(scene.append(group, "children", image).ok());
  scene.settle_data_types(proto);
  SceneReplacement command;
  command.use_names = true;
  command.protos = {proto};
  command.root = scene.add("Group").value();
  BifsConfig config = four_bits();
  config.proto_id_bits = 4;
  BifsEncoder encoder(config, short_integers());
  const auto bytes = encode_frame(encoder, scene, {command});
  ASSERT_TRUE(bytes.ok()) << to_string(bytes.error());
  EXPECT_LT(bytes.value().size(), 140U);
  BifsDecoder decoder(config);
  Diagnostics diagnostics;
  ASSERT_TRUE(decoder.decode(bytes.value(), diagnostics).ok());
  EXPECT_TRUE(nodes::equal(scene, decoder.scene()));
}

TEST(CodingQuantizer, StandsInNodesOfLaterCommandsToo) {
  Scene scene;
  const NodeId root = scene.add("Group").value();
  scene.node(root).id = 1;
  const NodeId group = scene.add("Group").value();
  add_octree(scene, group, 100);
  BifsEncoder encoder(four_bits(), short_integers());
  SceneReplacement begin;
  begin.root = root;
  const auto bytes =
      encode_frame(encoder, scene, {begin, NodeInsertion{root, {Position::Kind::last, 0}, group}});
  ASSERT_TRUE(bytes.ok());
  EXPECT_LT(bytes.value().size(), 130U);
  EXPECT_TRUE(nodes::equal(scene, decode(bytes.value()).scene));
}

}  // namespace afx::bifs
