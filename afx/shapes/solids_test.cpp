// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/shapes/solids.h"

#include <cmath>
#include <numbers>

#include "afx/shapes/shape_test_support.h"

namespace afx {
namespace {

constexpr double kPi = std::numbers::pi;
// Area and circumference of the polygon of 32 sides in a circle of radius 1.
const double kDisc = 16 * std::sin(2 * kPi / 32), kRound = 64 * std::sin(kPi / 32);

TEST(Solids, ABoxHasItsSize) {
  const Geometry box = geometry_from("Box { size 2 3 4 }");
  EXPECT_NEAR(volume_of(box), 24, 1e-5);
  EXPECT_NEAR(area_of(box), 2 * (6 + 8 + 12), 1e-5);
  EXPECT_EQ(euler_number(box), 2);
  expect_outward_normals(box);
  EXPECT_TRUE(box.solid);
}

TEST(Solids, ABoxShowsItsPictureUprightOnEachSide) {
  // VRML97: upright on front, back, left and right; on the top as one sees it turning the top to
  // the front, the lower edge is the one in front then; on the bottom likewise.
  const Geometry box = geometry_from("Box {}");
  const glm::vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  expect_near(texture_at(box, {-1, -1, 1}, z), {0, 0});
  expect_near(texture_at(box, {1, 1, 1}, z), {1, 1});
  expect_near(texture_at(box, {1, -1, -1}, -z), {0, 0});
  expect_near(texture_at(box, {-1, -1, -1}, -z), {1, 0});
  expect_near(texture_at(box, {1, -1, 1}, x), {0, 0});
  expect_near(texture_at(box, {1, 1, -1}, x), {1, 1});
  expect_near(texture_at(box, {-1, -1, -1}, -x), {0, 0});
  expect_near(texture_at(box, {-1, -1, 1}, -x), {1, 0});
  expect_near(texture_at(box, {-1, 1, 1}, y), {0, 0});
  expect_near(texture_at(box, {1, 1, -1}, y), {1, 1});
  expect_near(texture_at(box, {-1, -1, -1}, -y), {0, 0});
  expect_near(texture_at(box, {1, -1, 1}, -y), {1, 1});
}

TEST(Solids, ASphereIsNearlyRound) {
  const Geometry sphere = geometry_from("Sphere { radius 2 }");
  // Frustums of pyramids of 32 sides: by the rings' radii r and heights h, h/3 (A + B + sqrt(A B)).
  double volume = 0;
  for (int i = 0; i < 16; ++i) {
    const double a = 2 * std::sin(kPi * i / 16), b = 2 * std::sin(kPi * (i + 1) / 16);
    const double h = 2 * (std::cos(kPi * i / 16) - std::cos(kPi * (i + 1) / 16));
    volume += h / 3 * kDisc * (a * a + a * b + b * b);
  }
  EXPECT_NEAR(volume_of(sphere), volume, 1e-4);
  EXPECT_NEAR(volume, 4 * kPi / 3 * 8, 0.02 * volume);
  EXPECT_EQ(euler_number(sphere), 2);
  EXPECT_EQ(sphere.indices.size(), 3U * 2 * 32 * 15);
  expect_outward_normals(sphere);
  for (size_t i = 0; i < sphere.positions.size(); ++i)
    EXPECT_LT(glm::distance(sphere.positions[i], 2.0F * sphere.normals[i]), 1e-5);
}

TEST(Solids, ASphereShowsThePictureFromTheBackOverTheLeft) {
  const Geometry sphere = geometry_from("Sphere {}");
  expect_near(texture_at(sphere, {0, 0, 1}, {0, 0, 1}), {0.5, 0.5});
  expect_near(texture_at(sphere, {-1, 0, 0}, {-1, 0, 0}), {0.25, 0.5});
  expect_near(texture_at(sphere, {1, 0, 0}, {1, 0, 0}), {0.75, 0.5});
  EXPECT_EQ(texture_at(sphere, {0, 1, 0}, {0, 1, 0}).y, 1);
  EXPECT_EQ(texture_at(sphere, {0, -1, 0}, {0, -1, 0}).y, 0);
  bool from = false, to = false;  // the back is both edges of the picture
  for (size_t i = 0; i < sphere.positions.size(); ++i) {
    if (glm::distance(sphere.positions[i], {0, 0, -1}) > 1e-5F) continue;
    from |= sphere.texture_coordinates[i].x == 0;
    to |= sphere.texture_coordinates[i].x == 1;
  }
  EXPECT_TRUE(from && to);
}

TEST(Solids, AConeHasItsSize) {
  const Geometry cone = geometry_from("Cone { bottomRadius 2 height 6 }");
  EXPECT_NEAR(volume_of(cone), kDisc * 4 * 6 / 3, 1e-4);
  const double slant = std::sqrt(36 + 4 * std::pow(std::cos(kPi / 32), 2));
  EXPECT_NEAR(area_of(cone), kDisc * 4 + kRound * 2 * slant / 2, 1e-4);
  EXPECT_EQ(euler_number(cone), 2);
  expect_outward_normals(cone);
  // The side of slope 6 : 2 has its normals (6, 2) / sqrt(40).
  expect_near(glm::dvec3(cone.normals[0]), glm::dvec3(0, 2, -6) / std::sqrt(40.0));
  expect_near(texture_at(cone, {0, -3, 2}, {0, 0, 1}), {0.5, 0});
  expect_near(texture_at(cone, {-2, -3, 0}, {-1, 0, 0}), {0.25, 0});
  expect_near(texture_at(cone, {0, -3, 2}, {0, -1, 0}), {0.5, 1});
  expect_near(texture_at(cone, {-2, -3, 0}, {0, -1, 0}), {0, 0.5});
}

TEST(Solids, ACylinderHasItsSize) {
  const Geometry cylinder = geometry_from("Cylinder { radius 2 height 6 }");
  EXPECT_NEAR(volume_of(cylinder), kDisc * 4 * 6, 1e-4);
  EXPECT_NEAR(area_of(cylinder), 2 * kDisc * 4 + kRound * 2 * 6, 1e-4);
  EXPECT_EQ(euler_number(cylinder), 2);
  expect_outward_normals(cylinder);
  expect_near(texture_at(cylinder, {2, 3, 0}, {1, 0, 0}), {0.75, 1});
  expect_near(texture_at(cylinder, {0, 3, 2}, {0, 1, 0}), {0.5, 0});  // the top: the front is below
  expect_near(texture_at(cylinder, {0, -3, 2}, {0, -1, 0}), {0.5, 1});
}

TEST(Solids, SidesCanBeLeftOut) {
  EXPECT_NEAR(area_of(geometry_from("Cylinder { bottom FALSE side FALSE }")), kDisc, 1e-5);
  EXPECT_NEAR(area_of(geometry_from("Cylinder { bottom FALSE top FALSE }")), kRound * 2, 1e-5);
  EXPECT_NEAR(area_of(geometry_from("Cone { side FALSE }")), kDisc, 1e-5);
  EXPECT_TRUE(geometry_from("Cone { side FALSE bottom FALSE }").indices.empty());
}

TEST(Solids, BadSizesAreErrors) {
  EXPECT_EQ(geometry_error("DEF B Box { size 1 -2 3 }"),
            "bad_argument: Box \"B\": field size is 1 -2 3 (expected finite numbers, 0 or more)");
  EXPECT_EQ(geometry_error("Sphere { radius nan }"),
            "bad_argument: Sphere: field radius is nan (expected 0 or more)");
  EXPECT_EQ(geometry_error("Cone { height inf }"),
            "bad_argument: Cone: field height is inf (expected 0 or more)");
  EXPECT_EQ(geometry_error("Cylinder { radius -1 }"),
            "bad_argument: Cylinder: field radius is -1 (expected 0 or more)");
}

}  // namespace
}  // namespace afx
