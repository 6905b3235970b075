// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/xmt_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <string>

#include "bifs/config.h"
#include "bifs/vectors_test_support.h"
#include "bifs/xmt_writer.h"

namespace afx::bifs {

namespace {

using nodes::NodeId;
using testing::HasSubstr;

std::string in_body(const std::string& commands) {
  return "<XMT-A><Body>\n" + commands + "\n</Body></XMT-A>";
}
std::string in_scene(const std::string& children) {
  return in_body("<Replace><Scene><Group><children>\n" + children +
                 "\n</children></Group></Scene></Replace>");
}

Presentation read(const std::string& text) {
  Diagnostics warnings;
  Result<Presentation> presentation = read_xmt(text, {}, warnings);
  EXPECT_TRUE(presentation.ok()) << to_string(presentation.error()) << "\n" << text;
  EXPECT_EQ(warnings.count(), 0U);
  return presentation.ok() ? std::move(presentation).value() : Presentation{};
}

/// The commands of an access unit of the scene.
const std::vector<Command>& commands(const Presentation& presentation, size_t unit = 0) {
  return std::get<std::vector<Command>>(presentation.units.at(unit).commands);
}

/// A node that takes the place of another, where any may stand.
std::string alone(const std::string& node) {
  return in_body("<Replace><Scene><Group DEF='Old'/></Scene></Replace><Replace atNode='Old'>" +
                 node + "</Replace>");
}

/// The first value of that node.
template <class T>
T value_in(const std::string& node) {
  const Presentation presentation = read(alone(node));
  const NodeId alone = std::get<NodeReplacement>(commands(presentation).at(1)).node;
  return std::get<T>(presentation.scene.node(alone).values.at(0).value);
}

Error error_of(const std::string& text, const Limits& limits = {}) {
  Diagnostics warnings;
  const auto presentation = read_xmt(text, limits, warnings);
  EXPECT_FALSE(presentation.ok()) << text;
  return presentation.ok() ? Error{} : presentation.error();
}

std::string written(Presentation& presentation) {
  std::string text;
  XmtWriter writer([&](std::string_view piece) {
    text += piece;
    return Status{};
  });
  Diagnostics warnings;
  const Status told = play(presentation, writer, warnings);
  EXPECT_TRUE(told.ok()) << to_string(told.error());
  return text;
}

Presentation written_and_read(Presentation presentation) { return read(written(presentation)); }

}  // namespace

TEST(XmtValues, AreWhatTheAttributeSays) {
  EXPECT_EQ(value_in<int32_t>("<Switch whichChoice='-7'/>"), -7);
  EXPECT_EQ(value_in<bool>("<DepthImage orthographic='false'/>"), false);
  EXPECT_EQ(value_in<std::vector<float>>("<ScalarInterpolator key='0 0.25, 1'/>"),
            (std::vector<float>{0, 0.25F, 1}));
  EXPECT_EQ(value_in<std::vector<int32_t>>("<OctreeImage octree=''/>"), std::vector<int32_t>{});
  EXPECT_TRUE(std::isinf(value_in<float>("<Sphere radius='inf'/>")));
}

TEST(XmtValues, ResolveEntitiesAndKeepWhiteSpaceOfStrings) {
  EXPECT_EQ(value_in<std::string>(
                "<WorldInfo title=' a&lt;b &amp;&#233;&#x20AC;&#x1F30A;&quot;\t&apos;\r\n'/>"),
            " a<b &\xC3\xA9\xE2\x82\xAC\xF0\x9F\x8C\x8A\"\t'\n");
}

TEST(XmtValues, TakeListsOfStringsWithAndWithoutQuotes) {
  using Strings = std::vector<std::string>;
  EXPECT_EQ(value_in<Strings>(R"(<WorldInfo info='"a" "b \" \\ c"'/>)"),
            (Strings{"a", "b \" \\ c"}));
  EXPECT_EQ(value_in<Strings>("<WorldInfo info='just one'/>"), Strings{"just one"});
  EXPECT_EQ(value_in<Strings>("<WorldInfo info=' '/>"), Strings{});
}

TEST(XmtValues, TakeObjectDescriptorsInBothForms) {
  const auto urls = value_in<std::vector<nodes::Url>>(
      R"(<ImageTexture url='"od://od20" "od:21" "22" "a.png" "od:20#part" "od://od2000"'/>)");
  ASSERT_EQ(urls.size(), 6U);
  EXPECT_EQ(urls[0].object_descriptor, 20);
  EXPECT_EQ(urls[1].object_descriptor, 21);
  EXPECT_EQ(urls[2].object_descriptor, 22);
  EXPECT_EQ(urls[3].text, "a.png");
  EXPECT_EQ(urls[4].text, "od:20#part");
  EXPECT_EQ(urls[5].text, "od://od2000");
}

TEST(XmtValues, TakeBytesAsDataUrls) {
  const std::string bytes("\x00\xFF\x10", 3);
  for (const std::string text : {"data:application/octet-string;base64,AP8Q",
                                 "data:application/octet-string,%00%FF%10", "0x00FF10"})
    EXPECT_EQ(value_in<std::string>("<BitWrapper buffer='" + text + "'/>"), bytes);
}

TEST(XmtValues, ComeBackToTheBit) {
  constexpr auto kNan = std::numeric_limits<float>::quiet_NaN();
  const auto odd_nan = std::bit_cast<float>(0x7FA00001U);
  Presentation presentation =
      read(in_scene("<PositionInterpolator/><WorldInfo/><Shape><appearance><Appearance><texture>"
                    "<PixelTexture/></texture></Appearance></appearance></Shape>"));
  const std::vector<float> key{0.1F, -0.0F, INFINITY, -INFINITY, kNan, odd_nan, 1e-45F};
  const std::vector<std::string> info{"", "\"", "\\", "a\nb\r\tc", "<&>'", " x ", "\x01\xC3\xA9"};
  const nodes::Image image{1, 2, 4, {1, 2, 3, 4, 255, 254, 253, 0}};
  auto& scene = presentation.scene;
  ASSERT_TRUE(scene.set(NodeId{size_t{1}}, "key", key).ok());
  ASSERT_TRUE(scene.set(NodeId{size_t{2}}, "info", info).ok());
  ASSERT_TRUE(scene.set(NodeId{size_t{2}}, "title", std::string("\r\n\"q\" ")).ok());
  ASSERT_TRUE(scene.set(NodeId{size_t{5}}, "image", image).ok());
  const Presentation again = written_and_read(std::move(presentation));
  const auto& back = again.scene;
  EXPECT_TRUE(same_bits(back.node(NodeId{size_t{1}}).values.at(0).value, nodes::FieldValue{key}));
  EXPECT_EQ(back.get<std::vector<std::string>>(NodeId{size_t{2}}, "info"), info);
  EXPECT_EQ(back.get<std::string>(NodeId{size_t{2}}, "title"), "\r\n\"q\" ");
  EXPECT_EQ(back.get<nodes::Image>(NodeId{size_t{5}}, "image"), image);
}

TEST(XmtNodes, GetTheIdsOfTheirNamesOrTheOnesTheyAreTold) {
  const Presentation presentation = read(
      in_scene("<Group DEF='N4'/><Group DEF='a'/><Group DEF='b' binaryID='9'/><Group DEF='c'/>"));
  const auto& scene = presentation.scene;
  const auto id = [&](const char* name) { return scene.node(scene.find_name(name)).id; };
  EXPECT_EQ(id("N4"), 5U);
  EXPECT_EQ(id("a"), 1U);
  EXPECT_EQ(id("b"), 9U);
  EXPECT_EQ(id("c"), 2U);
}

TEST(XmtNodes, KeepIdsThatTheirNamesDoNotTell) {
  Presentation presentation =
      read(in_scene("<Group DEF='a' binaryID='3'/><Group DEF='N0' binaryID='2'/><Group DEF='b'/>"));
  presentation.scene.node(NodeId{size_t{0}}).id = 7;  // a name that N6 would be
  const Presentation again = written_and_read(std::move(presentation));
  for (const auto& [node, id] : {std::pair<size_t, uint32_t>{0, 7}, {1, 3}, {2, 2}, {3, 1}})
    EXPECT_EQ(again.scene.node(NodeId{node}).id, id) << node;
}

TEST(XmtNodes, MayReuseAnIdOfADeletedOne) {
  const std::string text = in_body(
      "<Replace><Scene><Group DEF='N0'><children><Shape DEF='N1'/></children></Group></Scene>"
      "</Replace><Delete atNode='N1'/>"
      "<Insert atNode='N0' position='END'><Transform DEF='N1' binaryID='2'/></Insert>"
      "<Replace atNode='N1' atField='scale' value='1 2 3'/>");
  Diagnostics warnings;
  auto presentation = read_xmt(text, {}, warnings);
  ASSERT_TRUE(presentation.ok()) << to_string(presentation.error());
  EXPECT_EQ(warnings.warnings().at(0).code, "def_twice");
  const auto& replacement = std::get<FieldReplacement>(commands(presentation.value()).at(3));
  EXPECT_EQ(presentation.value().scene.node(replacement.target.node).id, 2U);
  EXPECT_EQ(presentation.value().scene.type_name(replacement.target.node), "Transform");
}

TEST(XmtNodes, OfANewSceneHaveNamesAndIdsOfTheirOwn) {
  const Presentation presentation =
      read(in_body("<Replace><Scene><Group DEF='a'/></Scene></Replace>"
                   "<par begin='1'><Replace><Scene><Group DEF='a'/></Scene></Replace></par>"));
  EXPECT_EQ(presentation.scene.node(NodeId{size_t{0}}).id, 1U);
  EXPECT_EQ(presentation.scene.node(NodeId{size_t{1}}).id, 1U);
}

TEST(XmtUnits, AreOnesOfTheirStreamAndTime) {
  const Presentation presentation =
      read(in_body("<Replace><Scene><Group DEF='N0'/></Scene></Replace><ObjectDescriptorRemove "
                   "objectDescriptorId='od3 4'/>\n<par begin='0.001'><Delete atNode='N0'/></par>"
                   "<par begin='2.5' isRAP='yes'><Delete atNode='N0'/></par>"));
  ASSERT_EQ(presentation.units.size(), 4U);
  EXPECT_EQ(presentation.units[0].time, 0U);
  EXPECT_TRUE(presentation.units[0].random_access);
  const auto& removed = std::get<OdCommands>(presentation.units[1].commands);
  EXPECT_EQ(std::get<OdRemove>(removed.at(0).body).ids, (std::vector<uint16_t>{3, 4}));
  EXPECT_EQ(presentation.units[2].time, 1U);
  EXPECT_FALSE(presentation.units[2].random_access);
  EXPECT_EQ(presentation.units[3].time, 2500U);
  EXPECT_TRUE(presentation.units[3].random_access);
}

TEST(XmtDescriptors, OfAVectorAreRead) {
  const auto path = std::filesystem::path(AFX_SOURCE_DIR) /
                    "conformance/suites/bifs-gpac/13-media-object-descriptors";
  const Bytes file = file_bytes(path / "gpac.xmt");
  const Presentation presentation = read({file.begin(), file.end()});
  const InitialObjectDescriptor& initial = presentation.initial;
  EXPECT_FALSE(initial.in_file);
  EXPECT_EQ(initial.id, 1U);
  EXPECT_EQ(initial.od_profile, 1U);
  EXPECT_EQ(initial.graphics_profile, 254U);
  EXPECT_EQ(initial.visual_profile, 255U);
  ASSERT_EQ(initial.parts.size(), 2U);
  const EsDescriptor* scene = scene_stream(initial);
  ASSERT_NE(scene, nullptr);
  EXPECT_EQ(decoder_specific_info(*scene), file_bytes(path / "cfg.bin"));
  EXPECT_EQ(timestamp_resolution(scene), 1000U);
  EXPECT_TRUE(find_part<SlConfig>(scene->parts)->fields->access_unit_end);
  EXPECT_EQ(object_descriptor_stream(initial)->ocr_es_id, 1U);

  ASSERT_EQ(presentation.units.size(), 5U);
  const auto& update =
      std::get<OdUpdate>(std::get<OdCommands>(presentation.units[1].commands).at(0).body);
  const auto& image = std::get<ObjectDescriptor>(update.objects.at(0).body);
  EXPECT_EQ(image.id, 20U);
  const auto& es = std::get<EsDescriptor>(image.parts.at(0).body);
  EXPECT_EQ(es.source->file, "scene.mp4#20");
  EXPECT_EQ(decoder_specific_info(es), (Bytes{0x00, 0x14, 0x00, 0x01, 0x00, 0x01, 0x03}));
  EXPECT_EQ(find_part<DecoderConfig>(es.parts)->max_bitrate, 5360U);
  EXPECT_EQ(std::get<ObjectDescriptor>(update.objects.at(1).body).url, "other.mp4");
  EXPECT_EQ(presentation.units[3].time, 1500U);
  const auto& removal =
      std::get<EsRemove>(std::get<OdCommands>(presentation.units[3].commands).at(0).body);
  EXPECT_EQ(removal.od_id, 20U);
  EXPECT_FALSE(removal.references);
  EXPECT_EQ(removal.streams, std::vector<uint16_t>{31});
}

TEST(XmtDescriptors, OfEveryKindComeBack) {
  EsDescriptor es;
  es.es_id = 7;
  es.depends_on = 3;
  es.url = "a&b";
  es.priority = 31;
  es.source = MediaSource{"m.png", "MEDIA"};
  DecoderConfig config{object_type::kBifs, stream_type::kScene, true, 1, 2, 3, {}};
  BifsConfig bifs;
  bifs.node_id_bits = 5;
  bifs.size = DisplaySize{64, 48};
  config.parts = {{DecoderSpecificInfo{write_config(bifs).value()}},
                  {UnknownDescriptor{0x40, {1, 2, 3}}}};
  SlConfig own{0, SlFields{}, {9, 8}};
  own.fields->start_decoding_time = uint64_t{1} << 63;
  es.parts = {{config}, {own}, {UnknownDescriptor{0x41, {}}}};
  EsDescriptor other;
  other.es_id = 8;
  other.parts = {{DecoderConfig{5, 3, false, 0, 0, 0, {{DecoderSpecificInfo{{6}}}}}},
                 {SlConfig{2, {}, {}}}};
  Presentation presentation;
  presentation.initial.in_file = false;
  presentation.initial.inline_profiles = true;
  presentation.initial.parts = {{es}, {UnknownDescriptor{0x42, {0}}}, {other}, {EsIdInc{5}}};
  ObjectDescriptor object{false, 1023, "u", {{EsIdRef{2}}, {es}}};
  presentation.units.push_back({4, true,
                                OdCommands{{OdUpdate{{{object}}}},
                                           {OdRemove{{1, 2}}},
                                           {EsUpdate{3, false, {{other}}}},
                                           {EsRemove{4, true, {1}}},
                                           {EsRemove{5, false, {6, 7}}},
                                           {UnknownOdCommand{9, {1, 255}}}}});
  const InitialObjectDescriptor initial = presentation.initial;
  const auto units = std::get<OdCommands>(presentation.units[0].commands);
  const Presentation again = written_and_read(std::move(presentation));
  EXPECT_EQ(again.initial, initial);
  EXPECT_EQ(std::get<OdCommands>(again.units.at(0).commands), units);
}

TEST(XmtWriting, FailsWhereNoTextCanSayIt) {
  Presentation presentation = read(in_scene("<WorldInfo/>"));
  ASSERT_TRUE(presentation.scene.set(NodeId{size_t{1}}, "title", std::string("a\0b", 3)).ok());
  XmtWriter writer([](std::string_view) { return Status{}; });
  Diagnostics warnings;
  const Status told = play(presentation, writer, warnings);
  ASSERT_FALSE(told.ok());
  EXPECT_EQ(told.error().code, Errc::bad_argument);
}

TEST(XmtWriting, HandsOnTheErrorOfWhoeverTakesTheText) {
  Presentation presentation = read(in_scene("<WorldInfo/>"));
  XmtWriter writer([](std::string_view) { return Status{Error{Errc::io, {}, "full"}}; });
  Diagnostics warnings;
  const Status told = play(presentation, writer, warnings);
  ASSERT_FALSE(told.ok());
  EXPECT_EQ(told.error().code, Errc::io);
}

TEST(XmtWriting, HandsOnLongTextsInPieces) {
  std::string children;
  for (int i = 0; i < 20000; ++i) children += "<Transform translation='1 2 3'/>";
  Presentation presentation = read(in_scene(children));
  size_t longest = 0, whole = 0;
  XmtWriter writer([&](std::string_view piece) {
    longest = std::max(longest, piece.size());
    whole += piece.size();
    return Status{};
  });
  Diagnostics warnings;
  ASSERT_TRUE(play(presentation, writer, warnings).ok());
  EXPECT_GT(whole, size_t{20000} * 32);
  EXPECT_LT(longest, size_t{100000});
}

TEST(XmtReader, ATopNodeOfAnotherTypeGoesUnderAGroup) {
  Diagnostics warnings;
  const auto one = read_xmt(in_body("<Replace><Scene><Shape/></Scene></Replace>"), {}, warnings);
  ASSERT_TRUE(one.ok());
  const NodeId root = std::get<SceneReplacement>(commands(one.value()).at(0)).root;
  EXPECT_EQ(one.value().scene.type_name(root), "Group");
  ASSERT_EQ(warnings.count(), 1U);
  EXPECT_EQ(warnings.warnings()[0].code, "top_nodes");
  EXPECT_EQ(warnings.warnings()[0].place, Place::at_line(2, 18));
}

TEST(XmtErrors, SayWhereAndWhatIsMeant) {
  struct Case {
    std::string text;
    Place place;
    const char* says;
  };
  const Case cases[] = {
      {in_scene("<Sfere/>"), Place::at_line(3, 2), "no node 'Sfere'"},
      {in_scene("<DepthImag/>"), Place::at_line(3, 2), "did you mean 'DepthImage'?"},
      {in_scene("<Shape sise='1'/>"), Place::at_line(3, 8), "Shape: no field 'sise'"},
      {in_scene("<Switch whichChoise='1'/>"), Place::at_line(3, 9), "'whichChoice'?"},
      {in_scene("<Switch whichChoice='1.5'/>"), Place::at_line(3, 22), "an integer"},
      {in_scene("<Switch\n whichChoice='1 2'/>"), Place::at_line(4, 17), "the end of the value"},
      {in_scene("<Transform scale='1 &#32; x 2'/>"), Place::at_line(3, 27), "found 'x'"},
      {in_scene("<ScalarInterpolator key='0 ] 1'/>"), Place::at_line(3, 30),
       "the end of the value"},
      {in_scene("<Group USE='G'/>"), Place::at_line(3, 13), "no node 'G' before this"},
      {in_scene("<Group DEF='G'><children><Group USE='G'/></children></Group>"),
       Place::at_line(3, 38), "inside itself"},
      {in_scene("<Group DEF='G'/><Shape USE='G'/>"), Place::at_line(3, 29), "is a Group"},
      {in_scene("<Material/>"), Place::at_line(3, 2), "may not stand here"},
      {in_scene("NUL"), Place::at_line(3, 1), "a node or NULL"},
      {in_scene("<Shape><geometry/></Shape>"), Place::at_line(3, 9), "0 nodes"},
      {in_scene("<Shape geometry='x'/>"), Place::at_line(3, 8), "an element of that name"},
      {in_scene("<Shape set_x='1'/>"), Place::at_line(3, 8), "no field 'set_x'"},
      {in_scene("<Anchor url='&amp;&euro;'/>"), Place::at_line(3, 19), "'&euro;' is no character"},
      {in_scene("<Anchor url='&#0;'/>"), Place::at_line(3, 14), "is no character"},
      {in_scene("<Group><IS/></Group>"), Place::at_line(3, 9), "outside the body of a PROTO"},
      {in_scene("<ProtoInstance name='P'/>"), Place::at_line(3, 22), "no PROTO 'P'"},
      {in_scene("<PixelTexture image='1 1 5 0'/>"), Place::at_line(3, 22), "5 components"},
      {in_body("<Replace><Scene> <Box/></Scene></Replace>"), Place::at_line(2, 19),
       "a Box may not stand at the top [expected Group, Shape"},
      {in_body("<Inser/>"), Place::at_line(2, 2), "did you mean 'Insert'?"},
      {in_body("<Replace atNod='x'/>"), Place::at_line(2, 2), "without atNode"},
      {in_body("<Replace><Scene><Transform DEF='T'/></Scene></Replace>\n"
               "<Delete atNode='T' atField='scale' position='END'/>"),
       Place::at_line(3, 2), "scale is no list"},
      {in_body("<par begin='-1'/>"), Place::at_line(2, 13), "seconds, from 0"},
      {in_body("<par beginn='1'/>"), Place::at_line(2, 6), "did you mean 'begin'?"},
      {in_body("<ObjectDescriptorRemove objectDescriptorId='od2000'/>"), Place::at_line(2, 45),
       "od0 to 1023"},
      {in_body("<ObjectDescriptorUpdate><ObjectDescriptr/></ObjectDescriptorUpdate>"),
       Place::at_line(2, 26), "did you mean 'ObjectDescriptor'?"},
      {in_body("<Insert/>"), Place::at_line(2, 2), "without atNode or a ROUTE"},
      {in_body("<Replace atRoute='R0'/>"), Place::at_line(2, 2), "without a ROUTE"},
      {"<XMT-A/><XMT-A/>", Place::at_line(1, 10), "a second outermost element"},
      {"<XMT-B/>", Place::at_line(1, 2), "expected XMT-A"},
      {"<XMT-A><Header></XMT-A>", Place::at_line(1, 18), "not well-formed XML"},
  };
  for (const Case& wrong : cases) {
    const Error error = error_of(wrong.text);
    EXPECT_EQ(error.code, Errc::malformed) << wrong.text;
    EXPECT_EQ(error.place, wrong.place) << wrong.text << "\n" << to_string(error);
    EXPECT_THAT(error.text, HasSubstr(wrong.says));
    EXPECT_THAT(error.excerpt, HasSubstr("^"));
  }
}

TEST(XmtErrors, KeepWithinTheLimits) {
  Limits limits;
  limits.scene_depth = 3;
  const std::string deep = in_scene(
      "<Group><children><Group><children><Group/></children></Group>"
      "</children></Group>");
  EXPECT_EQ(error_of(deep, limits).code, Errc::limit_exceeded);
  limits = {};
  limits.scene_values = 10;
  EXPECT_EQ(error_of(in_scene("<ScalarInterpolator key='1 2 3 4 5 6 7 8'/>"), limits).code,
            Errc::limit_exceeded);
  limits = {};
  limits.memory = 100;
  EXPECT_EQ(error_of(in_scene("<Group/>"), limits).code, Errc::limit_exceeded);
}

TEST(XmtErrors, KeepNestedCommandBuffersWithinTheDepth) {
  std::string text = "<Replace><Scene><Conditional DEF='C'/></Scene></Replace>";
  std::string open, close;
  for (int i = 0; i < 2000; ++i) {
    open += "<Replace atNode='C' atField='buffer'>";
    close += "</Replace>";
  }
  const Error error = error_of(in_body(text + open + close));
  EXPECT_EQ(error.code, Errc::limit_exceeded);
}

TEST(XmtReader, AnXreplaceMayMeanAFieldThatAnInsertedScriptDeclares) {
  const Presentation one = read(
      in_body("<Replace><Scene><Group DEF=\"G\"/></Scene></Replace>"
              "<Insert atNode=\"G\" position=\"BEGIN\"><Script url=\"javascript:\">"
              "<field name=\"lit\" type=\"Boolean\" vrml97Hint=\"eventIn\"/></Script></Insert>"
              "<Replace extended=\"xreplace\" atNode=\"G\" atField=\"children\" position=\"BEGIN\" "
              "atChildNode=\"Script\" atChildField=\"lit\" value=\"true\"/>"));
  const auto& child = std::get<XReplace>(commands(one).at(2)).child_field;
  ASSERT_TRUE(child.has_value());
  EXPECT_EQ(child->node, std::get<NodeInsertion>(commands(one).at(1)).node);
}

}  // namespace afx::bifs
