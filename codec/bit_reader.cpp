// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "codec/bit_reader.h"

#include <cstring>

namespace afx::codec {

BitReader::Scope::Scope(BitReader& reader, std::string_view name)
    : reader_(reader), before_(reader.path_.size()) {
  reader.path_.append(name).push_back('/');
}

/// What u() does not do on its fast way: failures and traces.
uint32_t BitReader::u_told(unsigned bits, std::string_view name) {
  if (!ok()) return 0;
  element_bit_ = bit_;
  if (bits > bits_left()) {
    fail_truncated(name, std::to_string(bits) + " bits", bits_left());
    return 0;
  }
  const uint32_t value = bits_at(data_, bit_, bits);
  bit_ += bits;
  if (trace_ != nullptr) {
    const std::string path = path_ + std::string(name);
    (*trace_)({element_bit_, bits, path, value});
  }
  return value;
}

void BitReader::bytes(std::span<uint8_t> out, std::string_view name) {
  if (!ok() || out.empty()) return;
  if (out.size() > bits_left() / 8) {
    element_bit_ = bit_;
    return fail_truncated(name, std::to_string(out.size()) + " bytes", bits_left() / 8);
  }
  if (!has_run(out.size(), 8)) {
    for (uint8_t& byte : out) byte = static_cast<uint8_t>(u(8, name));
    return;
  }
  const uint64_t begin = bit_;
  Run rest = run(out.size(), 8);
  if (begin % 8 == 0) {
    std::memcpy(out.data(), data_.data() + begin / 8, out.size());
    return;
  }
  for (uint8_t& byte : out) byte = static_cast<uint8_t>(rest.u());
}

BitReader::Run BitReader::run(uint64_t count, unsigned bits) {
  assert(bits <= 32 && has_run(count, bits));
  const uint64_t begin = bit_;
  if (count > 0) element_bit_ = begin + (count - 1) * bits;
  bit_ += count * bits;
  return {data_, begin, bits};
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

void BitReader::fail_truncated(std::string_view name, const std::string& expected, uint64_t left) {
  fail(Errc::truncated, "the data end inside " + path_ + std::string(name) + " (expected " +
                            expected + ", " + std::to_string(left) + " are left)");
}

}  // namespace afx::codec
