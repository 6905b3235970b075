// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <string>

#include "bifs/node_codes.h"
#include "bifs/quantizer.h"

namespace afx::bifs {

namespace {

constexpr unsigned kMantissaBits = 14;  // of an efficient float, the sign apart
constexpr unsigned kFloatMantissaBits = 23;
constexpr int kExponentBias = 127;

uint32_t last_code(unsigned bits) { return (uint32_t{1} << bits) - 1; }  // bits <= 31

/// The greatest distance of a component's code from the code of zero.
double component_scale(unsigned bits) { return static_cast<double>(last_code(bits - 1)); }

/// The component of greatest magnitude, of equal ones the first. Those that differ by no more than
/// binary32 cannot hold are equal: what was decoded is then encoded to the same code again.
template <size_t n>
size_t greatest_component(const std::array<double, n>& c) {
  constexpr double kSame = 1 - 1e-6;
  double most = 0;
  for (const double component : c) most = std::max(most, std::abs(component));
  for (size_t i = 0; i < n; ++i)
    if (std::abs(c[i]) >= most * kSame) return i;
  return 0;  // NaN
}

template <size_t n>
QuantizedDirection quantize_direction(const std::array<double, n>& c, unsigned bits) {
  QuantizedDirection out;
  if (bits < 2) return out;
  const size_t greatest = greatest_component(c);
  out.orientation = static_cast<uint32_t>(greatest);
  out.negative = c[greatest] < 0;
  const uint32_t zero = uint32_t{1} << (bits - 1);
  for (size_t i = 0; i + 1 < n; ++i) {
    // c[greatest] is 0 or NaN only for a vector that is no direction.
    const double ratio = c[greatest] != 0 ? c[(greatest + 1 + i) % n] / c[greatest] : 0;
    const double t = std::atan(ratio) * 4 / std::numbers::pi;
    const double size = std::floor(std::abs(t) * component_scale(bits) + 0.5);
    const auto steps = static_cast<uint32_t>(std::isfinite(size) ? size : 0);
    out.components[i] = t < 0 ? zero - steps : zero + steps;
  }
  return out;
}

template <size_t n>
Result<std::array<double, n>> dequantize_direction(const QuantizedDirection& in, unsigned bits) {
  if (bits < 2)
    return Error{Errc::malformed,
                 {},
                 "a direction quantized to " + std::to_string(bits) + " bits [expected 2 or more]"};
  if (in.orientation >= n)
    return Error{Errc::malformed, {}, "the orientation of a normal is 3 [expected 0 to 2]"};
  std::array<double, n> c{};
  std::array<double, n - 1> ratio{};
  double sum = 1;
  const double zero = static_cast<double>(uint32_t{1} << (bits - 1));
  for (size_t i = 0; i + 1 < n; ++i) {
    const double m = (static_cast<double>(in.components[i]) - zero) / component_scale(bits);
    ratio[i] = std::tan(m * std::numbers::pi / 4);
    sum += ratio[i] * ratio[i];
  }
  const double greatest = (in.negative ? -1 : 1) / std::sqrt(sum);
  c[in.orientation] = greatest;
  for (size_t i = 0; i + 1 < n; ++i) c[(in.orientation + 1 + i) % n] = ratio[i] * greatest;
  return c;
}

}  // namespace

uint32_t quantize(float value, float lo, float hi, unsigned bits) {
  const uint32_t last = last_code(bits);
  if (!(value > lo)) return 0;
  if (value >= hi) return last;
  const float steps = static_cast<float>(last);
  const float scaled = (value - lo) * steps / (hi - lo);
  const float code = std::floor(static_cast<float>(static_cast<double>(scaled) + 0.5));
  if (!(code > 0)) return 0;
  return code >= steps ? last : static_cast<uint32_t>(code);
}

float dequantize(uint32_t code, float lo, float hi, unsigned bits) {
  if (code == 0) return lo;
  if (code == last_code(bits)) return hi;
  return lo + (hi - lo) * static_cast<float>(code) / static_cast<float>(last_code(bits));
}

QuantizedDirection quantize_normal(const glm::vec3& normal, unsigned bits) {
  return quantize_direction<3>({normal.x, normal.y, normal.z}, bits);
}

Result<glm::vec3> dequantize_normal(const QuantizedDirection& quantized, unsigned bits) {
  const auto c = dequantize_direction<3>(quantized, bits);
  if (!c.ok()) return c.error();
  return glm::vec3(c.value()[0], c.value()[1], c.value()[2]);
}

QuantizedDirection quantize_rotation(const nodes::Rotation& r, unsigned bits) {
  const double length = std::sqrt(double{r.x} * r.x + double{r.y} * r.y + double{r.z} * r.z);
  const double s = length > 0 ? std::sin(double{r.angle} / 2) / length : 0;
  QuantizedDirection out =
      quantize_direction<4>({std::cos(double{r.angle} / 2), s * r.x, s * r.y, s * r.z}, bits);
  out.negative = false;  // a quaternion and its negative are the same rotation
  return out;
}

Result<nodes::Rotation> dequantize_rotation(const QuantizedDirection& quantized, unsigned bits) {
  const auto result = dequantize_direction<4>(quantized, bits);
  if (!result.ok()) return result.error();
  const std::array<double, 4>& q = result.value();
  const double angle = 2 * std::acos(std::clamp(q[0], -1.0, 1.0));
  const double s = std::sin(angle / 2);
  nodes::Rotation rotation;
  rotation.angle = static_cast<float>(angle);
  if (s == 0) return rotation;
  rotation.x = static_cast<float>(q[1] / s);
  rotation.y = static_cast<float>(q[2] / s);
  rotation.z = static_cast<float>(q[3] / s);
  return rotation;
}

Result<EfficientFloat> to_efficient_float(float value) {
  EfficientFloat parts;
  if (value == 0) return parts;
  const auto word = std::bit_cast<uint32_t>(value);
  const int exponent = static_cast<int>(word >> kFloatMantissaBits & 0xFF) - kExponentBias;
  if (exponent > kExponentBias)
    return Error{Errc::bad_argument,
                 {},
                 "an infinity or NaN cannot be an efficient float [expected a finite number]"};
  parts.negative = (word >> 31) != 0;
  parts.mantissa = word >> (kFloatMantissaBits - kMantissaBits) & ((1U << kMantissaBits) - 1);
  parts.mantissa_length = 1 + bits_for(parts.mantissa);
  if (exponent == 0) return parts;
  const auto size = static_cast<uint32_t>(std::abs(exponent));
  parts.exponent_negative = exponent < 0;
  parts.exponent_length = bits_for(size);
  parts.exponent = size - (uint32_t{1} << (parts.exponent_length - 1));
  return parts;
}

float from_efficient_float(const EfficientFloat& parts) {
  if (parts.mantissa_length == 0) return 0;
  int exponent = 0;
  if (parts.exponent_length > 0) {
    const auto size = static_cast<int>((1U << (parts.exponent_length - 1)) + parts.exponent);
    exponent = parts.exponent_negative ? -size : size;
  }
  // An exponent of -127 gives a denormal, +127 is the greatest there is: 7 bits hold no more.
  const uint32_t word = (parts.negative ? 1U : 0U) << 31 |
                        static_cast<uint32_t>(exponent + kExponentBias) << kFloatMantissaBits |
                        parts.mantissa << (kFloatMantissaBits - kMantissaBits);
  return std::bit_cast<float>(word);
}

}  // namespace afx::bifs
