// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>

#include "codec/adaptive_table.h"
#include "codec/arithmetic_interval.h"

namespace afx::codec {

/// Decodes symbols from a span of bytes; bits past its end read as 0. The caller compares shifts()
/// with the bits that there are, see octree_decoder.cpp.
class ArithmeticDecoder {
 public:
  explicit ArithmeticDecoder(std::span<const uint8_t> data)
      : next_(data.data()), end_(data.data() + data.size()) {
    offset_ = take(16);
  }

  /// Decodes a symbol by the table and counts it there.
  uint32_t decode(AdaptiveTable& table) {
    const uint32_t total = table.total();
    // offset < range, hence target < total, whatever the data are.
    const uint32_t target = ((offset_ + 1) * total - 1) / interval_.range;
    const AdaptiveTable::Interval found = table.find(target);
    const uint32_t before = interval_.low;
    interval_.narrow(found.low, found.high, total);
    offset_ -= interval_.low - before;
    const unsigned shifts = interval_.shift().total();
    interval_.renormalise(shifts);
    offset_ = offset_ << shifts | take(shifts);
    shifts_ += shifts;
    table.count(found.symbol);
    return found.symbol;
  }

  /// Bits shifted in after the first 16.
  [[nodiscard]] uint64_t shifts() const { return shifts_; }

  /// Whether the code ends as an encoder leaves it. Ask after the last symbol.
  [[nodiscard]] bool ends_well() const {
    return (interval_.low + offset_) / 0x4000 == (interval_.low < 0x4000 ? 1U : 2U);
  }

 private:
  /// The next n bits, 0 <= n <= 16.
  uint32_t take(unsigned n) {
    if (held_ < 16) refill();
    const auto bits = static_cast<uint32_t>(window_ >> 1 >> (63 - n));
    window_ <<= n;
    held_ -= n;
    return bits;
  }

  /// Tops the window up to 48 bits or more, with zeros past the end.
  void refill() {
    if (end_ - next_ >= 8) {
      uint64_t word;
      std::memcpy(&word, next_, 8);
      if constexpr (std::endian::native == std::endian::little) word = __builtin_bswap64(word);
      window_ |= word >> held_;
      const unsigned bytes =
          (63 - held_) / 8;  // the byte that fits in part is read again, to the same bits
      next_ += bytes;
      held_ += bytes * 8;
      return;
    }
    for (; held_ <= 48; held_ += 8) {
      const uint64_t byte = next_ < end_ ? *next_++ : 0;
      window_ |= byte << (56 - held_);
    }
  }

  ArithmeticInterval interval_;
  uint32_t offset_ = 0;  // code - low
  uint64_t window_ = 0;  // bits that come next, at the top
  unsigned held_ = 0;    // how many of them
  const uint8_t* next_;
  const uint8_t* end_;
  uint64_t shifts_ = 0;
};

}  // namespace afx::codec
