// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/frequency_model.h"

#include <algorithm>
#include <bit>
#include <cassert>

namespace afx::bifs {

FrequencyModel::FrequencyModel(uint32_t symbols)
    : frequencies_(symbols, 1), sums_(symbols + size_t{1}), total_(symbols) {
  assert(symbols > 0 && symbols <= 1U << kMaxSymbolBits);
  sum_up();
}

void FrequencyModel::sum_up() {
  std::copy(frequencies_.begin(), frequencies_.end(), sums_.begin() + 1);
  for (size_t i = 1; i < sums_.size(); ++i) {
    const size_t up = i + (i & (~i + 1));
    if (up < sums_.size()) sums_[up] = static_cast<uint16_t>(sums_[up] + sums_[i]);
  }
}

FrequencyModel::Interval FrequencyModel::interval(uint32_t symbol) const {
  uint32_t before = 0;
  for (size_t i = symbol; i > 0; i &= i - 1) before += sums_[i];
  return {symbol, total_ - before - frequencies_[symbol], total_ - before};
}

FrequencyModel::Interval FrequencyModel::find(uint32_t target) const {
  size_t symbol = 0;
  uint32_t before = 0;
  for (size_t step = std::bit_floor(frequencies_.size()); step > 0; step /= 2) {
    const bool inside = symbol + step < sums_.size();
    if (!inside || before + sums_[symbol + step] > total_ - 1 - target) continue;
    symbol += step;
    before += sums_[symbol];
  }
  return {static_cast<uint32_t>(symbol), total_ - before - frequencies_[symbol], total_ - before};
}

void FrequencyModel::count(uint32_t symbol) {
  if (total_ == kMaxTotal) {
    total_ = 0;
    for (uint16_t& frequency : frequencies_) {
      frequency = static_cast<uint16_t>((frequency + 1) / 2);
      total_ += frequency;
    }
    sum_up();
  }
  ++frequencies_[symbol];
  ++total_;
  for (size_t i = size_t{symbol} + 1; i < sums_.size(); i += i & (~i + 1)) ++sums_[i];
}

}  // namespace afx::bifs
