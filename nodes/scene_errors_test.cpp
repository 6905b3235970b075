// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What is wrong with bad scene text, where, and how it is said.
#include "nodes/nearest_name.h"
#include "nodes/scene_test_support.h"
#include "nodes/text_place.h"

namespace afx::nodes {

namespace {

struct BadText {
  const char* text;
  Errc code;
  const char* message;  ///< "LINE:COLUMN: text"
};

std::ostream& operator<<(std::ostream& out, const BadText& bad) { return out << bad.text; }

constexpr Errc kMalformed = Errc::malformed, kTruncated = Errc::truncated,
               kUnsupported = Errc::unsupported;

const BadText kBadTexts[] = {
    // names
    {"Grup {}", kMalformed, "1:1: no node type 'Grup' (did you mean 'Group'?)"},
    {"group {}", kMalformed, "1:1: no node type 'group' (did you mean 'Group'?)"},
    {"Xyzzyq {}", kMalformed, "1:1: no node type 'Xyzzyq'"},
    {"Group {\n  childern [] }", kMalformed,
     "2:3: Group: no field 'childern' (did you mean 'children'?)"},
    {"DepthImage {\n\tfarPlan 3 }", kMalformed,
     "2:2: DepthImage: no field 'farPlan' (did you mean 'farPlane'?)"},
    {"Group { children Sphere {} }", kMalformed,
     "1:18: Group.children: a Sphere may not stand here [expected a node of type SF3DNode]"},
    {"Group { children [ Shape {} Box {} ] }", kMalformed,
     "1:29: Group.children: a Box may not stand here [expected a node of type SF3DNode]"},
    {"DepthImage { diTexture PixelTexture {} }", kMalformed,
     "1:24: DepthImage.diTexture: a PixelTexture may not stand here [expected a node of type "
     "SFDepthTextureNode]"},
    {"DEF A Shape {} Shape { geometry USE A }", kMalformed,
     "1:33: Shape.geometry: a Shape may not stand here [expected a node of type SFGeometryNode]"},
    {"PROTO P [] { Box {} } Group { children P {} }", kMalformed,
     "1:40: Group.children: a P may not stand here [expected a node of type SF3DNode]"},
    {"Transform { scale 1 1 1 scale 2 2 2 }", kMalformed,
     "1:25: Transform: a second value for 'scale'"},
    {"Transform { addChildren [] }", kMalformed,
     "1:25: Transform.addChildren: found '[' [expected IS, for an eventIn has no value]"},
    // DEF and USE
    {"DEF Front Group {} USE Frnot", kMalformed,
     "1:24: no node 'Frnot' before this (did you mean 'Front'?) [expected a name that DEF gave]"},
    {"DEF A Group { children USE A }", kMalformed,
     "1:28: Group.children: the node 'A' would stand inside itself"},
    {"DEF A Group { children Group { children [ USE A ] } }", kMalformed,
     "1:47: Group.children: the node 'A' would stand inside itself"},
    {"DEF", kTruncated, "1:4: the text ends here [expected the name of a node after DEF]"},
    {"DEF TRUE Group {}", kMalformed, "1:5: 'TRUE' is a keyword [expected a name]"},
    {"Group {} DEF field ROUTE A.b TO C.d", kMalformed,
     "1:14: 'field' is a keyword [expected a name]"},
    {"USE 5", kMalformed, "1:5: found '5' [expected the name of a node after USE]"},
    // numbers
    {"Switch { whichChoice 2147483648 }", kMalformed,
     "1:22: Switch.whichChoice: '2147483648' is out of range [expected an SFInt32, -2147483648 to "
     "2147483647]"},
    {"OctreeImage { octree [ 1 2 99999999999999999999 ] }", kMalformed,
     "1:28: OctreeImage.octree: '99999999999999999999' is out of range [expected an SFInt32, "
     "-2147483648 to "
     "2147483647]"},
    {"Switch { whichChoice -0x80000001 }", kMalformed,
     "1:22: Switch.whichChoice: '-0x80000001' is out of range [expected an SFInt32, -2147483648 to "
     "2147483647]"},
    {"Switch { whichChoice 1.5 }", kMalformed,
     "1:22: Switch.whichChoice: found '1.5' [expected an integer]"},
    {"Switch { whichChoice }", kMalformed,
     "1:22: Switch.whichChoice: found '}' [expected an integer]"},
    {"Switch { whichChoice 0x }", kMalformed,
     "1:22: Switch.whichChoice: found '0x' [expected an integer]"},
    {"Fog { visibilityRange 1e39 }", kMalformed,
     "1:23: Fog.visibilityRange: '1e39' is out of range [expected an SFFloat, at most 3.4028235e38 "
     "either way]"},
    {"Fog { visibilityRange 1.2.3 }", kMalformed,
     "1:23: Fog.visibilityRange: found '1.2.3' [expected a number]"},
    {"Fog { visibilityRange nan(0x0) }", kMalformed,
     "1:23: Fog.visibilityRange: found 'nan(0x0)' [expected a number]"},
    {"Fog { visibilityRange -- }", kMalformed,
     "1:23: Fog.visibilityRange: found '--' [expected a number]"},
    {"TimeSensor { startTime 1e309 }", kMalformed,
     "1:24: TimeSensor.startTime: '1e309' is out of range [expected an SFTime, at most "
     "1.7976931348623157e308 either "
     "way]"},
    {"Fog { color 1 0 }", kMalformed, "1:17: Fog.color: found '}' [expected a number]"},
    {"Coordinate { point [ 1 2 3 4 5 ] }", kMalformed,
     "1:32: Coordinate.point: the list ends inside a value [expected numbers by 3, 1 more]"},
    {"Fog { color 1 0 0 0.5 }", kMalformed, "1:19: Fog: found '0.5' [expected a field or '}']"},
    {"DepthImage { orthographic yes }", kMalformed,
     "1:27: DepthImage.orthographic: found 'yes' [expected TRUE or FALSE]"},
    // strings, URLs, images, bytes
    {"WorldInfo { title hello }", kMalformed,
     "1:19: WorldInfo.title: found 'hello' [expected a string in quotes]"},
    {"WorldInfo {\n title \"hello }", kTruncated,
     "2:8: WorldInfo.title: the string that begins here is never closed [expected '\"']"},
    {"ImageTexture { url [ 1024 ] }", kMalformed,
     "1:22: ImageTexture.url: found '1024' [expected a URL in quotes, or an object descriptor 0 to "
     "1023]"},
    {"PixelTexture { image 2 1 5 0 0 }", kMalformed,
     "1:22: PixelTexture.image: an image of 5 components [expected 0 to 4]"},
    {"PixelTexture { image 2 1 1 0x00 256 }", kMalformed,
     "1:33: PixelTexture.image: a pixel value of 256 [expected at most 255 for 1 components]"},
    {"PixelTexture { image 2 1 1 7 }", kMalformed,
     "1:30: PixelTexture.image: found '}' [expected an integer]"},
    {"PixelTexture { image 2 1 1 7 -1 }", kMalformed,
     "1:30: PixelTexture.image: '-1' is out of range [expected a number, 0 to 4294967295]"},
    {"PixelTexture { image 30000 30000 1 0 }", kTruncated,
     "1:22: PixelTexture.image: the text ends inside an image of 900000000 pixels"},
    {"PixelTexture { image 4294967295 4294967295 4 0 }", Errc::limit_exceeded,
     "1:22: PixelTexture.image: an image of 18446744065119617025 pixels is beyond the limit "
     "picture_pixels"},
    {"BitWrapper { buffer \"file:a.bin\" }", kUnsupported,
     "1:21: BitWrapper.buffer: 'file:a.bin': files cannot be loaded here"},
    {"BitWrapper { buffer \"abc\" }", kMalformed,
     "1:21: BitWrapper.buffer: bytes with an odd number of hex digits"},
    // brackets and ends
    {"Group {\n children [\n  Shape {}\n", kTruncated,
     "4:1: Group.children: the text ends here, and '[' of 2:11 is still open [expected ']']"},
    {"Group {\n  Transform", kMalformed, "2:3: Group: no field 'Transform'"},
    {"Group { children [ Shape {} }", kMalformed,
     "1:29: Group.children: found '}' [expected a node]"},
    {"Transform {", kTruncated,
     "1:12: Transform: the text ends here, and '{' of 1:11 is still open [expected '}']"},
    {"OctreeImage { octree [ 1 2", kTruncated,
     "1:27: OctreeImage.octree: the text ends here, and '[' of 1:22 is still open [expected ']']"},
    {"Group", kTruncated, "1:6: Group: the text ends here [expected '{' after the node type]"},
    {"Group [", kMalformed, "1:7: Group: found '[' [expected '{' after the node type]"},
    {"}", kMalformed, "1:1: found '}' [expected a node]"},
    {"Group { } 12", kMalformed, "1:11: found '12' [expected a node]"},
    {"Conditional { buffer { REPLACE ", kTruncated,
     "1:32: Conditional.buffer: the text ends here, and '{' of 1:22 is still open [expected '}']"},
    // PROTO, IS, Script
    {"PROTO P [ field SFInt32 a ] { Group {} }", kMalformed,
     "1:27: P.a: found ']' [expected an integer]"},
    {"PROTO P [ feild SFInt32 a 1 ] { Group {} }", kMalformed,
     "1:11: P: found 'feild' [expected field, exposedField, eventIn or eventOut]"},
    {"PROTO P [ field SFInt a 1 ] { Group {} }", kMalformed,
     "1:17: P: no field type 'SFInt' (did you mean 'SFInt32'?)"},
    {"PROTO P [ field SF3DNode a NULL ] { Group {} }", kMalformed,
     "1:17: P: no field type 'SF3DNode' (did you mean 'SFNode'?)"},
    {"PROTO P [ field SFBool a TRUE field SFTime a 1 ] {}", kMalformed,
     "1:31: P: a second field 'a', or more than 65535 fields"},
    {"PROTO P [] { Group {} } PROTO P [] { Group {} }", kMalformed,
     "1:31: there is a PROTO 'P' already [expected another name]"},
    {"PROTO Group [] { Shape {} }", kMalformed,
     "1:7: 'Group' is the name of a node or a keyword [expected another]"},
    {"PROTO P [] { Group { children P {} } }", kMalformed,
     "1:31: Group.children: the PROTO 'P' would stand inside itself"},
    {"PROTO P [ field SFFloat size 1 ] { Sphere { radius IS sise } }", kMalformed,
     "1:55: Sphere.radius: the PROTO 'P' has no field 'sise' (did you mean 'size'?)"},
    {"PROTO P [ field SFInt32 n 1 ] { Sphere { radius IS n } }", kMalformed,
     "1:52: Sphere.radius: 'n' is an SFInt32 [expected an SFFloat]"},
    {"Sphere { radius IS x }", kMalformed,
     "1:17: Sphere.radius: IS outside the body of a PROTO [expected a value]"},
    {"PROTO P [] { Group {} } PROTO Q [] { P {} PROTO P [] { Shape {} } }", kMalformed,
     "1:49: the PROTO 'P' of an outer scope was used here before [expected another name]"},
    {"Script { exposedField SFBool a TRUE }", kMalformed,
     "1:10: Script: a Script has no exposedField [expected field, eventIn or eventOut]"},
    {"Script { field SFBool url TRUE }", kMalformed,
     "1:10: Script: a second field 'url', or more than 65535 fields"},
    // ROUTE
    {"DEF A Transform {} ROUTE A.scale TO B.scale", kMalformed,
     "1:37: ROUTE: no node 'B' before this [expected a name that DEF gave]"},
    {"DEF A Transform {} ROUTE A.scale A.scale", kMalformed,
     "1:34: ROUTE: found 'A.scale' [expected TO]"},
    {"DEF A Transform {} ROUTE A.scale TO A.rotation", kMalformed,
     "1:37: ROUTE: an SFVec3f cannot go to an SFRotation [expected fields of one type]"},
    {"DEF A DepthImage {} ROUTE A.position TO A.position", kMalformed,
     "1:29: ROUTE: 'position' of DepthImage is no eventOut [expected one, or an exposedField]"},
    {"DEF A Transform {} ROUTE A.set_scale TO A.scale", kMalformed,
     "1:28: ROUTE: 'set_scale' of Transform is no eventOut [expected one, or an exposedField]"},
    {"DEF A Transform {} ROUTE A.scale TO A.scale_changed", kMalformed,
     "1:39: ROUTE: 'scale_changed' of Transform is no eventIn [expected one, or an exposedField]"},
    {"DEF A Transform {} ROUTE A.scael TO A.scale", kMalformed,
     "1:28: ROUTE: no field 'scael' (did you mean 'scale'?)"},
    // what is not read here
    {"InitialObjectDescriptor { objectDescriptorID 1 }", kUnsupported,
     "1:1: 'InitialObjectDescriptor' is not read here: this is a scene without object descriptors "
     "and "
     "commands"},
    {"Group {}\nAT 0 { UPDATE OD [] }", kUnsupported,
     "2:1: 'AT' is not read here: this is a scene without object descriptors and commands"},
    {"Group {} REPLACE A.b BY 1", kUnsupported,
     "1:10: 'REPLACE' is not read here: this is a scene without object descriptors and commands"},
    {"#VRML V1.0 ascii\nSeparator {}", kUnsupported,
     "1:1: this is VRML 1.0 [expected VRML 2.0 (VRML97) or BT]"},
};

class BadScene : public testing::TestWithParam<BadText> {};

}  // namespace

TEST_P(BadScene, IsRefusedWithThisMessageAtThisPlace) {
  const Error error = read_error(GetParam().text);
  EXPECT_EQ(to_string(error), GetParam().message);
  EXPECT_EQ(error.code, GetParam().code) << to_string(error.code);
  EXPECT_NE(error.excerpt.find('^'), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(SceneText, BadScene, testing::ValuesIn(kBadTexts));

TEST(SceneErrors, TheCaretStandsUnderThePlace) {
  EXPECT_EQ(read_error("Group {\n\tchildren [ Spere {} ] # ü\n}").excerpt,
            " children [ Spere {} ] # ü\n            ^");
  // Columns count characters, not bytes.
  const Error error = read_error("WorldInfo { title \"Grüße\" titel 1 }");
  EXPECT_EQ(error.place, Place::at_line(1, 27));
  EXPECT_EQ(error.excerpt, "WorldInfo { title \"Grüße\" titel 1 }\n                          ^");
}

TEST(SceneErrors, OfALongLineThePartAroundThePlaceIsShown) {
  std::string text = "OctreeImage { octree [";
  for (int i = 0; i < 1000; ++i) text += " 100";
  text += " x";
  for (int i = 0; i < 1000; ++i) text += " 200";
  const std::string excerpt = read_error(text).excerpt;
  EXPECT_LT(excerpt.size(), 220U);
  const size_t end = excerpt.find('\n');
  EXPECT_EQ(excerpt[excerpt.find('^') - end - 1], 'x');
  EXPECT_TRUE(excerpt.starts_with("..."));
  EXPECT_EQ(excerpt.substr(end - 3, 3), "...");
}

TEST(SceneErrors, EveryTruncationIsAnErrorOrAScene) {
  const std::string text =
      "#VRML V2.0 utf8\nPROTO P [ field SFFloat r 1 { b { 0 1 } } ] { DEF S Sphere { radius IS r } "
      "}\n"
      "EXTERNPROTO E [ field SFNode n NULL ] \"x\"\n"
      "DEF G Group { children [ Shape { geometry P { r 0.5 } } DEF T Transform { scale 1 2e1 0x } "
      "USE T\n"
      "Script { field SFInt32 a 0x1F url \"s\" } PixelTexture { image 1 1 3 0xFF00FF } Conditional "
      "{ buffer { a } } ] }\n"
      "WorldInfo { info [ \"ü\\\"\" ] } DEF R ROUTE G.children TO G.children";
  size_t scenes = 0;
  for (size_t length = 0; length <= text.size(); ++length) {
    const std::unique_ptr<char[]> exact(
        new char[length]);  // so that a sanitizer sees one byte too far
    std::copy_n(text.data(), length, exact.get());
    Diagnostics diagnostics;
    const auto scene = read_scene_text({exact.get(), length}, Limits{}, diagnostics);
    if (scene.ok()) {
      ++scenes;
    } else {
      EXPECT_FALSE(scene.error().text.empty());
      EXPECT_NE(scene.error().excerpt.find('^'), std::string::npos);
    }
  }
  EXPECT_GT(scenes, 2U);
}

TEST(SceneErrors, NestingIsLimited) {
  const auto nested = [](int depth) {
    std::string text;
    for (int i = 0; i < depth; ++i) text += "Group{children ";
    text += "Group{}";
    for (int i = 0; i < depth; ++i) text += "}";
    return text;
  };
  EXPECT_EQ(read_scene(nested(511)).node_count(), 512U);
  EXPECT_EQ(read_error(nested(512)).code, Errc::limit_exceeded);
  EXPECT_EQ(read_error(nested(1000000)).code, Errc::limit_exceeded);
  std::string protos;
  for (int i = 0; i < 100000; ++i) protos += "PROTO P [] {";
  EXPECT_EQ(read_error(protos).code, Errc::limit_exceeded);
}

TEST(SceneErrors, ValuesAndMemoryAreLimited) {
  Limits few;
  few.scene_values = 100;
  std::string list = "OctreeImage { octree [";
  for (int i = 0; i < 200; ++i) list += " 1";
  EXPECT_EQ(read_error(list + " ] }", few).code, Errc::limit_exceeded);
  Limits small;
  small.memory = 10000;
  std::string groups;
  for (int i = 0; i < 1000; ++i) groups += "Group{}";
  EXPECT_EQ(read_error(groups, small).code, Errc::limit_exceeded);
  std::string image = "PixelTexture { image 100 101 1";
  for (int i = 0; i < 100 * 101; ++i) image += " 0";
  EXPECT_EQ(read_error(image + " }", small).code, Errc::limit_exceeded);
  Limits pixels;
  pixels.picture_pixels = 10;
  EXPECT_EQ(read_error("PixelTexture { image 11 1 1 0", pixels).code, Errc::limit_exceeded);
}

TEST(SceneErrors, ManyWarningsCostLinearTime) {
  // Each place is counted from the one before; from the beginning this would take minutes.
  std::string text = "WorldInfo { info [";
  for (int i = 0; i < 300000; ++i) text += "\"\xFF\"\n";
  Diagnostics diagnostics;
  EXPECT_TRUE(read_scene_text(text + "] }", Limits{}, diagnostics).ok());
  EXPECT_EQ(diagnostics.count(), 300000U);
  EXPECT_EQ(diagnostics.warnings()[1].place, Place::at_line(2, 2));
}

TEST(NearestName, DistancesAreThoseOfHand) {
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
  EXPECT_EQ(edit_distance("childern", "children"), 1U);  // neighbours swapped
  EXPECT_EQ(edit_distance("same", "same"), 0U);
}

TEST(TextPlaces, LinesEndInThreeWays) {
  const std::string text =
      "a\nb\rc\r\nd\xC3\xBC"
      "e";
  TextPlaces places(text);
  EXPECT_EQ(places.at(0), Place::at_line(1, 1));
  EXPECT_EQ(places.at(2), Place::at_line(2, 1));
  EXPECT_EQ(places.at(4), Place::at_line(3, 1));
  EXPECT_EQ(places.at(7), Place::at_line(4, 1));
  EXPECT_EQ(places.at(10), Place::at_line(4, 3));
  EXPECT_EQ(places.at(2), Place::at_line(2, 1));  // going back
}

TEST(TextPlaces, OnlyValidUtf8IsValid) {
  EXPECT_EQ(find_invalid_utf8("aü深🌲"), std::string_view::npos);
  for (const std::string bad : {"\xFF", "\x80", "\xC0\x80", "\xC3", "\xE0\x80\x80", "\xED\xA0\x80",
                                "\xF4\x90\x80\x80", "\xF0\x9F\x8C"})
    EXPECT_EQ(find_invalid_utf8("ab" + bad), 2U);
}

}  // namespace afx::nodes
