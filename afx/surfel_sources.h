// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Models to surfels. Source: the paper, section VII.A (point-based representation).
#pragma once

#include <span>

#include "afx/depth_image.h"
#include "afx/dibr_model.h"
#include "afx/octree_model.h"
#include "afx/surfels.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx {

/// Half the side of a voxel's piece, in voxel sides. Neighbours across an edge are sqrt(2) apart,
/// so less than 0.71 would part them; the rest keeps surfaces closed that are seen from the side.
inline constexpr double kVoxelHalfSide = 0.85;

/// Adds a square around a centre with sides of 2 * half.
/// normal   where its outside is, of length 1; +z where it is (0, 0, 0)
void push_square(Surfels& surfels, const glm::dvec3& centre, const glm::vec3& normal, float half,
                 Rgba8 colour);

/// Adds pieces moved by an affine transform. Where it mirrors, u and v are exchanged, so that u x v
/// still points outwards.
void append(const Surfels& from, const glm::dmat4& transform, Surfels& to);

/// Every pixel of the model becomes the piece of surface that its cell covers, in the coordinates
/// of the node, from the lower left, rows upward. It is tilted as the distances of the neighbours
/// on the same surface say (kSurfaceStep in pixel_pieces.h; both sides or the one there is, else
/// frontal). In its own camera it covers its pixel and reaches no neighbour's centre; u points
/// right, v up, u x v to the viewer. Samples of a PointTexture do the same with the nearest sample
/// of each neighbouring pixel; where there are layers, they lie along their surface however steep
/// it is (layer_leaning.h). The last of 2 or 4 components becomes opacity; pixels whose opacity is
/// 0 are left out.
///
/// threads   0 = all cores; the result is the same for any number
/// Errors    those of check_depth_image; limit_exceeded: more than limits.memory / kSurfelBytes
Result<Surfels> surfels_of(const DepthImage& image, unsigned threads, const Limits& limits);

/// Every voxel of the finest level becomes a square (kVoxelHalfSide) with the colour of
/// colour_octree, in the octree's cube, in the order of Morton codes. It faces as surface_normals
/// says (voxel_shading.h; +z where that is zero). Its centre lies on the line through the voxel's
/// in that direction, as high as the mean of its neighbours but inside the voxel: the surface is
/// smoother than the grid, and has no gaps where it is seen from the side.
/// Errors, warnings   those of colour_octree; limit_exceeded as above
Result<Surfels> surfels_of(const OctreeModel& model, unsigned threads, const Limits& limits,
                           Diagnostics& diagnostics);

/// All objects of a scene together, in the world's coordinates.
/// Errors, warnings   as above; bad_argument: a transform that is not finite, or that
/// moves points beyond 1e37
Result<Surfels> surfels_of(std::span<const DibrModel> models, unsigned threads,
                           const Limits& limits, Diagnostics& diagnostics);

}  // namespace afx
