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
/// Memory: 24 bytes a voxel, and for rows of sight 24 bytes times 4^sight_level: up to 96 MiB.
std::vector<glm::vec3> surface_normals(std::span<const uint64_t> codes, unsigned level,
                                       const VoxelBlocks& blocks, unsigned threads);

/// The level of the grid whose rows are looked along: that of the voxels, but at most 11, and no
/// finer than gives 16 rows for each voxel (65536 rows are always had). Voxels in finer levels
/// share rows.
unsigned sight_level(unsigned level, size_t voxels);

/// How bright a surface with this normal is, in linear light, 0.06..0.65: as if lit from the front,
/// the left and above. Never black, so that the far side shows its shape too; without normal
/// between.
float shade_light(const glm::vec3& normal);

/// A colour under that light, made brighter so that where the surface faces the light it is the
/// colour itself.
Rgba8 shaded_colour(Rgba8 colour, const glm::vec3& normal);

/// A surface that is white under shade_light().
Rgba8 shaded_grey(const glm::vec3& normal);

/// Which of the two a surface becomes: its colour under the light, or grey where it has none.
inline Rgba8 lit(bool coloured, Rgba8 colour, const glm::vec3& normal) {
  return coloured ? shaded_colour(colour, normal) : shaded_grey(normal);
}

}  // namespace afx
