// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <vector>

#include "afx/builder/mesh.h"

namespace afx {

/// Points as a binary PLY file (little endian), as read_ply_points() reads it: x y z with the
/// origin added, in double precision where there is one, else in single precision; nx ny nz where
/// there are normals; red green blue (8 bits, sRGB) where there are colours. Alpha is not written.
/// The same points give the same bytes.
std::vector<uint8_t> write_ply_points(const PointCloud& cloud);

}  // namespace afx
