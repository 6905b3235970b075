// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// A mesh as points, to compare it with models (cloud_compare.h) and to see what they cover.
#pragma once

#include <cstddef>

#include "afx/builder/mesh.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx {

struct SurfaceSampling {
  size_t points = 0;     ///< on all of the surface; 0: as `spacing` says
  double spacing = 0;    ///< one point for each square of this side, in units of the mesh
  unsigned threads = 0;  ///< 0 = all cores; the result is the same for any number
  Limits limits = {};
};

/// Points spread evenly by area over the triangles of a mesh, always the same ones: equal steps of
/// area from triangle to triangle, a low-discrepancy sequence inside of each. With the normal of
/// the triangle and, where the mesh has colours, the mean colour around the point. Surface that is
/// transparent (Material::alpha_cutoff) gets none.
///
/// Memory  28 bytes a point twice, 8 a triangle, and what the textures take (texture_sampler.h)
/// Errors  bad_argument: triangles without area or none, all of the surface is transparent, neither
///         points nor a positive spacing; limit_exceeded: more points than limits.memory holds
/// Source  Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018 (R2)
[[nodiscard]] Result<PointCloud> sample_surface(const Mesh& mesh, const SurfaceSampling& sampling);

}  // namespace afx
