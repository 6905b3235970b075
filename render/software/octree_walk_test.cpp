// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What the walk passes over cannot be seen: held against drawing every node of the last level.
#include "render/software/octree_walk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <random>

#include "render/software/frame.h"
#include "render/software/splat_painter.h"
#include "render/test_scenes.h"

namespace afx::render {
namespace {

/// All discs of a tree in the order of the walk, whether they can be seen or not.
class PlainWalk {
 public:
  PlainWalk(const OctreeView& view, const TileSamples& tile, const glm::dvec3& ray)
      : view_(view), tile_(tile), nearest_(view.nearest_child(ray)) {
    visit(0, 0, view.root());
  }
  std::vector<TileDisc> discs;

 private:
  void visit(unsigned level, uint32_t number, const glm::dvec3& centre) {
    const VoxelTree::Branch branch = view_.tree().branches(level)[number];
    const bool last = view_.is_last(level + 1, centre);
    EightDiscs eight;
    EightRectangles boxes;
    view_.project(centre, branch, level + 1, eight);
    SplatPainter::plain().place(eight, tile_, boxes);
    const OctreeView::SideWeights weights = view_.side_weights(centre);
    for (unsigned k = 0; k < 8; ++k) {
      const unsigned i = nearest_ ^ k;
      if ((branch.symbol >> i & 1U) == 0) continue;
      const unsigned before = branch.symbol & ((1U << i) - 1);
      const uint32_t child = branch.first_child + static_cast<uint32_t>(std::popcount(before));
      const OctreeView::Size& size = view_.size(level + 1);
      if (!last) {
        visit(level + 1, child, centre + size.offsets[i]);
      } else if (eight.reach_x[i] > 0) {
        discs.push_back(
            {view_.splat(eight, i, level + 1), OctreeView::tilt(eight, i), boxes.at(i)});
        discs.back().splat.light = view_.light(level + 1, child, weights);
      }
    }
  }

