// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/view_sources.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "afx/builder/mesh_surfels.h"
#include "afx/builder/test_meshes.h"
#include "afx/builder/view_plan.h"

namespace afx {
namespace {

// A sphere, and the same as pieces of surface sampled at the resolution of the views.
class ViewSourcesTest : public ::testing::Test {
 protected:
  static constexpr uint32_t kResolution = 64;

  ViewSourcesTest()
      : mesh_(sphere_mesh(5)),
        look_(mesh_, Shade::always),
        surfels_(surfels_of(look_, kResolution, 2, {}).value()),
        of_mesh_(look_, 2, {}),
        of_surfels_(surfels_, 2, {}) {}

  Mesh mesh_;
  MeshLook look_;
  Surfels surfels_;
  MeshViews of_mesh_;
  SurfelViews of_surfels_;
};

TEST_F(ViewSourcesTest, PiecesOfAMeshShowTheSameDepthsAsTheMesh) {
  for (const glm::dvec3& direction : even_directions(6)) {
    const Shot shot = view_from(of_mesh_, direction, {kResolution, true});
    const auto expected = of_mesh_.distances(shot), found = of_surfels_.distances(shot);
    ASSERT_TRUE(expected.ok() && found.ok());
    size_t differ = 0;
    for (size_t i = 0; i < expected.value().size(); ++i) {
      const float a = expected.value()[i], b = found.value()[i];
      if (std::isfinite(a) != std::isfinite(b)) ++differ;
      // Where the surface is steep, a piece seen along another axis stands in: half a pixel aside.
      if (std::isfinite(a) && std::isfinite(b) && std::abs(a - b) > 2.0F / kResolution) ++differ;
    }
    EXPECT_LT(static_cast<double>(differ), 0.06 * kResolution * kResolution);  // at the outline
  }
}

TEST_F(ViewSourcesTest, BoundsOfPiecesHoldTheMeshAndLittleMore) {
  const glm::dmat3 axes(1);
  const Bounds mesh = of_mesh_.bounds_along(axes), pieces = of_surfels_.bounds_along(axes);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(mesh.low[axis], -1, 1e-6);
    EXPECT_NEAR(pieces.low[axis], -1, 2.0 / kResolution);
    EXPECT_NEAR(pieces.high[axis], 1, 2.0 / kResolution);
  }
}

TEST_F(ViewSourcesTest, SamplesOfPiecesHaveTheirNormals) {
  const auto samples = of_surfels_.samples(1000);
  ASSERT_TRUE(samples.ok());
  EXPECT_GE(samples.value().positions.size(), 1000U);
  EXPECT_LT(samples.value().positions.size(), 2100U);
  for (size_t i = 0; i < samples.value().positions.size(); ++i) {
    const glm::dvec3 place = samples.value().origin + glm::dvec3(samples.value().positions[i]);
    EXPECT_GT(glm::dot(place, glm::dvec3(glm::normalize(samples.value().normals[i]))), 0.95);
  }
}

TEST(SurfelViews, WithoutPiecesThereAreNoSamples) {
  const Surfels none;
  const SurfelViews views(none, 1, {});
  EXPECT_EQ(views.samples(10).error().text, "the model has no samples");
}

}  // namespace
}  // namespace afx
