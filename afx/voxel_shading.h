// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// A grey for each voxel that shows the shape of models without pictures.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "afx/octree_model.h"
#include "afx/voxel_blocks.h"

namespace afx {

/// The outward normal of the surface at each voxel, a unit vector or zero. Unlike voxel_normals it
/// does well on shells one voxel thick, whose neighbours do not tell inside from outside: a voxel
/// that is the first one seen along an axis, from either end, counts one step in that direction.
/// The number of voxels of a patch of surface seen along an axis is the patch's area as projected
/// along it, so the mean of the steps over a neighbourhood is its normal.
/// Memory: 24 bytes a voxel and up to 32 MiB.
std::vector<glm::vec3> surface_normals(std::span<const uint64_t> codes, unsigned level,
                                       const VoxelBlocks& blocks, unsigned threads);

/// Grey as if lit from the front, the left and above. Never black, so that the
/// far side shows its shape too; without normal half bright.
Rgba8 shaded_grey(const glm::vec3& normal);

}  // namespace afx
