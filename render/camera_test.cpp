// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

namespace afx::render {
namespace {

std::vector<glm::dvec3> box(glm::dvec3 low, glm::dvec3 high) {
  std::vector<glm::dvec3> corners;
  for (unsigned k = 0; k < 8; ++k) {
    corners.emplace_back((k & 1U) != 0 ? high.x : low.x, (k & 2U) != 0 ? high.y : low.y,
                         (k & 4U) != 0 ? high.z : low.z);
  }
  return corners;
}

/// Where points fall on the picture, each way from -1 to 1; by the camera's axes, worked out here.
struct Extent {
  double left = 1e9, right = -1e9, down = 1e9, up = -1e9, nearest = 1e9;
};
Extent extent(const std::vector<glm::dvec3>& points, const Camera& camera, double aspect) {
  const glm::dvec3 right = camera.orientation * glm::dvec3(1, 0, 0);
  const glm::dvec3 up = camera.orientation * glm::dvec3(0, 1, 0);
  const glm::dvec3 back = camera.orientation * glm::dvec3(0, 0, 1);
  Extent e;
  for (const glm::dvec3& point : points) {
    const glm::dvec3 from = point - camera.position;
    const double depth = -glm::dot(from, back);
    const double half = camera.projection == Projection::perspective
                            ? depth * std::tan(camera.field_of_view / 2)
                            : camera.view_height / 2;
    const double x = glm::dot(from, right) / half / aspect, y = glm::dot(from, up) / half;
    e.left = std::min(e.left, x), e.right = std::max(e.right, x);
    e.down = std::min(e.down, y), e.up = std::max(e.up, y);
    e.nearest = std::min(e.nearest, depth);
  }
  return e;
}

TEST(FitCamera, TheObjectFillsThePictureUpToTheMargin) {
  const auto points = box({-0.2, -0.5, -0.1}, {0.3, 0.4, 0.1});
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    for (const double aspect : {0.5, 1.0, 16.0 / 9}) {
      for (const double azimuth : {0.5, 3.0}) {
        View view;
        view.projection = projection;
        view.azimuth = azimuth;
        const auto camera = fit_camera(points, view, aspect);
        ASSERT_TRUE(camera.ok());
        const Extent e = extent(points, camera.value(), aspect);
        const double reach = 1 - 2 * view.margin;
        EXPECT_NEAR(std::max(e.right, e.up), reach, 1e-3);
        EXPECT_GE(e.left, -reach - 1e-3);
        EXPECT_GE(e.down, -reach - 1e-3);
        // Perspective centres between the planes that touch it, so the fuller way is exact.
        EXPECT_NEAR(e.right - e.up > 0 ? e.left : e.down, -reach, 1e-3);
        EXPECT_GT(e.nearest, camera.value().near_plane);
      }
    }
  }
}

TEST(FitCamera, TheDefaultViewIsFromTheFrontRightAndAbove) {
  const auto camera = fit_camera({}, View{}, 1);
  ASSERT_TRUE(camera.ok());
  const glm::dvec3 p = camera.value().position;
  EXPECT_GT(p.z, p.x);
  EXPECT_GT(p.x, p.y);
  EXPECT_GT(p.y, 0);
  EXPECT_NEAR((camera.value().orientation * glm::dvec3(1, 0, 0)).y, 0, 1e-12);  // upright
}

TEST(FitCamera, OnePointIsLookedAtFromOutside) {
  const std::vector<glm::dvec3> points = {{3, 4, 5}};
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    View view;
    view.projection = projection;
    const auto camera = fit_camera(points, view, 1);
    ASSERT_TRUE(camera.ok());
    EXPECT_TRUE(check_camera(camera.value()).ok());
    EXPECT_GT(extent(points, camera.value(), 1).nearest, camera.value().near_plane);
  }
}

TEST(FitCamera, ValuesOutOfRangeAreRefused) {
  const auto code = [](View view, double aspect, glm::dvec3 point) {
    const auto camera = fit_camera(std::vector<glm::dvec3>{point}, view, aspect);
    return camera.ok() ? std::string("ok") : camera.error().text;
  };
  const glm::dvec3 origin(0);
  EXPECT_EQ(code({}, 1, origin), "ok");
  EXPECT_NE(code({}, 0, origin), "ok");
  EXPECT_NE(code({}, NAN, origin), "ok");
  EXPECT_NE(code({}, 1, {0, NAN, 0}), "ok");
  EXPECT_NE(code({}, 1, {0, 1e308, 0}), "");  // an answer, whichever
  EXPECT_NE(code({.azimuth = INFINITY}, 1, origin), "ok");
  EXPECT_NE(code({.elevation = 1.6}, 1, origin), "ok");
  EXPECT_NE(code({.field_of_view = 0}, 1, origin), "ok");
  EXPECT_NE(code({.margin = 0.5}, 1, origin), "ok");
}

TEST(CheckCamera, NamesWhatIsWrong) {
  const auto text = [](const Camera& camera) {
    const Status s = check_camera(camera);
    return s.ok() ? std::string("ok") : s.error().text;
  };
  EXPECT_EQ(text({}), "ok");
  EXPECT_EQ(text({.position = {NAN, 0, 0}}).substr(0, 15), "camera position");
  EXPECT_NE(text({.orientation = {0, 0, 0, 0}}), "ok");
  EXPECT_NE(text({.orientation = {NAN, 0, 0, 0}}), "ok");
  EXPECT_EQ(text({.near_plane = 0}), "near plane is 0.000000 (expected a distance > 0)");
  EXPECT_EQ(text({.field_of_view = 4}),
            "field of view is 4.000000 (expected more than 0 and less than pi)");
  EXPECT_NE(text({.projection = Projection::orthographic, .view_height = -1}), "ok");
}

}  // namespace
}  // namespace afx::render
