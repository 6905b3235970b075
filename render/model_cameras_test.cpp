// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/model_cameras.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace afx::render {
namespace {

using Kind = ModelCamera::Kind;

glm::dmat4 moved(double x) {
  glm::dmat4 matrix(1);
  matrix[3].x = x;
  return matrix;
}

TEST(ModelCameras, ADepthImageHasItsOwn) {
  DepthImage first, second;
  second.camera = {{1, 2, 3}, {0, 0, 1, 0}, false, {0.5, 0.25}, 2, 7};
  const std::vector<DibrModel> models = {{moved(4), std::vector{first, second}}};
  const std::vector<ModelCamera> cameras = model_cameras(models);
  ASSERT_EQ(cameras.size(), 2U);
  EXPECT_EQ(cameras[0].camera, DepthCamera());
  EXPECT_EQ(cameras[1].camera, second.camera);
  EXPECT_EQ(cameras[1].kind, Kind::depth_image);
  EXPECT_EQ(cameras[1].model, 0U);
  EXPECT_EQ(cameras[1].image, 1U);
  EXPECT_EQ(cameras[1].to_world, moved(4));
}

TEST(ModelCameras, ThePlanesOfAReferenceImageTouchTheCube) {
  OctreeModel octree;
  octree.images.resize(2);  // 0 0 10, looking along -z
  octree.images[0].field_of_view = {2, 3};
  // On +x, turned to the left by 45 degrees: the edge of the cube at x = z = 1/2 is sqrt(1/2)
  // nearer than its middle, which lies sqrt(2) ahead.
  octree.images[1].position = {1, 0, 1};
  const auto half_turn = static_cast<float>(std::acos(-1.0) / 8);
  octree.images[1].orientation = {std::cos(half_turn), 0, std::sin(half_turn), 0};
  const std::vector<DibrModel> models = {{glm::dmat4(1), std::vector<DepthImage>()},
                                         {moved(-1), std::move(octree)}};
  const std::vector<ModelCamera> cameras = model_cameras(models);
  ASSERT_EQ(cameras.size(), 2U);
  EXPECT_EQ(cameras[0].kind, Kind::reference_image);
  EXPECT_EQ(cameras[0].model, 1U);
  EXPECT_EQ(cameras[0].to_world, moved(-1));
  EXPECT_TRUE(cameras[0].camera.orthographic);
  EXPECT_EQ(cameras[0].camera.field_of_view, glm::dvec2(2, 3));
  EXPECT_DOUBLE_EQ(cameras[0].camera.near_plane, 9.5);
  EXPECT_DOUBLE_EQ(cameras[0].camera.far_plane, 10.5);
  EXPECT_NEAR(cameras[1].camera.near_plane, std::sqrt(2.0) - std::sqrt(0.5), 1e-6);
  EXPECT_NEAR(cameras[1].camera.far_plane, std::sqrt(2.0) + std::sqrt(0.5), 1e-6);
}

TEST(ModelCameras, ACameraInsideTheCubeHasTheNearPlaneBehindIt) {
  OctreeModel octree;
  octree.images.resize(1);
  octree.images[0].position = {0, 0, 0.25};
  const std::vector<DibrModel> models = {{glm::dmat4(1), std::move(octree)}};
  EXPECT_DOUBLE_EQ(model_cameras(models).at(0).camera.near_plane, -0.25);
  EXPECT_DOUBLE_EQ(model_cameras(models).at(0).camera.far_plane, 0.75);
}

}  // namespace
}  // namespace afx::render
