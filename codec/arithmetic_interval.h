// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The interval of the 16-bit arithmetic coder, and the two steps on it that encoder and decoder
// must do alike. Source: ITU-T H.263 Annex E, as ISO/IEC 14496-16 uses it for OctreeImage (clause
// not checked).
#pragma once

#include <array>
#include <bit>
#include <cassert>
#include <cstdint>

namespace afx::codec {

/// floor(product / total) by a multiplication: exact for total <= 2^14 and product <= 2^16 * total.
/// With m = floor(2^44 / total) + 1 the quotient product * m / 2^44 is too large by at most
/// product / 2^44 <= total / 2^28 < 1 / total, so it never reaches the next integer; product * m <
/// 2^61.
class Reciprocal {
 public:
  static constexpr uint32_t kLargest = 8192;  ///< greatest total
  constexpr explicit Reciprocal(uint32_t total) : factor_((uint64_t{1} << 44) / total + 1) {}
  constexpr Reciprocal() = default;
  [[nodiscard]] uint32_t divide(uint32_t product) const {
    return static_cast<uint32_t>(product * factor_ >> 44);
  }

 private:
  uint64_t factor_ = 0;
};

/// reciprocal_of(total) for every total that a table can have (at least 1).
inline const Reciprocal& reciprocal_of(uint32_t total) {
  static constexpr auto kTable = [] {
    std::array<Reciprocal, Reciprocal::kLargest + 1> table{};
    for (uint32_t i = 1; i <= Reciprocal::kLargest; ++i) table[i] = Reciprocal(i);
    return table;
  }();
  return kTable[total];
}

/// The interval [low, low + range) of 16-bit codes that is still possible.
///
/// Between symbols it is wide: either it reaches over the middle (low < 2^15 <= high) and beyond
/// one of the quarters. So range > 2^14, and a symbol of frequency >= 1 of a total <= 8192 keeps
/// range >= 1.
struct ArithmeticInterval {
  uint32_t low = 0;
  uint32_t range = 0x10000;  ///< high - low + 1

  /// Narrows to the symbol with cum[symbol] = above_high, cum[symbol + 1] = above_low.
  void narrow(uint32_t above_low, uint32_t above_high, uint32_t total) {
    const Reciprocal& reciprocal = reciprocal_of(total);
    const uint32_t from = reciprocal.divide(range * above_low);
    low += from;
    range = reciprocal.divide(range * above_high) - from;
  }

  /// How far renormalisation shifts: first once for each leading bit that low and high share, then
  /// once for each following bit that is 1 in low and 0 in high (the interval straddles the
  /// middle).
  struct Shift {
    unsigned shared;
    unsigned straddling;
    [[nodiscard]] unsigned total() const { return shared + straddling; }
  };
  [[nodiscard]] Shift shift() const {
    const uint32_t high = low + range - 1;
    const auto shared = static_cast<unsigned>(std::countl_zero((low ^ high) << 16 | 0x8000U));
    const uint32_t straddling = (low & ~high)
                                << shared << 17;  // what follows the first bit that differs
    return {shared, static_cast<unsigned>(std::countl_one(straddling))};
  }

  /// What all the shifts do together: low loses its shared bits at the top and, for each straddling
  /// shift, the quarter that is subtracted.
  void renormalise(unsigned shifts) {
    low = (low << shifts) & 0x7fff;
    range <<= shifts;
    assert(range > 0x4000 && low + range <= 0x10000);
  }
};

}  // namespace afx::codec
