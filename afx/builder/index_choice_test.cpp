// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/index_choice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <random>

namespace afx {
namespace {

// The symbols that an assignment takes, and the least total, by trying every assignment: the other
// way to find what dynamic programming finds.
double total(const std::vector<uint64_t>& codes, unsigned levels,
             const std::vector<uint8_t>& images, const std::vector<std::vector<double>>& costs) {
  double sum = 0;
  for (size_t i = 0; i < codes.size(); ++i) sum += costs[i][images[i] - 1U];
  // A symbol for each node whose parent's subtree is not of one image.
  std::map<std::pair<unsigned, uint64_t>, bool> uniform;
  for (unsigned level = 0; level <= levels; ++level)
    for (size_t i = 0; i < codes.size(); ++i) {
      const uint64_t node = codes[i] >> (3 * (levels - level));
      const auto first = static_cast<size_t>(
          std::find_if(codes.begin(), codes.end(),
                       [&](uint64_t c) { return c >> (3 * (levels - level)) == node; }) -
          codes.begin());
      const auto [at, is_new] = uniform.try_emplace({level, node}, true);
      at->second = at->second && images[i] == images[first];
    }
  for (const auto& [key, ignored] : uniform)
    if (key.first == 0 || !uniform.at({key.first - 1, key.second >> 3})) sum += kSymbolPrice;
  return sum;
}

TEST(ChooseIndex, FindsTheLeastTotal) {
  std::mt19937 random(3);
  for (int round = 0; round < 300; ++round) {
    constexpr unsigned kLevels = 2, kImages = 2;
    std::vector<uint64_t> codes;
    for (uint64_t code = 0; code < 64 && codes.size() < 9; ++code)
      if (random() % 6 == 0) codes.push_back(code);
    if (codes.empty()) continue;
    std::vector<std::vector<double>> costs(codes.size(), std::vector<double>(kImages));
    for (auto& c : costs)
      for (double& cost : c) cost = static_cast<double>(random() % 100);
    const std::vector<uint8_t> chosen = choose_index(
        codes, kLevels, kImages,
        [&](size_t i, std::span<double> of) {
          std::copy(costs[i].begin(), costs[i].end(), of.begin());
        },
        kSymbolPrice);
    double least = std::numeric_limits<double>::max();
    for (unsigned bits = 0; bits < 1U << codes.size(); ++bits) {
      std::vector<uint8_t> images;
      for (size_t i = 0; i < codes.size(); ++i)
        images.push_back(static_cast<uint8_t>(1 + (bits >> i & 1)));
      least = std::min(least, total(codes, kLevels, images, costs));
    }
    EXPECT_DOUBLE_EQ(total(codes, kLevels, chosen, costs), least) << round;
  }
}

void all_equal(size_t, std::span<double> costs) { std::fill(costs.begin(), costs.end(), 1.0); }

TEST(ChooseIndex, GivesTheWholeModelToOneImageWhereAllAreEqual) {
  const std::vector<uint64_t> codes{0, 7, 100, 511};
  const auto chosen = choose_index(codes, 3, 200, all_equal, kSymbolPrice);
  EXPECT_EQ(chosen, (std::vector<uint8_t>{1, 1, 1, 1}));
}

TEST(ChooseIndex, NeverTakesAnImageThatIsBadlyWrong) {
  // Voxel 5 of 64 is right only in image 3, all others in image 1.
  std::vector<uint64_t> codes(64);
  for (uint64_t i = 0; i < 64; ++i) codes[i] = i;
  const auto chosen = choose_index(
      codes, 2, 3,
      [](size_t i, std::span<double> costs) {
        costs[0] = i == 5 ? 1e5 : 0;
        costs[1] = 1e5;
        costs[2] = i == 5 ? 0 : 1e5;
      },
      kSymbolPrice);
  for (size_t i = 0; i < 64; ++i) EXPECT_EQ(chosen[i], i == 5 ? 3 : 1);
}

TEST(ChooseIndex, WithoutPriceGivesEachVoxelItsBest) {
  std::vector<uint64_t> codes(64);
  for (uint64_t i = 0; i < 64; ++i) codes[i] = i * 5;
  const auto chosen = choose_index(
      codes, 3, 127,
      [](size_t i, std::span<double> costs) {
        std::fill(costs.begin(), costs.end(), 1e-3);
        costs[2 * i] = 0;
      },
      0);
  for (size_t i = 0; i < 64; ++i) EXPECT_EQ(chosen[i], 2 * i + 1);
}

TEST(ChooseIndex, TakesOneVoxelAndNone) {
  const std::vector<uint64_t> one{0};
  EXPECT_EQ(choose_index(one, 0, 1, all_equal, kSymbolPrice), (std::vector<uint8_t>{1}));
  EXPECT_TRUE(choose_index({}, 4, 6, all_equal, kSymbolPrice).empty());
}

}  // namespace
}  // namespace afx
