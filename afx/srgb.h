// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

#include "afx/picture.h"

namespace afx {

/// Linear light, 0..1, of each 8-bit sRGB value. Averages of colours are made in linear light.
/// Source: IEC 61966-2-1 (clause not checked).
const std::array<float, 256>& srgb_to_linear();

/// The same for a value between: 0..1 on the sRGB scale; clamps, NaN gives 0.
float srgb_to_linear(float srgb);

/// The 8-bit sRGB value nearest (on the sRGB scale) to a linear one; clamps, NaN gives 0.
uint8_t linear_to_srgb(float linear);

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
