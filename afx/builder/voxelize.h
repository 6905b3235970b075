// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Surfaces and points to coloured voxels.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <vector>

#include "afx/builder/grid.h"
#include "afx/builder/mesh.h"
#include "afx/octree_model.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx {

/// The voxels of a surface. The lists are parallel.
struct SurfaceVoxels {
  std::vector<uint64_t> codes;     ///< Morton codes, ascending
  std::vector<Rgba8> colours;      ///< sRGB, opaque
  std::vector<glm::vec3> normals;  ///< of length 1, or zero where unknown
};

/// The voxels that the triangles of a mesh pass through, exactly (see triangle_cells.h), with the
/// mean colour of the surface inside each. The voxels of a closed mesh enclose its inside: no path
/// from voxel to neighbouring voxel leads in. A voxel that only surface with an alpha_cutoff passes
/// through is set where the mean of alpha over that surface in it reaches the cutoff; transparent
/// parts have no say in colours.
///
/// mesh      as its invariants say
/// threads   0 = all cores; the result is the same for any number
/// done      called with 0..1 as the work goes on, from any thread, one at a time; may be empty
/// Memory    24 bytes a voxel twice, 8 for each triangle in each block of 32 x 32 x 32 voxels
///           that it meets
/// Errors    limit_exceeded: more voxels than limits.octree_nodes, memory beyond limits.memory;
///           bad_argument: all of the surface is transparent
Result<SurfaceVoxels> voxelize(const Mesh& mesh, const Grid& grid, unsigned threads,
                               const Limits& limits, const std::function<void(double)>& done = {});

/// The voxels that points lie in, with the mean of their colours (white without colours) and
/// normals.
///
/// Errors    as for meshes
Result<SurfaceVoxels> voxelize(const PointCloud& cloud, const Grid& grid, const Limits& limits);

}  // namespace afx
