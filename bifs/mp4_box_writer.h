// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Part of mp4_writer, not for others.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bifs/mp4_movie.h"

namespace afx::bifs {

/// Appends fields and boxes, big-endian, to bytes.
class Mp4BoxWriter {
 public:
  explicit Mp4BoxWriter(std::vector<uint8_t>& out) : out_(out) {}

  void u(uint64_t value, unsigned bytes) {
    for (unsigned i = bytes; i-- > 0;) out_.push_back(static_cast<uint8_t>(value >> (8 * i)));
  }
  void u8(uint8_t value) { u(value, 1); }
  void u16(uint16_t value) { u(value, 2); }
  void u32(uint32_t value) { u(value, 4); }
  void i16(int16_t value) { u16(static_cast<uint16_t>(value)); }
  void i32(int32_t value) { u32(static_cast<uint32_t>(value)); }
  void zeros(size_t count) { out_.insert(out_.end(), count, 0); }
  void bytes(std::span<const uint8_t> value) {
    out_.insert(out_.end(), value.begin(), value.end());
  }
  void version(uint8_t version, uint32_t flags) {
    u8(version);
    u(flags, 3);
  }
  void matrix(const Mp4Matrix& matrix) {
    for (const int32_t number : matrix) i32(number);
  }
  void box(const Mp4Box& kept) {
    const Scope scope(*this, kept.type);
    bytes(kept.payload);
  }

  /// A box, from here to the end of its life. Its size is cut to 32 bits: who needs more looks at
  /// the size of the whole.
  class Scope {
   public:
    Scope(Mp4BoxWriter& writer, FourCc type) : writer_(writer), begin_(writer.out_.size()) {
      writer_.u32(0);
      writer_.u32(type);
    }
    ~Scope() {
      const auto size = static_cast<uint32_t>(writer_.out_.size() - begin_);
      for (unsigned i = 0; i < 4; ++i) {
        writer_.out_[begin_ + i] = static_cast<uint8_t>(size >> (24 - 8 * i));
      }
    }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    Mp4BoxWriter& writer_;
    size_t begin_;
  };

 private:
  std::vector<uint8_t>& out_;
};

}  // namespace afx::bifs
