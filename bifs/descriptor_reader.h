// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "bifs/descriptor.h"
#include "codec/bit_reader.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx::bifs {

/// Descriptors stand at most this deep in each other (an ordinary stream needs four).
constexpr unsigned kMaxDescriptorDepth = 16;

struct DescriptorReadOptions {
  Limits limits = {};                   ///< `memory` bounds what the descriptors may take
  const codec::Trace* trace = nullptr;  ///< hears every element
  size_t begin = 0;                     ///< the byte of `data` where reading begins
  std::string path = {};                ///< what the descriptors are in, for texts; "" or "name"
};

/// Reads descriptors one after the other to the end of `data`. Places count from the start of
/// `data`. Written again (descriptor_writer.h) they give the same bytes, unless there was a
/// warning.
///
/// Errors    truncated: a descriptor does not end within what it is in, or a field does not;
///           malformed: tag 0 or 0xFF (forbidden), a length of more than 4 bytes, an SLConfig with
///           field widths beyond the allowed ones;
///           limit_exceeded: deeper than kMaxDescriptorDepth, more than limits.memory
/// Warnings  reserved_bits; trailing_bytes: bytes behind the last field of a descriptor (dropped)
Result<Descriptors> read_descriptors(std::span<const uint8_t> data,
                                     const DescriptorReadOptions& options,
                                     Diagnostics& diagnostics);

}  // namespace afx::bifs
