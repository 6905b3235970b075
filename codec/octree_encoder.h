// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Encodes one frame of an OctreeImage stream.
// Source: ISO/IEC 14496-16, OctreeImage (clause not checked); the paper, section V.
#pragma once

#include <cstdint>
#include <vector>

#include "codec/error.h"
#include "codec/octree.h"

namespace afx::codec {

/// Checks that the fields of a frame fit each other and `levels`, and that with `textures` images
/// every index names one.
/// Errors  bad_argument: too few or too many entries in a field, an index greater than `textures`,
/// indices
///         with textures = 0 or none with textures > 0 (the text names field, position and
///         expectation)
Status check_octree_fields(const OctreeFields& fields, unsigned levels, unsigned textures);

/// Appends the frame (without start code) to `out`, up to the next byte boundary.
///
/// levels    octree_levels(octreeResolution), 0..31
/// textures  numOfTextures, 0..127
/// Returns   the exact number of bits of the frame
/// Errors    as check_octree_fields; then nothing is appended
/// Memory    what is appended and less than 1 MB
Result<uint64_t> encode_octree_frame(const OctreeFields& fields, unsigned levels, unsigned textures,
                                     std::vector<uint8_t>& out);

}  // namespace afx::codec
