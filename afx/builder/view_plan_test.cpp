// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/view_plan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "afx/builder/test_meshes.h"
#include "afx/builder/view_sources.h"

namespace afx {
namespace {

std::vector<Shot> shots(const ViewSource& source, const std::vector<glm::dvec3>& directions,
                        const ViewOptions& options) {
  std::vector<Shot> result;
  for (const glm::dvec3& d : directions) result.push_back(view_from(source, d, options));
  return result;
}

TEST(EvenDirections, SixAreTheSidesOfABox) {
  const auto six = even_directions(6);
  EXPECT_EQ(six[0], glm::dvec3(0, 0, 1));
  EXPECT_EQ(six[5], glm::dvec3(0, -1, 0));
}

TEST(EvenDirections, AreUnitVectorsFarApartThatSumToNearlyNothing) {
  for (const unsigned count : {21U, 122U}) {
    glm::dvec3 sum(0);
    double closest = 2;
    const auto directions = even_directions(count);
    for (size_t i = 0; i < count; ++i) {
      EXPECT_NEAR(glm::length(directions[i]), 1, 1e-12);
      sum += directions[i];
      for (size_t j = 0; j < i; ++j)
        closest = std::min(closest, glm::distance(directions[i], directions[j]));
    }
    // Each has the area 4 pi / count; a square of that area has this side.
    EXPECT_GT(closest, 0.75 * std::sqrt(4 * 3.1416 / count)) << count;
    EXPECT_LT(glm::length(sum) / count, 0.02);
  }
}

TEST(ViewFrom, HoldsTheModelCloselyWithSquarePixels) {
  const Mesh box = box_mesh({-1, -2, -3}, {1, 2, 3});
  const MeshLook look(box, Shade::never);
  const MeshViews views(look, 1, {});
  const Shot side = view_from(views, {1, 0, 0}, {60, true});  // 6 long: pixels of 0.1
  EXPECT_EQ(side.width, 60U);
  EXPECT_EQ(side.height, 40U);
  EXPECT_NEAR(side.camera.field_of_view.x, 6, 1e-6);
  EXPECT_NEAR(side.camera.field_of_view.y, 4, 1e-6);
  EXPECT_NEAR(glm::length(side.camera.position - glm::dvec3(7, 0, 0)), 0, 1e-6);
  EXPECT_NEAR(side.camera.far_plane - side.camera.near_plane, 2, 2e-3);
  EXPECT_LT(side.camera.near_plane, 6);
}

TEST(ViewFrom, FromAboveMinusZIsUpAndFromBelowZ) {
  const Mesh box = box_mesh({-1, -2, -3}, {1, 2, 3});
  const MeshLook look(box, Shade::never);
  const MeshViews views(look, 1, {});
  for (const bool parallel : {true, false})
    for (const double y : {1.0, -1.0}) {
      const Shot shot = view_from(views, {0, y, 0}, {60, parallel});
      const DepthCamera& camera = shot.camera;
      const auto turned = [&](const glm::dvec3& axis) { return camera.orientation * axis; };
      EXPECT_NEAR(glm::distance(turned({1, 0, 0}), glm::dvec3(1, 0, 0)), 0, 1e-6);
      EXPECT_NEAR(glm::distance(turned({0, 1, 0}), glm::dvec3(0, 0, -y)), 0, 1e-6);
      EXPECT_NEAR(glm::distance(turned({0, 0, 1}), glm::dvec3(0, y, 0)), 0, 1e-6);
      EXPECT_GT(y * camera.position.y, 2);
      EXPECT_LT(shot.width, shot.height);  // 2 along x, 6 along z
      EXPECT_NE(distance_to_depth(y * camera.position.y - 2, 65535, camera), 0U);
      if (!parallel) continue;
      EXPECT_EQ(glm::uvec2(shot.width, shot.height), glm::uvec2(20, 60));
    }
}

TEST(ViewFrom, EveryVertexIsInThePictureAndBetweenThePlanes) {
  Mesh sphere = sphere_mesh(3);
  for (glm::vec3& p : sphere.positions) p = p * glm::vec3(1, 0.3, 2) + glm::vec3(5, 6, 7);
  const MeshLook look(sphere, Shade::never);
  const MeshViews views(look, 1, {});
  for (const bool parallel : {true, false})
    for (const glm::dvec3& direction : even_directions(21)) {
      const Shot shot = view_from(views, direction, {100, parallel});
      ASSERT_TRUE(check_depth_camera(shot.camera).ok());
      const CameraProjection projection(shot.camera);
      for (const glm::vec3& p : sphere.positions) {
        const ScreenPoint at = projection.project(glm::dvec3(p));
        EXPECT_TRUE(at.u > -1e-6 && at.u < 1 + 1e-6 && at.v > -1e-6 && at.v < 1 + 1e-6);
        EXPECT_NE(distance_to_depth(at.distance, 65535, shot.camera), 0U);
      }
    }
}

TEST(CoverageMeter, SixViewsSeeAllOfABoxAndOneSeesASixth) {
  const Mesh box = box_mesh({-1, -1, -1}, {1, 1, 1});
  const MeshLook look(box, Shade::never);
  const MeshViews views(look, 2, {});
  const auto meter = CoverageMeter::of(views);
  ASSERT_TRUE(meter.ok()) << meter.error().text;
  const ViewOptions options{64, true};
  const auto all = meter.value().measure(shots(views, even_directions(6), options));
  EXPECT_EQ(all.value().covered, all.value().visible);
  EXPECT_GT(all.value().visible, 90000U);
  const auto one = meter.value().measure(shots(views, {{0, 0, 1}}, options));
  EXPECT_NEAR(one.value().part(), 1.0 / 6, 0.001);
  EXPECT_EQ(meter.value().choose().size(), 6U);  // nothing is left to be seen
}

TEST(CoverageMeter, SeesASlopeThroughPixelsHigherThanWideAsThroughWideOnes) {
  Mesh slope = textured_square(Picture(1, 1, 3));  // rises to the top and to the right
  for (glm::vec3& p : slope.positions) p.z = 0.7F * (p.x + p.y);
  const MeshLook look(slope, Shade::never);
  const MeshViews views(look, 2, {});
  const auto meter = CoverageMeter::of(views);
  ASSERT_TRUE(meter.ok());
  const DepthCamera camera{{0, 0, 10}, {1, 0, 0, 0}, true, {2, 2}, 1, 20};
  const auto part = [&](uint32_t width, uint32_t height) {
    return meter.value().measure({{camera, width, height}}).value().part();
  };
  EXPECT_EQ(part(64, 8), 1);
  EXPECT_EQ(part(8, 64), 1);
}

TEST(CoverageMeter, AddsViewsWhereSixDoNotSeeEverything) {
  // Six boxes around a seventh: its corners are open only towards slanting directions.
  Mesh mesh = box_mesh({-1, -1, -1}, {1, 1, 1});
  for (int axis = 0; axis < 3; ++axis)
    for (const float sign : {-1.0F, 1.0F}) {
      glm::vec3 centre(0), half(1.2F);
      centre[axis] = sign * 2.0F;
      half[axis] = 0.1F;
      Mesh more = box_mesh(centre - half, centre + half);
      const auto first = static_cast<uint32_t>(mesh.positions.size());
      mesh.positions.insert(mesh.positions.end(), more.positions.begin(), more.positions.end());
      for (const glm::uvec3& t : more.triangles)
        add_triangle(mesh, t.x + first, t.y + first, t.z + first);
    }
  const MeshLook look(mesh, Shade::never);
  const MeshViews views(look, 2, {});
  const auto meter = CoverageMeter::of(views);
  ASSERT_TRUE(meter.ok());
  const ViewOptions options{128, true};
  const double six =
      meter.value().measure(shots(views, even_directions(6), options)).value().part();
  const auto chosen = meter.value().choose();
  const double more = meter.value().measure(shots(views, chosen, options)).value().part();
  EXPECT_LT(six, 0.8);
  EXPECT_GT(chosen.size(), 6U);
  EXPECT_GT(more, 0.98);
}

}  // namespace
}  // namespace afx
