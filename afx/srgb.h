// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <array>
#include <cstdint>

namespace afx {

/// Linear light, 0..1, of each 8-bit sRGB value. Averages of colours are made in linear light.
/// Source: IEC 61966-2-1 (clause not checked).
const std::array<float, 256>& srgb_to_linear();

/// The same for a value between: 0..1 on the sRGB scale; clamps, NaN gives 0.
float srgb_to_linear(float srgb);

/// The 8-bit sRGB value nearest (on the sRGB scale) to a linear one; clamps, NaN gives 0.
uint8_t linear_to_srgb(float linear);

}  // namespace afx
