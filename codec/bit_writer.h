// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cassert>
#include <cstdint>
#include <vector>

namespace afx::codec {

/// Appends bits, most significant first, to a byte vector that starts at a byte boundary. Mirrors
/// BitReader.
class BitWriter {
 public:
  explicit BitWriter(std::vector<uint8_t>& out) : out_(out) {}

  /// Writes `value` in `bits` bits, 0..32; it must fit them.
  void u(uint32_t value, unsigned bits) {
    assert(bits <= 32 && (bits == 32 || value >> bits == 0));
    for (unsigned bit = bits; bit-- > 0;) {
      if (used_ == 0) out_.push_back(0);
      out_.back() = static_cast<uint8_t>(out_.back() | (value >> bit & 1U) << (7 - used_));
      used_ = (used_ + 1) % 8;
    }
  }

  /// Zero bits up to the next byte boundary.
  void align() { used_ = 0; }

 private:
  std::vector<uint8_t>& out_;
  unsigned used_ = 0;  // bits of the last byte
};

}  // namespace afx::codec
