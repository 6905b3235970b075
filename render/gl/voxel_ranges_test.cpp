// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Which nodes go to the graphics system. The expectations are those of the octree's own walk.
#include "render/gl/voxel_ranges.h"

#include <gtest/gtest.h>

#include <numeric>

#include "render/test_scenes.h"

namespace afx::render {
namespace {

/// A full cube of voxels: level n has 8^n nodes.
TestModel full_cube(unsigned level) {
  TestModelMaker maker(level);
  const uint32_t side = 1U << level;
  for (uint32_t i = 0; i < side * side * side; ++i)
    maker.add({i % side, i / side % side, i / side / side}, kRed);
  return maker.make();
}

/// The runs of one cloud for one camera, in a picture of 100 x 100 pixels of one sample.
struct Looked {
  Looked(const TestModel& model, const Camera& camera, double coarseness, double most_point)
      : cloud(model.cloud()),
        options{.width = 100, .height = 100, .coarseness = coarseness, .samples = 1},
        lens(camera, options),
        octree(cloud, lens, options),
        view(lens, options, 100, static_cast<float>(most_point)) {
    view.set_tile({0, 0, 100, 100});
  }
  [[nodiscard]] VoxelRanges ranges() const { return {octree, view}; }

  VoxelCloud cloud;
  RenderOptions options;
  Lens lens;
  OctreeView octree;
  GlView view;
};

int count(const NodeRuns& runs) { return std::accumulate(runs.count.begin(), runs.count.end(), 0); }

TEST(VoxelRanges, FromNearAreAllVoxelsInOneRun) {
  const TestModel model = full_cube(5);
  const Looked looked(model, looking_at_origin({0, 0, 1}, 3), 0, 50);
  const VoxelRanges ranges = looked.ranges();
  for (unsigned level = 0; level < 5; ++level) EXPECT_EQ(count(ranges.points(level)), 0) << level;
  EXPECT_EQ(ranges.points(5).first, std::vector<int32_t>{0});
  EXPECT_EQ(ranges.points(5).count, std::vector<int32_t>{32 * 32 * 32});
  EXPECT_EQ(count(ranges.quads(5)), 0);
}

// 100 samples over 64 units: the nodes of level 0 are 1.6 samples wide, those of level 1 less than
// one.
TEST(VoxelRanges, FromAfarAreFewNodes) {
  const TestModel model = full_cube(5);
  Camera camera = looking_at_origin({0, 0, 1}, 200);
  camera.projection = Projection::orthographic;
  camera.view_height = 64;
  const VoxelRanges ranges = Looked(model, camera, 1, 50).ranges();
  EXPECT_EQ(ranges.points(1).count, std::vector<int32_t>{8});
  for (const unsigned level : {0U, 2U, 3U, 4U, 5U}) EXPECT_EQ(count(ranges.points(level)), 0);
}

TEST(VoxelRanges, WhatLiesBehindOrBesideIsPassedOver) {
  const TestModel model = full_cube(5);
  Camera camera = looking_at_origin({0, 0, 1}, 3);
  camera.orientation = glm::dquat(0, 0, 1, 0);  // looks away
  EXPECT_EQ(count(Looked(model, camera, 0, 50).ranges().points(5)), 0);
  camera = looking_at_origin({0, 0, 1}, 3);
  camera.position.x += 0.5 + 3 * std::tan(0.3);  // the cube's left half and some voxels
  const int seen = count(Looked(model, camera, 0, 50).ranges().points(5));
  EXPECT_GT(seen, 0);
  EXPECT_LT(seen, 32 * 32 * 20);
}

TEST(VoxelRanges, OnlyWhatMayBeLargeIsDrawnAsQuadrilaterals) {
  const TestModel model = full_cube(5);
  // A voxel 1/2 before the eye is (100 / 2 / tan 0.3) / 16 = 10 samples wide, one behind 3.
  const Camera camera = looking_at_origin({0, 0, 1}, 1);
  const VoxelRanges none = Looked(model, camera, 0, 50).ranges();
  EXPECT_EQ(count(none.quads(5)), 0);
  const VoxelRanges some = Looked(model, camera, 0, 8).ranges();
  EXPECT_GT(count(some.quads(5)), 32 * 32);
  EXPECT_LT(count(some.quads(5)), count(some.points(5)));
}

TEST(VoxelRanges, RunsThatMeetBecomeOne) {
  NodeRuns runs;
  runs.add(3, 3);
  runs.add(3, 7);
  runs.add(7, 8);
  runs.add(9, 10);
  EXPECT_EQ(runs.first, (std::vector<int32_t>{3, 9}));
  EXPECT_EQ(runs.count, (std::vector<int32_t>{5, 1}));
}

}  // namespace
}  // namespace afx::render
