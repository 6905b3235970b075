// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "codec/octree_symmetry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace afx::codec {
namespace {

TEST(Symmetries, AreFortyEightDifferentOnesThatKeepTheCubesEdges) {
  std::set<std::array<uint8_t, 8>> seen(kSymmetryNumbering.begin(), kSymmetryNumbering.end());
  EXPECT_EQ(seen.size(), 48U);
  for (const auto& position : kSymmetryNumbering) {
    for (unsigned a = 0; a < 8; ++a) {
      for (unsigned b = 0; b < 8; ++b) {
        EXPECT_EQ(std::popcount(a ^ b), std::popcount(unsigned(position[a] ^ position[b])));
      }
    }
  }
}

TEST(Symmetries, FollowTheRuleOfTheNumbering) {
  // t = 6 * 5 + 3: permutation (2, 0, 1), flips of x and z. Child 1 = (1, 0, 0) goes to (z, x, y) =
  // (0, 1, 0), then to (1, 1, 1) = 7.
  EXPECT_EQ(kSymmetryNumbering[33][1], 7);
  EXPECT_EQ(kSymmetryNumbering[0], (std::array<uint8_t, 8>{0, 1, 2, 3, 4, 5, 6, 7}));
}

TEST(Symmetries, InverseMapsUndoTheMaps) {
  for (unsigned t = 0; t <= kSymmetries; ++t) {
    for (unsigned s = 0; s < 256; ++s) {
      EXPECT_EQ(kSymbolMaps.inverse[t][kSymbolMaps.forward[t][s]], s);
      EXPECT_EQ(std::popcount(unsigned(kSymbolMaps.forward[t][s])), std::popcount(s));
    }
  }
}

// By Polya's count the cube's corners coloured with k of 8 black fall, under all 48 symmetries,
// into 1 1 3 3 6 3 3 1 1 classes.
TEST(Classes, HaveTheNumbersThatPolyaCounts) {
  std::map<int, std::set<int>> classes;
  for (unsigned s = 0; s < 256; ++s) classes[std::popcount(s)].insert(kSymbolClasses.number[s]);
  const int expected[9] = {1, 1, 3, 3, 6, 3, 3, 1, 1};
  for (int k = 0; k <= 8; ++k) EXPECT_EQ(classes[k].size(), size_t(expected[k])) << k;
}

TEST(Classes, AreNumberedByTheirSmallestSymbols) {
  std::map<uint8_t, uint8_t> number_of_base;
  for (unsigned s = 0; s < 256; ++s) {
    EXPECT_LE(kSymbolClasses.base[s], s);
    number_of_base[kSymbolClasses.base[s]] = kSymbolClasses.number[s];
    EXPECT_EQ(kSymbolMaps.forward[kSymbolClasses.symmetry[s]][s], kSymbolClasses.base[s]);
  }
  uint8_t next = 0;
  for (const auto& [base, number] : number_of_base) EXPECT_EQ(number, next++) << int(base);
}

}  // namespace
}  // namespace afx::codec
