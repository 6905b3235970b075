// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The adaptive frequency table of the octree coder, kept as cumulative sums in two levels of 16 so
// that finding a symbol and counting one take a few vector instructions.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace afx::codec {

/// Of 16 values in descending order: the number of the last that is greater than `limit`. The first
/// must be greater.
inline unsigned last_greater_portable(const int16_t* values, int limit) {
  unsigned count = 0;
  for (unsigned i = 0; i < 16; ++i) count += values[i] > limit ? 1 : 0;
  return count - 1;
}

#ifdef __SSE2__
inline unsigned last_greater(const int16_t* values, int limit) {
  const __m128i bound = _mm_set1_epi16(static_cast<int16_t>(limit));
  const auto* vectors = reinterpret_cast<const __m128i*>(values);
  const __m128i low = _mm_cmpgt_epi16(_mm_loadu_si128(vectors), bound);
  const __m128i high = _mm_cmpgt_epi16(_mm_loadu_si128(vectors + 1), bound);
  const auto mask = static_cast<unsigned>(_mm_movemask_epi8(_mm_packs_epi16(low, high)));
  return static_cast<unsigned>(std::bit_width(mask)) - 1;
}
#else
inline unsigned last_greater(const int16_t* values, int limit) {
  return last_greater_portable(values, limit);
}
#endif

/// Frequencies of up to 256 symbols. All start at 1; a coded symbol's grows by `step`, and when the
/// sum is then greater than `limit` every frequency f becomes (f + 1) / 2. Sums must stay below
/// 2^15.
///
/// cum[s] is the sum of the frequencies of s and all greater symbols, cum[number of symbols] = 0.
/// It is kept as group_[g + 1] + inside_[g][s % 16] with g = s / 16:
///   group_[g]      sum of the groups g, g + 1, ... (so group_[0] is the total); group_[16] = 0
///   inside_[g][k]  sum of the symbols k .. 15 of group g;                       inside_[g][16] = 0
class AdaptiveTable {
 public:
  void reset(unsigned symbols, int step, int limit);
  void set_step(int step) { step_ = static_cast<int16_t>(step); }

  [[nodiscard]] uint32_t total() const { return static_cast<uint32_t>(group_[0]); }

  /// A symbol with its bounds: cum[symbol] = above + frequency, cum[symbol + 1] = above.
  struct Interval {
    uint32_t symbol;
    uint32_t low;   ///< cum[symbol + 1]
    uint32_t high;  ///< cum[symbol]
  };

  /// The symbol with cum[symbol + 1] <= target < cum[symbol]; target < total().
  [[nodiscard]] Interval find(uint32_t target) const {
    const unsigned g = last_greater(group_.data(), static_cast<int>(target));
    const auto base = static_cast<uint32_t>(group_[g + 1]);
    const int16_t* inside = inside_[g].data();
    const unsigned k = last_greater(inside, static_cast<int>(target - base));
    return {g * 16 + k, base + static_cast<uint32_t>(inside[k + 1]),
            base + static_cast<uint32_t>(inside[k])};
  }

  [[nodiscard]] Interval interval(uint32_t symbol) const {
    const unsigned g = symbol / 16;
    const unsigned k = symbol % 16;
    const auto base = static_cast<uint32_t>(group_[g + 1]);
    return {symbol, base + static_cast<uint32_t>(inside_[g][k + 1]),
            base + static_cast<uint32_t>(inside_[g][k])};
  }

  void count(uint32_t symbol) {
    add_to_first(inside_[symbol / 16].data(), symbol % 16, step_);
    add_to_first(group_.data(), symbol / 16, step_);
    if (group_[0] > limit_) halve();
  }

 private:
  /// Adds the step to values[0 .. last]; all 16 are written, so that it takes two vector additions.
  static void add_to_first(int16_t* values, unsigned last, int16_t step) {
    const int16_t* mask = kFirst.data() + (15 - last);
    for (unsigned i = 0; i < 16; ++i)
      values[i] = static_cast<int16_t>(values[i] + (mask[i] & step));
  }
  void halve();

  /// 16 times all ones, then zeros: from element 15 - last on it selects values 0 .. last.
  static constexpr std::array<int16_t, 32> kFirst = [] {
    std::array<int16_t, 32> mask{};
    for (unsigned i = 0; i < 16; ++i) mask[i] = -1;
    return mask;
  }();

  std::array<std::array<int16_t, 17>, 16> inside_;
  std::array<int16_t, 17> group_;
  int16_t step_ = 0;
  int16_t limit_ = 0;
  uint16_t groups_ = 16;  // that hold symbols
};

}  // namespace afx::codec
