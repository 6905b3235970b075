// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <vector>

#include "bifs/descriptor.h"
#include "codec/error.h"

namespace afx::bifs {

/// Writes descriptors one after the other: the mirror of read_descriptors.
///
/// Errors  bad_argument: a number that does not fit its field (the text names it), a URL of more
///         than 255 bytes, a payload of 2^28 bytes or more, an SLConfig whose `fields` do not go
///         with `predefined`, tag 0 or 0xFF, or an UnknownDescriptor with the tag of a known one
Result<std::vector<uint8_t>> write_descriptors(const Descriptors& descriptors);

/// Appends a tag, the length of the payload and the payload, as descriptors and object descriptor
/// commands begin. length_bytes as in Descriptor; more are used where the length needs them.
/// Errors  bad_argument: a payload of 2^28 bytes or more
Status append_tagged(uint8_t tag, uint8_t length_bytes, const std::vector<uint8_t>& payload,
                     std::vector<uint8_t>& out);

}  // namespace afx::bifs