  const OctreeView& view_;
  const TileSamples& tile_;
  unsigned nearest_;
};

/// The same for the whole tile: a copy of the ray that the walk takes for its order.
glm::dvec3 ray_of(const Frame& frame, const TileSamples& tile) {
  if (!frame.lens.perspective) return {0, 0, -1};
  const double half = static_cast<double>(tile.side) / 2;
  return {(static_cast<double>(tile.left) + half - frame.lens.middle.x) / frame.lens.focal,
          (frame.lens.middle.y - static_cast<double>(tile.top) - half) / frame.lens.focal, -1};
}

void expect_equal(const std::vector<float>& a, const std::vector<float>& b, uint32_t tile) {
  const auto [at, other] = std::mismatch(a.begin(), a.end(), b.begin());
  if (at == a.end()) return;
  ADD_FAILURE() << "sample " << at - a.begin() << " of tile " << tile << ": " << *at << " and "
                << *other;
}

struct Counts {
  size_t all = 0, walked = 0;
};

/// Draws every tile in both ways and expects the same sums, bit for bit.
Counts expect_equal(const Scene& scene, const Camera& camera, const RenderOptions& options) {
  const MipPictures pictures;
  const Frame frame(scene, pictures, camera, options);
  TileSamples walked(frame.grid, options), plain(frame.grid, options);
  OctreeWalk walk;
  Counts counts;
  for (uint32_t tile = 0; tile < frame.grid.columns * frame.grid.rows; ++tile) {
    std::vector<TileDisc> all, seen;
    walked.clear(tile % frame.grid.columns, tile / frame.grid.columns);
    plain.clear(tile % frame.grid.columns, tile / frame.grid.columns);
    for (const OctreeView& view : frame.octrees) {
      for (const TileDisc& d : PlainWalk(view, plain, ray_of(frame, plain)).discs) all.push_back(d);
      walk.run(view, walked, seen);
    }
    const SplatPainter& painter = SplatPainter::plain();
    for (const TileDisc& disc : all) painter.lay_disc_depth(disc, plain);
    for (const TileDisc& disc : all) painter.lay_disc_colour(disc, plain);
    for (const TileDisc& disc : seen) SplatPainter::best().lay_disc_colour(disc, walked);
    expect_equal(walked.depths, plain.depths, tile);
    expect_equal(walked.sum_weight, plain.sum_weight, tile);
    expect_equal(walked.sum_r, plain.sum_r, tile);
    expect_equal(walked.sum_g, plain.sum_g, tile);
    expect_equal(walked.sum_b, plain.sum_b, tile);
    counts.all += all.size();
    counts.walked += seen.size();
  }
  return counts;
}

TestModel two_spheres(unsigned level) {
  TestModelMaker maker(level);
  std::minstd_rand random(1);
  add_sphere(maker, level, 0.45, kRed);
  add_sphere(maker, level, 0.3, kBlue);
  TestModel model = maker.make();
  for (Rgba8& colour : model.colours) colour.g = static_cast<uint8_t>(random() & 0xff);
  return model;
}

TEST(OctreeWalk, WhatIsPassedOverCannotBeSeen) {
  const Scene scene = two_spheres(6).scene();
  for (const glm::dvec3& direction : directions(6)) {
    for (const double distance : {0.2, 0.47, 0.9, 3.0, 40.0}) {
      for (const unsigned samples : {1U, 3U}) {
        Camera camera = looking_at_origin(direction, distance);
        const RenderOptions options{.width = 130, .height = 97, .samples = samples};
        expect_equal(scene, camera, options);
        camera.projection = Projection::orthographic;
        camera.view_height = distance;
        expect_equal(scene, camera, options);
      }
    }
  }
}

TEST(OctreeWalk, TiltedDiscsThatArePassedOverCannotBeSeen) {
  const TestModel model = two_spheres(5);
  const Scene scene{.voxels = {model.smooth_cloud()}};
  for (const glm::dvec3& direction : directions(3)) {
    for (const double distance : {0.2, 0.47, 0.9, 3.0, 40.0}) {
      RenderOptions options{.width = 70, .height = 47, .samples = 1};
      for (const double scale : {1.0, 8.0}) {
        for (const double coarseness : {0.0, 1.4}) {
          options.splat_scale = scale, options.coarseness = coarseness;
          SCOPED_TRACE(testing::Message() << distance << " " << scale << " " << coarseness);
          Camera camera = looking_at_origin(direction, distance);
          expect_equal(scene, camera, options);
          camera.field_of_view = 2.5;
          expect_equal(scene, camera, options);
          camera.projection = Projection::orthographic;
          camera.view_height = distance;
          expect_equal(scene, camera, options);
        }
      }
    }
  }
}

TEST(OctreeWalk, CloudsHideEachOtherAndStretchedOnesToo) {
  const TestModel model = two_spheres(5);
  Scene scene;
  scene.voxels = {model.cloud(), model.cloud(), model.cloud()};
  scene.voxels[1].local_to_world[3] = {0.3, 0.1, 0.5, 1};
  scene.voxels[2].local_to_world[0] = {3, 0.5, 0, 0};
  scene.voxels[2].local_to_world[1] = {-0.2, 0.1, 0.7, 0};
  for (const glm::dvec3& direction : directions(5)) {
    for (const SplatKind kind : {SplatKind::smooth, SplatKind::flat, SplatKind::points}) {
      const RenderOptions options{.width = 150, .height = 90, .splats = kind, .samples = 2};
      expect_equal(scene, looking_at_origin(direction, 2.5), options);
    }
  }
}

TEST(OctreeWalk, MostOfWhatIsHiddenIsNotLookedAt) {
  TestModelMaker maker(5);  // a solid cube
  for (uint32_t k = 0; k < 32 * 32 * 32; ++k) maker.add({k % 32, k / 32 % 32, k / 1024}, kRed);
  const Scene scene = maker.make().scene();
  Camera camera = looking_at_origin({0, 0, 1}, 2);
  camera.projection = Projection::orthographic;
  camera.view_height = 1.2;
  const Counts counts =
      expect_equal(scene, camera, {.width = 64, .height = 64, .samples = 1, .threads = 1});
  EXPECT_EQ(counts.all, 32U * 32 * 32);
  EXPECT_LT(counts.walked, 32U * 32 * 8);  // the first layers of 32
}

}  // namespace
}  // namespace afx::render
