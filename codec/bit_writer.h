// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cassert>
#include <cstdint>
#include <span>
#include <vector>

#include "codec/bit_window.h"

namespace afx::codec {

/// Appends bits, most significant first, to a byte vector that starts at a byte boundary. Mirrors
/// BitReader. After each call the vector holds all bits that were written, those that are missing
/// in its last byte as zeros; after align() others may append to it too.
class BitWriter {
 public:
  explicit BitWriter(std::vector<uint8_t>& out) : out_(out) {}

  /// Writes `value` in `bits` bits, 0..32; it must fit them.
  void u(uint32_t value, unsigned bits) {
    assert(bits <= 32 && (bits == 32 || value >> bits == 0));
    const unsigned free = (8 - used_) % 8;  // bits of the last byte
    used_ = (used_ + bits) % 8;
    if (bits <= free) {
      if (bits > 0) out_.back() = static_cast<uint8_t>(out_.back() | value << (free - bits));
      return;
    }
    unsigned left = bits - free;
    if (free > 0) out_.back() = static_cast<uint8_t>(out_.back() | value >> left);
    for (; left >= 8; left -= 8) out_.push_back(static_cast<uint8_t>(value >> (left - 8)));
    if (left > 0) out_.push_back(static_cast<uint8_t>(value << (8 - left)));
  }

  /// Writes bytes, wherever the writer stands in its own.
  void bytes(std::span<const uint8_t> data) {
    if (used_ == 0) {
      out_.insert(out_.end(), data.begin(), data.end());
      return;
    }
    Run run(*this, data.size(), 8);
    for (const uint8_t byte : data) run.u(byte);
  }

  /// Numbers of one width that follow each other; the memory for them is asked for once. While it
  /// lives nothing else is written; at its end its last bits are.
  class Run {
   public:
    /// count  how many numbers will be written
    /// bits   of each, 0..32
    Run(BitWriter& writer, uint64_t count, unsigned bits) : bits_(bits), held_bits_(writer.used_) {
      std::vector<uint8_t>& out = writer.out_;
      const size_t begin = out.size() - (writer.used_ > 0 ? 1 : 0);
      if (writer.used_ > 0) held_ = out.back() >> (8 - writer.used_);
      const uint64_t end_bit = held_bits_ + count * bits;
      out.resize(begin + (end_bit + 7) / 8);
      at_ = out.data() + begin;
      writer.used_ = static_cast<unsigned>(end_bit % 8);
    }
    Run(const Run&) = delete;
    Run& operator=(const Run&) = delete;
    ~Run() {
      for (; held_bits_ >= 8; held_bits_ -= 8)
        *at_++ = static_cast<uint8_t>(held_ >> (held_bits_ - 8));
      if (held_bits_ > 0) *at_ = static_cast<uint8_t>(held_ << (8 - held_bits_));
    }

    /// The next number; exactly `count` times.
    void u(uint32_t value) {
      assert(bits_ == 32 || value >> bits_ == 0);
      held_ = held_ << bits_ | value;  // at most 31 bits are held before
      held_bits_ += bits_;
      if (held_bits_ < 32) return;
      held_bits_ -= 32;
      store_half_word(at_, static_cast<uint32_t>(held_ >> held_bits_));
      at_ += 4;
    }

   private:
    uint8_t* at_;
    unsigned bits_;
    uint64_t held_ = 0;
    unsigned held_bits_;  // of held_, not stored yet
  };

  /// Zero bits up to the next byte boundary.
  void align() { used_ = 0; }

 private:
  std::vector<uint8_t>& out_;
  unsigned used_ = 0;  // bits of the last byte
};

}  // namespace afx::codec
