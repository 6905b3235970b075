// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Surfels to layers of depth: how models become PointTextures.
// Source: the paper, section VII.A (PointTexture: points projected, each pixel's depths sorted).
#pragma once

#include <cstdint>

#include "afx/depth_image.h"
#include "afx/shot.h"
#include "afx/surfels.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx {

/// The least bits of depth, 8..16, whose steps over `range` (farPlane - nearPlane) are at most half
/// the side of a pixel: a surface then looks as even from the side as from the front. 16 where no
/// fewer do.
[[nodiscard]] unsigned depth_bits_for(double range, double pixel_side);

/// Puts surfels into a PointTexture, near to far in each pixel, whichever way they face.
///
/// The centre of every piece is a sample of the pixel it falls into; samples of the same depth
/// value become one with the mean of their colours, in linear light. Pieces larger than pixels are
/// samples also of the other pixels whose centres they cover, so that coarse models leave no
/// holes, but only where no other sample lies within a pixel's side before or behind. (So the
/// surfels of a PointTexture give it back in its own camera.) Pieces with opacity 0, and what lies
/// beyond the planes, are left out; other opacities are not kept.
///
/// depth_bits  1..32
/// Memory    16 bytes a sample while it works
/// Errors    bad_argument: those of check_shot, depth_bits; limit_exceeded:
///           limits.picture_pixels, limits.memory, most_surfel_pixels (surfel_footprint.h)
Result<DepthImage> layer_surfels(const Surfels& surfels, const Shot& shot, unsigned depth_bits,
                                 const Limits& limits);

}  // namespace afx
