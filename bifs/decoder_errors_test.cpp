// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What a decoder says of streams that are cut off, damaged or hostile.
#include <random>

#include "bifs/decoder.h"
#include "bifs/encoder.h"
#include "bifs/vectors_test_support.h"

namespace afx::bifs {

namespace {

/// Decodes the units before one and then bytes in its place.
Result<CommandFrame> decode_instead(const BifsVector& vector, size_t unit, const Bytes& bytes,
                                    const Limits& limits = {}) {
  BifsDecoder decoder(vector.config, limits);
  Diagnostics diagnostics;
  for (size_t i = 0; i < unit; ++i) (void)decoder.decode(vector.units[i], diagnostics);
  return decoder.decode(bytes, diagnostics);
}

/// Bytes from text of 0, 1 and blanks, filled up with zero bits.
Bytes bits(const std::string& text) {
  Bytes bytes;
  size_t count = 0;
  for (const char c : text) {
    if (c == ' ') continue;
    if (count % 8 == 0) bytes.push_back(0);
    if (c == '1') bytes.back() = static_cast<uint8_t>(bytes.back() | 0x80U >> count % 8);
    ++count;
  }
  return bytes;
}

struct BadFrame {
  const char* about;
  const char* frame;
  Errc code;
  uint64_t bit;
  const char* text;
};

// The configuration of these: version 2, 2 bits for node IDs, 2 for ROUTEs, 2 for PROTOs. A scene
// replacement begins 11 000000 0 0 (type, reserved, no names, no PROTOs).
const BadFrame kBadFrames[] = {
    {"nothing", "", Errc::truncated, 0, "the data end inside commandFrame/commandType"},
    {"a reserved deletion", "01 01", Errc::malformed, 2,
     "commandFrame: deletion command of type 1, which is reserved"},
    {"a node that is not there", "01 00 10 0", Errc::malformed, 4,
     "commandFrame/NodeDeletion: no node has the ID 3"},
    {"an extended update of a later edition", "00 01 00001000 0", Errc::unsupported, 4,
     "commandFrame: extended update of type 8 [expected 0 to 7]"},
    {"an unknown top node", "11 000000 0 0 0 111 0", Errc::malformed, 11,
     "commandFrame/SceneReplacement: there is no SFTopNode of version 1 and code 7"},
    {"a USE of nothing", "11 000000 0 0 1 00 0", Errc::malformed, 11,
     "commandFrame/SceneReplacement: no node before this has the ID 1"},
    {"a PROTO that is not there", "11 000000 0 0 0 000 1 01 0", Errc::malformed, 15,
     "commandFrame/SceneReplacement: no PROTO has the ID 1"},
    {"a node with the ID of NULL", "11 000000 0 0 0 001 1 11 0 1 0", Errc::malformed, 15,
     "commandFrame/SceneReplacement/Group: the node has the ID that means the NULL node"},
    {"an insertion into a node without children",
     "11 000000 0 0 0 001 0 1 1 0 1 0 0 100110 1 00 1 0 0 1 0 1 00 00 00 11", Errc::malformed, 40,
     "commandFrame/NodeInsertion: a Shape has no children"},
    {"a script that declares an exposedField",
     "11 000000 0 0 0 001 0 1 1 0 1 0 0 100101 0 1 1 0 1 0 1 0 11 000000 0", Errc::malformed, 35,
     "commandFrame/SceneReplacement/Group/children/Script/url/script: a script field of event "
     "type 3"},
    {"a quantized normal of no orientation",
     "11 000000 0 0 0 001 0 1 1 0 1 0 0 100011 0 1 00000000 00000000 00000000 00000000 00000000 00 "
     "100110 0 1 0 1 0 01001 0 1 0 0 1 0 1 0 1 1 0 1 0 0 11 10000000 10000000 1 0",
     Errc::malformed, 101,
     "commandFrame/SceneReplacement/Group/children/Shape/geometry/IndexedFaceSet/normal/Normal/"
     "vector: the orientation of a normal is 3 [expected 0 to 2]"},
    {"a ROUTE without nodes", "00 11 0 00 0", Errc::malformed, 5,
     "commandFrame/ROUTEInsertion: no node has the ID 1"},
};

BifsConfig small_config() {
  BifsConfig config;
  config.version = 2;
  config.node_id_bits = config.route_id_bits = config.proto_id_bits = 2;
  return config;
}

}  // namespace

TEST(BifsErrors, EachBadFrameIsRefusedWithPlaceAndPath) {
  for (const BadFrame& bad : kBadFrames) {
    BifsDecoder decoder(small_config());
    Diagnostics diagnostics;
    const auto frame = decoder.decode(bits(bad.frame), diagnostics);
    ASSERT_FALSE(frame.ok()) << bad.about;
    EXPECT_EQ(frame.error().code, bad.code) << bad.about;
    EXPECT_EQ(frame.error().place, Place::at_bit(bad.bit)) << bad.about;
    EXPECT_EQ(frame.error().text.substr(0, std::string(bad.text).size()), bad.text) << bad.about;
  }
}

TEST(BifsErrors, EveryTruncationOfEveryVectorIsTruncatedAtABitInside) {
  for (const std::string& name : vector_names()) {
    if (name.starts_with("33")) continue;  // cannot be decoded whole
    const BifsVector vector = load_vector(name);
    for (size_t unit = 0; unit < vector.units.size(); ++unit) {
      const Bytes& whole = vector.units[unit];
      const size_t step = whole.size() > 400 ? 7 : 1;
      for (size_t size = 0; size < whole.size(); size += step) {
        const Bytes cut(whole.begin(), whole.begin() + static_cast<ptrdiff_t>(size));
        const auto frame = decode_instead(vector, unit, cut);
        ASSERT_FALSE(frame.ok()) << name << " " << unit << " " << size;
        EXPECT_EQ(frame.error().code, Errc::truncated) << name << " " << to_string(frame.error());
        EXPECT_LE(frame.error().place.bit, size * 8) << name;
        EXPECT_NE(frame.error().text.find("commandFrame"), std::string::npos);
      }
    }
  }
}

TEST(BifsErrors, DamagedVectorsAreAFrameOrAnErrorWithAPlace) {
  std::mt19937 random(37);
  for (const std::string& name : vector_names()) {
    const BifsVector vector = load_vector(name);
    for (size_t unit = 0; unit < vector.units.size(); ++unit) {
      for (int round = 0; round < 40; ++round) {
        Bytes bytes = vector.units[unit];
        for (unsigned i = 0; i <= random() % 3; ++i)
          bytes[random() % bytes.size()] ^= static_cast<uint8_t>(1U << random() % 8);
        Limits limits;
        limits.memory = 16 << 20;
        const auto frame = decode_instead(vector, unit, bytes, limits);
        if (frame.ok()) continue;
        EXPECT_EQ(frame.error().place.kind, Place::Kind::bit);
        EXPECT_LE(frame.error().place.bit, bytes.size() * 8);
        EXPECT_NE(frame.error().text.find("commandFrame"), std::string::npos) << frame.error().text;
      }
    }
  }
}

TEST(BifsErrors, NestingIsLimited) {
  // Group { children [ Group { children [ ... : list description, list of nodes, each 21 bits.
  std::string text = "11 000000 0 0 0 001 0 0 0 0 1 0";  // up to the first child
  for (int i = 0; i < 100; ++i) text += "0 010001 0 0 0 0 1 0";
  Limits limits;
  limits.scene_depth = 50;
  BifsDecoder decoder(small_config(), limits);
  Diagnostics diagnostics;
  const auto frame = decoder.decode(bits(text), diagnostics);
  ASSERT_FALSE(frame.ok());
  EXPECT_EQ(frame.error().code, Errc::limit_exceeded) << to_string(frame.error());
}

TEST(BifsErrors, AListOfElementsWithoutBitsIsLimited) {
  // Colours of 0 bits: 2000 of them are a few bytes.
  nodes::Scene scene;
  const auto add = [&](const char* type) { return scene.add(type).value(); };
  const nodes::NodeId group = add("Group"), shape = add("Shape"), faces = add("IndexedFaceSet"),
                      color = add("Color"), quantizer = add("QuantizationParameter");
  ASSERT_TRUE(scene.append(group, "children", shape).ok());
  ASSERT_TRUE(scene.set(shape, "geometry", faces).ok());
  ASSERT_TRUE(scene.set(faces, "color", color).ok());
  ASSERT_TRUE(scene.set(quantizer, "colorNbBits", int32_t{0}).ok());
  scene.node(color).id = 1;
  const nodes::FieldIndex field = scene.node(color).definition->find("color");
  SceneReplacement replacement;
  replacement.root = group;
  const std::vector<Command> commands = {
      replacement, GlobalQuantizer{quantizer},
      FieldReplacement{{color, field}, std::vector<glm::vec3>(2000)}};
  BifsEncoder encoder(small_config());
  const auto bytes = encode_frame(encoder, scene, commands);
  ASSERT_TRUE(bytes.ok()) << to_string(bytes.error());
  EXPECT_LT(bytes.value().size(), 40U);
  Limits limits;
  Diagnostics diagnostics;
  EXPECT_TRUE(BifsDecoder(small_config(), limits).decode(bytes.value(), diagnostics).ok());
  limits.scene_values = 1000;
  const auto frame = BifsDecoder(small_config(), limits).decode(bytes.value(), diagnostics);
  ASSERT_FALSE(frame.ok());
  EXPECT_EQ(frame.error().code, Errc::limit_exceeded);
}

TEST(BifsDecoding, ARepeatedFieldOfACommandOverrides) {
  // Group { children [ DEF 1 Switch { } ] }; MultipleFieldReplacement of whichChoice by 3 and by 5.
  const Bytes scene = bits("11 000000 0 0  0 001 0 1 1  0 1  0 0 101011 1 00 1 00  1  0 0");
  const std::string zeros(29, '0');
  const Bytes command =
      bits("00 01 00000100 00 0  0 1 " + zeros + "011  0 1 " + zeros + "101  1 0");
  BifsDecoder decoder(small_config());
  Diagnostics diagnostics;
  ASSERT_TRUE(decoder.decode(scene, diagnostics).ok());
  size_t fields = 0;
  const auto frame =
      decoder.decode(command, diagnostics, [&](const Command& one, const nodes::Scene&) {
        fields = std::get<MultipleFieldReplacement>(one).values.size();
      });
  ASSERT_TRUE(frame.ok()) << to_string(frame.error());
  EXPECT_EQ(fields, 1U);
}

TEST(BifsErrors, TrailingBytesAreAWarningAndNotUsed) {
  const BifsVector vector = load_vector("36-peer-end-flags");
  Bytes padded = vector.units[0];
  padded.push_back(0);
  BifsDecoder decoder(vector.config);
  Diagnostics diagnostics;
  const auto frame = decoder.decode(padded, diagnostics);
  ASSERT_TRUE(frame.ok());
  ASSERT_EQ(diagnostics.warnings().size(), 1U);
  EXPECT_EQ(diagnostics.warnings()[0].code, "trailing_bytes");
}

TEST(BifsConfigReading, TheWrongObjectTypeIndicationIsFoundOut) {
  // nodeIDbits 1, routeIDbits 0, command stream, pixel metric, 320 x 240 (spec/bifs.md 2).
  const Bytes bytes = {0x08, 0x38, 0x0A, 0x00, 0x07, 0x80};
  Diagnostics diagnostics;
  const auto config = read_config(bytes, kOtiBifs, diagnostics);
  ASSERT_TRUE(config.ok());
  EXPECT_EQ(config.value().node_id_bits, 1);
  EXPECT_EQ(config.value().size, (DisplaySize{320, 240}));
  const auto other = read_config(bytes, kOtiBifsV2, diagnostics);
  ASSERT_TRUE(other.ok());
  EXPECT_EQ(other.value(), config.value());
  ASSERT_EQ(diagnostics.warnings().size(), 1U);
  EXPECT_EQ(diagnostics.warnings()[0].code, "config_form");
}

TEST(BifsConfigReading, WhatIsLeftOutIsNamed) {
  Diagnostics diagnostics;
  const auto extended = read_config(Bytes{0}, kOtiBifsExtended, diagnostics);
  ASSERT_FALSE(extended.ok());
  EXPECT_EQ(extended.error().code, Errc::unsupported);
  EXPECT_NE(extended.error().text.find("BIFSConfigEx"), std::string::npos);
  const auto animation = read_config(Bytes{0x08, 0x00}, kOtiBifs, diagnostics);
  ASSERT_FALSE(animation.ok());
  EXPECT_EQ(animation.error().code, Errc::unsupported);
  EXPECT_NE(animation.error().text.find("BIFS-Anim"), std::string::npos);
  // Version 2: no tools, no IDs, isCommandStream 0.
  const auto second = read_config(Bytes{0x00, 0x00, 0x00}, kOtiBifsV2, diagnostics);
  ASSERT_FALSE(second.ok());
  EXPECT_EQ(second.error().code, Errc::unsupported);
  EXPECT_NE(second.error().text.find("BIFSv2Config/isCommandStream is 0: BIFS-Anim"),
            std::string::npos)
      << second.error().text;
}

TEST(BifsErrors, AnIndexedFaceSetAs3DMeshIsNamed) {
  // Shape { geometry IndexedFaceSet { } }: the configuration says that a 3D mesh stands here.
  nodes::Scene scene;
  SceneReplacement replacement;
  replacement.root = scene.add("Group").value();
  const nodes::NodeId shape = scene.add("Shape").value();
  ASSERT_TRUE(scene.append(replacement.root, "children", shape).ok());
  ASSERT_TRUE(scene.set(shape, "geometry", scene.add("IndexedFaceSet").value()).ok());
  BifsConfig config = small_config();
  BifsEncoder encoder(config);
  const auto bytes = encode_frame(encoder, scene, {replacement});
  ASSERT_TRUE(bytes.ok()) << to_string(bytes.error());
  Diagnostics diagnostics;
  EXPECT_TRUE(BifsDecoder(config).decode(bytes.value(), diagnostics).ok());
  config.use_3d_mesh_coding = true;
  const auto frame = BifsDecoder(config).decode(bytes.value(), diagnostics);
  ASSERT_FALSE(frame.ok());
  EXPECT_EQ(frame.error().code, Errc::unsupported);
  EXPECT_NE(frame.error().text.find("3D mesh bitstream (use3DMeshCoding), which is not read"),
            std::string::npos)
      << frame.error().text;
}

TEST(BifsErrors, ABufferThatHadToWaitIsReadAsIfForTheFirstTime) {
  // { REPLACE G.children BY [ DEF N Transform {} ] DELETE B } stands before B is inserted.
  nodes::Scene scene;
  const auto named = [&](const char* type, const char* name, uint32_t id) {
    const nodes::NodeId node = scene.add(type).value();
    EXPECT_TRUE(scene.set_name(node, name).ok());
    scene.node(node).id = id;
    return node;
  };
  const nodes::NodeId top = named("Group", "G", 1);
  const nodes::NodeId held = named("Transform", "N", 2);
  const nodes::NodeId late = named("Group", "B", 3);
  const nodes::NodeId conditional = scene.add("Conditional").value();
  const FieldRef children{top, scene.node(top).definition->find("children")};
  auto commands = std::make_shared<BufferedCommands>();
  commands->commands.push_back(FieldReplacement{children, std::vector<nodes::NodeId>{held}});
  commands->commands.push_back(NodeDeletion{late, false});
  nodes::CommandBuffer buffer;
  buffer.content = commands;
  ASSERT_TRUE(scene.set(conditional, "buffer", buffer).ok());
  ASSERT_TRUE(scene.append(top, "children", conditional).ok());
  SceneReplacement replacement;
  replacement.root = top;
  replacement.use_names = true;
  const BifsConfig config = small_config();
  BifsEncoder encoder(config);
  const auto bytes = encode_frame(
      encoder, scene, {replacement, NodeInsertion{top, {Position::Kind::last, 0}, late}});
  ASSERT_TRUE(bytes.ok()) << to_string(bytes.error());
  BifsDecoder decoder(config);
  Diagnostics diagnostics;
  const auto frame = decoder.decode(bytes.value(), diagnostics);
  ASSERT_TRUE(frame.ok()) << to_string(frame.error());
  for (const Warning& warning : diagnostics.warnings()) EXPECT_NE(warning.code, "name_twice");
  EXPECT_TRUE(decoder.scene().find_name("N").valid());
  size_t transforms = 0;
  for (size_t i = 0; i < decoder.scene().node_count(); ++i)
    transforms += decoder.scene().type_name(nodes::NodeId{i}) == "Transform";
  EXPECT_EQ(transforms, 1U);
}

}  // namespace afx::bifs
