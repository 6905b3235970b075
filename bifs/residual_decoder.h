// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <span>

#include "bifs/frequency_model.h"

namespace afx::bifs {

/// Decodes one arithmetic code of a predictive MF field. It has no mark of its end and is read up
/// to kBitsAhead bits beyond it; bits past the end of the data read as 0.
class ResidualDecoder {
 public:
  /// A code that begins at a bit of data.
  ResidualDecoder(std::span<const uint8_t> data, uint64_t bit)
      : data_(data), begin_(bit), next_(bit) {
    for (int i = 0; i < 16; ++i) offset_ = offset_ << 1 | take();
  }

  /// Decodes a symbol and counts it in the model.
  uint32_t decode(FrequencyModel& model) {
    // offset < range, hence target < total, whatever the data are.
    const uint32_t target = ((offset_ + 1) * model.total() - 1) / interval_.range;
    const FrequencyModel::Interval found = model.find(target);
    const uint32_t before = interval_.low;
    narrow(interval_, found, model.total());
    offset_ -= interval_.low - before;
    const unsigned shifts = interval_.shift().total();
    interval_.renormalise(shifts);
    for (unsigned i = 0; i < shifts; ++i) offset_ = offset_ << 1 | take();
    model.count(found.symbol);
    return found.symbol;
  }

  /// The bits of the code, stuffing included, if it ends behind the last symbol.
  [[nodiscard]] uint64_t bits() const {
    return next_ - begin_ - kBitsAhead - (stuffing_at_ > code_bits() ? 1 : 0);
  }
  /// Whether bits past the end of the data may have had a part in the symbols.
  [[nodiscard]] bool looked_past_end() const { return next_ > uint64_t{data_.size()} * 8; }
  /// Whether every stuffing bit of the code is a 1.
  [[nodiscard]] bool is_stuffed_well() const { return bad_at_ == 0 || bad_at_ > code_bits(); }
  /// Whether the code ends with the two bits that an encoder writes.
  [[nodiscard]] bool ends_well() const {
    return (interval_.low + offset_) / 0x4000 == (interval_.low < 0x4000 ? 1U : 2U);
  }

 private:
  /// Bits of the code without stuffing.
  [[nodiscard]] uint64_t code_bits() const { return taken_ - kBitsAhead; }

  uint32_t raw() {
    const uint64_t at = next_++;
    return at / 8 < data_.size() ? data_[at / 8] >> (7 - at % 8) & 1U : 0;
  }

  /// The next bit of the code without stuffing.
  uint32_t take() {
    ++taken_;
    if (zeros_ == kZerosBeforeStuffing) {
      stuffing_at_ = taken_;
      if (raw() == 0 && bad_at_ == 0) bad_at_ = taken_;
      zeros_ = 0;
    }
    const uint32_t bit = raw();
    zeros_ = bit != 0 ? 0 : zeros_ + 1;
    return bit;
  }

  std::span<const uint8_t> data_;
  uint64_t begin_;  // bits of data
  uint64_t next_;
  uint64_t taken_ = 0;        // bits taken, without stuffing
  uint64_t stuffing_at_ = 0;  // taken_ behind the last stuffing: two never stand within kBitsAhead
  uint64_t bad_at_ = 0;       // taken_ behind the first stuffing that is 0
  unsigned zeros_ = 0;
  codec::ArithmeticInterval interval_;
  uint32_t offset_ = 0;  // code - low
};

}  // namespace afx::bifs
