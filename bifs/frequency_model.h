// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What encoder and decoder of the arithmetic code of predictive MF fields share: the adaptive model
// and the rules of the code. Source: ITU-T H.263 Annex E, as ISO/IEC 14496-11 uses it (clauses not
// checked); spec/bifs.md 10. Where it leaves a choice, see predictive_model.h.
#pragma once

#include <cstdint>
#include <vector>

#include "codec/arithmetic_interval.h"

namespace afx::bifs {

/// Zeros in a row of an arithmetic code before a 1 is stuffed in.
inline constexpr unsigned kZerosBeforeStuffing = 22;
/// Bits that an arithmetic decoder has read beyond those that count.
inline constexpr unsigned kBitsAhead = 14;

/// Frequencies of the symbols 0 .. n-1, n <= 2^13. All start at 1 and a coded symbol's grows by 1;
/// before that, if their sum is 16383, every frequency f becomes (f + 1) / 2. Finding and counting
/// take log2(n) steps.
class FrequencyModel {
 public:
  /// More symbols than this would not fit a sum of 16383 with frequencies of 1.
  static constexpr unsigned kMaxSymbolBits = 13;
  static constexpr uint32_t kMaxTotal = 16383;

  explicit FrequencyModel(uint32_t symbols = 2);

  [[nodiscard]] uint32_t total() const { return total_; }

  /// A symbol and its part of [0, total()); greater symbols lie below.
  struct Interval {
    uint32_t symbol;
    uint32_t low;
    uint32_t high;
  };
  [[nodiscard]] Interval interval(uint32_t symbol) const;
  /// The symbol whose part holds target, target < total().
  [[nodiscard]] Interval find(uint32_t target) const;
  void count(uint32_t symbol);

 private:
  void sum_up();

  std::vector<uint16_t> frequencies_;
  std::vector<uint16_t> sums_;  // [i]: of the (i & -i) symbols before symbol i
  uint32_t total_ = 0;
};

/// Narrows the interval to that of a symbol; total <= 16383.
inline void narrow(codec::ArithmeticInterval& interval, const FrequencyModel::Interval& symbol,
                   uint32_t total) {
  const uint32_t from = interval.range * symbol.low / total;
  interval.low += from;
  interval.range = interval.range * symbol.high / total - from;
}

}  // namespace afx::bifs
