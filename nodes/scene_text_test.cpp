// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <bit>
#include <cmath>
#include <limits>

#include "nodes/scene_test_support.h"
#include "nodes/scene_writer.h"

namespace afx::nodes {

namespace {

/// The first root of a scene that is a single node.
template <class T>
T value_in(const std::string& text, const std::string& field) {
  const Scene scene = read_scene(text);
  const T* value = scene.roots().empty() ? nullptr : scene.find<T>(scene.roots()[0], field);
  EXPECT_NE(value, nullptr) << text;
  return value != nullptr ? *value : T{};
}

void expect_round_trip(const std::string& text) {
  const Scene scene = read_scene(text);
  const std::string written = write_scene_text(scene);
  const Scene again = read_scene(written);
  EXPECT_TRUE(equal(scene, again)) << written;
  EXPECT_EQ(write_scene_text(again), written);
}

}  // namespace

TEST(SceneText, ANodeHasTheValuesGivenAndElseTheDefaults) {
  const Scene scene =
      read_scene("#VRML V2.0 utf8\nDEF D DepthImage { nearPlane 2.5 orthographic FALSE }");
  const NodeId id = scene.find_name("D");
  ASSERT_TRUE(id.valid());
  EXPECT_EQ(scene.get<float>(id, "nearPlane"), 2.5F);
  EXPECT_EQ(scene.get<float>(id, "farPlane"), 100.0F);
  EXPECT_FALSE(scene.get<bool>(id, "orthographic"));
  EXPECT_EQ(scene.get<glm::vec3>(id, "position"), glm::vec3(0, 0, 10));
  EXPECT_EQ(scene.find<float>(id, "position"), nullptr);  // another type
  EXPECT_EQ(scene.find<float>(id, "noSuchField"), nullptr);
}

TEST(SceneText, IntegersHaveTheseForms) {
  using Ints = std::vector<int32_t>;
  EXPECT_EQ((value_in<Ints>("OctreeImage { octree [ 1 -2,+3,,0x10 0XfF -0x1 007 ] }", "octree")),
            (Ints{1, -2, 3, 16, 255, -1, 7}));
  EXPECT_EQ((value_in<Ints>("OctreeImage{octree[2147483647 -2147483648 0xFFFFFFFF 0x7fffffff]}",
                            "octree")),
            (Ints{2147483647, -2147483647 - 1, -1, 2147483647}));
  EXPECT_EQ((value_in<Ints>("OctreeImage { octree 5 octreeResolution 3 }", "octree")), Ints{5});
  EXPECT_EQ((value_in<Ints>("OctreeImage { octree [] }", "octree")), Ints{});
  EXPECT_EQ((value_in<Ints>("OctreeImage { octree [ 1 # 7 ] 8\n 2#\n#]\r3 ] }", "octree")),
            (Ints{1, 2, 3}));
}

TEST(SceneText, FloatsHaveTheseForms) {
  using Floats = std::vector<float>;
  constexpr float kInf = std::numeric_limits<float>::infinity();
  EXPECT_EQ(
      (value_in<Floats>("ScalarInterpolator { key [ 1 -2.5 +.5 3. 1e3 1E-2 -1e+2 0 ] }", "key")),
      (Floats{1, -2.5F, 0.5F, 3, 1000, 0.01F, -100, 0}));
  EXPECT_EQ(
      (value_in<Floats>("ScalarInterpolator { key [ inf +inf -Inf INFINITY -infinity ] }", "key")),
      (Floats{kInf, kInf, -kInf, kInf, -kInf}));
  // Too small for a float: the nearest is a denormal or 0. 1e-46 is below half of the least
  // denormal.
  EXPECT_EQ((value_in<Floats>("ScalarInterpolator { key [ 1e-45 1e-46 -1e-400 0.00000000000001e-40 "
                              "0e9999999999999999999 ] }",
                              "key")),
            (Floats{std::numeric_limits<float>::denorm_min(), 0, -0.0F, 0, 0}));
  const auto zeros = value_in<Floats>("ScalarInterpolator { key [ -0 -0.0 -1e-60 ] }", "key");
  for (const float zero : zeros) EXPECT_TRUE(std::signbit(zero));
  const auto nans =
      value_in<Floats>("ScalarInterpolator { key [ nan -NaN nan(0x7fc12345) ] }", "key");
  ASSERT_EQ(nans.size(), 3U);
  EXPECT_EQ(std::bit_cast<uint32_t>(nans[0]), 0x7fc00000U);
  EXPECT_EQ(std::bit_cast<uint32_t>(nans[1]), 0xffc00000U);
  EXPECT_EQ(std::bit_cast<uint32_t>(nans[2]), 0x7fc12345U);
}

TEST(SceneText, StringsHaveTwoEscapesAndKeepEverythingElse) {
  EXPECT_EQ(value_in<std::string>(R"(WorldInfo { title "a \"b\" \\ c \n # d" })", "title"),
            R"(a "b" \ c \n # d)");
  EXPECT_EQ(value_in<std::string>("WorldInfo { title \"Grüße\n深度\" }", "title"), "Grüße\n深度");
  EXPECT_EQ((value_in<std::vector<std::string>>(R"(WorldInfo { info ["" "a","b"] })", "info")),
            (std::vector<std::string>{"", "a", "b"}));
}

