// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Lists whose elements are numbers of one width: decoder and encoder take those as runs of numbers
// (codec/bit_reader.h, bit_writer.h) and not element by element.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

#include "bifs/quantizer.h"
#include "nodes/field_value.h"

namespace afx::bifs {

/// How many numbers an element is written as; 0 where there is more to it than numbers.
template <class T>
inline constexpr size_t kNumbersIn = 0;
template <>
inline constexpr size_t kNumbersIn<uint8_t> = 1;  // MFBool
template <>
inline constexpr size_t kNumbersIn<int32_t> = 1;
template <>
inline constexpr size_t kNumbersIn<float> = 1;
template <>
inline constexpr size_t kNumbersIn<double> = 2;
template <>
inline constexpr size_t kNumbersIn<glm::vec2> = 2;
template <>
inline constexpr size_t kNumbersIn<glm::vec3> = 3;
template <>
inline constexpr size_t kNumbersIn<glm::vec4> = 4;
template <>
inline constexpr size_t kNumbersIn<nodes::Rotation> = 4;

/// The width of those numbers, 0..32 bits; none where they are not all of one width (efficient
/// floats) or not coded each for itself (directions).
template <class T>
std::optional<unsigned> number_width(const ElementCoding& coding) {
  using Kind = ElementCoding::Kind;
  if constexpr (kNumbersIn<T> == 0) return std::nullopt;
  if constexpr (std::is_same_v<T, uint8_t>) return 1;
  if constexpr (std::is_same_v<T, double>) return 32;
  if constexpr (std::is_same_v<T, int32_t>) return coding.kind == Kind::integer ? coding.bits : 32;
  if (coding.kind == Kind::linear && kNumbersIn<T> <= coding.lo.size()) return coding.bits;
  if (coding.kind == Kind::plain && !coding.efficient_floats) return 32;
  return std::nullopt;
}

/// The components of an element of floats.
inline float* components(float& value) { return &value; }
inline float* components(glm::vec2& value) { return &value.x; }
inline float* components(glm::vec3& value) { return &value.x; }
inline float* components(glm::vec4& value) { return &value.x; }
inline float* components(nodes::Rotation& value) { return &value.x; }

/// An element of numbers that next() gives one after another.
template <class T, class Next>
void from_numbers(T& value, const ElementCoding& coding, Next next) {
  if constexpr (std::is_same_v<T, uint8_t>) {
    value = static_cast<uint8_t>(next());
  } else if constexpr (std::is_same_v<T, int32_t>) {
    value = static_cast<int32_t>(int64_t{next()} + coding.offset);  // the offset of plain ones is 0
  } else if constexpr (std::is_same_v<T, double>) {
    const uint64_t high = next();
    value = std::bit_cast<double>(high << 32 | next());
  } else {
    float* const at = components(value);
    const bool linear = coding.kind == ElementCoding::Kind::linear;
    for (size_t i = 0; i < kNumbersIn<T>; ++i)
      at[i] = linear ? dequantize(next(), coding.lo[i], coding.hi[i], coding.bits)
                     : std::bit_cast<float>(next());
  }
}

/// Hands the numbers of an element to put() one after another. All of the list must pass
/// fit_numbers().
template <class T, class Put>
void to_numbers(T value, const ElementCoding& coding, Put put) {
  if constexpr (std::is_same_v<T, uint8_t>) {
    put(value != 0 ? 1U : 0U);
  } else if constexpr (std::is_same_v<T, int32_t>) {
    put(static_cast<uint32_t>(int64_t{value} - coding.offset));
  } else if constexpr (std::is_same_v<T, double>) {
    put(static_cast<uint32_t>(std::bit_cast<uint64_t>(value) >> 32));
    put(static_cast<uint32_t>(std::bit_cast<uint64_t>(value)));
  } else {
    const float* const at = components(value);
    const bool linear = coding.kind == ElementCoding::Kind::linear;
    for (size_t i = 0; i < kNumbersIn<T>; ++i)
      put(linear ? quantize(at[i], coding.lo[i], coding.hi[i], coding.bits)
                 : std::bit_cast<uint32_t>(at[i]));
  }
}

/// Whether the quantizer can hold all elements of a list.
template <class T>
bool fit_numbers(const std::vector<T>& list, const ElementCoding& coding) {
  if constexpr (std::is_same_v<T, int32_t>) {
    if (coding.kind != ElementCoding::Kind::integer) return true;
    const int64_t last = (int64_t{1} << coding.bits) - 1;
    return std::all_of(list.begin(), list.end(), [&](int32_t value) {
      const int64_t code = int64_t{value} - coding.offset;
      return code >= 0 && code <= last;
    });
  }
  if (coding.kind != ElementCoding::Kind::linear) return true;
  for (size_t i = 0; i < std::min(kNumbersIn<T>, coding.lo.size()); ++i)
    if (!std::isfinite(coding.hi[i] - coding.lo[i])) return false;
  return true;
}

}  // namespace afx::bifs
