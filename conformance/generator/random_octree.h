// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include "afx/octree_stream.h"
#include "conformance/generator/choices.h"

namespace afx::conformance {

/// A legal stream of 1 to 4 frames: mostly small, of any number of levels, with and without images;
/// now and then large enough for every stage of the coder. All draws 0: one voxel.
OctreeStream random_octree(Choices& choices);

}  // namespace afx::conformance
