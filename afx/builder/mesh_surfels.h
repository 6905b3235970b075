// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include "afx/builder/mesh_look.h"
#include "afx/surfels.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx {

/// A mesh as pieces of surface on three grids of lines of sight, those along x, y and z: each
/// triangle is sampled along the axis that it faces most, and along others that it faces at least
/// 0.9 times as much, so that the grids leave no gap where they meet. None is seen at more than 58
/// degrees from its normal. All layers, not only the nearest; colours as MeshLook has them; where
/// triangles touch or overlap both are kept.
///
/// resolution  cells of the grids along the longest side of the mesh, 1..65535. The grid along z
///             is that of view_from(+z) with this resolution: pieces seen along z lie at the
///             centres of its pixels
/// Memory      kSurfelBytes a piece twice
/// Errors      limit_exceeded: more pieces than limits.memory holds
Result<Surfels> surfels_of(const MeshLook& look, uint32_t resolution, unsigned threads,
                           const Limits& limits);

}  // namespace afx
