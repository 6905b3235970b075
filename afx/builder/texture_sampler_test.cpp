// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/texture_sampler.h"

#include <gtest/gtest.h>

#include <limits>

#include <initializer_list>

namespace afx {
namespace {

Picture grey_row(std::initializer_list<uint8_t> values) {
  Picture picture(static_cast<uint32_t>(values.size()), 1, 1);
  picture.samples = values;
  return picture;
}

float grey_at(const TextureSampler& sampler, double u, Wrap wrap, double area = 1) {
  return sampler.sample({u, 0.5}, area, wrap, wrap).r;
}

TEST(TextureSampler, BlendsNeighboursInLinearLight) {
  const Picture picture = grey_row({0, 255});
  const TextureSampler sampler(picture);
  EXPECT_FLOAT_EQ(grey_at(sampler, 0.25, Wrap::clamp), 0);
  EXPECT_FLOAT_EQ(grey_at(sampler, 0.5, Wrap::clamp), 0.5F);
  EXPECT_FLOAT_EQ(grey_at(sampler, 0.75, Wrap::clamp), 1);
}

TEST(TextureSampler, WrapsAsTold) {
  const Picture picture = grey_row({0, 255, 255, 255});
  const TextureSampler sampler(picture);
  EXPECT_FLOAT_EQ(grey_at(sampler, -0.125, Wrap::repeat), 1);  // the last texel
  EXPECT_FLOAT_EQ(grey_at(sampler, 0, Wrap::repeat), 0.5F);    // between the last and the first
  EXPECT_FLOAT_EQ(grey_at(sampler, 5.125, Wrap::repeat), 0);
  EXPECT_FLOAT_EQ(grey_at(sampler, -3, Wrap::clamp), 0);
  EXPECT_FLOAT_EQ(grey_at(sampler, -0.125, Wrap::mirror), 0);  // the first texel again
  EXPECT_FLOAT_EQ(grey_at(sampler, 1.875, Wrap::mirror), 0);
}

TEST(TextureSampler, TakesAnyFiniteCoordinate) {
  const Picture picture = grey_row({10, 200, 30});
  const TextureSampler sampler(picture);
  for (const double u : {1e30, -1e30, 3e38, -0.0, 1e-40})
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp, Wrap::mirror}) {
      const float value = sampler.sample({u, -u}, 1, wrap, wrap).r;
      EXPECT_TRUE(value >= 0 && value <= 1) << u;
    }
}

TEST(TextureSampler, OverAllOfItIsTheMeanOfItsLight) {
  // 85 black and 15 white texels of 10 x 10, sides that are no powers of two: 0.15 of the light.
  Picture picture(10, 10, 1);
  for (size_t i = 0; i < 15; ++i) picture.samples[i * 6 + 3] = 255;
  const TextureSampler sampler(picture);
  EXPECT_NEAR(sampler.sample({0.3, 0.3}, 1e6, Wrap::repeat, Wrap::repeat).r, 0.15, 1e-3);
}

TEST(TextureSampler, TakesAnyArea) {
  const Picture picture = grey_row({0, 255});
  const TextureSampler sampler(picture);
  const float all = sampler.sample({0.1, 0.5}, 2, Wrap::clamp, Wrap::clamp).r;
  EXPECT_NEAR(all, 0.5, 1e-4);
  for (const double area : {1e18, 1e300, std::numeric_limits<double>::infinity()})
    EXPECT_EQ(sampler.sample({0.1, 0.5}, area, Wrap::clamp, Wrap::clamp).r, all);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(sampler.sample({0.1, 0.5}, nan, Wrap::clamp, Wrap::clamp).r, 0);
}

TEST(TextureSampler, WeightsLightByAlpha) {
  // Red and half there, beside green that is not there: nothing of the green, at any size.
  Picture picture(2, 1, 4);
  picture.samples = {255, 0, 0, 128, 0, 255, 0, 0};
  const TextureSampler sampler(picture);
  constexpr float kAlpha = 128 / 255.0F;
  const auto at = [&](double u, double area) {
    return sampler.sample({u, 0.5}, area, Wrap::clamp, Wrap::clamp);
  };
  EXPECT_EQ(at(0.25, 1), glm::vec4(kAlpha, 0, 0, kAlpha));
  EXPECT_EQ(at(0.75, 1), glm::vec4(0));
  EXPECT_EQ(at(0.5, 1), glm::vec4(kAlpha, 0, 0, kAlpha) / 2.0F);
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(at(0.1, 2)[k], (k % 3 == 0 ? kAlpha / 2 : 0), 1e-5);
}

TEST(TextureSampler, TakesGreyWithAlpha) {
  Picture picture(1, 1, 2);
  picture.samples = {255, 51};
  const glm::vec4 at = TextureSampler(picture).sample({0, 0}, 1, Wrap::repeat, Wrap::repeat);
  for (int k = 0; k < 4; ++k) EXPECT_FLOAT_EQ(at[k], 0.2F);
}

TEST(TextureSampler, WithoutAlphaAllIsOpaque) {
  for (const uint32_t components : {1U, 3U}) {
    const Picture picture(4, 4, components);
    const TextureSampler sampler(picture);
    for (const double area : {1.0, 16.0})
      EXPECT_EQ(sampler.sample({0.3, 0.3}, area, Wrap::repeat, Wrap::repeat),
                glm::vec4(0, 0, 0, 1));
  }
}

}  // namespace
}  // namespace afx