TEST(SceneText, UrlsAreDescriptorsOrText) {
  const Url ten{"", 10};
  EXPECT_EQ(
      (value_in<std::vector<Url>>(
          R"(ImageTexture { url [ 10 "od:10" "10" od:10 "od:10#part" "a.png" "1024" ] })", "url")),
      (std::vector<Url>{ten, ten, ten, ten, {"od:10#part", -1}, {"a.png", -1}, {"1024", -1}}));
}

TEST(SceneText, ImagesAreBytesRowByRow) {
  const auto image = value_in<Image>("PixelTexture { image 2 1 3 0xFF8800 255 }", "image");
  EXPECT_EQ(image, (Image{2, 1, 3, {255, 136, 0, 0, 0, 255}}));
  EXPECT_EQ((value_in<Image>("PixelTexture { image 1 1 4 0xFFFFFFFE }", "image").samples),
            (std::vector<uint8_t>{255, 255, 255, 254}));
  EXPECT_EQ((value_in<Image>("PixelTexture { image 0 0 0 }", "image")), Image{});
  EXPECT_EQ(
      (value_in<Image>("PixelTexture { image 3 1 2 0x1080 32 0 repeatS FALSE }", "image").samples),
      (std::vector<uint8_t>{16, 128, 0, 32, 0, 0}));
}

TEST(SceneText, BuffersAreBytesInSeveralForms) {
  const auto buffer = [](const std::string& text) {
    return value_in<std::string>("BitWrapper { buffer \"" + text + "\" }", "buffer");
  };
  const std::string bytes("\0\xFF\x10", 3);
  EXPECT_EQ(buffer("data:application/octet-string,00FF10"), bytes);
  EXPECT_EQ(buffer("data:application/octet-string;base64,AP8Q"), bytes);
  EXPECT_EQ(buffer("data:application/octet-string;base64,AP8="), bytes.substr(0, 2));
  EXPECT_EQ(buffer("data:application/octet-string;base64,AA=="), bytes.substr(0, 1));
  EXPECT_EQ(buffer("0x00ff10"), bytes);
  EXPECT_EQ(buffer("00ff10"), bytes);
  EXPECT_EQ(buffer(""), "");
}

TEST(SceneText, ABufferFromAFileIsLoadedByTheCaller) {
  SceneReadOptions options;
  options.load_file = [](std::string_view name) -> Result<std::string> {
    return std::string(name).append("!");
  };
  Diagnostics diagnostics;
  const auto scene =
      read_scene_text("BitWrapper { buffer \"file:a.bin\" }", {}, diagnostics, options);
  ASSERT_TRUE(scene.ok());
  EXPECT_EQ(scene.value().get<std::string>(scene.value().roots()[0], "buffer"), "a.bin!");
}

TEST(SceneText, DefAndUseShareOneNode) {
  const Scene scene =
      read_scene("Group { children [ DEF A Shape {} USE A Group { children USE A } ] }");
  const auto& children = scene.get<std::vector<NodeId>>(scene.roots()[0], "children");
  ASSERT_EQ(children.size(), 3U);
  EXPECT_EQ(children[0], children[1]);
  EXPECT_EQ(scene.get<std::vector<NodeId>>(children[2], "children")[0], children[0]);
  EXPECT_EQ(scene.node_count(), 3U);
}

TEST(SceneText, ANameGivenTwiceIsANewNodeAndUseMeansTheLast) {
  Diagnostics diagnostics;
  const std::string text =
      "DEF A Group {} USE A DEF A Transform {} USE A DEF A_2 Shape {} DEF A Shape {} USE A";
  const auto scene = read_scene_text(text, {}, diagnostics);
  ASSERT_TRUE(scene.ok());
  const auto& roots = scene.value().roots();
  ASSERT_EQ(roots.size(), 7U);
  EXPECT_EQ(roots[0], roots[1]);
  EXPECT_EQ(roots[2], roots[3]);
  EXPECT_EQ(roots[5], roots[6]);
  EXPECT_EQ(diagnostics.count(), 3U);
  EXPECT_EQ(diagnostics.warnings()[0].code, "def_twice");
  EXPECT_EQ(diagnostics.warnings()[0].place, Place::at_line(1, 26));
  expect_round_trip(text);
}

TEST(SceneText, RoutesConnectFieldsByTheirVrmlNames) {
  const Scene scene = read_scene(
      "DEF T TimeSensor {} DEF P PositionInterpolator {} DEF X Transform {}\n"
      "ROUTE T.fraction_changed TO P.set_fraction DEF R ROUTE P.value_changed TO "
      "X.set_translation");
  const auto& routes = scene.scope().routes;
  ASSERT_EQ(routes.size(), 2U);
  EXPECT_EQ(routes[0].from, scene.find_name("T"));
  EXPECT_EQ(routes[1].name, "R");
  EXPECT_EQ(routes[1].to_field, scene.node(scene.find_name("X")).definition->find("translation"));
}

TEST(SceneText, RoutesAndProtosMayStandInNodes) {
  const Scene scene = read_scene(
      "Group { children [ DEF A Transform {} DEF B Transform {} ] ROUTE A.scale TO B.scale PROTO P "
      "[] { Box {} } }");
  EXPECT_EQ(scene.scope().routes.size(), 1U);
  EXPECT_EQ(scene.scope().protos.size(), 1U);
}

TEST(SceneText, AProtoHasInterfaceBodyAndLinks) {
  const Scene scene = read_scene(
      "PROTO Ball [ exposedField SFColor tint 1 0 0 { QP 4 b { 0 1 } } field MFInt32 n [ 3 ] { QP "
      "13 nbBits 5 b { 0 31 } } ]\n"
      "{ Material { diffuseColor IS tint } DEF S Sphere {} }\n"
      "Shape { appearance Appearance { material Ball { tint 0 0 1 } } }");
  const ProtoId id = scene.find_proto("Ball");
  ASSERT_TRUE(id.valid());
  const Proto& proto = scene.proto(id);
  const FieldDefinition& tint = proto.interface.field(proto.interface.find("tint"));
  EXPECT_EQ(tint.quant_category, 4);
  EXPECT_EQ(tint.bounds, (Bounds{0, 1, false, false}));
  EXPECT_EQ(proto.interface.field(proto.interface.find("n")).quant_bits, 5);
  EXPECT_EQ(proto.interface.data_types,
            scene.node(scene.scope(proto.body).roots[0]).definition->data_types);
  EXPECT_TRUE(scene.find_name("S", proto.body).valid());
  EXPECT_FALSE(scene.find_name("S").valid());
  const Node& material = scene.node(scene.scope(proto.body).roots[0]);
  ASSERT_EQ(material.links.size(), 1U);
  EXPECT_EQ(material.definition->field(material.links[0].field).name, "diffuseColor");
}

TEST(SceneText, AnExternProtoNeedsNoDefaultsAndMayStandAnywhere) {
  const Scene scene = read_scene(
      "EXTERNPROTO Lamp [ exposedField SFColor color 1 1 1 eventIn SFBool on field MFString tags ] "
      "[ \"lib.wrl#Lamp\" 30 ]\n"
      "Shape { geometry Lamp { color 0 1 0 } appearance Lamp {} }");
  const Proto& proto = scene.proto(scene.find_proto("Lamp"));
  EXPECT_TRUE(proto.external);
  EXPECT_EQ(proto.urls, (std::vector<Url>{{"lib.wrl#Lamp", -1}, {"", 30}}));
  EXPECT_EQ(scene.scope(proto.body).roots.size(), 0U);
}

TEST(SceneText, AScriptKeepsItsFieldsAndText) {
  const Scene scene = read_scene(
      "DEF S Script { eventIn SFBool clicked field SFInt32 count 5 directOutput TRUE field SFNode "
      "t Group {} eventOut SFTime out\n"
      " url \"javascript: x = 'a';\" }\n DEF T TouchSensor {} ROUTE T.isActive TO S.clicked");
  const NodeId id = scene.find_name("S");
  const NodeDefinition& definition = *scene.node(id).definition;
  EXPECT_EQ(definition.fields().size(), 7U);
  EXPECT_EQ(scene.get<int32_t>(id, "count"), 5);
  EXPECT_TRUE(scene.get<bool>(id, "directOutput"));
  EXPECT_EQ(scene.get<std::vector<std::string>>(id, "url")[0], "javascript: x = 'a';");
  // Behind the three fields that every Script has, in every mode.
  EXPECT_EQ(definition.index_in(IndexMode::in, definition.find("clicked")), 1U);
  EXPECT_EQ(definition.index_in(IndexMode::def, definition.find("count")), 3U);
}

TEST(SceneText, ACommandBufferIsKeptAsItsText) {
  const std::string text = "Conditional { buffer { REPLACE A.b BY { \"}\" } # }\n } }";
  EXPECT_EQ(value_in<CommandBuffer>(text, "buffer").text, " REPLACE A.b BY { \"}\" } # }\n ");
  expect_round_trip(text);
}

TEST(SceneText, AByteOrderMarkAndAnyLineEndsAreTaken) {
  EXPECT_EQ(read_scene("\xEF\xBB\xBF#VRML V2.0 utf8\r\nGroup {}\rShape {}").roots().size(), 2U);
  EXPECT_EQ(read_scene("").roots().size(), 0U);
  EXPECT_EQ(read_scene("# nothing").roots().size(), 0U);
}

TEST(SceneText, BytesThatAreNotUtf8AreKeptWithAWarning) {
  Diagnostics diagnostics;
  const auto scene = read_scene_text("WorldInfo {\n title \"a\xFFz\" }", {}, diagnostics);
  ASSERT_TRUE(scene.ok());
  EXPECT_EQ(scene.value().get<std::string>(scene.value().roots()[0], "title"), "a\xFFz");
  ASSERT_EQ(diagnostics.count(), 1U);
  EXPECT_EQ(diagnostics.warnings()[0].code, "invalid_utf8");
  EXPECT_EQ(diagnostics.warnings()[0].place, Place::at_line(2, 10));
}

TEST(SceneText, EverySampleReadsBackEqual) {
  const auto scenes = plain_scenes();
  EXPECT_EQ(scenes.size(), 31U);
  for (const auto& [name, text] : scenes) {
    SCOPED_TRACE(name);
    expect_round_trip(text);
  }
}

TEST(SceneText, EveryFloatReadsBackToItsBits) {
  Scene scene;
  const NodeId id = scene.add("ScalarInterpolator").value();
  scene.add_root(id);
  std::vector<float> values;
  for (uint64_t bits = 0; bits <= UINT32_MAX; bits += 65521)
    values.push_back(std::bit_cast<float>(static_cast<uint32_t>(bits)));
  for (const uint32_t bits : {0x7f800000U, 0xff800000U, 0x7fc00000U, 0xffc00000U, 0x7f800001U,
                              0xffffffffU, 1U, 0x80000000U})
    values.push_back(std::bit_cast<float>(bits));
  ASSERT_TRUE(scene.set(id, "key", values).ok());
  EXPECT_TRUE(equal(scene, read_scene(write_scene_text(scene))));
}

TEST(SceneText, EveryDoubleReadsBackToItsBits) {
  Scene scene;
  std::vector<double> values{5e-324, 1.7976931348623157e308, 0.1, -0.0, 1.0 / 3, 2208988800.123456};
  uint64_t bits = 88172645463325252U;
  for (int i = 0; i < 20000; ++i) {  // xorshift
    bits ^= bits << 13;
    bits ^= bits >> 7;
    bits ^= bits << 17;
    values.push_back(std::bit_cast<double>(bits));
  }
  for (const double value : values) {
    const NodeId id = scene.add("TimeSensor").value();
    ASSERT_TRUE(scene.set(id, "startTime", value).ok());
    scene.add_root(id);
  }
  EXPECT_TRUE(equal(scene, read_scene(write_scene_text(scene))));
}

TEST(SceneText, ScenesThatDifferAreNotEqual) {
  const char* const texts[] = {"Group {}",
                               "Transform {}",
                               "DEF A Group {}",
                               "Group {} Group {}",
                               "DEF A Group {} USE A",
                               "Group { children Shape {} }",
                               "DepthImage { nearPlane 1 }",
                               "DepthImage { nearPlane 1.0000001 }",
                               "DepthImage { nearPlane -0 }",
                               "DepthImage { nearPlane 0 }",
                               "PROTO P [] { Group {} } P {}",
                               "PROTO Q [] { Group {} } Q {}",
                               "PROTO P [ field SFInt32 a 1 ] { Group {} } P {}",
                               "PROTO P [ field SFInt32 a 2 ] { Group {} } P {}",
                               "PROTO P [ field SFInt32 a 2 { QP 13 nbBits 3 } ] { Group {} } P {}",
                               "DEF A Transform {} ROUTE A.scale TO A.center",
                               "DEF A Transform {} ROUTE A.scale TO A.translation",
                               "DEF A Transform {} DEF R ROUTE A.scale TO A.translation",
                               "Script {}",
                               "Script { field SFInt32 a 1 }",
                               "Script { field SFInt32 b 1 }",
                               "PROTO P [ field SFFloat r 1 ] { Sphere { radius IS r } } P {}",
                               "PROTO P [ field SFFloat r 1 ] { Sphere { } } P {}"};
  for (size_t i = 0; i < std::size(texts); ++i)
    for (size_t k = 0; k < std::size(texts); ++k)
      EXPECT_EQ(equal(read_scene(texts[i]), read_scene(texts[k])), i == k)
          << texts[i] << " and " << texts[k];
  // A default that is written out is no difference, nor is the order of fields.
  EXPECT_TRUE(equal(read_scene("DepthImage {}"), read_scene("DepthImage { nearPlane 10 }")));
  EXPECT_TRUE(equal(read_scene("Transform { scale 1 2 3 center 4 5 6 }"),
                    read_scene("Transform { center 4 5 6 scale 1 2 3 }")));
}

TEST(SceneText, TheWriterNamesNodesThatAreSharedAndNamesThatTextCannotHold) {
  Scene scene;
  const NodeId group = scene.add("Group").value();
  const NodeId shape = scene.add("Shape").value();
  const NodeId other = scene.add("Shape").value();
  scene.add_root(group);
  ASSERT_TRUE(scene.set_name(other, "two words").ok());
  for (const NodeId child : {shape, other, shape})
    ASSERT_TRUE(scene.append(group, "children", child).ok());
  EXPECT_EQ(write_scene_text(scene, {.vrml_header = true}),
            "#VRML V2.0 utf8\nGroup {\n  children [\n    DEF _N1 Shape {}\n    DEF _N2 Shape {}\n  "
            "  USE _N1\n  ]\n}\n");
}

}  // namespace afx::nodes
