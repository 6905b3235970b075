// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/software/piece.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "render/software/piece_samples.h"
#include "render/test_shapes.h"

namespace afx::render {
namespace {

const RenderOptions kOptions{.width = 64, .height = 64, .samples = 1};

/// One primitive as a camera in the origin, 90 degrees wide, sees it: 32 samples a unit of slope.
struct Seen {
  explicit Seen(Geometry geometry)
      : shape(shape_of(std::move(geometry), {})),
        lens({.position = {0, 0, 0}, .field_of_view = std::acos(0.0), .near_plane = 0.5}, kOptions),
        view(shape, lens, {}) {
    view.corners.resize(view.geometry->positions.size());
    view.place_corners(0, view.corners.size());
    made = make_piece(view, 0, lens, 1, piece);
  }

  Shape shape;
  Lens lens;
  ShapeView view;
  Piece piece{};
  bool made = false;
};

Geometry triangle(glm::vec3 a, glm::vec3 b, glm::vec3 c) {
  return {.positions = {a, b, c},
          .normals = std::vector<glm::vec3>(3, glm::vec3(0, 0, 1)),
          .indices = {0, 1, 2}};
}

std::set<size_t> covered_by(const Piece& piece) {
  TileSamples tile(TileGrid(kOptions), kOptions);
  tile.clear(0, 0);
  std::set<size_t> samples;
  for_covered(piece, tile, [&](size_t at, LaneMask covered, Lanes) {
    for (size_t k = 0; k < kLanes; ++k)
      if (covered[static_cast<int>(k)] != 0) samples.insert(at + k);
  });
  return samples;
}

TEST(Piece, CornersCountInPerspective) {
  // On the screen the middle between the corners at depths 1 and 3; in space a quarter of the way,
  // since 1 / depth is (1 + 1/3) / 2 = 1 / 1.5.
  const Seen seen(triangle({-1, 0, -1}, {3, 0, -3}, {0, 1, -1}));
  ASSERT_TRUE(seen.made);
  const glm::dvec3 parts = corner_parts(seen.piece, Geometry::Kind::triangles, 32, 32);
  EXPECT_NEAR(parts.x, 0.75, 1e-12);
  EXPECT_NEAR(parts.y, 0.25, 1e-12);
  EXPECT_NEAR(parts.z, 0, 1e-12);
  EXPECT_NEAR(value_at(seen.piece.depth, 32, 32), 1 / 1.5, 1e-12);
}

TEST(Piece, ALinesEndsCountInPerspectiveAlsoWhenCutOff) {
  Geometry line{.kind = Geometry::Kind::lines};
  line.positions = {{-1, 0, -1}, {3, 0, -3}};
  line.indices = {0, 1};
  const Seen whole(line);
  ASSERT_TRUE(whole.made);
  EXPECT_NEAR(corner_parts(whole.piece, Geometry::Kind::lines, 32, 32).y, 0.25, 1e-12);
  // From behind the eye: depth 1, two thirds of the way, is seen at slope 1.
  line.positions = {{1, 0, 1}, {1, 0, -2}};
  const Seen cut(line);
  ASSERT_TRUE(cut.made);
  EXPECT_NEAR(corner_parts(cut.piece, Geometry::Kind::lines, 64, 32).y, 2.0 / 3, 1e-12);
}

TEST(Piece, WhatCannotBeSeenIsNotMade) {
  EXPECT_TRUE(Seen(triangle({0, 0, -1}, {1, 0, -1}, {0, 1, -1})).made);
  EXPECT_FALSE(Seen(triangle({0, 0, -1}, {0, 1, -1}, {1, 0, -1})).made);           // from behind
  EXPECT_FALSE(Seen(triangle({0, 0, 1}, {1, 0, 1}, {0, 1, 1})).made);              // behind the eye
  EXPECT_FALSE(Seen(triangle({0, 0, -0.4F}, {1, 0, -0.4F}, {0, 1, -0.4F})).made);  // too near
  EXPECT_FALSE(Seen(triangle({2, 0, -1}, {3, 0, -1}, {2, 1, -1})).made);           // to the right
  EXPECT_FALSE(Seen(triangle({0, 0, -1}, {0, 0, -2}, {1, 0, -1.5F})).made);        // edge-on
  EXPECT_FALSE(Seen(triangle({0, 0, -1}, {0, 0, -1}, {1, 0, -1})).made);           // no area
}

TEST(Piece, SamplesOnASharedEdgeBelongToOneTriangle) {
  // The diagonal runs through the centres of samples.
  const Seen upper(triangle({-0.5F, -0.5F, -1}, {0.5F, 0.5F, -1}, {-0.5F, 0.5F, -1}));
  const Seen lower(triangle({-0.5F, -0.5F, -1}, {0.5F, -0.5F, -1}, {0.5F, 0.5F, -1}));
  const std::set<size_t> one = covered_by(upper.piece), other = covered_by(lower.piece);
  std::set<size_t> both = one;
  both.insert(other.begin(), other.end());
  EXPECT_EQ(one.size() + other.size(), 32U * 32);
  EXPECT_EQ(both.size(), 32U * 32);
}

TEST(Piece, ATriangleThatReachesBehindTheEyeCoversItsConeOnly) {
  // A floor under the eye, from one unit behind it to three before it: seen below slope -1 / 3, as
  // wide as the picture, which ends at slope -1; the near plane, at 1 / 2, lies lower.
  const Seen seen(triangle({-100, -1, 1}, {100, -1, 1}, {0, -1, -3}));
  ASSERT_TRUE(seen.made);
  const std::set<size_t> samples = covered_by(seen.piece);
  for (size_t y = 0; y < 64; ++y) {
    const double slope = (32 - (static_cast<double>(y) + 0.5)) / 32;
    const bool expected = slope < -1.0 / 3;
    EXPECT_EQ(samples.count(y * TileGrid(kOptions).side + 31), expected ? 1U : 0U) << y;
  }
}

}  // namespace
}  // namespace afx::render
