// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Lists that are coded as runs of numbers against the same lists element by element: a decoder with
// a trace reads every number for itself, and the list form has a bit before every element.
#include "bifs/number_run.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "bifs/decoder.h"
#include "bifs/encoder.h"
#include "nodes/scene_reader.h"

namespace afx::bifs {

namespace {

using nodes::Scene;
using Bytes = std::vector<uint8_t>;
using Form = EncodeOptions::Form;

const codec::Trace kSilent = [](const codec::TraceElement&) {};

Scene scene_of(const std::string& text) {
  Diagnostics diagnostics;
  auto scene = nodes::read_scene_text(text, {}, diagnostics);
  EXPECT_TRUE(scene.ok()) << text;
  return std::move(scene).value();
}

/// The root gets an ID, whose width moves what follows by as many bits.
BifsConfig config_of(unsigned id_bits) {
  BifsConfig config;
  config.version = 2;
  config.node_id_bits = static_cast<uint8_t>(id_bits);
  config.proto_id_bits = 1;
  return config;
}

Bytes encoded(const std::string& text, unsigned id_bits, Form lists) {
  Scene scene = scene_of(text);
  SceneReplacement command;
  command.protos = scene.scope().protos;
  for (const nodes::ProtoId proto : command.protos) scene.proto(proto).id = 1;
  command.root = scene.roots().at(0);
  scene.node(command.root).id = 1;
  EncodeOptions options;
  options.lists = lists;
  BifsEncoder encoder(config_of(id_bits), options);
  EXPECT_TRUE(encoder.add(command, scene).ok());
  auto bytes = encoder.finish();
  EXPECT_TRUE(bytes.ok()) << (bytes.ok() ? "" : to_string(bytes.error()));
  return bytes.ok() ? bytes.value() : Bytes{};
}

Result<Scene> decoded(std::span<const uint8_t> bytes, unsigned id_bits,
                      const codec::Trace* trace = nullptr) {
  Diagnostics diagnostics;
  BifsDecoder decoder(config_of(id_bits));
  const auto frame = decoder.decode(bytes, diagnostics, {}, trace);
  if (!frame.ok()) return frame.error();
  EXPECT_EQ(diagnostics.count(), 0U);
  EXPECT_LT(bytes.size() * 8 - frame.value().bits_used, 8U);
  return decoder.take_scene();
}

/// Encodes and decodes in both ways; what the run gave.
Scene expect_alike(const std::string& text, unsigned id_bits) {
  const Bytes bytes = encoded(text, id_bits, Form::compact);
  auto fast = decoded(bytes, id_bits);
  const auto by_element = decoded(bytes, id_bits, &kSilent);
  const auto from_list = decoded(encoded(text, id_bits, Form::list), id_bits);
  EXPECT_TRUE(fast.ok() && by_element.ok() && from_list.ok()) << text;
  if (!fast.ok() || !by_element.ok() || !from_list.ok()) return {};
  EXPECT_TRUE(equal(fast.value(), by_element.value())) << text;
  EXPECT_TRUE(equal(fast.value(), from_list.value())) << text;
  return std::move(fast).value();
}

std::string integers(size_t count, int64_t low, int64_t high) {
  std::mt19937_64 random(1);
  std::string text;
  for (size_t i = 0; i < count; ++i)
    text += std::to_string(low + static_cast<int64_t>(random() % uint64_t(high - low + 1))) + ' ';
  return text;
}

std::string fractions(size_t count) {
  std::mt19937 random(2);
  std::string text;
  for (size_t i = 0; i < count; ++i)
    text += std::to_string(static_cast<double>(random()) / 4294967296.0) + ' ';
  return text;
}

std::string grouped(const std::string& node) { return "Group { children [ " + node + " ] }"; }

std::string quantized(const std::string& fields, const std::string& node) {
  return grouped("QuantizationParameter { " + fields + " } " + node);
}

}  // namespace

TEST(NumberRun, PlainListsOfAllTypesComeBackAtAllAlignments) {
  const std::string coord = "Shape { geometry IndexedFaceSet { ";
  const std::string texts[] = {
      grouped("OctreeImage { octree [" + integers(33, INT32_MIN, INT32_MAX) + "] }"),
      grouped("ScalarInterpolator { keyValue [" + fractions(33) + "nan(0x7fc12345) -inf] }"),
      grouped(coord + "texCoord TextureCoordinate { point [" + fractions(34) + "] } } }"),
      grouped(coord + "coord Coordinate { point [" + fractions(33) + "] } } }"),
      grouped(coord + "color Color { color [" + fractions(33) + "] } } }"),
      grouped("OrientationInterpolator { keyValue [" + fractions(36) + "] }"),
  };
  for (const std::string& text : texts)
    for (unsigned id_bits = 1; id_bits <= 8; ++id_bits)
      EXPECT_TRUE(equal(expect_alike(text, id_bits), scene_of(text))) << text;
}

TEST(NumberRun, PlainListsThatOnlyProtosHaveComeBackAtAllAlignments) {
  const std::string instance = "] { Group {} } Group { children [ P { a [";
  const std::string texts[] = {
      "PROTO P [ field MFBool a [TRUE] " + instance +
          "TRUE FALSE FALSE TRUE TRUE FALSE TRUE] } ] }",
      "PROTO P [ field MFTime a [7] " + instance + fractions(33) + "-1e300] } ] }",
  };
  const auto list_of = [](const Scene& scene) {
    const auto& children = scene.get<std::vector<nodes::NodeId>>(scene.roots().at(0), "children");
    return scene.value(children.at(0), nodes::FieldIndex{size_t{0}});
  };
  for (const std::string& text : texts)
    for (unsigned id_bits = 1; id_bits <= 8; ++id_bits)
      EXPECT_TRUE(same_bits(list_of(expect_alike(text, id_bits)), list_of(scene_of(text)))) << text;
}

TEST(NumberRun, QuantizedListsOfAllWidthsComeBackAtAllAlignments) {
  const std::string range = "position3DQuant TRUE position3DMin 0 .25 -1 position3DMax 1 1 1 ";
  for (unsigned width = 0; width <= 31; ++width) {
    const std::string bits = "NbBits " + std::to_string(width) + " ";
    for (unsigned id_bits = 1; id_bits <= 8; ++id_bits) {
      (void)expect_alike(quantized(range + "position3D" + bits,
                                   "Shape { geometry PointSet { coord Coordinate { point [" +
                                       fractions(33) + "] } } }"),
                         id_bits);
      (void)expect_alike(
          quantized("key" + bits, "ScalarInterpolator { key [" + fractions(9) + "]}"), id_bits);
    }
  }
}

TEST(NumberRun, IntegersUnderAQuantizerComeBackAtAllAlignments) {
  for (unsigned id_bits = 1; id_bits <= 8; ++id_bits) {
    const std::string octree =
        quantized("", "OctreeImage { octree [" + integers(99, 0, 255) + "]}");
    EXPECT_TRUE(equal(expect_alike(octree, id_bits), scene_of(octree)));
    for (const int points : {1, 2, 5, 300}) {
      const std::string faces = quantized(
          "position3DQuant FALSE", "Shape { geometry IndexedFaceSet { coord Coordinate { point [" +
                                       fractions(size_t(3 * points)) + "] } coordIndex [" +
                                       integers(50, -1, points - 2) + "] } }");
      EXPECT_TRUE(equal(expect_alike(faces, id_bits), scene_of(faces)));
    }
  }
}

TEST(NumberRun, FloatsThatAreNoRunsComeBackToo) {
  const std::string text = quantized("useEfficientCoding TRUE colorQuant FALSE keyQuant FALSE",
                                     "ScalarInterpolator { key [" + fractions(40) + "] }");
  (void)expect_alike(text, 3);
  (void)expect_alike(quantized("", "Shape { geometry IndexedFaceSet { normal Normal { vector [" +
                                       fractions(33) + "] } } }"),
                     3);
}

TEST(NumberRun, AListThatIsCutOffFailsAsElementByElement) {
  const Bytes bytes = encoded(
      "Group { children [ Shape { geometry PointSet { coord Coordinate { point [" + fractions(12) +
          "] } } } OctreeImage { octree [" + integers(9, 0, 255) + "] } ] }",
      5, Form::compact);
  for (size_t size = 0; size < bytes.size(); ++size) {
    const auto part = std::span(bytes).first(size);
    const auto fast = decoded(part, 5);
    const auto by_element = decoded(part, 5, &kSilent);
    ASSERT_FALSE(fast.ok());
    ASSERT_FALSE(by_element.ok());
    EXPECT_EQ(to_string(fast.error()), to_string(by_element.error()));
    EXPECT_EQ(fast.error().code, Errc::truncated);
  }
}

TEST(NumberRun, AnIntegerThatTheQuantizerCannotHoldIsNamed) {
  Scene scene = scene_of(quantized("", "OctreeImage { octree [1 2 256 3 4 5 6 7 8] }"));
  SceneReplacement command;
  command.root = scene.roots().at(0);
  BifsEncoder encoder(config_of(3));
  const Status added = encoder.add(command, scene);
  ASSERT_FALSE(added.ok());
  EXPECT_NE(added.error().text.find("256 cannot be written"), std::string::npos)
      << added.error().text;
}

}  // namespace afx::bifs
