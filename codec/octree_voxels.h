// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Octree bytes to voxels and back, in linear passes without pointers.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "codec/error.h"
#include "codec/limits.h"
#include "codec/octree.h"

namespace afx::codec {

/// The greatest number of levels whose Morton codes fit 64 bits.
inline constexpr unsigned kMortonLevels = 21;

/// Interleaves: bit 3k of the code is bit k of x, 3k+1 of y, 3k+2 of z. Coordinates < 2^21.
uint64_t morton_code(Voxel voxel);
Voxel morton_decode(uint64_t code);

/// How many nodes each level has: element L for L = 0 (the root: always 1) .. levels (the voxels).
/// Errors  bad_argument: `octree` has too few or too many bytes for its own structure and `levels`;
///         limit_exceeded: more nodes than limits.octree_nodes
Result<std::vector<uint64_t>> octree_level_counts(std::span<const uint8_t> octree, unsigned levels,
                                                  const Limits& limits = {});

/// The voxels of `level` (a node at that level is a voxel of side 2^-level; level <= levels), as
/// Morton codes, ascending, which is the breadth-first order. Eight bytes a voxel, plus three while
/// it works. Errors  as octree_level_counts; unsupported: level > kMortonLevels
Result<std::vector<uint64_t>> octree_morton(std::span<const uint8_t> octree, unsigned levels,
                                            unsigned level, const Limits& limits = {});

/// The same as coordinates, for any number of levels up to 31. Twelve bytes a voxel, plus four
/// while it works.
Result<std::vector<Voxel>> octree_voxels(std::span<const uint8_t> octree, unsigned levels,
                                         unsigned level, const Limits& limits = {});

/// The octree whose voxels are `codes` (Morton codes, ascending, no doubles, < 8^levels). No codes:
/// the empty object, one byte 0 (no byte at all where levels is 0, which has just one voxel).
std::vector<uint8_t> octree_from_morton(std::span<const uint64_t> codes, unsigned levels);

/// For each voxel of `level` in breadth-first order the image that colours it, by the rules of
/// OctreeFields: 0 where it is undefined at that level (also everywhere, if voxel_image_index is
/// empty). Errors  bad_argument: a field has too few or too many entries (the text names it and the
/// place)
Result<std::vector<uint8_t>> octree_voxel_images(const OctreeFields& fields, unsigned levels,
                                                 unsigned level, const Limits& limits = {});

/// The coarsest voxel_image_index for the given octree whose voxels have the images `voxel_images`
/// (one for each voxel, 1..255; 0 = left to the renderer): a subtree whose voxels agree is named
/// once at its top.
std::vector<uint8_t> octree_image_index(std::span<const uint8_t> octree, unsigned levels,
                                        std::span<const uint8_t> voxel_images);

}  // namespace afx::codec
