// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What conformance/scenes/mixed.wrl holds, counted by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "nodes/scene_reader.h"
#include "render/camera.h"
#include "render/model_cameras.h"
#include "render/scene_maker.h"

namespace afx::render {
namespace {

using Kind = Geometry::Kind;

class MixedScene : public testing::Test {
 protected:
  void SetUp() override {
    std::ifstream file(AFX_SOURCE_DIR "/conformance/scenes/mixed.wrl");
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    auto nodes = nodes::read_scene_text(text, {}, diagnostics_);
    ASSERT_TRUE(nodes.ok()) << nodes.error().text;
    nodes_ = std::move(nodes).value();
    reader_.emplace(nodes_, UrlBase(""), VisualOptions(), Limits());
    read(std::nullopt);
  }
  void read(const std::optional<nodes::Viewer>& viewer) {
    auto visual = reader_->read(viewer, diagnostics_);
    ASSERT_TRUE(visual.ok()) << visual.error().text;
    visual_ = std::move(visual).value();
    auto scene = maker_.make(visual_, diagnostics_);
    ASSERT_TRUE(scene.ok()) << scene.error().text;
    scene_ = std::move(scene).value();
    EXPECT_EQ(diagnostics_.count(), 0U);
    const Status right = check_scene(scene_);
    EXPECT_TRUE(right.ok()) << right.error().text;
  }
  [[nodiscard]] size_t primitives(size_t shape) const {
    const Geometry& g = *scene_.shapes.at(shape).geometry;
    return g.indices.size() / corners_of(g.kind);
  }
  [[nodiscard]] glm::dvec3 place(size_t shape) const {
    return glm::dvec3(scene_.shapes.at(shape).to_world[3]);
  }

