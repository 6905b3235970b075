// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "codec/bit_reader.h"

#include <algorithm>
#include <cassert>

namespace afx::codec {

BitReader::Scope::Scope(BitReader& reader, std::string_view name)
    : reader_(reader), before_(reader.path_.size()) {
  reader.path_.append(name).push_back('/');
}

uint32_t BitReader::u(unsigned bits, std::string_view name) {
  assert(bits <= 32);
  if (!ok()) return 0;
  element_bit_ = bit_;
  if (bits > bits_left()) {
    fail(Errc::truncated, "the data end inside " + path_ + std::string(name) + " (expected " +
                              std::to_string(bits) + " bits, " + std::to_string(bits_left()) +
                              " are left)");
    return 0;
  }
  uint64_t value = 0;
  for (uint64_t at = bit_; at < bit_ + bits;) {
    const auto offset = static_cast<unsigned>(at % 8);
    const auto take = static_cast<unsigned>(std::min<uint64_t>(8 - offset, bit_ + bits - at));
    const unsigned byte = data_[at / 8];
    value = value << take | (byte >> (8 - offset - take) & ((1U << take) - 1));
    at += take;
  }
  bit_ += bits;
  if (trace_ != nullptr) {
    const std::string path = path_ + std::string(name);
    (*trace_)({element_bit_, bits, path, value});
  }
  return static_cast<uint32_t>(value);
}

void BitReader::align(Diagnostics& diagnostics) {
  const auto bits = static_cast<unsigned>((8 - bit_ % 8) % 8);
  if (!ok() || bits == 0) return;
  const uint64_t at = bit_;
  if (u(bits, "align") != 0) {
    diagnostics.warn("align_bits", Place::at_bit(at), path_ + "align has bits that are not 0");
  }
}

void BitReader::fail(Errc code, std::string text) {
  if (ok()) error_ = Error{code, Place::at_bit(element_bit_), std::move(text)};
}

}  // namespace afx::codec
