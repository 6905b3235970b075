// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Bounds against errors that are computed here, in long double.
#include "bifs/quantization_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

namespace afx::bifs {

namespace {

using Kind = ElementCoding::Kind;

class Random {
 public:
  uint32_t word() { return static_cast<uint32_t>(generator_()); }
  /// 0 <= x <= 1
  double unit() { return word() / 4294967295.0; }
  glm::vec3 direction() {
    const double z = 2 * unit() - 1;
    const double a = unit() * 6.283185307179586;
    const double r = std::sqrt(1 - z * z);
    return {r * std::cos(a), r * std::sin(a), z};
  }

 private:
  std::mt19937 generator_{1};
};

ElementCoding linear(float lo, float hi, unsigned bits) {
  ElementCoding coding;
  coding.kind = Kind::linear;
  coding.bits = bits;
  coding.lo.fill(lo);
  coding.hi.fill(hi);
  return coding;
}

ElementCoding directions(Kind kind, unsigned bits) {
  ElementCoding coding;
  coding.kind = kind;
  coding.bits = bits;
  return coding;
}

}  // namespace

TEST(ErrorBound, HoldsForValuesOfEveryRangeAndWidth) {
  Random random;
  const std::pair<float, float> ranges[] = {
      {0, 1},           {-1, 1},          {-20, 20},        {1000, 1001},    {-1e30F, 1e28F},
      {-3e-7F, 2e-38F}, {16777215, 2e7F}, {1e-42F, 3e-41F}, {0, 6.2831853F}, {-7, -6.9999F}};
  for (const auto& [lo, hi] : ranges) {
    for (unsigned bits = 1; bits <= 24; ++bits) {
      const ElementCoding coding = linear(lo, hi, bits);
      const double bound = error_bound(coding, 0);
      for (int i = 0; i < 300; ++i) {
        const float value =
            std::clamp(static_cast<float>(lo + (double{hi} - lo) * random.unit()), lo, hi);
        const long double back = dequantize(quantize(value, lo, hi, bits), lo, hi, bits);
        ASSERT_LE(std::abs(back - static_cast<long double>(value)), bound)
            << lo << " " << hi << " " << bits << " " << value;
      }
    }
  }
}

TEST(ErrorBound, IsHalfAStepAndHardlyMore) {
  // 8 bits over 0..1: a step is 1 / 255.
  EXPECT_NEAR(error_bound(linear(0, 1, 8), 0), 1.0 / 510, 2e-6);
  EXPECT_GT(error_bound(linear(0, 1, 8), 0), 1.0 / 510);
  EXPECT_EQ(error_bound(linear(3, 3, 8), 0), 0);
}

TEST(LargestError, IsThatOfTheWorstElement) {
  // 2 bits over 0..3: codes are 0, 1, 2, 3.
  const ElementCoding coding = linear(0, 3, 2);
  EXPECT_FLOAT_EQ(static_cast<float>(largest_error(coding, std::vector<float>{0, 1.125F, 2.75F})),
                  0.25F);
  EXPECT_FLOAT_EQ(static_cast<float>(largest_error(coding, glm::vec3(1, 2.5F, 0.125F))), 0.5F);
  EXPECT_EQ(largest_error(coding, std::vector<float>{}), 0);
}

TEST(ErrorBound, HoldsForNormalsAsAngles) {
  Random random;
  for (const unsigned bits : {2U, 3U, 5U, 8U, 12U, 20U, 31U}) {
    const double bound = error_bound(directions(Kind::normal, bits), 0);
    double worst = 0;
    for (int i = 0; i < 5000; ++i) {
      const glm::vec3 n = random.direction();
      const auto back = dequantize_normal(quantize_normal(n, bits), bits);
      ASSERT_TRUE(back.ok());
      const glm::dvec3 a(n);
      const glm::dvec3 b(back.value());
      const glm::dvec3 cross(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
      const double angle =
          std::atan2(std::hypot(cross.x, cross.y, cross.z), a.x * b.x + a.y * b.y + a.z * b.z);
      ASSERT_LE(angle, bound) << bits;
      ASSERT_NEAR(largest_error(directions(Kind::normal, bits), n), angle, 1e-6);
      worst = std::max(worst, angle);
    }
    if (bits < 16) {
      EXPECT_GT(worst, bound / 3) << "a bound that says nothing";
    }
  }
}

TEST(ErrorBound, HoldsForRotationsAsTheAngleBetweenThem) {
  Random random;
  for (const unsigned bits : {2U, 4U, 8U, 12U, 20U}) {
    const double bound = error_bound(directions(Kind::rotation, bits), 0);
    for (int i = 0; i < 3000; ++i) {
      const glm::vec3 axis = random.direction();
      const glm::vec3 probe = random.direction();
      const nodes::Rotation r{axis.x, axis.y, axis.z, static_cast<float>(random.unit() * 6.28)};
      const auto back = dequantize_rotation(quantize_rotation(r, bits), bits);
      ASSERT_TRUE(back.ok());
      const auto turned = [&](const nodes::Rotation& by) {  // by Rodrigues' formula
        const glm::dvec3 k =
            glm::dvec3(by.x, by.y, by.z) / std::hypot(double{by.x}, double{by.y}, double{by.z});
        const glm::dvec3 v(probe);
        const double dot = k.x * v.x + k.y * v.y + k.z * v.z;
        const glm::dvec3 cross(k.y * v.z - k.z * v.y, k.z * v.x - k.x * v.z, k.x * v.y - k.y * v.x);
        return v * std::cos(double{by.angle}) + cross * std::sin(double{by.angle}) +
               k * dot * (1 - std::cos(double{by.angle}));
      };
      // A vector moves by no more than the angle.
      const glm::dvec3 moved = turned(r) - turned(back.value());
      const double chord = std::hypot(moved.x, moved.y, moved.z);
      ASSERT_LE(chord, bound);
      ASSERT_LE(chord, largest_error(directions(Kind::rotation, bits), r) + 1e-5);
    }
  }
}

}  // namespace afx::bifs
