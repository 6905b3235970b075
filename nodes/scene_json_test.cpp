// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What scene text means, against an independent decode of the same scenes by way of BIFS
// (conformance/suites/bifs-gpac/README.md).
#include <cmath>
#include <limits>
#include <map>

#include "nodes/definitions.h"
#include "nodes/scene_test_support.h"

namespace afx::nodes {

namespace {

using nlohmann::json;

double number_of(const json& j) {
  if (!j.is_string()) return j.get<double>();
  const std::string text = j.get<std::string>();
  if (text == "nan") return std::numeric_limits<double>::quiet_NaN();
  return text[0] == '-' ? -std::numeric_limits<double>::infinity()
                        : std::numeric_limits<double>::infinity();
}

bool same_number(double value, const json& j) {
  const double expected = number_of(j);
  return value == expected || (std::isnan(value) && std::isnan(expected));
}
bool same_float(float value, const json& j) {
  const double expected = number_of(j);
  return same_number(value, j) || value == static_cast<float>(expected);
}
bool same_floats(const float* values, size_t count, const json& j) {
  if (j.size() != count) return false;
  for (size_t i = 0; i < count; ++i)
    if (!same_float(values[i], j[i])) return false;
  return true;
}

bool same(bool v, const json& j) { return j.is_boolean() && v == j.get<bool>(); }
bool same(uint8_t v, const json& j) { return same(v != 0, j); }
bool same(int32_t v, const json& j) {
  return j.is_string() ? v == INT32_MAX : static_cast<double>(v) == j.get<double>();
}
bool same(float v, const json& j) { return same_float(v, j); }
bool same(double v, const json& j) { return same_number(v, j); }
bool same(const std::string& v, const json& j) {
  if (j.is_string()) return v == j.get<std::string>();
  std::string hex;
  for (const char c : v) {
    char digits[3];
    std::snprintf(digits, sizeof digits, "%02x", static_cast<unsigned char>(c));
    hex += digits;
  }
  return j.is_object() && hex == j.at("hex").get<std::string>();
}
bool same(const Url& v, const json& j) {
  return j.is_object() ? v.object_descriptor == j.at("od").get<int>()
                       : !v.is_descriptor() && v.text == j.get<std::string>();
}
bool same(const glm::vec2& v, const json& j) { return same_floats(&v.x, 2, j); }
bool same(const glm::vec3& v, const json& j) { return same_floats(&v.x, 3, j); }
bool same(const glm::vec4& v, const json& j) { return same_floats(&v.x, 4, j); }
bool same(const Rotation& v, const json& j) { return same_floats(&v.x, 4, j); }
bool same(const Image& v, const json& j) {
  if (v.width != j.at("width") || v.height != j.at("height")) return false;
  if (v.samples.empty()) return j.at("pixels") == "" || j.at("pixels").empty();
  const std::string bytes(v.samples.begin(), v.samples.end());
  return v.components == j.at("numComponents") && same(bytes, json{{"hex", j.at("pixels")}});
}
bool same(NodeId v, const json& j) { return !v.valid() && j.is_null(); }
bool same(const CommandBuffer& v, const json& j) { return v.text.empty() && j.empty(); }
template <class T>
bool same(const std::vector<T>& v, const json& j) {
  if (!j.is_array() || v.size() != j.size()) return false;
  for (size_t i = 0; i < v.size(); ++i)
    if (!same(v[i], j[i])) return false;
  return true;
}

/// Walks a scene and its decode in step.
class Comparison {
 public:
  explicit Comparison(const Scene& scene) : scene_(scene) {}
  size_t fields = 0;

  void node(NodeId id, const json& j, const std::string& path) {
    ASSERT_EQ(id.valid(), !j.is_null()) << path;
    if (!id.valid()) return;
    if (j.contains("use")) {
      ASSERT_TRUE(by_id_.contains(j["use"])) << path;
      EXPECT_EQ(by_id_.at(j["use"]), id) << path;
      return;
    }
    const NodeDefinition& definition = *scene_.node(id).definition;
    ASSERT_EQ(definition.name, j.at("node").get<std::string>()) << path;
    if (j.contains("id")) by_id_[j["id"]] = id;
    for (size_t i = 0; i < definition.fields().size(); ++i)
      field(id, FieldIndex{i}, j.at("fields"), path);
  }

 private:
  void field(NodeId id, FieldIndex index, const json& given, const std::string& path) {
    const FieldDefinition& definition = scene_.node(id).definition->field(index);
    if (!definition.has_value()) return;
    // The peer does not write these (defects 11 and 16 of the vectors' README).
    if (element_type(definition.type) == FieldType::sf_vec4f ||
        definition.type == FieldType::sf_command_buffer)
      return;
    const std::string here = path + "/" + definition.name;
    const FieldValue& value = scene_.value(id, index);
    ++fields;
    if (!given.contains(definition.name)) {
      FieldValue normal = value;  // absent: equal to the default as numbers, -0 as 0
      std::visit(
          []<class T>(T& v) {
            if constexpr (std::is_floating_point_v<T>) v += T{0};
            if constexpr (std::is_same_v<T, glm::vec2> || std::is_same_v<T, glm::vec3>) v += T(0);
          },
          normal);
      EXPECT_TRUE(same_bits(normal, definition.default_value)) << here;
      return;
    }
    // The peer keeps both of "\\\\"; VRML97 says that they stand for one.
    if (here == "27-strings-utf8/children[0]/info") return;
    const json& j = given.at(definition.name);
    if (definition.type == FieldType::sf_node) return node(*std::get_if<NodeId>(&value), j, here);
    if (definition.type != FieldType::mf_node) {
      EXPECT_TRUE(json_equals(value, j)) << here << " is not " << j;
      return;
    }
    const auto& list = *std::get_if<std::vector<NodeId>>(&value);
    ASSERT_EQ(list.size(), j.size()) << here;
    for (size_t i = 0; i < list.size(); ++i)
      node(list[i], j[i], here + "[" + std::to_string(i) + "]");
  }

  const Scene& scene_;
  std::map<int, NodeId> by_id_;
};

}  // namespace

bool json_equals(const FieldValue& value, const json& j) {
  return std::visit([&](const auto& v) { return same(v, j); }, value);
}

TEST(SceneText, ScenesMeanWhatAnIndependentDecoderSaw) {
  // Those without quantization, PROTOs, Scripts and IDs that the stream alone has.
  constexpr const char* kScenes[] = {"01-depthimage-pixeltexture",
                                     "04-pointtexture",
                                     "05-octreeimage",
                                     "07-dibr-v2",
                                     "08-shapes3d",
                                     "09-environment",
                                     "12-grouping",
                                     "27-strings-utf8",
                                     "28-extremes",
                                     "31-2d-graphics",
                                     "32-later-versions"};
  const auto texts = plain_scenes();
  size_t fields = 0;
  for (const std::string name : kScenes) {
    const json decoded = json::parse(
        file_text(source_path("conformance/suites/bifs-gpac/" + name + "/decoded.json")));
    const Scene scene = read_scene(texts.at(name));
    ASSERT_EQ(scene.roots().size(), 1U) << name;
    Comparison comparison(scene);
    comparison.node(scene.roots()[0], decoded["accessUnits"][0]["commands"][0]["node"], name);
    fields += comparison.fields;
  }
  EXPECT_GT(fields, 1400U);
}

}  // namespace afx::nodes
