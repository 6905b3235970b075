// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>

namespace afx {

/// The largest sizes that input may ask for. Every reader takes one and refuses what is beyond it
/// with Errc::limit_exceeded before the memory is asked for.
struct Limits {
  uint64_t octree_nodes = uint64_t{1} << 28;    ///< nodes and voxels of one octree frame together
  uint64_t memory = uint64_t{2} << 30;          ///< bytes of decoded data that one call may hold
  uint64_t scene_values = uint64_t{1} << 28;    ///< field elements in one scene
  uint32_t scene_depth = 512;                   ///< nesting of nodes and PROTOs in a scene
  uint64_t picture_pixels = uint64_t{1} << 30;  ///< pixels of one picture
  uint64_t file_bytes = uint64_t{8} << 30;      ///< size of a file that is read whole
};

}  // namespace afx
