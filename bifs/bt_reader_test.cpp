// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// BT by hand: times, commands, descriptors, and what is refused where.
#include "bifs/bt_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bifs/bt_writer.h"

namespace afx::bifs {

namespace {

using testing::HasSubstr;

Presentation read(const std::string& text) {
  Diagnostics diagnostics;
  auto read = read_bt(text, {}, diagnostics);
  EXPECT_TRUE(read.ok()) << to_string(read.error());
  return read.ok() ? std::move(read).value() : Presentation();
}

const std::vector<Command>& commands(const Presentation& presentation, size_t unit) {
  return std::get<std::vector<Command>>(presentation.units.at(unit).commands);
}

std::string write(Presentation& presentation) {
  std::string text;
  BtWriter writer([&text](std::string_view piece) -> Status {
    text += piece;
    return {};
  });
  Diagnostics diagnostics;
  EXPECT_TRUE(play(presentation, writer, diagnostics).ok());
  return text;
}

constexpr const char* kLists =
    "DEF A Group { children [ DEF P PositionInterpolator { key [ 0 1 ] } ] }\n";

}  // namespace

TEST(BtReader, TimesAreAbsoluteOrAfterTheOneBefore) {
  const Presentation one = read(
      "DEF X Group {}\nAT 100 { XDELETE X }\nRAP AT D50 { GLOBALQP NULL }\n"
      "AT 20 { REMOVE OD [ 1 ] }");
  const uint64_t times[] = {0, 20, 100, 150};
  const bool random_access[] = {true, true, false, true};  // the first of each stream
  ASSERT_EQ(one.units.size(), std::size(times));
  for (size_t i = 0; i < std::size(times); ++i) {
    EXPECT_EQ(one.units[i].time, times[i]);
    EXPECT_EQ(one.units[i].random_access, random_access[i]) << i;
  }
}

TEST(BtReader, NamesOfCommandsMayBeNamesOfNodes) {
  const Presentation one = read(
      "PROTO AT [] { Group {} } PROTO UPDATE [] { Group {} }\n"
      "DEF SCENE Group { children [ AT {} DEF LAST Group {} ] } UPDATE {}"
      "\nAT 1 { REPLACE SCENE.children BY [] DELETE LAST.children[0] REPLACE SCENE BY NULL }");
  EXPECT_EQ(one.units.size(), 2U);
  EXPECT_EQ(commands(one, 1).size(), 3U);
}

TEST(BtReader, AnXreplaceOfAChildMeansTheNodeThatIsThereByThen) {
  const Presentation one = read(
      "DEF G Group { children [ Shape {} ] }\nAT 1 { INSERT AT G.children[0] Transform {}\n"
      "XREPLACE G.children[0].translation BY 1 2 3 }");
  const auto& command = std::get<XReplace>(commands(one, 1)[1]);
  ASSERT_TRUE(command.child_field.has_value());
  EXPECT_EQ(one.scene.type_name(command.child_field->node), "Transform");
}

TEST(BtReader, AnXreplaceOfAChildKnowsWhatOtherCommandsDidToTheList) {
  const std::pair<const char*, const char*> kCases[] = {
      {"DELETE A", "Transform"},
      {"REPLACE A BY Transform {}", "Transform"},
      {"REPLACE A BY NULL", "Transform"},
      {"DELETE G.children[7]", "Shape"},
      {"REPLACE G.children[7] BY Transform {}", "Shape"},
      {"MULTIPLEINDREPLACE G.children [ 7 BY Transform {} 0 BY Transform {} ]", "Shape"},
      {"XREPLACE G.children[0] BY Transform {}", "Transform"},
      {"XREPLACE G.children BY H.children", "Transform"},
      {"DELETE H XREPLACE G.children BY [ Transform {} ]", "Transform"},
  };
  for (const auto& [commands_before, expected] : kCases) {
    const std::string field =
        expected == std::string("Shape") ? ".geometry BY NULL" : ".translation BY 1 2 3";
    const Presentation one = read(
        "DEF G Group { children [ DEF A Shape {} Transform {} DEF H Group { children [ Transform "
        "{} ] } ] }\nAT 1 { " +
        std::string(commands_before) + "\nXREPLACE G.children[0]" + field + " }");
    const auto& command = std::get<XReplace>(commands(one, 1).back());
    ASSERT_TRUE(command.child_field.has_value()) << commands_before;
    EXPECT_EQ(one.scene.type_name(command.child_field->node), expected) << commands_before;
  }
}

TEST(BtReader, AnXreplaceOfAChildTakesItsIndexFromAFieldAsItIsByThen) {
  for (const std::string commands_before :
       {"REPLACE S.whichChoice BY 2", "MULTIPLEREPLACE S { whichChoice 2 }",
        "XREPLACE S.whichChoice BY 2",
        "REPLACE S.whichChoice BY 7 REPLACE T.whichChoice BY 2 "
        "XREPLACE S.whichChoice BY T.whichChoice"}) {
    const Presentation one = read(
        "DEF G Group { children [ DEF S Switch { whichChoice 0 } DEF T Switch {} Transform {} ] }\n"
        "AT 1 { " +
        commands_before + " XREPLACE G.children[S.whichChoice].translation BY 1 2 3 }");
    const auto& command = std::get<XReplace>(commands(one, 1).back());
    ASSERT_TRUE(command.child_field.has_value()) << commands_before;
    EXPECT_EQ(one.scene.type_name(command.child_field->node), "Transform") << commands_before;
  }
}

TEST(BtReader, WhatAnSlConfigDescriptorDoesNotSayIsZeroAsItIsWritten) {
  for (const std::string said : {"", "timeStampResolution 0"}) {
    const Presentation one = read(
        "InitialObjectDescriptor { esDescr [ ES_Descriptor { ES_ID 1 decConfigDescr "
        "DecoderConfigDescriptor { streamType 3 } slConfigDescr SLConfigDescriptor { " +
        said + " } } ] } Group {}");
    const auto* sl = find_part<SlConfig>(scene_stream(one.initial)->parts);
    ASSERT_TRUE(sl != nullptr && sl->fields.has_value());
    EXPECT_EQ(sl->fields->time_stamp_resolution, 0U);
    EXPECT_TRUE(sl->fields->time_stamps);
  }
}

TEST(BtReader, ACommandOutsideOfAtComesAfterTheScene) {
  const Presentation one = read(
      "DEF A Transform {}\nDEF r ROUTE A.scale TO A.scale\nDELETE ROUTE r\n"
      "INSERTPROTO [ PROTO P [] { Group {} } ]");
  ASSERT_EQ(commands(one, 0).size(), 3U);
  const auto& scene = std::get<SceneReplacement>(commands(one, 0)[0]);
  EXPECT_TRUE(scene.protos.empty());
  EXPECT_EQ(std::get<RouteDeletion>(commands(one, 0)[1]).route_id, scene.routes.at(0).id);
  EXPECT_EQ(std::get<ProtoInsertion>(commands(one, 0)[2]).protos.size(), 1U);
}

TEST(BtReader, RoutesInAProtoBodyHaveIdsOfTheirOwn) {
  const Presentation one = read(
      "PROTO P [] { DEF A Transform {} DEF R4 ROUTE A.scale TO A.scale\n"
      "DEF r ROUTE A.scale TO A.scale ROUTE A.scale TO A.scale }\n"
      "DEF A Transform {}\nDEF R4 ROUTE A.scale TO A.scale");
  const auto& body = one.scene.scope(one.scene.proto(nodes::ProtoId{0U}).body).routes;
  ASSERT_EQ(body.size(), 3U);
  EXPECT_EQ(body[0].id, 5U);
  EXPECT_EQ(body[1].id, 1U);
  EXPECT_EQ(body[2].id, 0U);
  EXPECT_EQ(std::get<SceneReplacement>(commands(one, 0)[0]).routes.at(0).id, 5U);
}

TEST(BtWriter, ARouteOfTheSceneKeepsItsNameBesideOneInAProtoBodyOfTheSameId) {
  Presentation one = read(
      "DEF A Transform {}\nDEF R0 ROUTE A.scale TO A.scale\n"
      "AT 1 { INSERTPROTO [ PROTO P [] { DEF A Transform {} DEF r ROUTE A.scale TO A.scale } ]\n"
      "DELETE ROUTE R0 }");
  EXPECT_THAT(write(one), HasSubstr("DELETE ROUTE R0"));
}

TEST(BtWriter, ASceneOfPrototypesAloneReadsBackAsACommand) {
  Presentation one = read("Group {}\nAT 1 { REPLACE SCENE BY PROTO P [] { Group {} } NULL }");
  const std::string text = write(one);
  const Presentation again = read(text);
  ASSERT_EQ(again.units.size(), 2U) << text;
  const auto& scene = std::get<SceneReplacement>(commands(again, 1)[0]);
  EXPECT_EQ(scene.protos.size(), 1U);
  EXPECT_FALSE(scene.root.valid());
}

TEST(BtReader, CommandsOfOneTimeAreOneAccessUnit) {
  const Presentation one =
      read(std::string(kLists) + "APPEND TO P.key 2\nAT 5 { DELETE P.key[0] }\nAT 5 { DELETE P }");
  ASSERT_EQ(one.units.size(), 2U);
  EXPECT_EQ(commands(one, 0).size(), 2U);
  EXPECT_EQ(commands(one, 1).size(), 2U);
}

TEST(BtReader, PositionsAreFirstLastOrAnIndex) {
  const Presentation one =
      read(std::string(kLists) +
           "AT 1 { DELETE P.key[0] DELETE P.key[FIRST] DELETE FIRST P.key DELETE P.key[-1] "
           "DELETE P.key[LAST] DELETE LAST P.key DELETE P.key[7] }");
  const Position::Kind expected[] = {
      Position::Kind::first, Position::Kind::first, Position::Kind::first, Position::Kind::last,
      Position::Kind::last,  Position::Kind::last,  Position::Kind::index};
  ASSERT_EQ(commands(one, 1).size(), std::size(expected));
  for (size_t i = 0; i < std::size(expected); ++i)
    EXPECT_EQ(std::get<IndexedValueDeletion>(commands(one, 1)[i]).position.kind, expected[i]) << i;
  EXPECT_EQ(std::get<IndexedValueDeletion>(commands(one, 1)[6]).position.index, 7U);
}

TEST(BtReader, IdsFollowNamesThatStandForThem) {
  const Presentation one = read(
      "Group { children [ DEF A Transform {} DEF N7 Transform {} DEF B Transform {} ] }\n"
      "DEF R4 ROUTE A.translation TO B.translation\nDEF x ROUTE A.scale TO B.scale");
  const auto id = [&](const char* name) { return one.scene.node(one.scene.find_name(name)).id; };
  EXPECT_EQ(id("A"), 1U);
  EXPECT_EQ(id("N7"), 8U);
  EXPECT_EQ(id("B"), 2U);
  const auto& scene = std::get<SceneReplacement>(commands(one, 0)[0]);
  EXPECT_EQ(scene.routes.at(0).id, 5U);
  EXPECT_EQ(scene.routes.at(1).id, 1U);
}

TEST(BtReader, SeveralTopNodesGoUnderAGroup) {
  Diagnostics diagnostics;
  const auto one = read_bt("Shape {} Transform {}", {}, diagnostics);
  ASSERT_TRUE(one.ok());
  const auto& scene = std::get<SceneReplacement>(commands(one.value(), 0)[0]);
  EXPECT_EQ(one.value().scene.type_name(scene.root), "Group");
  ASSERT_EQ(diagnostics.count(), 1U);
  EXPECT_EQ(diagnostics.warnings()[0].code, "top_nodes");
  EXPECT_EQ(diagnostics.warnings()[0].place, Place::at_line(1, 10));
}

TEST(BtReader, CommandBuffersMaySpeakOfNodesBehindThem) {
  const Presentation one = read(
      "Group { children [ Conditional { buffer { REPLACE T.scale BY 2 2 2 } } DEF T Transform {} ] "
      "}");
  const auto& scene = std::get<SceneReplacement>(commands(one, 0)[0]);
  const auto& children = one.scene.get<std::vector<nodes::NodeId>>(scene.root, "children");
  const auto& buffer = one.scene.get<nodes::CommandBuffer>(children[0], "buffer");
  const auto* held = dynamic_cast<const BufferedCommands*>(buffer.content.get());
  ASSERT_NE(held, nullptr);
  ASSERT_EQ(held->commands.size(), 1U);
  EXPECT_EQ(std::get<FieldReplacement>(held->commands[0]).target.node, children[1]);
}

TEST(BtReader, UnknownDescriptorsAndCommandsAreKept) {
  const std::string text =
      "InitialObjectDescriptor {\n  objectDescriptorID 1\n  esDescr [\n    ES_Descriptor {\n"
      "      ES_ID 1\n      decConfigDescr DecoderConfigDescriptor {\n        streamType 3\n"
      "        otherDescr [\n          UnknownDescriptor {\n            tag 129\n"
      "            data \"data:application/octet-string;base64,AQID\"\n          }\n        ]\n"
      "      }\n    }\n  ]\n  otherDescr [\n    UnknownDescriptor {\n      tag 192\n"
      "      data \"\"\n    }\n  ]\n}\n\nGroup {}\nRAP AT 0 {\n  UnknownCommand {\n    tag 5\n"
      "    data \"data:application/octet-string;base64,/w==\"\n  }\n}\n";
  Presentation one = read(text);
  const auto* es = scene_stream(one.initial);
  ASSERT_NE(es, nullptr);
  const auto* config = find_part<DecoderConfig>(es->parts);
  const auto* unknown = find_part<UnknownDescriptor>(config->parts);
  ASSERT_NE(unknown, nullptr);
  EXPECT_EQ(unknown->tag, 129);
  EXPECT_EQ(unknown->payload, (std::vector<uint8_t>{1, 2, 3}));
  EXPECT_EQ(write(one), text);
}

TEST(BtReader, DecoderSpecificInfoIsReadAsGpacWritesIt) {
  const Presentation one = read(
      "InitialObjectDescriptor { esDescr [ ES_Descriptor { ES_ID 1 decConfigDescr "
      "DecoderConfigDescriptor { streamType 3 decSpecificInfo DecoderSpecificInfo { info "
      "%00%14%FF } } } ] } Group {}");
  EXPECT_EQ(decoder_specific_info(*scene_stream(one.initial)),
            (std::vector<uint8_t>{0, 0x14, 0xFF}));
}

struct BadText {
  const char* text;
  Errc code;
  const char* message;
};

class BadBt : public testing::TestWithParam<BadText> {};

constexpr BadText kBad[] = {
    {"DEF A Group {} AT 1 { INSERT ROUTE DEF TRUE A.children TO A.addChildren }", Errc::malformed,
     "1:40: INSERT: 'TRUE' is a keyword [expected a name]"},
    {"Group {} REPLACE A BY NULL", Errc::malformed,
     "1:18: REPLACE: no node 'A' before this [expected a name that DEF gave]"},
    {"DEF A Group {} AT 1 { REPLACE A.childern BY [] }", Errc::malformed,
     "1:33: REPLACE: no field 'childern' (did you mean 'children'?)"},
    {"DEF A Group {} AT 1 { REPLACE A.children[0] 5 }", Errc::malformed,
     "1:45: REPLACE: found '5' [expected BY]"},
    {"DEF A Group {} AT 1 { INSERT AT A.children Group {} }", Errc::malformed,
     "1:44: INSERT: found 'Group' [expected '[' and an index]"},
    {"DEF A Group {} AT 1 { DELETE A.children[-2] }", Errc::malformed,
     "1:41: DELETE: an index of -2 [expected 0 or more, or -1 for the last]"},
    {"DEF A Group {} AT x { }", Errc::malformed,
     "1:19: found 'x' [expected a number of at most 64 bits]"},
    {"DEF A Group {} AT 1 { DELETE A", Errc::truncated,
     "1:31: the text ends here, and '{' of 1:21 is still open [expected '}']"},
    {"DEF A Group {} AT 1 { DELETE ROUTE r }", Errc::malformed,
     "1:36: DELETE: no ROUTE 'r' before this [expected a name that DEF gave]"},
    {"DEF A Group {} AT 5 { XDELETE A }\nAT 4 { XDELETE A }", Errc::malformed,
     "2:1: commands at 4 behind those at 5 [expected times that do not go back]"},
    {"DEF A Transform {} AT 1 { REPLACE A.scale [0] BY 2 2 2 }", Errc::malformed,
     "1:43: REPLACE: found '[' [expected BY, for this field is no list]"},
    {"Group {} AT 1 { REPLACE SCENE BY Shape {} }", Errc::malformed,
     "1:34: REPLACE: a Shape may not be the top node [expected Group, OrderedGroup, Layer2D, "
     "Layer3D]"},
    {"Shape {}\n  Box {}", Errc::malformed,
     "2:3: a Box may not stand at the top [expected Group, Shape or another that may stand under a "
     "Group]"},
    {"Group {} AT 1 IN 7 { }", Errc::unsupported,
     "1:18: commands in the stream 7 [expected the first scene stream or that of object "
     "descriptors]"},
    {"Group {} AT 1 { UPDATE OD [ ObjectDescriptor { objectDescriptorID 1024 } ] }",
     Errc::malformed, "1:67: ObjectDescriptor: 1024 does not fit 10 bits"},
    {"Group {} AT 1 { UPDATE OD [ ObjectDescriptor { esDesc [ ] } ] }", Errc::malformed,
     "1:48: ObjectDescriptor: no field 'esDesc' (did you mean 'esDescr'?)"},
    {"Group {} InitialObjectDescriptor { }", Errc::malformed,
     "1:10: 'InitialObjectDescriptor' behind the beginning [expected it first, and once]"},
    {"Group {} AT 1 { DELETEPROTO [ P ] }", Errc::malformed, "1:31: DELETEPROTO: no PROTO 'P'"},
    {"Group { children [ Conditional { buffer { UPDATE OD [] } } ] }", Errc::malformed,
     "1:43: found 'UPDATE' [expected a command of the scene or '}']"},
};

TEST_P(BadBt, IsRefusedWithPlaceAndSentence) {
  Diagnostics diagnostics;
  const auto result = read_bt(GetParam().text, {}, diagnostics);
  ASSERT_FALSE(result.ok()) << GetParam().text;
  EXPECT_EQ(result.error().code, GetParam().code);
  EXPECT_THAT(to_string(result.error()), HasSubstr(GetParam().message));
}
INSTANTIATE_TEST_SUITE_P(All, BadBt, testing::ValuesIn(kBad));

TEST(BtReader, CommandBuffersNestedWithoutEndStopAtTheLimit) {
  std::string text = "Group { children [ DEF C Conditional { buffer { ";
  for (int i = 0; i < 100000; ++i) text += "REPLACE C.buffer BY { ";
  Diagnostics diagnostics;
  EXPECT_FALSE(read_bt(text, {}, diagnostics).ok());
  for (int i = 0; i < 100002; ++i) text += "}";
  text += " ] }";
  const auto result = read_bt(text, {}, diagnostics);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, Errc::limit_exceeded);
}

}  // namespace afx::bifs
