// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>

#include "afx/picture.h"

namespace afx {

/// Linear light, 0..1, of each 8-bit sRGB value. Averages of colours are made in linear light.
/// Source: IEC 61966-2-1 (clause not checked).
const std::array<float, 256>& srgb_to_linear();

/// The same for a value between: 0..1 on the sRGB scale; clamps, NaN gives 0.
float srgb_to_linear(float srgb);

/// Takes linear light to the nearest 8-bit sRGB value (on the sRGB scale), many at a time.
class SrgbEncoder {
 public:
  /// The one there is.
  static const SrgbEncoder& get();

  /// Clamps; NaN gives 0.
  uint8_t operator()(float linear) const {
    if (!(linear > 0)) return 0;
    if (linear >= 1) return 255;
    const size_t k = starts_[static_cast<size_t>(static_cast<int>(linear * kBuckets))];
    return static_cast<uint8_t>(k + (linear >= thresholds_[k + 1] ? 1 : 0));
  }

 private:
  SrgbEncoder();

  static constexpr int kBuckets =
      4096;  // fewer than one step of the scale in each, at its steepest
  std::array<float, 257>
      thresholds_{};  // element k: the least linear value that rounds to k or more
  std::array<uint8_t, kBuckets + 1> starts_{};  // of each bucket's least value
};

/// The same for one.
inline uint8_t linear_to_srgb(float linear) { return SrgbEncoder::get()(linear); }

/// The three components of a colour in linear light, 0..1; alpha has no part in it.
inline glm::dvec3 linear_light(Rgba8 colour) {
  const std::array<float, 256>& linear = srgb_to_linear();
  return {linear[colour.r], linear[colour.g], linear[colour.b]};
}

/// The other way round: an opaque colour. The mean of colours is to_srgb(sum of lights / count).
inline Rgba8 to_srgb(const glm::dvec3& light) {
  const auto byte = [](double part) { return linear_to_srgb(static_cast<float>(part)); };
  return {byte(light.x), byte(light.y), byte(light.z), 255};
}

}  // namespace afx
