// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The surface that voxels stand for, smoother than their grid.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "afx/voxel_blocks.h"

namespace afx {

/// A piece of surface in each voxel. The lists are parallel to that of the voxels.
struct VoxelSurface {
  std::vector<glm::vec3> normals;  ///< outwards, of length 1; (0, 0, 0) where none is known
  /// How far above the voxel's centre along its normal the surface lies, in voxel sides: as high as
  /// the mean of the centres of the voxel and its neighbours, but inside the voxel. Reckoned in
  /// floats: beyond level 17 or so it is rough.
  std::vector<float> heights;
  /// The number of the voxel that is seen in the place of this one: the next in the direction of
  /// its normal, or the next after that as that one's normal says, if there are any, else itself.
  /// Surfaces are often two voxels thick; the colour of the lower one nobody has seen, and it
  /// should not show where both are drawn.
  std::vector<uint32_t> seen;
};

/// The surface through the voxels given as ascending Morton codes: normals as surface_normals has
/// them (voxel_shading.h).
///
/// level     of the voxels, at most codec::kMortonLevels
/// blocks    of these codes
/// threads   0 = all cores; the result is the same for any number
VoxelSurface voxel_surface(std::span<const uint64_t> codes, unsigned level,
                           const VoxelBlocks& blocks, unsigned threads);

}  // namespace afx
