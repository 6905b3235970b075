// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "codec/error.h"

namespace afx::bifs {

/// A file of any size, read here and there.
struct Mp4Source {
  uint64_t size = 0;  ///< bytes
  /// Fills `out` with the bytes from `offset` on; they lie within `size`. Its errors (io) are
  /// handed on. Called from one thread at a time.
  std::function<Status(uint64_t offset, std::span<uint8_t> out)> read;
  /// The same bytes where they are, as long as the source lives; empty: they are nowhere.
  std::function<std::span<const uint8_t>(uint64_t offset, uint64_t count)> view = {};
  /// Hears that everything before an offset has been read and may be dropped from memory, though
  /// not for ever; may be empty.
  std::function<void(uint64_t offset)> passed = {};
};

/// Bytes in memory (or mapped there) as a source; they must live as long as it.
Mp4Source mp4_source(std::span<const uint8_t> bytes);

/// Takes the bytes of a file one after the other. Its errors (io) are handed on.
using Mp4Sink = std::function<Status(std::span<const uint8_t>)>;

}  // namespace afx::bifs
