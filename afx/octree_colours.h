// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// From an OctreeImage to coloured voxels: what renderers and exporters of points draw.
// Source: ISO/IEC 14496-16 OctreeImage (clause not checked); the paper, sections IV and VI.
#pragma once

#include <cstdint>
#include <vector>

#include "afx/octree_model.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx {

/// The voxels of one level of an OctreeImage with their colours. The three lists are parallel.
struct ColouredVoxels {
  unsigned level = 0;           ///< the cube of side 1 around the origin is divided 2^level times
  std::vector<uint64_t> codes;  ///< Morton codes (codec/octree_voxels.h), ascending
  std::vector<Rgba8> colours;   ///< sRGB; opaque: the octree alone says what exists, a is 255
  std::vector<uint8_t> images;  ///< k = coloured by images[k-1]; 0 = by none
};

/// Colours the voxels of `level` (level <= octree_levels(model.resolution)).
///
/// At the finest level a voxel takes one pixel of its image: the one its centre falls on, with
/// i = floor(u*w + 1/64), j = floor(v*h + 1/64) counted from the lower left, in double precision. A
/// centre outside takes the nearest edge pixel and is counted in a warning
/// ("voxel_outside_image", one for each image).
///
/// At a coarser level it takes the mean, in linear light, of the pixels that its square (side
/// 2^-level around its projected centre) covers: those it overlaps by more than 1/64 of a pixel.
/// Pixels with alpha 0 are left out unless all have it. Where the square covers no more than one
/// pixel this is the rule above.
///
/// Image 0 is the renderer's choice: octree_image_choice.h. Where the chosen image has no picture,
/// or where there are no images, the voxel is grey, shaded by its normal as if lit from the front,
/// the left and above (voxel_shading.h), so that the shape shows (a stand-in of ours; DIBR itself
/// bakes light into the colours). If images there are, that is counted in a warning ("no_picture").
///
/// threads   0 = all cores; the result is the same for any number
/// Errors    bad_argument: level beyond the model's, an index greater than the number of images or
///           in disagreement with the octree, an image with a field of view that is not > 0, a
///           camera that is not finite or an orientation of length 0, a picture whose samples do
///           not fit its size; limit_exceeded: more voxels or memory than `limits`, or reference
///           cameras so close that the work has no bound; unsupported: level > 21
[[nodiscard]] Result<ColouredVoxels> colour_octree(const OctreeModel& model, unsigned level,
                                                   unsigned threads, const Limits& limits,
                                                   Diagnostics& diagnostics);

}  // namespace afx
