// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// From coloured voxels to an OctreeImage: which images, which image for which voxel, what the
// images show.
#pragma once

#include "afx/builder/octree_builder.h"
#include "afx/builder/voxelize.h"
#include "codec/error.h"

namespace afx {

/// Builds the model and its statistics but for those about the input. Of the options those about
/// images, threads, progress (0.65 to 1 of the whole) and limits count.
/// voxels       at least one
/// levels       of the octree
/// resolution   octreeResolution
/// Errors       limit_exceeded: what the voxels have for six images, the largest picture while it
///              is drawn, or all images together take more than limits.memory
Result<BuiltOctree> build_model(SurfaceVoxels voxels, unsigned levels, uint32_t resolution,
                                const BuildOptions& options);

}  // namespace afx
