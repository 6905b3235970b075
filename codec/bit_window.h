// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Bits of a byte string, most significant first, by words of eight bytes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace afx::codec {

/// Eight bytes as a number, the first one the most significant. Compilers know this form.
inline uint64_t load_word(const uint8_t* at) {
  return uint64_t{at[0]} << 56 | uint64_t{at[1]} << 48 | uint64_t{at[2]} << 40 |
         uint64_t{at[3]} << 32 | uint64_t{at[4]} << 24 | uint64_t{at[5]} << 16 |
         uint64_t{at[6]} << 8 | uint64_t{at[7]};
}

/// Four bytes of a number, the most significant one first.
inline void store_half_word(uint8_t* at, uint32_t value) {
  at[0] = static_cast<uint8_t>(value >> 24);
  at[1] = static_cast<uint8_t>(value >> 16);
  at[2] = static_cast<uint8_t>(value >> 8);
  at[3] = static_cast<uint8_t>(value);
}

/// The eight bytes from `byte` on, zeros behind the end.
inline uint64_t word_at(std::span<const uint8_t> data, size_t byte) {
  if (data.size() - byte >= 8) return load_word(data.data() + byte);
  uint64_t word = 0;
  for (size_t i = byte; i < data.size(); ++i) word |= uint64_t{data[i]} << (56 - 8 * (i - byte));
  return word;
}

/// The number of `bits` bits, 0..32, at a bit offset; all of them must be in `data`.
inline uint32_t bits_at(std::span<const uint8_t> data, uint64_t bit, unsigned bits) {
  const uint64_t from = word_at(data, bit / 8) << bit % 8;  // at least 57 bits are there
  return static_cast<uint32_t>(from >> 1 >> (63 - bits));   // in two steps: 64 - 0 is no shift
}

}  // namespace afx::codec
