// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// For tests: pictures in floating point, which we do not write ourselves.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

namespace afx {

/// A TIFF of one strip of 32-bit floating point, grey, by the TIFF 6.0 specification.
inline std::vector<uint8_t> float_tiff(uint32_t width, uint32_t height,
                                       const std::vector<float>& samples) {
  std::vector<uint8_t> bytes{'I', 'I', 42, 0, 8, 0, 0, 0, 9, 0};
  const auto put = [&](uint32_t value, int count) {
    for (int n = 0; n < count; ++n) bytes.push_back(static_cast<uint8_t>(value >> (8 * n)));
  };
  const auto size = static_cast<uint32_t>(4 * samples.size());
  constexpr uint32_t kData = 8 + 2 + 9 * 12 + 4;
  const uint32_t entries[9][2] = {{256, width}, {257, height}, {258, 32},   {259, 1}, {262, 1},
                                  {273, kData}, {278, height}, {279, size}, {339, 3}};
  for (const auto& [tag, value] : entries) {
    put(tag, 2);
    put(4, 2);  // LONG
    put(1, 4);
    put(value, 4);
  }
  put(0, 4);
  for (const float sample : samples) put(std::bit_cast<uint32_t>(sample), 4);
  return bytes;
}

}  // namespace afx
