// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "codec/plain/octree_plain_coder.h"

#include <algorithm>
#include <utility>

namespace afx::codec::plain {
namespace {

constexpr uint32_t kQ1 = 16384;
constexpr uint32_t kQ2 = 32768;
constexpr unsigned kMostSteps = 16;

}  // namespace

void Interval::narrow(uint32_t cum, uint32_t cum_next, uint32_t total) {
  const uint32_t size = length();
  high_ = low_ - 1 + divide(size * cum, total, rules_.high_up);
  low_ = low_ + divide(size * cum_next, total, rules_.low_up);
}

Interval::Step Interval::due() const {
  if (steps_ == kMostSteps) return Step::none;
  if (high_ < kQ2) return Step::lower;
  if (low_ >= kQ2) return Step::upper;
  return low_ >= rules_.middle_from && high_ < rules_.middle_below ? Step::middle : Step::none;
}

uint32_t Interval::taken(Step step) {
  return step == Step::upper ? kQ2 : step == Step::middle ? kQ1 : 0;
}

void Interval::apply(Step step) {
  low_ = 2 * (low_ - taken(step));
  high_ = 2 * (high_ - taken(step)) + 1;
  ++steps_;
}

void Encoder::encode(const Table& table, size_t symbol) {
  uint32_t before = 0;
  for (size_t s = 0; s < symbol; ++s) before += table.frequency[s];
  const uint32_t own = table.frequency[symbol];
  const uint32_t lower = rules_.greater_lower ? table.total - before - own : before;
  at_.narrow(lower + own, lower, table.total);
  at_.begin_symbol();
  for (Interval::Step step; (step = at_.due()) != Interval::Step::none; at_.apply(step)) {
    if (step == Interval::Step::middle) {
      ++pending_;
    } else {
      put(step == Interval::Step::lower ? rules_.lower_bit : rules_.upper_bit);
    }
  }
}

std::vector<bool> Encoder::finish() {
  pending_ += rules_.finish_pending;
  put(at_.low() < rules_.finish_zero_below ? 0 : 1);
  return std::move(bits_);
}

void Encoder::put(unsigned bit) {
  bits_.push_back(bit != 0);
  bits_.insert(bits_.end(), pending_, (bit != 0) != rules_.pending_complement);
  if (rules_.pending_spent) pending_ = 0;
}

Decoder::Decoder(const std::vector<bool>& data, const CoderRules& rules)
    : data_(data), rules_(rules), at_(rules) {
  for (unsigned i = 0; i < rules.code_bits; ++i) code_ = 2 * code_ + bit();
}

size_t Decoder::decode(const Table& table) {
  whole_ += rules_.whole_bits + shifts_ <= data_.size() ? 1 : 0;
  const uint32_t size = std::max(1U, at_.length());
  const uint32_t from_low = code_ - at_.low();
  const uint32_t target = rules_.target_from_code ? from_low * table.total / size
                                                  : ((from_low + 1) * table.total - 1) / size;
  Sums sums{};
  const size_t symbol = find(table, target, sums);
  at_.narrow(sums.cum, sums.cum_next, table.total);
  at_.begin_symbol();
  for (Interval::Step step; (step = at_.due()) != Interval::Step::none; at_.apply(step)) {
    code_ = 2 * (code_ - Interval::taken(step)) + bit();
    ++shifts_;
  }
  ++symbols_;
  return symbol;
}

size_t Decoder::find(const Table& table, uint32_t target, Sums& sums) const {
  size_t symbol = 0;
  const size_t last = table.frequency.size() - 1;
  if (rules_.greater_lower) {
    sums.cum = table.total;
    while (symbol < last && sums.cum - table.frequency[symbol] > target)
      sums.cum -= table.frequency[symbol++];
    sums.cum_next = sums.cum - table.frequency[symbol];
    return symbol;
  }
  while (symbol < last && sums.cum_next + table.frequency[symbol] <= target)
    sums.cum_next += table.frequency[symbol++];
  sums.cum = sums.cum_next + table.frequency[symbol];
  return symbol;
}

bool Decoder::ends_well() const {
  return code_ / kQ1 == (at_.low() < kQ1 ? rules_.ending_low : rules_.ending_high);
}

}  // namespace afx::codec::plain
