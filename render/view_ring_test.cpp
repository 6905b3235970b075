// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/view_ring.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace afx::render {
namespace {

/// From where the cube of side 1 is looked at.
glm::dvec3 direction(const View& view) {
  const auto camera = fit_camera({}, view, 1);
  EXPECT_TRUE(camera.ok());
  return camera.ok() ? camera.value().orientation * glm::dvec3(0, 0, 1) : glm::dvec3(0);
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b) {
  EXPECT_LT(glm::length(a - b), 1e-9) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(ViewRing, FourViewsAreFrontRightBackAndLeftByTurnsFromBelowAndAbove) {
  const std::vector<View> views = view_ring(4);
  ASSERT_EQ(views.size(), 4U);
  const double flat = 0.9396926207859084, high = 0.3420201433256687;  // cosine, sine of 20 degrees
  expect_near(direction(views[0]), {0, -high, flat});
  expect_near(direction(views[1]), {flat, high, 0});
  expect_near(direction(views[2]), {0, -high, -flat});
  expect_near(direction(views[3]), {-flat, high, 0});
}

TEST(ViewRing, NeighboursAreEquallyFarApart) {
  const std::vector<View> views = view_ring(12);
  const double cosine = glm::dot(direction(views[0]), direction(views[1]));
  EXPECT_LT(cosine, 0.8);
  for (size_t k = 0; k < 12; ++k) {
    EXPECT_NEAR(glm::dot(direction(views[k]), direction(views[(k + 1) % 12])), cosine, 1e-9);
  }
}

TEST(ViewRing, AllElseIsAsByDefault) {
  for (const View& view : view_ring(5)) {
    EXPECT_EQ(view.projection, View{}.projection);
    EXPECT_EQ(view.field_of_view, View{}.field_of_view);
    EXPECT_EQ(view.margin, View{}.margin);
  }
  EXPECT_TRUE(view_ring(0).empty());
}

}  // namespace
}  // namespace afx::render
