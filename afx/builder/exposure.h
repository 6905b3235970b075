// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "codec/octree.h"

namespace afx {

/// Which voxels somebody outside can see: those with a cell at one of their six sides from which
/// one of the 26 directions (to sides, edges and corners) leads out of the object. The inner layers
/// of a slanting surface and what a closed surface encloses are not seen.
///
/// coordinates   each < 2^levels, levels <= 12
/// Returns       1 or 0 for each voxel
/// Memory        16 * 4^levels bytes for each thread, up to four
std::vector<uint8_t> exposed_voxels(std::span<const Voxel> coordinates, unsigned levels,
                                    unsigned threads);

}  // namespace afx
