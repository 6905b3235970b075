// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Codes and widths against conformance/facts/mpeg4-nodes.json and the tables of spec/bifs.md 6.2.
#include "bifs/node_codes.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

namespace afx::bifs {

namespace {

using nlohmann::json;
using nodes::definitions;
using nodes::IndexMode;
using nodes::NodeDataType;
using nodes::NodeDefinition;

constexpr const char* kModes[] = {"all", "def", "in", "out", "dyn"};

const json& facts() {
  static const json table = [] {
    std::ifstream file(std::filesystem::path(AFX_SOURCE_DIR) /
                       "conformance/facts/mpeg4-nodes.json");
    return json::parse(file);
  }();
  return table;
}

NodeDataType type_of(const std::string& name) {
  const auto type = definitions().find_data_type(name);
  EXPECT_TRUE(type.has_value()) << name;
  return type.value_or(NodeDataType{});
}

/// All the bits of a node's code, escapes included.
std::string code_bits(const std::string& node_name, const std::string& type_name) {
  const NodeDefinition& node = *definitions().find(node_name);
  const NodeDataType type = type_of(type_name);
  std::string bits;
  for (unsigned v = 1; v <= node.version; ++v) {
    const uint32_t code = v == node.version ? node_code(node, type).value_or(0) : kEscapeCode;
    for (unsigned b = node_code_bits(type, v); b-- > 0;) bits += (code >> b & 1) != 0 ? '1' : '0';
    if (v < node.version) bits += ' ';
  }
  return bits;
}

}  // namespace

TEST(NodeCodes, EveryCodeAndWidthIsAsTheFactsSay) {
  size_t codes = 0;
  for (const auto& [type_name, versions] : facts()["ndt"].items()) {
    const NodeDataType type = type_of(type_name);
    for (unsigned v = 1; v <= kVersions; ++v) {
      const json table = versions.value(std::to_string(v),
                                        json{{"bits", v == 2 ? 1 : 0}, {"codes", json::object()}});
      EXPECT_EQ(node_code_bits(type, v), table["bits"].get<unsigned>())
          << type_name << " version " << v;
      for (const auto& [node_name, code] : table["codes"].items()) {
        const NodeDefinition* node = definitions().find(node_name);
        ASSERT_NE(node, nullptr) << node_name;
        EXPECT_EQ(node->version, v);
        EXPECT_EQ(node_code(*node, type), code.get<uint32_t>()) << node_name << " in " << type_name;
        EXPECT_EQ(node_of_code(type, v, code.get<uint32_t>()), node)
            << node_name << " in " << type_name;
        ++codes;
      }
      const uint32_t behind = static_cast<uint32_t>(table["codes"].size()) + (v == 2 ? 2 : 1);
      EXPECT_EQ(node_of_code(type, v, behind), nullptr) << type_name << " version " << v;
      EXPECT_EQ(node_of_code(type, v, kEscapeCode), nullptr);
    }
    EXPECT_EQ(node_of_code(type, kProtoVersion, kProtoCode), nullptr);
  }
  EXPECT_GT(codes, 450U);
}

TEST(NodeCodes, FieldIndicesAndWidthsAreAsTheFactsSay) {
  for (const json& fact : facts()["nodes"]) {
    if (fact["private"]) continue;
    const auto name = fact["name"].get<std::string>();
    const NodeDefinition& node = *definitions().find(name);
    for (size_t m = 0; m < nodes::kIndexModes; ++m) {
      const auto mode = static_cast<IndexMode>(m);
      EXPECT_EQ(field_count(node, mode), fact["count"][kModes[m]].get<uint32_t>())
          << name << " " << kModes[m];
      EXPECT_EQ(field_index_bits(node, mode), fact["bits"][kModes[m]].get<unsigned>())
          << name << " " << kModes[m];
      for (size_t f = 0; f < node.fields().size(); ++f) {
        const json& index = fact["fields"][f]["index"][kModes[m]];
        const auto ours = node.index_in(mode, nodes::FieldIndex{f});
        ASSERT_EQ(ours.has_value(), !index.is_null())
            << name << "." << node.fields()[f].name << " " << kModes[m];
        if (!ours) continue;
        EXPECT_EQ(*ours, index.get<uint32_t>())
            << name << "." << node.fields()[f].name << " " << kModes[m];
        EXPECT_EQ(node.fields_in(mode)[*ours], nodes::FieldIndex{f});
      }
    }
  }
}

TEST(NodeCodes, TheDibrNodesHaveTheseCodes) {
  EXPECT_EQ(code_bits("DepthImage", "SF3DNode"), "000000 000 00 000 00011");
  EXPECT_EQ(code_bits("DepthImage", "SFDepthImageNode"), " 0   1");
  EXPECT_EQ(code_bits("OctreeImage", "SF3DNode"), "000000 000 00 000 00101");
  EXPECT_EQ(code_bits("PointTexture", "SFDepthTextureNode"), " 0   01");
  EXPECT_EQ(code_bits("SimpleTexture", "SFDepthTextureNode"), " 0   10");
  EXPECT_EQ(code_bits("DepthImageV2", "SF3DNode"), "000000 000 00 000 00000 000 001");
  EXPECT_EQ(code_bits("DepthImageV2", "SFDepthImageNode"), " 0   0  1");
  EXPECT_EQ(code_bits("PointTextureV2", "SFDepthTextureNode"), " 0   00  01");
  EXPECT_EQ(code_bits("BitWrapper", "SFGeometryNode"), "00000 00   0001");
  EXPECT_EQ(code_bits("OctreeImage", "SFWorldNode"), "0000000 0000 00 000 010001");
  EXPECT_EQ(code_bits("SimpleTexture", "SFWorldNode"), "0000000 0000 00 000 100011");
}

TEST(NodeCodes, ANodeHasNoCodeWhereItMayNotStand) {
  EXPECT_EQ(node_code(*definitions().find("Sphere"), type_of("SF3DNode")), std::nullopt);
  EXPECT_EQ(node_code_bits(NodeDataType{200}, 1), 0U);
  EXPECT_EQ(node_of_code(type_of("SF3DNode"), 10, 1), nullptr);
}

TEST(NodeCodes, BitsForIsTheLengthOfTheNumber) {
  EXPECT_EQ(bits_for(0), 0U);
  EXPECT_EQ(bits_for(1), 1U);
  EXPECT_EQ(bits_for(255), 8U);
  EXPECT_EQ(bits_for(256), 9U);
}

}  // namespace afx::bifs
