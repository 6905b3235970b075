// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/shapes/geometry_nodes.h"

#include "afx/shapes/shape_test_support.h"

namespace afx {
namespace {

const std::string kPoints = "coord Coordinate { point [ 0 0 0 1 0 0 1 1 0 ] } ";

TEST(PointSet, HasItsPointsAndColours) {
  const Geometry g =
      geometry_from("PointSet { " + kPoints + "color Color { color [ 1 0 0 0 1 0 0 0 9 ] } }");
  EXPECT_EQ(g.kind, Geometry::Kind::points);
  EXPECT_EQ(g.indices, (std::vector<uint32_t>{0, 1, 2}));
  EXPECT_EQ(g.positions[2], glm::vec3(1, 1, 0));
  EXPECT_EQ(g.colours[2], glm::vec3(0, 0, 1));
  EXPECT_TRUE(geometry_from("PointSet { " + kPoints + "}").colours.empty());
  EXPECT_EQ(geometry_error("PointSet { " + kPoints + "color Color { color [ 1 1 1 ] } }"),
            "bad_argument: PointSet: field color has 1 values (expected at least 3)");
}

TEST(IndexedLineSet, LinesRunThroughTheirPoints) {
  const Geometry g =
      geometry_from("IndexedLineSet { " + kPoints + "coordIndex [ 0 1 2 -1 2 0 -1 1 ] }");
  EXPECT_EQ(g.kind, Geometry::Kind::lines);
  ASSERT_EQ(g.indices.size(), 6U);  // a line of one point shows nothing
  EXPECT_EQ(corner(g, 1), glm::dvec3(1, 0, 0));
  EXPECT_EQ(corner(g, 2), glm::dvec3(1, 0, 0));
  EXPECT_EQ(corner(g, 4), glm::dvec3(1, 1, 0));
  EXPECT_EQ(corner(g, 5), glm::dvec3(0, 0, 0));
}

TEST(IndexedLineSet, ColoursAreByPointOrByLine) {
  const std::string lines =
      "IndexedLineSet { " + kPoints +
      "coordIndex [ 0 1 -1 1 2 ] color Color { color [ 1 0 0 0 1 0 0 0 1 ] } ";
  const Geometry points = geometry_from(lines + "}");
  EXPECT_EQ(points.colours[points.indices[3]], glm::vec3(0, 0, 1));
  const Geometry indexed = geometry_from(lines + "colorIndex [ 2 2 -1 0 0 ] }");
  EXPECT_EQ(indexed.colours[indexed.indices[0]], glm::vec3(0, 0, 1));
  const Geometry by_line = geometry_from(lines + "colorPerVertex FALSE }");
  EXPECT_EQ(by_line.colours[by_line.indices[0]], glm::vec3(1, 0, 0));
  EXPECT_EQ(by_line.colours[by_line.indices[3]], glm::vec3(0, 1, 0));
  const Geometry by_index = geometry_from(lines + "colorPerVertex FALSE colorIndex [ 2 0 ] }");
  EXPECT_EQ(by_index.colours[by_index.indices[0]], glm::vec3(0, 0, 1));
  EXPECT_EQ(geometry_error(lines + "colorIndex [ 0 0 -1 0 5 ] }"),
            "bad_argument: IndexedLineSet: field colorIndex: value 4 is 5 (expected 0 to 2)");
}

TEST(Geometry, OtherNodesAreUnsupported) {
  EXPECT_EQ(geometry_error("DEF T Text {}"),
            "unsupported: Text \"T\": is not a geometry that can be shown");
  EXPECT_FALSE(is_known_geometry("Text"));
  EXPECT_TRUE(is_known_geometry("Box"));
}

}  // namespace
}  // namespace afx
