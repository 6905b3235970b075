// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// A plain coder for octree frames, as the text reads: a list of nodes for each level, tables of
// frequencies with a running total that are searched one by one, renormalisation bit by bit. It is
// the truth that the fast coder is tested and measured against, and part of no library.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "codec/octree.h"

namespace afx::codec::plain {

/// The bits of the frame, in bytes, zeros behind. The fields must fit (check_octree_fields).
std::vector<uint8_t> encode_frame(const OctreeFields& fields, unsigned levels, unsigned textures);

struct Frame {
  OctreeFields fields;
  uint64_t bits = 0;       ///< used; of a whole frame its length
  bool truncated = false;  ///< then fields hold the symbols up to the one where it was noticed
  uint64_t whole = 0;      ///< symbols decoded from 16 bits of code that were all there
};

/// Decodes a frame; stops where it is truncated or has more nodes than `most_nodes`.
Frame decode_frame(std::span<const uint8_t> data, unsigned levels, unsigned textures,
                   uint64_t most_nodes);

}  // namespace afx::codec::plain
