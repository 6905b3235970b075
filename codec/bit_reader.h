// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "codec/bit_window.h"
#include "codec/diagnostics.h"
#include "codec/error.h"

namespace afx::codec {

/// One syntax element as it was read.
struct TraceElement {
  uint64_t bit;           ///< where it begins, from the start of the caller's buffer
  unsigned width;         ///< bits
  std::string_view path;  ///< e.g. "octree_stream/octreeResolution"; valid during the call only
  uint64_t value;
};
using Trace = std::function<void(const TraceElement&)>;

/// Reads bits, most significant first. The first failure sticks: reads after it give 0 and do
/// nothing, so a structure is read to its end and ok() asked once, but always before a value
/// becomes a size, an index or the end of a loop.
class BitReader {
 public:
  /// trace, where given, hears every element; it must live as long as the reader.
  explicit BitReader(std::span<const uint8_t> data, const Trace* trace = nullptr)
      : data_(data), trace_(trace) {}

  /// Reads an unsigned number of `bits` bits, 0..32 (0 reads nothing and gives 0).
  /// Fails with truncated where they are not there.
  uint32_t u(unsigned bits, std::string_view name) {
    assert(bits <= 32);
    if (!ok() || trace_ != nullptr || bits > bits_left()) return u_told(bits, name);
    element_bit_ = bit_;
    bit_ += bits;
    return bits_at(data_, element_bit_, bits);
  }

  /// Fills `out` with bytes, wherever the reader stands in its own. Fails with truncated, and
  /// leaves `out` as it is, where they are not all there.
  void bytes(std::span<uint8_t> out, std::string_view name);

  /// Numbers of one width that follow each other, read without a test and a name for each.
  class Run {
   public:
    /// The next number; not more often than the run is long.
    uint32_t u() {
      const uint64_t at = bit_;
      bit_ += bits_;
      return bits_at(data_, at, bits_);
    }

   private:
    friend class BitReader;
    Run(std::span<const uint8_t> data, uint64_t bit, unsigned bits)
        : data_(data), bit_(bit), bits_(bits) {}
    std::span<const uint8_t> data_;
    uint64_t bit_;
    unsigned bits_;
  };

  /// Takes `count` numbers of `bits` bits each, 0..32; the reader then stands behind them. Only
  /// where has_run().
  Run run(uint64_t count, unsigned bits);
  /// Whether so many numbers can be taken as a run: they are there, and nobody wants to hear of
  /// each.
  [[nodiscard]] bool has_run(uint64_t count, unsigned bits) const {
    return ok() && trace_ == nullptr && (bits == 0 || count <= bits_left() / bits);
  }

  /// Skips to the next byte boundary; bits other than 0 there are a warning (align_bits).
  void align(Diagnostics& diagnostics);

  /// Moves on to a bit offset, e.g. behind a part that another decoder has read; past the end is
  /// the end.
  void seek(uint64_t bit) { bit_ = std::min(bit, uint64_t{data_.size()} * 8); }

  /// Makes the reader fail at the element read last, unless it has failed before.
  void fail(Errc code, std::string text);

  [[nodiscard]] bool ok() const { return !error_.has_value(); }
  [[nodiscard]] const Error& error() const { return *error_; }  ///< only where !ok()
  [[nodiscard]] uint64_t bit() const { return bit_; }
  [[nodiscard]] uint64_t bits_left() const { return uint64_t{data_.size()} * 8 - bit_; }

  /// Names the structure being read, for traces and errors, as long as it lives.
  class Scope {
   public:
    Scope(BitReader& reader, std::string_view name);
    ~Scope() { reader_.path_.resize(before_); }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    BitReader& reader_;
    size_t before_;
  };

 private:
  uint32_t u_told(unsigned bits, std::string_view name);
  void fail_truncated(std::string_view name, const std::string& expected, uint64_t left);

  std::span<const uint8_t> data_;
  const Trace* trace_;
  uint64_t bit_ = 0;
  uint64_t element_bit_ = 0;  // where the element read last begins
  std::string path_;          // "octree_stream/"
  std::optional<Error> error_;
};

}  // namespace afx::codec
