// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/image_candidates.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace afx {
namespace {

constexpr Rgba8 kRed{255, 0, 0, 255}, kBlue{0, 0, 255, 255};

// Two voxels behind each other, seen from the front: the blue one hides the red one.
ImageCandidate weighed(ImageCandidate candidate, std::vector<uint8_t> exposed) {
  const std::vector<Voxel> coordinates{{1, 2, 0}, {1, 2, 3}};
  const std::vector<Rgba8> colours{kRed, kBlue};
  const std::vector<glm::vec3> normals{{0, 0, -1}, {0, 0, 1}};
  weigh(candidate, {coordinates, colours, normals, exposed, 2});
  return candidate;
}

TEST(ImageCandidates, KnowWhatEachVoxelWouldGet) {
  const ImageCandidate front = weighed({0, side_camera(0, 4)}, {1, 1});
  EXPECT_EQ(front.seen, (std::vector<bool>{false, true}));
  EXPECT_EQ(front.squared, (std::vector<uint16_t>{65535, 0}));
  EXPECT_GT(front.cost(0), 1e6);
  EXPECT_LT(front.cost(1), 1e-6);
  // For a voxel that nobody sees it matters less, but matters.
  const ImageCandidate hidden = weighed({0, side_camera(0, 4)}, {0, 1});
  EXPECT_NEAR(hidden.cost(0) * 64 / front.cost(0), 1, 0.02);
  // An image from elsewhere costs more where both show the same.
  const ImageCandidate slanting = weighed({6, side_camera(0, 4)}, {1, 1});
  EXPECT_GT(slanting.cost(1), 10);
}

TEST(ImageCandidates, PreferTheImageThatTheSurfaceFaces) {
  const std::vector<Voxel> coordinates{{1, 1, 1}};
  const std::vector<Rgba8> colours{kRed};
  const std::vector<glm::vec3> normals{{0.8F, 0, 0.6F}};
  const std::vector<uint8_t> exposed{1};
  double before = -1;
  for (const unsigned view : {2U, 0U, 4U, 1U, 3U}) {  // right, front, top, back, left
    ImageCandidate candidate{view, side_camera(view, 4)};
    weigh(candidate, {coordinates, colours, normals, exposed, 2});
    EXPECT_GT(candidate.cost(0), before);
    before = candidate.cost(0);
  }
}

// Candidates that are told what they show: [view][voxel].
std::vector<ImageCandidate> told(const std::vector<std::vector<uint16_t>>& squared, double worth) {
  std::vector<ImageCandidate> candidates;
  for (const auto& of_view : squared) {
    ImageCandidate candidate{static_cast<unsigned>(candidates.size()), {}, worth};
    candidate.squared = of_view;
    candidates.push_back(candidate);
  }
  return candidates;
}

TEST(DropDearImages, KeepsOneOfTwoThatShowTheSame) {
  auto candidates = told({{900}, {900}, {900}, {900}, {900}, {900}, {10}, {10}, {800}}, 500);
  drop_dear_images(candidates, std::vector<uint8_t>{1});
  ASSERT_EQ(candidates.size(), 7U);  // the sides are never dropped
  EXPECT_EQ(candidates[6].view, 7U);
}

TEST(DropDearImages, CountsWhatAllExposedVoxelsGain) {
  const std::vector<uint16_t> bad(5, 200), good(5, 0);
  auto kept = told({bad, bad, bad, bad, bad, bad, good}, 900);
  auto dropped = kept;
  drop_dear_images(kept, std::vector<uint8_t>(5, 1));
  EXPECT_EQ(kept.size(), 7U);
  drop_dear_images(dropped, std::vector<uint8_t>{1, 1, 0, 1, 1});
  EXPECT_EQ(dropped.size(), 6U);
}

TEST(LeastDifference, IsTheMeanOfTheBestImages) {
  const auto candidates = told({{3, 10, 7}, {9, 4, 7}}, 0);
  EXPECT_EQ(least_difference(candidates, std::vector<uint8_t>{1, 1, 0}), 3.5);
  EXPECT_EQ(least_difference(candidates, std::vector<uint8_t>{0, 0, 1}), 7);
}

}  // namespace
}  // namespace afx
