// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <vector>

#include "bifs/frequency_model.h"

namespace afx::bifs {

/// Writes one arithmetic code of a predictive MF field: the mirror of ResidualDecoder.
class ResidualEncoder {
 public:
  explicit ResidualEncoder(std::vector<bool>& out) : out_(out) {}

  /// Encodes a symbol and counts it in the model.
  void encode(FrequencyModel& model, uint32_t symbol) {
    narrow(interval_, model.interval(symbol), model.total());
    const codec::ArithmeticInterval::Shift shift = interval_.shift();
    for (unsigned i = 0; i < shift.shared; ++i) settle((interval_.low >> (15 - i) & 1U) != 0);
    pending_ += shift.straddling;
    interval_.renormalise(shift.total());
    model.count(symbol);
  }

  /// Writes the two last bits. Nothing may be encoded after it.
  void finish() {
    ++pending_;
    settle(interval_.low >= 0x4000);
  }

 private:
  /// A bit that low and high share, and the complement of it for each straddling shift since.
  void settle(bool bit) {
    put(bit);
    for (; pending_ > 0; --pending_) put(!bit);
  }

  void put(bool bit) {
    if (zeros_ == kZerosBeforeStuffing) {
      out_.push_back(true);
      zeros_ = 0;
    }
    out_.push_back(bit);
    zeros_ = bit ? 0 : zeros_ + 1;
  }

  std::vector<bool>& out_;
  codec::ArithmeticInterval interval_;
  uint64_t pending_ = 0;  // straddling shifts since the last bit that is settled
  unsigned zeros_ = 0;
};

}  // namespace afx::bifs
