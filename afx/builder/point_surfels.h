// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Point clouds to surfels and back.
#pragma once

#include "afx/builder/mesh.h"
#include "afx/surfels.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx {

/// Half the side of a point's piece, in spacings of the points, so that a point's neighbours across
/// the diagonal of a grid meet it.
inline constexpr double kPointHalfSide = 0.72;

/// Every point becomes a square at its place with the origin added, as large as the points are
/// apart (NearestPoints::spacing) and facing as its normal says. Where there is none, the points
/// around tell (point_normals.h), and it looks away from the middle of the cloud; +z where they do
/// not tell either. Without colours: white.
///
/// threads   0 = all cores; the result is the same for any number
/// Memory    kSurfelBytes a point, and 72 while it works
/// Errors    limit_exceeded: that beyond limits.memory
Result<Surfels> surfels_of(const PointCloud& cloud, unsigned threads, const Limits& limits);

/// The centres as points, with the directions of u x v (of length 1, or zero for pieces without
/// area). The origin is the first centre.
PointCloud points_of(const Surfels& surfels);

}  // namespace afx
