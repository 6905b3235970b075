// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Decodes one frame of an OctreeImage stream.
// Source: ISO/IEC 14496-16, OctreeImage (clause not checked); the paper, section V.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"
#include "codec/octree.h"

namespace afx::codec {

/// What one level of a frame cost. The entry after the last level of nodes is for the voxels.
struct OctreeLevelStats {
  uint64_t nodes = 0;            ///< nodes of the level (voxels in the last entry)
  uint64_t texture_symbols = 0;  ///< coded in the level
  uint64_t end_bit = 0;          ///< bits of the frame used when the level was done
};

struct OctreeFrameOptions {
  unsigned levels = 0;       ///< of the octree: octree_levels(octreeResolution), 0..31
  unsigned textures = 0;     ///< numOfTextures, 0..127
  unsigned stop_level = 32;  ///< decode no further than this level; >= levels: the whole frame
  uint64_t base_byte = 0;    ///< where the frame begins, for the places of errors and warnings
  Limits limits = {};
};

/// A decoded frame, or what is whole of it.
struct OctreeFrame {
  Status status;  ///< ok, or why the frame ends early
  bool usable =
      false;  ///< `fields` hold a model: the one asked for or, after a truncation, a coarser one
  unsigned levels = 0;  ///< of `fields`
  OctreeFields fields;  ///< voxels that the truncated or coarser model leaves undefined have a 0
  std::vector<OctreeLevelStats> stats;  ///< of what was decoded
  uint64_t node_symbols = 0;            ///< decoded
  uint64_t texture_symbols = 0;         ///< decoded
  uint64_t bits = 0;                    ///< of the frame used; where it is whole, its exact length
};

/// Decodes the frame that begins at the first byte of `data` (after its start code); data may go on
/// behind the frame.
///
/// Errors    truncated: the data end inside the frame (the text says at which symbol);
///           limit_exceeded: more nodes than limits.octree_nodes, or fields beyond limits.memory
/// Warnings  octree_childless_node: a node below the root has no children;
///           octree_bad_ending: the code does not end as an encoder leaves it: damage
/// Memory    the fields and less than 1 MB
OctreeFrame decode_octree_frame(std::span<const uint8_t> data, const OctreeFrameOptions& options,
                                Diagnostics& diagnostics);

/// Cuts whole fields of `levels` levels down to the model of `level` levels: the symbols of the
/// levels above it, and a texture symbol 0 for each of its voxels whose image is undefined. level
/// >= levels leaves the fields as they are. The fields must fit each other (octree_voxel_images).
void coarsen_octree(OctreeFields& fields, unsigned levels, unsigned level);

}  // namespace afx::codec
