// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "conformance/generator/shrink.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "conformance/generator/random_octree.h"

namespace afx::conformance {
namespace {

using Draws = std::vector<uint32_t>;

TEST(Choices, AreTheSameForASeedAndNumberAndOthersForOthers) {
  const auto draws = [](uint64_t seed, uint64_t number) {
    Choices choices(seed, number);
    for (int i = 0; i < 20; ++i) (void)choices.below(1000000);
    return choices.draws();
  };
  EXPECT_EQ(draws(3, 7), draws(3, 7));
  EXPECT_NE(draws(3, 7), draws(3, 8));
  EXPECT_NE(draws(3, 7), draws(7, 3));
}

TEST(Choices, StayBelowAndReachAll) {
  Choices choices(1, 1);
  std::vector<int> found(5);
  for (int i = 0; i < 1000; ++i) ++found.at(choices.below(5));
  for (const int times : found) EXPECT_GT(times, 120);
}

TEST(Choices, PlayedAreTakenModuloAndThenAreZero) {
  Choices choices(Draws{7, 2});
  EXPECT_EQ(choices.below(5), 2U);
  EXPECT_EQ(choices.below(5), 2U);
  EXPECT_EQ(choices.below(5), 0U);
  EXPECT_EQ(choices.draws(), (Draws{2, 2}));
}

TEST(Choices, PlayedAgainMakeTheSameCase) {
  for (uint64_t number = 0; number < 200; ++number) {
    Choices made(5, number);
    const OctreeStream stream = random_octree(made);
    Choices played(made.draws());
    const OctreeStream again = random_octree(played);
    EXPECT_EQ(again.resolution, stream.resolution);
    EXPECT_EQ(again.textures, stream.textures);
    EXPECT_EQ(again.frames, stream.frames);
    EXPECT_EQ(played.draws(), made.draws());
  }
}

/// A list of numbers below 1000, as a generator makes one.
Draws random_list(Choices& choices) {
  Draws list;
  while (choices.below(30) != 0) list.push_back(choices.below(1000));
  return list;
}

TEST(Shrink, FindsTheLeastElementThatMatters) {
  const Fails fails = [](Choices& choices) {
    const Draws list = random_list(choices);
    return std::any_of(list.begin(), list.end(), [](uint32_t x) { return x >= 321; });
  };
  Choices choices(1, 2);
  ASSERT_TRUE(fails(choices));
  EXPECT_EQ(shrink(choices.draws(), fails), (Draws{1, 321}));
}

TEST(Shrink, FindsTheLeastCountWithItsElements) {
  const Fails fails = [](Choices& choices) {
    int large = 0;
    for (uint32_t left = choices.below(40); left > 0; --left) large += choices.below(10) >= 5;
    return large >= 2;
  };
  Choices choices(1, 0);
  ASSERT_TRUE(fails(choices));
  EXPECT_EQ(shrink(choices.draws(), fails), (Draws{2, 5, 5}));
}

TEST(Shrink, EndsAfterTheTriesItMayTake) {
  unsigned tries = 0;
  const Fails fails = [&](Choices& choices) {
    ++tries;
    return choices.below(9) > 9;
  };
  shrink(Draws(100, 5), fails, 10);
  EXPECT_EQ(tries, 10U);
}

TEST(Shrink, OfAnOctreeLeavesTheSymbolThatMatters) {
  const auto is_full = [](const OctreeStream& stream) {
    return std::any_of(stream.frames.begin(), stream.frames.end(), [](const OctreeFields& frame) {
      return std::find(frame.octree.begin(), frame.octree.end(), 0xFF) != frame.octree.end();
    });
  };
  const Fails fails = [&](Choices& choices) { return is_full(random_octree(choices)); };
  int found = 0;
  for (uint64_t number = 0; found < 20; ++number) {
    Choices choices(1, number);
    if (!fails(choices)) continue;
    ++found;
    Choices smallest(shrink(choices.draws(), fails));
    const OctreeStream stream = random_octree(smallest);
    EXPECT_EQ(stream.resolution, 2U);
    EXPECT_EQ(stream.textures, 0U);
    EXPECT_EQ(stream.frames, (std::vector<OctreeFields>{{{0xFF}, {}}}));
  }
}

}  // namespace
}  // namespace afx::conformance
