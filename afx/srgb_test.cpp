// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/srgb.h"

#include <gtest/gtest.h>

#include <cmath>

namespace afx {
namespace {

TEST(Srgb, EveryValueComesBack) {
  for (size_t k = 0; k < 256; ++k) EXPECT_EQ(linear_to_srgb(srgb_to_linear()[k]), k);
}

TEST(Srgb, KnownValuesAreMet) {
  EXPECT_EQ(srgb_to_linear()[0], 0);
  EXPECT_EQ(srgb_to_linear()[255], 1);
  EXPECT_NEAR(srgb_to_linear()[128], 0.2158605, 1e-6);
  EXPECT_EQ(linear_to_srgb(0.5F), 188);  // 1.055 * 0.5^(1/2.4) - 0.055 = 0.735357; * 255 = 187.52
}

TEST(Srgb, LinearValuesRoundToTheNearest) {
  for (int i = 0; i <= 100000; ++i) {
    const double linear = i / 100000.0;
    const double value =
        linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
    ASSERT_NEAR(linear_to_srgb(static_cast<float>(linear)), value * 255, 0.502) << linear;
  }
}

TEST(Srgb, WhatIsOutOfRangeIsClamped) {
  EXPECT_EQ(linear_to_srgb(-1), 0);
  EXPECT_EQ(linear_to_srgb(2), 255);
  EXPECT_EQ(linear_to_srgb(INFINITY), 255);
  EXPECT_EQ(linear_to_srgb(NAN), 0);
}

TEST(Srgb, FractionsGoTheSameWayAsBytes) {
  for (size_t k = 0; k < 256; ++k)
    EXPECT_NEAR(srgb_to_linear(static_cast<float>(k) / 255), srgb_to_linear()[k], 1e-6) << k;
  EXPECT_EQ(srgb_to_linear(-1.0F), 0);
  EXPECT_EQ(srgb_to_linear(2.0F), 1);
  EXPECT_EQ(srgb_to_linear(std::nanf("")), 0);
}

}  // namespace
}  // namespace afx
