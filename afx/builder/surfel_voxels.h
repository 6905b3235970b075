// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Surfels to coloured voxels: the way from any model to an octree.
// Source: the paper, section VII.A (OctreeImage from the point-based representation).
#pragma once

#include "afx/builder/voxelize.h"
#include "afx/surfels.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx {

/// The voxels of pieces of surface, with the mean of their colours in linear light and of their
/// outsides. A piece no longer than a voxel sets the one that its centre lies in; a longer one all
/// that it passes through (as triangles do, voxelize.h). A piece of up to 1.75 voxels that stands
/// across the middle of its voxel was made from one (surfel_sources.h) and sets it alone: so an
/// octree taken to surfels and back in the same cube is the same.
///
/// Left out: pieces with opacity 0, and what lies outside of the cube by more than 1/512 voxel:
/// longer pieces are cut along its sides.
///
/// threads   0 = all cores; the result is the same for any number
/// outside   becomes the number of pieces with opacity that lay outside, wholly or in part; those
///           longer than 256 cubes count as wholly outside
/// Memory    that of voxelize() and 256 bytes for each piece longer than a voxel
/// Errors    those of voxelize()
Result<SurfaceVoxels> voxelize(const Surfels& surfels, const Grid& grid, unsigned threads,
                               const Limits& limits, uint64_t& outside);

}  // namespace afx
