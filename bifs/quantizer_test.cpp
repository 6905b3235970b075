// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The arithmetic of quantization against hand calculations from spec/bifs.md 9.
#include "bifs/quantizer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace afx::bifs {

TEST(LinearQuantizer, HasTheValuesOfTheFormula) {
  // 10 bits over -10..10: 1 is (11 * 1023 / 20) + 0.5 = 563.15 -> 563 -> -10 + 20 * 563 / 1023.
  EXPECT_EQ(quantize(1, -10, 10, 10), 563U);
  EXPECT_FLOAT_EQ(dequantize(563, -10, 10, 10), -10.0F + 20.0F * 563.0F / 1023.0F);
  EXPECT_EQ(quantize(0.5F, 0, 1, 8), 128U);  // 127.5 + 0.5
}

TEST(LinearQuantizer, TheEndsAreExactAndOutsideIsTheNearerEnd) {
  for (const unsigned bits : {1U, 2U, 8U, 16U, 24U, 31U}) {
    const uint32_t last = (uint32_t{1} << bits) - 1;
    EXPECT_EQ(quantize(-3, -3, 7, bits), 0U);
    EXPECT_EQ(quantize(7, -3, 7, bits), last);
    EXPECT_EQ(quantize(-1e30F, -3, 7, bits), 0U);
    EXPECT_EQ(quantize(1e30F, -3, 7, bits), last);
    EXPECT_EQ(dequantize(0, -3, 7, bits), -3);
    EXPECT_EQ(dequantize(last, -3, 7, bits), 7);
  }
  EXPECT_EQ(quantize(5, -3, 7, 0), 0U);
  EXPECT_EQ(quantize(std::numeric_limits<float>::quiet_NaN(), -3, 7, 8), 0U);
}

TEST(LinearQuantizer, ADecodedValueIsEncodedToTheSameCode) {
  for (uint32_t code = 0; code < 4096; ++code)
    ASSERT_EQ(quantize(dequantize(code, -20, 20, 12), -20, 20, 12), code);
}

TEST(DirectionQuantizer, AxesAreExactInEverySign) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const float sign : {1.0F, -1.0F}) {
      glm::vec3 normal(0);
      normal[axis] = sign;
      const QuantizedDirection quantized = quantize_normal(normal, 8);
      EXPECT_EQ(quantized.orientation, static_cast<uint32_t>(axis));
      EXPECT_EQ(quantized.negative, sign < 0);
      EXPECT_EQ(quantized.components[0], 128U);  // zero
      const auto back = dequantize_normal(quantized, 8);
      ASSERT_TRUE(back.ok());
      EXPECT_EQ(back.value(), normal);
    }
  }
}

TEST(DirectionQuantizer, HalfwayBetweenAxesIsTheLastCode) {
  // (1, 1, -1) / sqrt 3: the ratios 1 and -1 are +-45 degrees, the ends of the range.
  const QuantizedDirection quantized = quantize_normal({1, 1, -1}, 10);
  EXPECT_EQ(quantized.orientation, 0U);
  EXPECT_EQ(quantized.components[0], 512U + 511U);
  EXPECT_EQ(quantized.components[1], 512U - 511U);
  const auto back = dequantize_normal(quantized, 10);
  ASSERT_TRUE(back.ok());
  EXPECT_NEAR(back.value().z, -1 / std::sqrt(3.0), 1e-6);
}

TEST(DirectionQuantizer, NormalsComeBackWithinHalfAStep) {
  for (int i = 0; i < 1000; ++i) {
    const double a = i * 2.399963;  // golden angle
    const double z = 1 - (2 * i + 1) / 1000.0;
    const double r = std::sqrt(1 - z * z);
    const glm::vec3 normal(r * std::cos(a), r * std::sin(a), z);
    const auto back = dequantize_normal(quantize_normal(normal, 12), 12);
    ASSERT_TRUE(back.ok());
    // A step is (pi / 4) / 2047 radians in each of two components.
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(back.value()[c], normal[c], 4e-4);
  }
}

TEST(DirectionQuantizer, RotationsComeBackAsTheSameRotation) {
  const nodes::Rotation cases[] = {
      {0, 1, 0, 0.5F}, {1, 0, 0, -1.2F}, {0.6F, 0.8F, 0, 2.9F}, {0, 0, 1, 0}, {0, 0, 1, 6.2F}};
  for (const nodes::Rotation& r : cases) {
    const auto result = dequantize_rotation(quantize_rotation(r, 16), 16);
    ASSERT_TRUE(result.ok());
    const nodes::Rotation& b = result.value();
    const double w = std::cos(double{r.angle} / 2) * std::cos(double{b.angle} / 2);
    const double s = std::sin(double{r.angle} / 2) * std::sin(double{b.angle} / 2);
    const double dot = w + s * (double{r.x} * b.x + double{r.y} * b.y + double{r.z} * b.z);
    EXPECT_NEAR(std::abs(dot), 1, 1e-6);  // of the two quaternions
  }
}

TEST(DirectionQuantizer, TooFewBitsAndOrientationThreeAreMalformed) {
  EXPECT_FALSE(dequantize_normal({false, 0, {0, 0, 0}}, 1).ok());
  EXPECT_FALSE(dequantize_normal({false, 3, {128, 128, 0}}, 8).ok());
  EXPECT_TRUE(dequantize_rotation({false, 3, {128, 128, 128}}, 8).ok());
}

TEST(EfficientFloat, HasTheFieldsOfTheDescription) {
  // 1.5 * 2^3 = 12: mantissa bits 10 0000 0000 0000, exponent 3 = 2^1 + 1.
  const auto twelve = to_efficient_float(-12);
  ASSERT_TRUE(twelve.ok());
  EXPECT_EQ(twelve.value().mantissa_length, 15U);
  EXPECT_EQ(twelve.value().mantissa, 0x2000U);
  EXPECT_TRUE(twelve.value().negative);
  EXPECT_EQ(twelve.value().exponent_length, 2U);
  EXPECT_EQ(twelve.value().exponent, 1U);
  EXPECT_EQ(from_efficient_float(twelve.value()), -12);
  EXPECT_EQ(to_efficient_float(1).value().mantissa_length, 1U);  // no mantissa, no exponent
  EXPECT_EQ(to_efficient_float(-0.0F).value().mantissa_length, 0U);
}

TEST(EfficientFloat, IsWithinTwoToTheMinusFourteen) {
  for (float value = 1e-37F; value < 1e38F; value *= 1.37F) {
    const auto parts = to_efficient_float(value);
    ASSERT_TRUE(parts.ok());
    EXPECT_NEAR(from_efficient_float(parts.value()) / value, 1, 1.0 / 16384);
  }
  EXPECT_FALSE(to_efficient_float(std::numeric_limits<float>::infinity()).ok());
  EXPECT_FALSE(to_efficient_float(std::numeric_limits<float>::quiet_NaN()).ok());
}

}  // namespace afx::bifs
