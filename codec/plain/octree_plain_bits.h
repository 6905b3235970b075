// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "codec/plain/octree_rules.h"

namespace afx::codec::plain {

/// Where bit `bit` of a stream stands in its byte.
inline unsigned shift_of_bit(size_t bit, const BitRules& rules) {
  return static_cast<unsigned>(rules.msb_first ? 7 - bit % 8 : bit % 8);
}

inline std::vector<bool> bits_of_bytes(std::span<const uint8_t> bytes, const BitRules& rules) {
  std::vector<bool> bits(bytes.size() * 8);
  for (size_t i = 0; i < bits.size(); ++i)
    bits[i] = (bytes[i / 8] >> shift_of_bit(i, rules) & 1) != 0;
  return bits;
}

/// Filled up with zeros.
inline std::vector<uint8_t> bytes_of_bits(const std::vector<bool>& bits, const BitRules& rules) {
  std::vector<uint8_t> bytes((bits.size() + 7) / 8);
  for (size_t i = 0; i < bits.size(); ++i)
    if (bits[i]) bytes[i / 8] = static_cast<uint8_t>(bytes[i / 8] | 1U << shift_of_bit(i, rules));
  return bytes;
}

}  // namespace afx::codec::plain
