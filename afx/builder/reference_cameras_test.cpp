// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/reference_cameras.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "afx/reference_projection.h"

namespace afx {
namespace {

TEST(ReferenceCameras, LookAtTheCentreFromSixSides) {
  const glm::vec3 directions[] = {{0, 0, 1},  {0, 0, -1}, {1, 0, 0},
                                  {-1, 0, 0}, {0, 1, 0},  {0, -1, 0}};
  for (unsigned view = 0; view < kSideViews; ++view) {
    const ReferenceImage camera = side_camera(view, 8).image;
    const glm::vec3 ahead = camera.orientation * glm::vec3(0, 0, -1);
    EXPECT_NEAR(glm::length(camera.position + ahead), 0, 1e-6) << view;  // at distance 1
    EXPECT_NEAR(glm::dot(directions[view], ahead), -1, 1e-6);
  }
  // Upright: no picture of the four sides lies on its side.
  for (unsigned view = 0; view < 4; ++view)
    EXPECT_NEAR((side_camera(view, 8).image.orientation * glm::vec3(0, 1, 0)).y, 1, 1e-6);
}

TEST(ReferenceCameras, LookAtTheWholeCubeFromAnywhere) {
  for (const glm::dvec3 given :
       {glm::dvec3(1, 1, 1), glm::dvec3(0, 1, 2), glm::dvec3(-2, 2, -1), glm::dvec3(1, 0, 0)}) {
    const glm::dvec3 to_camera = glm::normalize(given);
    const ReferenceCamera camera = slanting_camera(to_camera, 100);
    const ReferenceProjection projection(camera.image, camera.width, camera.height);
    EXPECT_NEAR(glm::length(projection.to_camera() - to_camera), 0, 1e-6);
    EXPECT_NEAR(glm::length(glm::dvec3(camera.image.position) - to_camera), 0, 1e-6);
    EXPECT_NEAR(camera.image.field_of_view.x * 100, camera.width, 1e-4);  // square pixels
    EXPECT_NEAR(camera.image.field_of_view.y * 100, camera.height, 1e-4);
    // y leads upwards, and neither left nor right.
    const auto at = [&](const glm::dvec3& point) { return projection.project(point); };
    EXPECT_NEAR(at({0, 1, 0}).x, at({0, 0, 0}).x, 1e-4);
    EXPECT_GT(at({0, 1, 0}).y, at({0, 0, 0}).y);
    for (int corner = 0; corner < 8; ++corner) {
      const glm::dvec3 point((corner & 1) - 0.5, (corner >> 1 & 1) - 0.5, (corner >> 2) - 0.5);
      EXPECT_TRUE(projection.pixel_at(at(point)).inside);
      const double from_camera = kReferenceDistance + projection.depth(point);
      EXPECT_GT(from_camera, double{kReferenceNearPlane});
      EXPECT_LT(from_camera, double{kReferenceFarPlane});
    }
  }
}

TEST(ReferenceCameras, CroppedKeepThePixelGrid) {
  for (const ReferenceCamera& whole :
       {side_camera(3, 64), slanting_camera(glm::normalize(glm::dvec3(2, -1, 1)), 64)}) {
    const ReferenceCamera part = cropped(whole, 5, 9, 20, 31);
    EXPECT_EQ(part.width, 20U);
    EXPECT_EQ(part.height, 31U);
    const ReferenceProjection before(whole.image, whole.width, whole.height);
    const ReferenceProjection after(part.image, part.width, part.height);
    for (const glm::dvec3 point : {glm::dvec3(0, 0, 0), glm::dvec3(0.3, -0.2, 0.4)}) {
      EXPECT_NEAR(after.project(point).x, before.project(point).x - 5, 1e-3);
      // From below: what was cropped there is what is neither above nor left.
      const int below = static_cast<int>(whole.height) - 9 - 31;
      EXPECT_NEAR(after.project(point).y, before.project(point).y - below, 1e-3);
      EXPECT_NEAR(after.depth(point), before.depth(point), 1e-6);
    }
  }
}

TEST(ReferenceCameras, HaveNames) {
  EXPECT_EQ(reference_name(0), "front");
  EXPECT_EQ(reference_name(5), "bottom");
  EXPECT_EQ(reference_name(6), "view07");
  EXPECT_EQ(reference_name(126), "view127");
}

}  // namespace
}  // namespace afx
