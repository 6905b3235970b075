// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <vector>

#include "codec/adaptive_table.h"
#include "codec/arithmetic_interval.h"

namespace afx::codec {

/// Encodes symbols and appends the bits, most significant first, to a byte vector.
class ArithmeticEncoder {
 public:
  explicit ArithmeticEncoder(std::vector<uint8_t>& out) : out_(&out) {}

  /// Encodes a symbol by the table and counts it there.
  void encode(AdaptiveTable& table, uint32_t symbol) {
    const AdaptiveTable::Interval bounds = table.interval(symbol);
    interval_.narrow(bounds.low, bounds.high, table.total());
    const ArithmeticInterval::Shift shift = interval_.shift();
    if (shift.shared > 0) put_shared(interval_.low >> (16 - shift.shared), shift.shared);
    pending_ += shift.straddling;
    interval_.renormalise(shift.total());
    table.count(symbol);
  }

  /// Writes the two last bits and zeros up to the next byte. Nothing may be encoded after it.
  /// Returns the number of bits without the zeros.
  uint64_t finish() {
    ++pending_;
    put_shared(interval_.low < 0x4000 ? 0 : 1, 1);
    const uint64_t bits = written_ + held_;
    for (unsigned at = 0; at < held_; at += 8)
      out_->push_back(static_cast<uint8_t>(window_ >> (56 - at)));
    held_ = 0;
    return bits;
  }

 private:
  /// The top bits that low and high share: the first, then the complement of it for each straddling
  /// shift since, then the rest. 1 <= count <= 16.
  void put_shared(uint32_t bits, unsigned count) {
    if (pending_ == 0) return put(bits, count);
    const uint32_t first = bits >> (count - 1);
    put(first, 1);
    const uint32_t complement = first != 0 ? 0 : 0xffff;
    for (; pending_ > 16; pending_ -= 16) put(complement, 16);
    put(complement >> (16 - pending_), static_cast<unsigned>(pending_));
    pending_ = 0;
    put(bits & ~(first << (count - 1)), count - 1);
  }

  /// Appends the low `count` bits (the others are 0), 0 <= count <= 16.
  void put(uint32_t bits, unsigned count) {
    window_ |= uint64_t{bits} << (48 - held_) << (16 - count);
    held_ += count;
    if (held_ >= 32) put_word();
  }

  void put_word() {
    const auto word = static_cast<uint32_t>(window_ >> 32);
    const uint8_t bytes[4] = {static_cast<uint8_t>(word >> 24), static_cast<uint8_t>(word >> 16),
                              static_cast<uint8_t>(word >> 8), static_cast<uint8_t>(word)};
    out_->insert(out_->end(), bytes, bytes + 4);
    window_ <<= 32;
    held_ -= 32;
    written_ += 32;
  }

  ArithmeticInterval interval_;
  uint64_t pending_ = 0;  // straddling shifts since the last bit written
  uint64_t window_ = 0;   // bits not yet written, at the top
  unsigned held_ = 0;     // how many of them, < 32 between calls
  uint64_t written_ = 0;  // bits written
  std::vector<uint8_t>* out_;
};

}  // namespace afx::codec
