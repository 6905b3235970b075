// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What kind of picture a file is and how large, from its first bytes: enough to put it into an MP4
// file, without decoding it. Sources: PNG (ISO/IEC 15948), JPEG (ITU-T T.81), JPEG 2000 (ISO/IEC
// 15444-1); clauses not checked.
#pragma once

#include <cstdint>
#include <span>

#include "codec/error.h"

namespace afx {

struct PictureHeader {
  uint8_t object_type = 0;  ///< bifs::object_type::kPng, kJpeg or kJpeg2000
  uint32_t width = 0;       ///< pixels, not 0
  uint32_t height = 0;      ///< likewise
  bool operator==(const PictureHeader&) const = default;
};

/// The object type of a PNG, JPEG or JPEG 2000 (JP2) file by its first bytes; 0 for others.
uint8_t still_picture_type(std::span<const uint8_t> bytes);

/// Reads IHDR of PNG, the frame header of JPEG, 'ihdr' of JP2. Places count from the start of
/// `bytes`.
/// Errors  unsupported: none of these, or a JPEG that says its height later; truncated: ends before
///         the size; malformed: no size, or a width or height of 0
Result<PictureHeader> read_picture_header(std::span<const uint8_t> bytes);

}  // namespace afx
