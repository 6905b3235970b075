// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The renderer's choice of the image that colours a voxel, where the model leaves it open.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "afx/octree_model.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx {

/// Replaces each 0 of `images` (one entry for each voxel; k = model image k-1) by an image.
///
/// Each image gets a depth buffer of its picture's size (2^level squared, at most 8192 squared,
/// without a picture), into which every voxel draws the square of side 2^-level around its
/// projected centre: the pixels it overlaps by more than 1/64. An image sees a voxel that lies
/// inside the picture and not more than one voxel side (and 1/64, for rounding) behind the buffer
/// at the pixel of its centre. Of those that see it, the image whose direction to the camera is
/// closest to the voxel's normal is taken; without normal, or if none sees it, the one least far
/// behind its buffer; outside comes last. Ties (cosines within 1e-6, depths within 1/64 voxel side)
/// go to the lower index.
///
/// Does nothing if there are no images. Memory: 16 bytes a voxel that is left open and four a pixel
/// of the largest picture.
/// reference   checked (check_reference_images)
/// codes       ascending Morton codes of the voxels of `level`, fewer than 2^32
/// normals     one for each voxel, zero where there is none (voxel_normals)
/// Errors      limit_exceeded: the buffer is beyond `limits`, or the squares of the voxels cover so
///             many pixels that the work has no bound (check_drawable)
[[nodiscard]] Status choose_images(std::span<const ReferenceImage> reference,
                                   std::span<const uint64_t> codes, unsigned level,
                                   std::span<const glm::vec3> normals, std::span<uint8_t> images,
                                   unsigned threads, const Limits& limits);

}  // namespace afx
