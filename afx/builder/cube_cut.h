// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What of a model lies in a cube.
#pragma once

#include <cstdint>

#include "afx/builder/grid.h"
#include "afx/builder/mesh.h"

namespace afx {

/// The part of a mesh that lies in a cube: triangles that reach outside are cut along its sides.
/// outside   becomes the number of triangles that lay outside, wholly or in part
Mesh inside_of_cube(const Mesh& mesh, const Cube& cube, uint64_t& outside);

/// The points that a grid holds; the origin is left as it is.
/// outside   becomes the number of the others
PointCloud inside_of_cube(const PointCloud& cloud, const Grid& grid, uint64_t& outside);

}  // namespace afx
