// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/quantization_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace afx::bifs {

namespace {

using Kind = ElementCoding::Kind;
using nodes::FieldValue;
using nodes::Rotation;

// Coding and decoding a number takes eleven roundings of numbers up to the range, each of 2^-24,
// and one of a number up to the greater end; near 0 a rounding is of 2^-150.
constexpr double kRangeRounding = 0x1p-20;
constexpr double kEndRounding = 0x1p-23;
constexpr double kLeastRounding = 0x1p-148;
// A direction goes through binary64, and its components through binary32.
constexpr double kDirectionRounding = 0x1p-18;

template <size_t n>
using Direction = std::array<double, n>;

/// Length of the difference of two unit vectors, as an angle.
template <size_t n>
double angle_between(const Direction<n>& a, const Direction<n>& b, double sign) {
  double sum = 0;
  for (size_t i = 0; i < n; ++i) sum += (a[i] - sign * b[i]) * (a[i] - sign * b[i]);
  return 2 * std::asin(std::min(std::sqrt(sum) / 2, 1.0));
}

Direction<3> unit(double x, double y, double z) {
  const double length = std::sqrt(x * x + y * y + z * z);
  if (!(length > 0)) return {};
  return {x / length, y / length, z / length};
}

Direction<4> quaternion(const Rotation& r) {
  const Direction<3> axis = unit(r.x, r.y, r.z);
  const bool has_axis = axis != Direction<3>{};
  const double half = has_axis ? double{r.angle} / 2 : 0;
  const double s = std::sin(half);
  return {std::cos(half), s * axis[0], s * axis[1], s * axis[2]};
}

double error_of(const glm::vec3& normal, unsigned bits) {
  const Direction<3> before = unit(normal.x, normal.y, normal.z);
  const auto back = dequantize_normal(quantize_normal(normal, bits), bits);
  if (!back.ok() || before == Direction<3>{}) return 0;
  return angle_between(before, unit(back.value().x, back.value().y, back.value().z), 1);
}

/// A quaternion and its negative are the same rotation, of twice the quaternion's angle.
double error_of(const Rotation& rotation, unsigned bits) {
  const auto back = dequantize_rotation(quantize_rotation(rotation, bits), bits);
  if (!back.ok()) return 0;
  const Direction<4> a = quaternion(rotation);
  const Direction<4> b = quaternion(back.value());
  return 2 * std::min(angle_between(a, b, 1), angle_between(a, b, -1));
}

template <class T>
double largest_direction_error(const FieldValue& value, unsigned bits) {
  if (const auto* one = std::get_if<T>(&value)) return error_of(*one, bits);
  double largest = 0;
  if (const auto* many = std::get_if<std::vector<T>>(&value))
    for (const T& one : *many) largest = std::max(largest, error_of(one, bits));
  return largest;
}

/// Of half a step in each of the smaller components. A step of an angle whose tangent is coded
/// turns the direction by no more than that step: with a = g[i]^2 <= 1 and b the sum of the squares
/// of the other tangents, by (1 + a) sqrt(1 + b) / (1 + a + b) of it.
double direction_bound(unsigned bits, unsigned smaller_components) {
  const double half_step = std::numbers::pi / 8 / static_cast<double>((1U << (bits - 1)) - 1);
  return smaller_components * half_step + kDirectionRounding;
}

}  // namespace

double error_bound(const ElementCoding& coding, size_t component) {
  if (coding.kind == Kind::normal) return direction_bound(coding.bits, 2);
  if (coding.kind == Kind::rotation) return 2 * direction_bound(coding.bits, 3);
  if (coding.kind != Kind::linear) return 0;
  const double lo = coding.lo[component];
  const double hi = coding.hi[component];
  if (lo == hi) return 0;
  const double steps = std::ldexp(1.0, static_cast<int>(coding.bits)) - 1;
  return (hi - lo) / (2 * steps) + (hi - lo) * kRangeRounding +
         std::max(std::abs(lo), std::abs(hi)) * kEndRounding + kLeastRounding;
}

double largest_error(const ElementCoding& coding, const FieldValue& value) {
  if (coding.kind == Kind::normal) return largest_direction_error<glm::vec3>(value, coding.bits);
  if (coding.kind == Kind::rotation) return largest_direction_error<Rotation>(value, coding.bits);
  double largest = 0;
  if (coding.kind != Kind::linear) return largest;
  for_each_component(value, [&](float v, size_t component) {
    const float lo = coding.lo[component];
    const float hi = coding.hi[component];
    const float back = dequantize(quantize(v, lo, hi, coding.bits), lo, hi, coding.bits);
    largest = std::max(largest, std::abs(double{back} - double{v}));
  });
  return largest;
}

}  // namespace afx::bifs
