// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// From coloured voxels to an OctreeImage: which images, which image for which voxel, what the
// images show.
#pragma once

#include "afx/builder/octree_builder.h"
#include "afx/builder/voxelize.h"

namespace afx {

/// Builds the model and its statistics but for those about the input. Of the options those about
/// images, threads, progress (0.65 to 1 of the whole) and limits count.
/// voxels       at least one
/// levels       of the octree
/// resolution   octreeResolution
BuiltOctree build_model(SurfaceVoxels voxels, unsigned levels, uint32_t resolution,
                        const BuildOptions& options);

}  // namespace afx
