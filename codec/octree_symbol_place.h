// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "codec/octree.h"

namespace afx::codec {

/// A symbol of a frame, by its place in its field.
struct OctreeSymbol {
  bool texture = false;  ///< in voxelImageIndex; otherwise in octree
  uint64_t index = 0;
};

/// The bit of a frame at which a symbol is coded: how far the decoder has shifted before it. An
/// arithmetic code has no border between symbols; this one is that of the decoder of the text.
///
/// data       the frame, from its first bit on
/// fields     what it decodes to, whole
/// Returns    nothing where the frame has no such symbol
std::optional<uint64_t> octree_symbol_bit(std::span<const uint8_t> data, const OctreeFields& fields,
                                          unsigned levels, unsigned textures, OctreeSymbol symbol);

}  // namespace afx::codec
