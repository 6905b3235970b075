// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/shapes/face_nodes.h"

#include "afx/shapes/shape_test_support.h"

namespace afx {
namespace {

const std::string kSquare = "coord Coordinate { point [ 0 0 0 1 0 0 1 1 0 0 1 0 ] } ";

std::string faces(const std::string& fields) {
  return "DEF F IndexedFaceSet { " + kSquare + fields + " }";
}

/// The colour of the corner at a place in a triangle.
glm::vec3 colour_in(const Geometry& g, size_t triangle, size_t corner_of) {
  return g.colours.at(g.indices.at(triangle * 3 + corner_of));
}

TEST(IndexedFaceSet, FacesEndAtMinusOneAndAtTheEnd) {
  const Geometry g = geometry_from(faces("coordIndex [ 0 1 2 -1 0 2 3 ]"));
  EXPECT_EQ(g.indices.size(), 6U);
  EXPECT_EQ(g.positions.size(), 4U);
  EXPECT_NEAR(area_of(g), 1, 1e-9);
  expect_outward_normals(g);
  EXPECT_EQ(g.normals[0], glm::vec3(0, 0, 1));
  EXPECT_EQ(geometry_from(faces("coordIndex [ -1 -1 0 1 2 -1 -1 ]")).indices.size(), 3U);
}

TEST(IndexedFaceSet, WithoutPointsOrFacesItShowsNothing) {
  EXPECT_TRUE(geometry_from("IndexedFaceSet {}").indices.empty());
  EXPECT_TRUE(geometry_from(faces("")).indices.empty());
}

TEST(IndexedFaceSet, FlagsAreHandedOn) {
  EXPECT_FALSE(geometry_from(faces("coordIndex [ 0 1 2 ] solid FALSE")).solid);
  EXPECT_EQ(geometry_from(faces("coordIndex [ 0 1 2 ] ccw FALSE")).normals[0], glm::vec3(0, 0, -1));
}

TEST(IndexedFaceSet, ConcaveFacesAreCutIntoTheirArea) {
  // A U in the plane x = 1, seen from +x: 3 x 3 without the notch of 1 x 2 from above.
  const std::string u =
      "IndexedFaceSet { coord Coordinate { point [ 1 0 0 1 0 -3 1 3 -3 1 3 -2 1 1 -2 1 1 -1 1 3 -1 "
      "1 "
      "3 0 ] } convex FALSE coordIndex [ 0 1 2 3 4 5 6 7 -1 ] }";
  const Geometry g = geometry_from(u);
  EXPECT_EQ(g.indices.size(), 18U);
  EXPECT_NEAR(area_of(g), 9 - 2, 1e-9);
  expect_outward_normals(g);
  EXPECT_EQ(g.normals[0], glm::vec3(1, 0, 0));
}

TEST(IndexedFaceSet, ColoursByVertexFollowCoordIndexOrTheirOwn) {
  const std::string colour = "color Color { color [ 1 0 0 0 1 0 0 0 1 1 2 -1 ] } ";
  const Geometry own = geometry_from(faces("coordIndex [ 1 2 3 ] " + colour));
  EXPECT_EQ(colour_in(own, 0, 0), glm::vec3(0, 1, 0));
  EXPECT_EQ(colour_in(own, 0, 2), glm::vec3(1, 1, 0));  // drawn into 0..1
  const Geometry indexed = geometry_from(
      faces("coordIndex [ 0 1 2 -1 0 2 3 -1 ] colorIndex [ 2 2 0 -1 1 0 0 -1 ] " + colour));
  EXPECT_EQ(colour_in(indexed, 0, 0), glm::vec3(0, 0, 1));
  EXPECT_EQ(colour_in(indexed, 1, 0), glm::vec3(0, 1, 0));
  EXPECT_EQ(indexed.positions.size(), 5U);  // point 0 twice, point 2 has one colour
}

TEST(IndexedFaceSet, ColoursByFaceComeInOrderOrByIndex) {
  const std::string two =
      "coordIndex [ 0 1 2 -1 0 2 3 ] colorPerVertex FALSE color Color { color [ 1 0 0 0 1 0 ] } ";
  const Geometry order = geometry_from(faces(two));
  EXPECT_EQ(colour_in(order, 0, 1), glm::vec3(1, 0, 0));
  EXPECT_EQ(colour_in(order, 1, 1), glm::vec3(0, 1, 0));
  const Geometry index = geometry_from(faces(two + "colorIndex [ 1 1 ]"));
  EXPECT_EQ(colour_in(index, 0, 1), glm::vec3(0, 1, 0));
}

TEST(IndexedFaceSet, NormalsAreMadeOneLong) {
  const std::string normals =
      "coordIndex [ 0 1 2 -1 0 2 3 ] normal Normal { vector [ 0 0 5 0 3 4 0 0 0 1 0 0 ] } ";
  const Geometry by_vertex = geometry_from(faces(normals));
  EXPECT_EQ(by_vertex.normals[0], glm::vec3(0, 0, 1));
  EXPECT_EQ(by_vertex.normals[1], glm::vec3(0, 0.6F, 0.8F));
  EXPECT_EQ(by_vertex.normals[2], glm::vec3(0, 0, 1));  // of length 0: the face's
  const Geometry by_face =
      geometry_from(faces(normals + "normalPerVertex FALSE normalIndex [ 3 1 ]"));
  EXPECT_EQ(by_face.normals[by_face.indices[0]], glm::vec3(1, 0, 0));
  EXPECT_EQ(by_face.normals[by_face.indices[5]], glm::vec3(0, 0.6F, 0.8F));
}

TEST(IndexedFaceSet, TextureCoordinatesFollowTheirIndex) {
  const std::string texture = "texCoord TextureCoordinate { point [ 0 0 2 0 2 3 7 7 ] } ";
  const Geometry own = geometry_from(faces("coordIndex [ 0 1 2 ] " + texture));
  expect_near(texture_at(own, {1, 1, 0}, {0, 0, 1}), {2, 3});
  const Geometry indexed =
      geometry_from(faces("coordIndex [ 0 1 2 -1 ] texCoordIndex [ 3 0 1 -1 ] " + texture));
  expect_near(texture_at(indexed, {0, 0, 0}, {0, 0, 1}), {7, 7});
  // Without: by the bounding box.
  const Geometry none = geometry_from(faces("coordIndex [ 0 1 2 3 ]"));
  expect_near(texture_at(none, {1, 1, 0}, {0, 0, 1}), {1, 1});
}

TEST(IndexedFaceSet, BadIndicesAndValuesAreErrors) {
  const std::string of = "bad_argument: IndexedFaceSet \"F\": field ";
  EXPECT_EQ(geometry_error(faces("coordIndex [ 0 1 4 ]")),
            of + "coordIndex: value 2 is 4 (expected -1 or 0 to 3)");
  EXPECT_EQ(geometry_error(faces("coordIndex [ 0 1 -2 ]")),
            of + "coordIndex: value 2 is -2 (expected -1 or 0 to 3)");
  EXPECT_EQ(geometry_error("DEF F IndexedFaceSet { coordIndex 0 }"),
            of + "coordIndex: value 0 is 0 (expected -1: there are no points)");
  EXPECT_EQ(geometry_error("DEF F IndexedFaceSet { coord Coordinate { point [ 0 0 0 nan 0 0 ] } }"),
            of + "coord: value 1 is not finite (expected finite numbers)");
  EXPECT_EQ(geometry_error(faces("coordIndex [ 0 1 2 ] color Color { color [ 1 1 1 ] }")),
            of + "color has 1 values (expected at least 3)");
  EXPECT_EQ(
      geometry_error(faces("coordIndex [ 0 1 2 ] colorIndex [ 0 ] color Color { color 1 1 1 }")),
      of + "colorIndex has 1 values (expected at least 2)");
  EXPECT_EQ(geometry_error(
                faces("coordIndex [ 0 1 2 ] texCoordIndex [ 0 -1 0 ] texCoord TextureCoordinate { "
                      "point [ 0 0 ] }")),
            of + "texCoordIndex: value 1 is -1 (expected 0 to 0)");
  EXPECT_EQ(geometry_error(faces("coordIndex [ 0 1 2 ] normalIndex [ 0 0 0 ] normal Normal {}")),
            of + "normalIndex: value 0 is 0 (expected no index: there are no values)");
  EXPECT_EQ(geometry_error(faces("coordIndex [ 0 1 2 ] creaseAngle -1")),
            of + "creaseAngle is -1 (expected 0 or more)");
  Limits small;
  small.memory = 1000;
  EXPECT_EQ(geometry_error(faces("coordIndex [ 0 1 2 -1 0 1 2 -1 ]"), small),
            "limit_exceeded: IndexedFaceSet \"F\": has 8 corners, more than the limit");
}

TEST(ElevationGrid, PointsRunAlongXThenAlongZ) {
  const Geometry g = geometry_from(
      "ElevationGrid { xDimension 3 zDimension 2 xSpacing 2 zSpacing 5 height [ 0 0 0 0 0 0 ] }");
  EXPECT_EQ(g.positions.size(), 6U);
  EXPECT_EQ(g.indices.size(), 12U);
  EXPECT_NEAR(area_of(g), 4 * 5, 1e-9);
  expect_outward_normals(g);
  EXPECT_EQ(g.normals[0], glm::vec3(0, 1, 0));
  const glm::vec3 up(0, 1, 0);
  expect_near(texture_at(g, {0, 0, 0}, up), {0, 0});
  expect_near(texture_at(g, {2, 0, 0}, up), {0.5, 0});
  expect_near(texture_at(g, {4, 0, 5}, up), {1, 1});
}

TEST(ElevationGrid, HeightsAreY) {
  // A slope of 1 along x: normals (-1, 1, 0) / sqrt 2.
  const Geometry g =
      geometry_from("ElevationGrid { xDimension 2 zDimension 2 height [ 0 1 0 1 ] solid FALSE }");
  EXPECT_NEAR(area_of(g), std::sqrt(2.0), 1e-6);
  expect_near(glm::dvec3(g.normals[0]), glm::dvec3(-1, 1, 0) / std::sqrt(2.0));
  EXPECT_FALSE(g.solid);
}

TEST(ElevationGrid, ColoursAreByPointOrBySquare) {
  const std::string grid = "ElevationGrid { xDimension 2 zDimension 3 height [ 0 0 0 0 0 0 ] ";
  const Geometry squares =
      geometry_from(grid + "colorPerVertex FALSE color Color { color [ 1 0 0 0 0 1 ] } }");
  EXPECT_EQ(colour_in(squares, 0, 0), glm::vec3(1, 0, 0));
  EXPECT_EQ(colour_in(squares, 3, 0), glm::vec3(0, 0, 1));
  EXPECT_EQ(geometry_error(grid + "color Color { color [ 1 0 0 0 0 1 ] } }"),
            "bad_argument: ElevationGrid: field color has 2 values (expected at least 6)");
}

TEST(ElevationGrid, BadFieldsAreErrors) {
  const std::string of = "bad_argument: ElevationGrid: field ";
  EXPECT_EQ(geometry_error("ElevationGrid { xDimension -1 }"),
            of + "xDimension is -1 (expected 0 or more)");
  EXPECT_EQ(geometry_error("ElevationGrid { xDimension 2 zDimension 2 height [ 1 2 3 ] }"),
            of + "height has 3 values (expected 4)");
  EXPECT_EQ(geometry_error("ElevationGrid { xDimension 2 zDimension 2 height [ 1 2 3 inf ] }"),
            of + "height: point (1, 1) is not finite (expected finite numbers)");
  EXPECT_EQ(geometry_error("ElevationGrid { xDimension 2147483647 zDimension 2147483647 }"),
            "limit_exceeded: ElevationGrid: has 4611686014132420609 corners, more than the limit");
  EXPECT_TRUE(geometry_from("ElevationGrid { xDimension 1 zDimension 5 }").indices.empty());
}

}  // namespace
}  // namespace afx
