// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/local_mean.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace afx {
namespace {

TEST(LocalMean, IsTheMeanOfTheNeighboursThatThereAre) {
  Picture picture(3, 2, 1);
  picture.samples = {0, 9, 18, 90, 90, 90};
  // Corners have four pixels, the middle column six: (0+9+90+90)/4, (0+9+18+270)/6, (9+18+180)/4.
  EXPECT_EQ(local_mean(picture).samples, (std::vector<uint8_t>{47, 49, 51, 47, 49, 51}));
}

TEST(LocalMean, TakesComponentsApart) {
  Picture picture(2, 1, 3);
  picture.samples = {10, 20, 30, 20, 40, 60};
  EXPECT_EQ(local_mean(picture).samples, (std::vector<uint8_t>{15, 30, 45, 15, 30, 45}));
}

}  // namespace
}  // namespace afx
