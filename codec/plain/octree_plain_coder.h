// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The arithmetic coder, bit by bit (section 6). Symbols are searched one by one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "codec/plain/octree_plain_model.h"

namespace afx::codec::plain {

class Interval {
 public:
  explicit Interval(const CoderRules& rules) : rules_(rules), high_(rules.first_high) {}

  [[nodiscard]] uint32_t length() const { return high_ - low_ + rules_.length_beyond; }
  [[nodiscard]] uint32_t low() const { return low_; }
  void narrow(uint32_t cum, uint32_t cum_next, uint32_t total);

  enum class Step { lower, upper, middle, none };
  /// The step of renormalisation that is due. No symbol takes more than 16: broken rules stop here.
  [[nodiscard]] Step due() const;
  /// What the step takes away before everything is doubled.
  static uint32_t taken(Step step);
  void apply(Step step);
  void begin_symbol() { steps_ = 0; }

 private:
  [[nodiscard]] uint32_t divide(uint32_t a, uint32_t b, bool up) const {
    return up || rules_.division_up ? (a + b - 1) / b : a / b;
  }
  const CoderRules& rules_;
  uint32_t low_ = 0;
  uint32_t high_;
  unsigned steps_ = 0;
};

/// Where a symbol lies in a table.
struct Sums {
  uint32_t cum;       ///< its own and of those that lie lower
  uint32_t cum_next;  ///< of those that lie lower
};

class Encoder {
 public:
  explicit Encoder(const CoderRules& rules) : rules_(rules), at_(rules) {}

  void encode(const Table& table, size_t symbol);
  /// The bits of the frame.
  std::vector<bool> finish();

 private:
  void put(unsigned bit);

  const CoderRules& rules_;
  Interval at_;
  uint64_t pending_ = 0;
  std::vector<bool> bits_;
};

class Decoder {
 public:
  /// data: the frame's bits, as far as they are there.
  Decoder(const std::vector<bool>& data, const CoderRules& rules);

  size_t decode(const Table& table);

  /// Whether more bits are used than there are.
  [[nodiscard]] bool truncated() const { return bits() > data_.size(); }
  /// The frame's length, if it ends here.
  [[nodiscard]] uint64_t bits() const {
    return symbols_ == 0 ? rules_.empty_frame_bits : shifts_ + rules_.end_bits;
  }
  /// Symbols that were decoded from code that was all there.
  [[nodiscard]] uint64_t whole() const { return whole_; }
  [[nodiscard]] bool ends_well() const;

 private:
  [[nodiscard]] size_t find(const Table& table, uint32_t target, Sums& sums) const;
  unsigned bit() {
    const uint64_t at = next_++;
    return at < data_.size() ? (data_[at] ? 1 : 0) : rules_.past_end;
  }

  const std::vector<bool>& data_;
  const CoderRules& rules_;
  Interval at_;
  uint32_t code_ = 0;
  uint64_t next_ = 0;
  uint64_t shifts_ = 0;
  uint64_t symbols_ = 0;
  uint64_t whole_ = 0;
};

}  // namespace afx::codec::plain