  Diagnostics diagnostics_;
  nodes::Scene nodes_;
  std::optional<VisualSceneReader> reader_;
  SceneMaker maker_;
  VisualScene visual_;
  Scene scene_;
};

void expect_near(const glm::dvec3& a, const glm::dvec3& b) {
  EXPECT_LT(glm::distance(a, b), 1e-6) << a.x << " " << a.y << " " << a.z;
}

/// The ball, the relief, the layers, the ball in the LOD's first level, the relief on the sign.
TEST_F(MixedScene, HasFiveModelsOfThreeShapes) {
  ASSERT_EQ(visual_.models.size(), 5U);
  EXPECT_EQ(visual_.models[0].shape, visual_.models[3].shape);
  EXPECT_EQ(visual_.models[1].shape, visual_.models[4].shape);
  const glm::dvec3 places[] = {
      {-1.8, 0, 0}, {1, 0, -0.4}, {0, 1.4, 0}, {2.6, -0.7, 1.6}, {-3, -0.3, 0.7}};
  const double sizes[] = {1.6, 1, 1, 0.4, 0.3};
  for (size_t i = 0; i < 5; ++i) {
    const glm::dmat4& m = visual_.models[i].to_world;
    expect_near(glm::dvec3(m[3]), places[i]);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(m[k][k], sizes[i], 1e-6);
  }
}

TEST_F(MixedScene, ItsModelsHaveTheirVoxelsAndSamples) {
  ASSERT_EQ(scene_.voxels.size(), 2U);
  EXPECT_EQ(scene_.voxels[0].tree->voxels(), 144U);
  EXPECT_EQ(scene_.voxels[0].tree, scene_.voxels[1].tree);
  ASSERT_EQ(scene_.surfels.size(), 3U);
  EXPECT_EQ(scene_.surfels[0].surfels->size(), 32U);  // 36 less the corners
  EXPECT_EQ(scene_.surfels[1].surfels->size(), 9U);
  EXPECT_EQ(scene_.surfels[0].surfels, scene_.surfels[2].surfels);
}

/// The band across the front image's middle is white and blue. Its pixel (2, 3) is blue: the voxel
/// of x = 2, y = 3 that lies farthest in front, at z = 7, shows it.
TEST_F(MixedScene, TheBallShowsItsFrontPicture) {
  const VoxelTree& tree = *scene_.voxels[0].tree;
  const std::vector<uint64_t> codes = tree.codes(3);
  // Morton code of (2, 3, 7) = 010, 011, 111 binary: from the highest bit (z y x) 100 111 110.
  const uint64_t code = 0b100'111'110;
  const auto found = std::find(codes.begin(), codes.end(), code);
  ASSERT_NE(found, codes.end());
  const Rgba8 colour = tree.colours()[static_cast<size_t>(found - codes.begin())];
  EXPECT_EQ(colour, (Rgba8{0x20, 0x40, 0xA0, 255}));
}

/// The points of the relief's middle lie at z = 2 - 1.6 = 0.4 in its coordinates, those of depth 64
/// at 2 - (2.4 - 63 / 254 * 0.8).
TEST_F(MixedScene, TheReliefStandsOutByItsDepths) {
  double nearest = -9, farthest = 9;
  for (const glm::dvec3& centre : scene_.surfels[0].surfels->centres) {
    nearest = std::max(nearest, centre.z);
    farthest = std::min(farthest, centre.z);
  }
  EXPECT_NEAR(nearest, 0.4, 1e-6);
  EXPECT_NEAR(farthest, -0.4 + 63.0 / 254 * 0.8, 1e-6);
}

TEST_F(MixedScene, HasNineShapesWithoutAViewer) {
  ASSERT_EQ(scene_.shapes.size(), 9U);
  EXPECT_EQ(primitives(0), 32U);  // floor: 4 x 4 cells
  expect_near(place(0), {-4, -1, -4});
  expect_near(place(1), {-1.8, 0.1, -1.2});  // cone
  EXPECT_EQ(primitives(2), 12U);             // box
  EXPECT_FLOAT_EQ(scene_.shapes[2].look->transparency, 0.3F);
  EXPECT_NEAR(scene_.shapes[2].to_world[0][0], std::cos(0.4), 1e-6);
  expect_near(place(3), {1.5, 0.1, -0.2});  // sphere
  EXPECT_EQ(scene_.shapes[3].look->diffuse, scene_.shapes[1].look->diffuse);
  EXPECT_EQ(scene_.shapes[4].geometry->kind, Kind::lines);
  EXPECT_EQ(primitives(4), 12U);  // the edges of a box
  EXPECT_EQ(primitives(5), 4U);   // roof
  ASSERT_NE(scene_.shapes[5].look->texture, nullptr);
  EXPECT_FALSE(scene_.shapes[5].geometry->solid);
  EXPECT_EQ(scene_.shapes[6].geometry->kind, Kind::points);
  EXPECT_EQ(primitives(6), 5U);
  EXPECT_EQ(scene_.shapes[6].geometry->colours.size(), 5U);
  expect_near(place(7), {0, -0.6, 1.4});  // cylinder
  EXPECT_EQ(primitives(8), 2U);           // sign; the LOD shows the ball
  EXPECT_FALSE(scene_.shapes[8].look->lit);
}

TEST_F(MixedScene, ItsLightsFallOnEverything) {
  ASSERT_EQ(scene_.lights.size(), 2U);
  EXPECT_EQ(scene_.lights[0].kind, Light::Kind::directional);
  EXPECT_EQ(scene_.lights[1].kind, Light::Kind::point);
  EXPECT_EQ(scene_.lights[1].radius, 6);
  for (const Shape& shape : scene_.shapes) EXPECT_EQ(shape.lights, (std::vector<uint32_t>{0, 1}));
  EXPECT_FALSE(scene_.headlight);
}

TEST_F(MixedScene, HasSkyGroundAndFog) {
  ASSERT_TRUE(scene_.backdrop.has_value());
  EXPECT_EQ(scene_.backdrop->sky_colours.size(), 3U);
  EXPECT_EQ(scene_.backdrop->ground_colours.size(), 2U);
  ASSERT_TRUE(scene_.fog.has_value());
  EXPECT_FALSE(scene_.fog->exponential);
  EXPECT_EQ(scene_.fog->visibility_range, 40);
}

TEST_F(MixedScene, HasTwoViewpoints) {
  ASSERT_EQ(visual_.viewpoints.size(), 2U);
  EXPECT_EQ(visual_.viewpoints[0].name, "FRONT");
  expect_near(visual_.viewpoints[0].position, {0, 0.6, 9});
  expect_near(visual_.viewpoints[1].position, {0, 7, 0});
  expect_near(visual_.viewpoints[1].orientation * glm::dvec3(0, 0, -1), {0, -1, 0});
}

/// From the first viewpoint the LOD at (2.6, -0.7, 1.6) is 8 units away, and the sign at (-3, -0.3,
/// 0.6) turns towards (0, *, 9): by the angle whose tangent is 3 / 8.4.
TEST_F(MixedScene, AViewerSeesTheBoxInsteadOfTheBallAndTheSignTurned) {
  const auto known = scene_.voxels[0].tree;
  read(nodes::Viewer{visual_.viewpoints[0].position, {0, 1, 0}});
  EXPECT_TRUE(visual_.depends_on_viewer);
  EXPECT_EQ(visual_.models.size(), 4U);
  ASSERT_EQ(scene_.voxels.size(), 1U);
  EXPECT_EQ(scene_.voxels[0].tree, known);
  ASSERT_EQ(scene_.shapes.size(), 10U);
  expect_near(place(8), {2.6, -0.7, 1.6});
  EXPECT_EQ(primitives(8), 12U);
  const double length = std::hypot(3, 8.4);
  expect_near(glm::dvec3(scene_.shapes[9].to_world[2]), {3 / length, 0, 8.4 / length});
  expect_near(glm::dvec3(visual_.models[3].to_world[3]),
              glm::dvec3(-3, -0.3, 0.6) + 0.1 * glm::dvec3(3, 0, 8.4) / length);
  read(nodes::Viewer{{2.6, 0, 5}, {0, 1, 0}});  // within 6 units
  EXPECT_EQ(scene_.voxels.size(), 2U);
}

TEST_F(MixedScene, ItsPicturesHaveSevenCameras) {
  const std::vector<ModelCamera> cameras = model_cameras(visual_.models);
  // Two of the ball, the relief's, the layers', the ball's again, the relief's again.
  ASSERT_EQ(cameras.size(), 7U);
  EXPECT_EQ(cameras[1].kind, ModelCamera::Kind::reference_image);
  expect_near(cameras[1].camera.position, {0, 0, -10});
  EXPECT_FALSE(cameras[3].camera.orthographic);
  EXPECT_NEAR(cameras[3].camera.far_plane, 3.4, 1e-6);
  EXPECT_EQ(cameras[6].model, 4U);
}

/// From the front, along z: the cone is behind the ball, the box before it; the sphere's front is
/// before the relief that it stands in.
TEST_F(MixedScene, ModelsStandBeforeAndBehindGeometry) {
  const double ball_front = 0.8, ball_back = -0.8;
  EXPECT_LT(place(1).z, ball_back);
  EXPECT_GT(place(2).z, ball_front);
  const double relief_front = -0.4 + 0.4;
  EXPECT_GT(place(3).z + 0.4, relief_front);
  EXPECT_LT(place(3).z - 0.4, relief_front);
}

}  // namespace
}  // namespace afx::render
