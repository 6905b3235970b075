// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/viewer/moving_quality.h"

#include <gtest/gtest.h>

namespace afx::tools {
namespace {

/// Draws pictures of which a whole one takes so many milliseconds; the time of the last one.
double settle(MovingQuality& quality, double whole) {
  double time = 0;
  for (int i = 0; i < 10; ++i) {
    time = whole * quality.scale() * quality.scale();
    quality.learn(quality.scale(), time);
  }
  return time;
}

TEST(MovingQuality, StaysWholeWhereThatIsFastEnough) {
  MovingQuality quality;
  settle(quality, 49);
  EXPECT_EQ(quality.scale(), 1);
}

TEST(MovingQuality, BecomesSmallerUntilItIsFastAndGrowsAgain) {
  MovingQuality quality;
  const double time = settle(quality, 200);
  EXPECT_LE(time, MovingQuality::kMost);
  EXPECT_GT(time, MovingQuality::kMost / 2);
  EXPECT_LT(quality.scale(), 0.6);
  settle(quality, 20);
  EXPECT_EQ(quality.scale(), 1);
}

TEST(MovingQuality, IsNeverTooSmallToSeeAnything) {
  MovingQuality quality;
  settle(quality, 1e6);
  EXPECT_EQ(quality.scale(), MovingQuality::kLeastScale);
}

}  // namespace
}  // namespace afx::tools
