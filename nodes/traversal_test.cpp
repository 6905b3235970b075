// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "nodes/traversal.h"

#include <chrono>
#include <glm/geometric.hpp>
#include <numbers>

#include "nodes/scene_test_support.h"

namespace afx::nodes {

namespace {

std::vector<DibrObject> objects_in(const Scene& scene, const TraversalOptions& options = {}) {
  auto objects = find_dibr_objects(scene, options);
  EXPECT_TRUE(objects.ok()) << (objects.ok() ? "" : objects.error().text);
  return objects.ok() ? std::move(objects).value() : std::vector<DibrObject>{};
}

/// Objects as one text: kinds and DEF names of the nodes.
std::string names_in(const std::vector<DibrObject>& objects) {
  std::string out;
  for (const DibrObject& object : objects) {
    out += object.kind == DibrObject::Kind::octree_image ? "O(" : "D(";
    for (const NodeView& node : object.nodes) out += " " + node.node().name;
    out += " ) ";
  }
  return out;
}

glm::dvec3 moved(const glm::dmat4& m, glm::dvec3 point) {
  return glm::dvec3(m * glm::dvec4(point, 1));
}

void expect_near(glm::dvec3 a, glm::dvec3 b, const std::string& what = {}) {
  EXPECT_LT(glm::distance(a, b), 1e-6) << what << " " << a.x << " " << a.y << " " << a.z;
}

}  // namespace

TEST(Traversal, ATransformScalesThenTurnsThenMoves) {
  // By hand: (1,0,0) scaled by 2 is (2,0,0), a quarter turn about z gives (0,2,0), moved (10,2,0).
  const Scene scene = read_scene(
      "Transform { translation 10 0 0 rotation 0 0 1 1.5707963267948966 scale 2 2 2 children "
      "DepthImage {} }");
  expect_near(moved(objects_in(scene)[0].to_world, {1, 0, 0}), {10, 2, 0});
}

TEST(Traversal, TheCenterStaysWhereItIs) {
  // A half turn about the z axis through (1,1,0): the origin goes to (2,2,0), the center stays.
  const Scene scene = read_scene(
      "Transform { center 1 1 0 rotation 0 0 1 3.1415926535897932 children DepthImage {} }");
  const glm::dmat4 m = objects_in(scene)[0].to_world;
  expect_near(moved(m, {1, 1, 0}), {1, 1, 0});
  expect_near(moved(m, {0, 0, 5}), {2, 2, 5});
}

TEST(Traversal, ScaleOrientationTurnsTheAxesOfTheScale) {
  // Scale 3 along the local x axis turned by 45 degrees: (1,1,0) grows to (3,3,0), (1,-1,0) stays.
  const Scene scene = read_scene(
      "Transform { scale 3 1 1 scaleOrientation 0 0 1 0.7853981633974483 children DepthImage {} }");
  const glm::dmat4 m = objects_in(scene)[0].to_world;
  expect_near(moved(m, {1, 1, 0}), {3, 3, 0});
  expect_near(moved(m, {1, -1, 0}), {1, -1, 0});
}

TEST(Traversal, AllFieldsOfATransformWorkTogether) {
  // T(1,2,3) C(1,0,0) R(z,90) SR(z,90) S(2,1,1) SR(z,-90) C(-1,0,0) on (2,1,0):
  // -C (1,1,0); -SR (1,-1,0); S (2,-1,0); SR (1,2,0); R (-2,1,0); C (-1,1,0); T (0,3,3).
  const Scene scene = read_scene(
      "Transform { translation 1 2 3 center 1 0 0 rotation 0 0 9 1.5707963267948966 scale 2 1 1\n"
      "scaleOrientation 0 0 1 1.5707963267948966 children DepthImage {} }");
  expect_near(moved(objects_in(scene)[0].to_world, {2, 1, 0}), {0, 3, 3});
}

TEST(Traversal, ARotationAboutNoAxisIsNone) {
  const Scene scene = read_scene("Transform { rotation 0 0 0 2 children DepthImage {} }");
  expect_near(moved(objects_in(scene)[0].to_world, {1, 2, 3}), {1, 2, 3});
}

TEST(Traversal, MatricesOfNestedTransformsMultiply) {
  const Scene scene = read_scene(
      "Transform { scale 2 2 2 children Group { children Transform { translation 1 0 0 children "
      "OctreeImage {} } } }");
  expect_near(moved(objects_in(scene)[0].to_world, {0, 1, 0}), {2, 2, 0});
}

TEST(Traversal, TwoDimensionalTransformsCountToo) {
  // (1,0,7): minus center (0,-1,7)... by hand: center (1,1), quarter turn: (0,-1) -> (1,0); back
  // (2,1), moved (5,1).
  const Scene turned = read_scene(
      "Transform2D { translation 3 0 center 1 1 rotationAngle 1.5707963 children BitWrapper { node "
      "OctreeImage {} } }");
  expect_near(moved(objects_in(turned)[0].to_world, {1, 0, 7}), {5, 1, 7});
  const Scene matrix = read_scene(
      "TransformMatrix2D { mxx 2 mxy 3 tx 4 myx 5 myy 6 ty 7 children BitWrapper { node "
      "OctreeImage {} } }");
  expect_near(moved(objects_in(matrix)[0].to_world, {1, 10, 2}), {2 + 30 + 4, 5 + 60 + 7, 2});
}

TEST(Traversal, TheDepthImagesUnderOneTransformAreOneGroup) {
  const Scene scene = read_scene(
      "DEF a DepthImage {} Transform { children [ DEF b DepthImage {} Group { children DEF c "
      "DepthImageV2 {} } DEF o OctreeImage {}\n"
      "Transform { children DEF d DepthImage {} } DEF e BitWrapper { node DepthImage {} } ] } DEF "
      "f DepthImage {}");
  EXPECT_EQ(names_in(objects_in(scene)), "D( a f ) D( b c e ) O( o ) D( d ) ");
}

TEST(Traversal, ASharedTransformIsMetAtEachPlace) {
  const Scene scene = read_scene(
      "DEF T Transform { translation 1 0 0 children DEF a DepthImage {} } Transform { translation "
      "0 5 0 children USE T }");
  const auto objects = objects_in(scene);
  ASSERT_EQ(objects.size(), 2U);
  expect_near(moved(objects[0].to_world, {0, 0, 0}), {1, 0, 0});
  expect_near(moved(objects[1].to_world, {0, 0, 0}), {1, 5, 0});
}

TEST(Traversal, TheImagesOfAnOctreeAreItsOwn) {
  const Scene scene = read_scene("DEF o OctreeImage { images [ DepthImage {} DepthImage {} ] }");
  EXPECT_EQ(names_in(objects_in(scene)), "O( o ) ");
}

TEST(Traversal, SwitchAndLodChoose) {
  const std::string choices = "[ DEF a DepthImage {} DEF b DepthImage {} DEF c DepthImage {} ] }";
  EXPECT_EQ(names_in(objects_in(read_scene("Switch { choice " + choices))), "");
  EXPECT_EQ(names_in(objects_in(read_scene("Switch { whichChoice 1 choice " + choices))),
            "D( b ) ");
  EXPECT_EQ(names_in(objects_in(read_scene("Switch { whichChoice 3 choice " + choices))), "");
  const Scene lod = read_scene(
      "Transform { translation 100 0 0 children LOD { range [ 10 20 ] center 0 0 1 level " +
      choices + " }");
  EXPECT_EQ(names_in(objects_in(lod)), "D( a ) ");
  const auto seen_from = [&](double z) {
    TraversalOptions options;
    options.viewer = Viewer{{100, 0, z}, {0, 1, 0}};
    return names_in(objects_in(lod, options));
  };
  EXPECT_EQ(seen_from(10.9), "D( a ) ");
  EXPECT_EQ(seen_from(11), "D( b ) ");  // at the limit the next one
  EXPECT_EQ(seen_from(20.9), "D( b ) ");
  EXPECT_EQ(seen_from(1000), "D( c ) ");
  EXPECT_EQ(names_in(objects_in(read_scene("LOD {}"))), "");
}

TEST(Traversal, ABillboardTurnsItsZAxisToTheViewer) {
  const auto z_axis = [](const std::string& axis, glm::dvec3 from) {
    const Scene scene =
        read_scene("Transform { translation 5 0 0 children Billboard { axisOfRotation " + axis +
                   " children DepthImage {} } }");
    TraversalOptions options;
    options.viewer = Viewer{from, {0, 1, 0}};
    return glm::dvec3(objects_in(scene, options)[0].to_world * glm::dvec4(0, 0, 1, 0));
  };
  expect_near(z_axis("0 1 0", {15, 0, 0}), {1, 0, 0});
  expect_near(z_axis("0 1 0", {15, 99, 0}), {1, 0, 0});  // only about y
  expect_near(z_axis("0 1 0", {5, 0, -3}), {0, 0, -1});
  expect_near(z_axis("0 0 0", {5, 4, 3}), {0, 0.8, 0.6});
  expect_near(z_axis("0 0 0", {5, 0, 0}), {0, 0, 1});  // the viewer is in it
  const Scene still = read_scene("Billboard { children DepthImage {} }");
  EXPECT_EQ(objects_in(still)[0].to_world, glm::dmat4(1));
}

TEST(Traversal, AWrapperMayBeAGeometry) {
  EXPECT_EQ(names_in(objects_in(read_scene("Shape { geometry DEF w BitWrapper { node OctreeImage "
                                           "{} } } Shape { geometry Box {} }"))),
            "O( w ) ");
  EXPECT_EQ(names_in(objects_in(read_scene("BitWrapper {} BitWrapper { node IndexedFaceSet {} }"))),
            "");
}

TEST(Traversal, ProtoInstancesShowTheirInsideWithTheirValues) {
  const Scene scene = read_scene(
      "PROTO View [ field SFVec3f from 0 0 1 field SFNode tex SimpleTexture {} ] { DepthImage { "
      "position IS from diTexture IS tex } }\n"
      "PROTO Two [ field SFVec3f at 7 7 7 field MFNode more [] ] {\n"
      "  Transform { translation 1 0 0 children [ View { from IS at tex PointTexture {} } View {} "
      "Group { children IS more } ] } }\n"
      "Two { at 1 2 3 more [ View { from 4 5 6 } ] } Two {}");
  const auto objects = objects_in(scene);
  ASSERT_EQ(objects.size(), 2U);
  ASSERT_EQ(objects[0].nodes.size(), 3U);
  EXPECT_EQ(objects[0].nodes[0].get<glm::vec3>("position"), glm::vec3(1, 2, 3));
  EXPECT_EQ(objects[0].nodes[0].child("diTexture").type(), "PointTexture");
  EXPECT_EQ(objects[0].nodes[1].get<glm::vec3>("position"), glm::vec3(0, 0, 1));
  EXPECT_EQ(objects[0].nodes[1].child("diTexture").type(), "SimpleTexture");
  EXPECT_EQ(objects[0].nodes[2].get<glm::vec3>("position"), glm::vec3(4, 5, 6));
  ASSERT_EQ(objects[1].nodes.size(), 2U);
  EXPECT_EQ(objects[1].nodes[0].get<glm::vec3>("position"), glm::vec3(7, 7, 7));
  expect_near(moved(objects[0].to_world, {0, 0, 0}), {1, 0, 0});
}

TEST(Traversal, WhatCannotBeSeenThroughIsNothing) {
  const Scene scene = read_scene(
      "EXTERNPROTO E [] \"x\" PROTO N [] { NULL } PROTO M [] {} E {} N {} M {} Group { children [ "
      "NULL E {} ] }");
  EXPECT_EQ(objects_in(scene).size(), 0U);
  EXPECT_EQ(NodeView(scene, scene.roots()[0]).type(), "NULL");
  EXPECT_EQ(NodeView(scene, scene.roots()[0]).child("x").type(), "NULL");
}

/// Everything as one text: kinds, DEF names; of lights the names of the shapes that they light.
std::string everything_in(const std::string& text) {
  const Scene scene = read_scene(text);
  const auto found = find_scene_objects(scene);
  EXPECT_TRUE(found.ok());
  std::string out;
  const auto& objects = found.value().objects;
  for (const SceneObject& object : objects) {
    out += std::string("DOSLBFVNI").substr(static_cast<size_t>(object.kind), 1) + "(" +
           object.nodes.front().node().name;
    for (size_t i = object.lit_begin; i < object.lit_end; ++i)
      if (objects[i].kind == SceneObject::Kind::shape) out += " " + objects[i].nodes[0].node().name;
    out += ") ";
  }
  return out;
}

TEST(Traversal, AllThatASceneShowsComesInItsOrder) {
  EXPECT_EQ(
      everything_in("DEF v Viewpoint {} Group { children [ DEF s Shape { geometry Box {} } DEF "
                    "f Fog {} DEF d DepthImage {} DEF i Inline {} ] } DEF b Background {} "
                    "Anchor { children DEF o OctreeImage {} } DEF n NavigationInfo {} "
                    "Collision { children DEF t Shape { geometry Sphere {} } }"),
      "V(v) S(s) F(f) D(d) I(i) B(b) O(o) N(n) S(t) ");
}

TEST(Traversal, AShapeWithoutGeometryShowsNothing) {
  EXPECT_EQ(everything_in("Shape {} Shape { appearance Appearance {} }"), "");
}

TEST(Traversal, ADirectionalLightLightsItsGroup) {
  EXPECT_EQ(everything_in(
                "DEF a Shape { geometry Box {} } Transform { children [ DEF b Shape { geometry "
                "Box {} } DEF l DirectionalLight {} Group { children [ DEF c Shape { geometry "
                "Box {} } DEF m DirectionalLight {} ] } DEF d Shape { geometry Box {} } ] } DEF "
                "e Shape { geometry Box {} }"),
            "S(a) S(b) L(l b c d) S(c) L(m c) S(d) S(e) ");
  EXPECT_EQ(everything_in("DEF a Shape { geometry Box {} } DEF l DirectionalLight {}"),
            "S(a) L(l a) ");
}

TEST(Traversal, PointAndSpotLightsLightEverything) {
  EXPECT_EQ(
      everything_in("DEF a Shape { geometry Box {} } Group { children [ DEF p PointLight {} DEF "
                    "s SpotLight {} DEF b Shape { geometry Box {} } ] }"),
      "S(a) L(p a b) L(s a b) S(b) ");
}

TEST(Traversal, LightsThatAreOffDoNotExist) {
  EXPECT_EQ(everything_in("PROTO P [ field SFBool lit TRUE ] { PointLight { on IS lit } } "
                          "DirectionalLight { on FALSE } P { lit FALSE } PointLight { on FALSE }"),
            "");
}

TEST(Traversal, ALightThatASwitchChoosesHasNoSiblings) {
  EXPECT_EQ(
      everything_in("Group { children [ DEF a Shape { geometry Box {} } Switch { whichChoice 0 "
                    "choice DEF l DirectionalLight {} } ] }"),
      "S(a) L(l) ");
}

TEST(Traversal, ALayerHasItsBoundNodes) {
  EXPECT_EQ(everything_in("Layer3D { viewpoint DEF v Viewpoint {} fog DEF f Fog {} children DEF s "
                          "Shape { geometry Box {} } }"),
            "F(f) V(v) S(s) ");
}

TEST(Traversal, WhatDependsOnTheViewerIsSaid) {
  const auto depends = [](const std::string& text) {
    const Scene scene = read_scene(text);
    return find_scene_objects(scene).value().depends_on_viewer;
  };
  EXPECT_FALSE(depends("Group { children Switch { choice LOD {} } }"));
  EXPECT_TRUE(depends("Group { children LOD {} }"));
  EXPECT_TRUE(depends("Billboard {}"));
}

TEST(Traversal, ASceneCanStandSomewhere) {
  const Scene scene = read_scene("Transform { translation 1 0 0 children Viewpoint {} }");
  TraversalOptions options;
  options.to_world[3] = glm::dvec4(0, 5, 0, 1);
  const auto found = find_scene_objects(scene, options);
  ASSERT_EQ(found.value().objects.size(), 1U);
  expect_near(moved(found.value().objects[0].to_world, {0, 0, 0}), {1, 5, 0});
  EXPECT_EQ(found.value().visits, 2U);
}

TEST(NodeView, PathsTellInstancesApart) {
  const Scene scene = read_scene(
      "PROTO P [ field MFNode c [] ] { Group { children [ Anchor {} Group { children IS c } ] } } "
      "DEF a P {} DEF b P { c DEF s Shape {} } USE a");
  std::vector<NodeView> anchors;
  for (const NodeId root : scene.roots())
    anchors.push_back(NodeView(scene, root).child_at("children", 0));
  EXPECT_NE(anchors[0].path(), anchors[1].path());
  EXPECT_EQ(anchors[0].path(), anchors[2].path());
  EXPECT_EQ(anchors[0].path().size(), 2U);
  const NodeView shape =
      NodeView(scene, scene.roots()[1]).child_at("children", 1).child_at("children", 0);
  EXPECT_EQ(shape.path(), std::vector<uint32_t>{scene.find_name("s").value});
  EXPECT_TRUE(NodeView().path().empty());
}

TEST(Traversal, DoublingsWithoutEndAreRefused) {
  std::string text = "DEF G0 Group {}\n";
  for (int i = 1; i < 60; ++i) {
    const std::string use = std::string(" USE G").append(std::to_string(i - 1));
    text.append("DEF G").append(std::to_string(i)).append(" Group { children [");
    text.append(use).append(use).append(" ] }\n");
  }
  const Scene scene = read_scene(text);
  const auto objects = find_dibr_objects(scene);
  ASSERT_FALSE(objects.ok());
  EXPECT_EQ(objects.error().code, Errc::limit_exceeded);
  TraversalOptions shallow;
  shallow.max_depth = 3;
  const auto deep = find_dibr_objects(
      read_scene("Group { children Group { children Group { children Group {} } } }"), shallow);
  ASSERT_FALSE(deep.ok());
  EXPECT_EQ(deep.error().text, "the scene is nested deeper than 3");
}

TEST(NodeView, LabelsNameTypeAndNode) {
  const Scene scene = read_scene("DEF FRONT DepthImage {} Group {}");
  EXPECT_EQ(NodeView(scene, scene.roots()[0]).label(), "DepthImage \"FRONT\"");
  EXPECT_EQ(NodeView(scene, scene.roots()[1]).label(), "Group");
}

TEST(Scene, SetRefusesWhatDoesNotFit) {
  Scene scene;
  const NodeId image = scene.add("DepthImage").value();
  const NodeId texture = scene.add("SimpleTexture").value();
  const NodeId group = scene.add("Group").value();
  EXPECT_TRUE(scene.set(image, "diTexture", texture).ok());
  EXPECT_TRUE(scene.append(group, "children", image).ok());
  EXPECT_EQ(scene.set(image, "nearPlan", 1.0F).error().text,
            "DepthImage.nearPlan: there is no such field");
  EXPECT_EQ(scene.set(image, "nearPlane", 1.0).error().text,
            "DepthImage.nearPlane: a value of another type [expected SFFloat]");
  EXPECT_EQ(scene.set(image, "diTexture", image).error().text,
            "DepthImage.diTexture: a node that may not stand here [expected SFDepthTextureNode]");
  EXPECT_FALSE(scene.append(group, "children", texture).ok());
  EXPECT_FALSE(scene.set(group, "addChildren", std::vector<NodeId>{}).ok());
  EXPECT_FALSE(scene.add("DepthImag").ok());
  EXPECT_TRUE(scene.set_name(image, "A").ok());
  EXPECT_FALSE(scene.set_name(group, "A").ok());
  EXPECT_TRUE(scene.set_name(image, "B").ok());
  EXPECT_TRUE(scene.set_name(group, "A").ok());
  EXPECT_EQ(scene.find_name("A"), group);
}

/// Seconds to traverse a Switch of so many empty choices that is used so many times.
double seconds_for(size_t choices, size_t uses) {
  std::string text = "Group { children [ DEF S Switch { whichChoice 0 choice [ ";
  for (size_t i = 0; i < choices; ++i) text += "NULL ";
  text += "] } ";
  for (size_t i = 0; i < uses; ++i) text += "USE S ";
  const Scene scene = read_scene(text + "] }");
  const auto start = std::chrono::steady_clock::now();
  objects_in(scene);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TEST(Traversal, WhatASwitchDoesNotChooseCostsNothing) {
  // Were each visit to look at all 10,000 choices it would take thousands of times as long.
  EXPECT_LT(seconds_for(10000, 10000), 50 * seconds_for(1, 10000) + 0.2);
}

TEST(SceneText, TrueInSmallLettersIsAName) {
  const Scene scene = read_scene("DEF true Group { }");
  EXPECT_TRUE(scene.find_name("true").valid());
}

}  // namespace afx::nodes
