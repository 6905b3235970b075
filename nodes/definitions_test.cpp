// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The definitions against conformance/facts/mpeg4-nodes.json (origin: README.md there).
#include "nodes/definitions.h"

#include <limits>
#include <set>

#include "nodes/scene_test_support.h"

namespace afx::nodes {

namespace {

using nlohmann::json;

const json& facts() {
  static const json table =
      json::parse(file_text(source_path("conformance/facts/mpeg4-nodes.json")));
  return table;
}

double bound_of(const json& j) {
  if (!j.is_string()) return j.get<double>();
  return j == "-inf" ? -std::numeric_limits<double>::infinity()
                     : std::numeric_limits<double>::infinity();
}

void expect_field(const FieldDefinition& field, const json& fact, const std::string& path) {
  const Definitions& d = definitions();
  EXPECT_EQ(field.name, fact["name"].get<std::string>()) << path;
  EXPECT_EQ(to_string(field.kind), fact["event"].get<std::string>()) << path;
  EXPECT_EQ(to_string(field.type), fact["baseType"].get<std::string>()) << path;
  if (is_node(field.type)) {
    EXPECT_EQ(d.data_type_name(field.data_type), fact["ndt"].get<std::string>()) << path;
  }
  EXPECT_EQ(field.has_value(), fact.contains("default")) << path;
  EXPECT_TRUE(holds(field.type, field.default_value)) << path;
  if (fact.contains("default")) {
    EXPECT_TRUE(json_equals(field.default_value, fact["default"])) << path;
  }
  const json& quant = fact["quant"];
  EXPECT_EQ(field.quant_category, quant.is_null() ? 0 : quant["category"].get<int>()) << path;
  EXPECT_EQ(field.quant_bits, quant.is_null() ? 0 : quant.value("nbits", 0)) << path;
  EXPECT_EQ(field.anim_category, fact["anim"].is_null() ? 0 : fact["anim"].get<int>()) << path;
  ASSERT_EQ(field.bounds.has_value(), !fact["bounds"].is_null()) << path;
  if (!field.bounds) return;
  const json open = fact.value("boundsOpen", json::array({false, false}));
  EXPECT_EQ(field.bounds->lower, bound_of(fact["bounds"][0])) << path;
  EXPECT_EQ(field.bounds->upper, bound_of(fact["bounds"][1])) << path;
  EXPECT_EQ(field.bounds->lower_open, open[0].get<bool>()) << path;
  EXPECT_EQ(field.bounds->upper_open, open[1].get<bool>()) << path;
}

}  // namespace

TEST(Definitions, EveryPublicNodeIsAsTheFactsSay) {
  size_t next = 0, fields = 0;
  for (const json& fact : facts()["nodes"]) {
    if (fact["private"]) continue;
    ASSERT_LT(next, definitions().nodes().size());
    const NodeDefinition& node = definitions().nodes()[next++];  // the same order, too
    const auto name = fact["name"].get<std::string>();
    ASSERT_EQ(node.name, name);
    EXPECT_EQ(definitions().find(name), &node);
    EXPECT_EQ(node.version, fact["version"].get<int>()) << name;
    EXPECT_EQ(node.withdrawn, fact.value("withdrawn", false)) << name;
    EXPECT_EQ(node.script, fact["coding"] == "special") << name;
    std::set<std::string> types, expected;
    for (size_t t = 0; t < definitions().data_types().size(); ++t)
      if (contains(node.data_types, NodeDataType{static_cast<uint8_t>(t)}))
        types.insert(definitions().data_types()[t]);
    for (const json& type : fact["ndt"]) expected.insert(type);
    EXPECT_EQ(types, expected) << name;
    ASSERT_EQ(node.fields().size(), fact["fields"].size()) << name;
    for (size_t i = 0; i < node.fields().size(); ++i, ++fields)
      expect_field(node.fields()[i], fact["fields"][i], name + "." + node.fields()[i].name);
  }
  EXPECT_EQ(next, 190U);
  EXPECT_EQ(definitions().nodes().size(), 190U);
  EXPECT_GT(fields, 1700U);
}

TEST(Definitions, InsertionTypesAreAsTheFactsSay) {
  for (const json& fact : facts()["nodes"]) {
    if (fact["private"]) continue;
    const auto name = fact["name"].get<std::string>();
    // The peer's compiled tables have none for these two; its templates, and the rule, say
    // otherwise (remarks).
    if (name == "BuildingPartNode" || name == "FacadeNode") continue;
    const auto type = definitions().find(name)->insertion_type();
    const json& expected = fact["insertNdt"];
    ASSERT_EQ(type.has_value(), !expected.is_null()) << name;
    if (type) {
      EXPECT_EQ(definitions().data_type_name(*type), expected.get<std::string>()) << name;
    }
  }
}

TEST(Definitions, PrivateNodesAreLeftOut) {
  EXPECT_EQ(definitions().find("CacheTexture"), nullptr);
  EXPECT_EQ(definitions().find("NoSuchNode"), nullptr);
}

TEST(Definitions, TheCompiledInTextsAreTheFiles) {
  ASSERT_EQ(kDefinitionTextCount, 9U);
  for (unsigned i = 0; i < kDefinitionTextCount; ++i) {
    const std::string name = std::string("v").append(std::to_string(i + 1)).append(".nodes");
    EXPECT_EQ(kDefinitionTexts[i].name, name);
    EXPECT_EQ(kDefinitionTexts[i].text, file_text(source_path("nodes/definitions/" + name)));
  }
}

TEST(Definitions, OnlyTheBufferOfBitWrapperHoldsBytes) {
  size_t count = 0;
  for (const NodeDefinition& node : definitions().nodes())
    for (const FieldDefinition& field : node.fields()) count += field.bytes ? 1 : 0;
  EXPECT_EQ(count, 1U);
  const NodeDefinition& wrapper = *definitions().find("BitWrapper");
  EXPECT_TRUE(wrapper.field(wrapper.find("buffer")).bytes);
}

TEST(Definitions, EventsAnswerToTheirVrmlNames) {
  const NodeDefinition& transform = *definitions().find("Transform");
  const FieldIndex translation = transform.find("translation");
  EXPECT_EQ(transform.find_event_in("set_translation"), translation);
  EXPECT_EQ(transform.find_event_out("translation_changed"), translation);
  EXPECT_EQ(transform.find_event_in("translation"), translation);
  EXPECT_FALSE(transform.find_event_in("set_addChildren").valid());
  const NodeDefinition& faces = *definitions().find("IndexedFaceSet");
  // Here set_coordIndex is an event of its own, and coordIndex a plain field.
  EXPECT_NE(faces.find_event_in("set_coordIndex"), faces.find("coordIndex"));
}

TEST(Definitions, FaultsInAFileNameFileAndPlace) {
  const DefinitionText files[] = {
      {"v1.nodes", "NODE A { NDT SF3DNode } [\n  field SFFlot x 1\n]\n"}};
  const auto read = read_definitions(files);
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(to_string(read.error()),
            "v1.nodes:2:9: no field type 'SFFlot' (did you mean 'SFFloat'?)");
  EXPECT_EQ(read.error().excerpt, "  field SFFlot x 1\n        ^");
  const DefinitionText twice[] = {{"v1.nodes", "NODE A { NDT SF3DNode } []"},
                                  {"v2.nodes", "NODE A { NDT SF3DNode } []"}};
  EXPECT_FALSE(read_definitions(twice).ok());
}

}  // namespace afx::nodes
