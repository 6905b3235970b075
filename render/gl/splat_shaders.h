// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The shaders that draw voxels and surfels. One source each for what the preprocessor makes of it:
//   QUADS     splats too large for a point, as quadrilaterals; otherwise as points
//   COLOUR    the second pass, which adds colours; otherwise the first, which finds depths
//   SIDES     voxels: with a colour for each of six sides
//   DEPTH_IS_GREATER   the depth of a fragment is promised to be not less than the vertex's
// Places are in samples, right and down from the upper left corner of the tile.
#pragma once

#include <string>

namespace afx::render {

/// What both kinds have in common; see GlView::set_uniforms.
std::string splat_vertex_part();
std::string splat_fragment_part();
/// Of the nodes of an octree; see gl_voxels.h for its uniforms.
std::string voxel_vertex_shader();
std::string voxel_fragment_shader();
/// Of surfels; see gl_surfels.h.
std::string surfel_vertex_shader();
std::string surfel_fragment_shader();

}  // namespace afx::render
