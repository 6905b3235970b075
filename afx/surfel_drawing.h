// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Surfels to pictures with depth: how models become SimpleTextures of any camera.
// Source: the paper, section VII.A (SimpleTextures by reprojection).
#pragma once

#include <cstdint>

#include "afx/depth_image.h"
#include "afx/shot.h"
#include "afx/surfels.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx {

/// Draws surfels into a SimpleTexture. A piece is seen in the pixels whose centres it covers, and
/// one that is small (surfel_footprint.h) in that where its own centre falls, as far as it lies
/// between the near and far plane there.
///
/// What is nearest in a pixel is shown, together with pieces not farther behind than a pixel is
/// wide and the piece is long: their colours are averaged in linear light, with weights
///   max(10^-3, min(1, a)) / (d^2 + max(0, 1 - a) + 10^-6),
/// d the distance of a piece's centre from the pixel's in pixels and a the area it takes on the
/// picture. So of pieces as large as pixels the best placed one counts (surfels of a DepthImage
/// give its pixels back in its own camera), and many small ones are averaged. Pieces that face away
/// count only where no other does. The depth is that of the piece whose centre is the nearest in
/// the picture. Pieces without extent count like small ones; with opacity 0: not at all.
///
/// depth_bits  1..16
/// threads     0 = all cores; the result is the same for any number
/// Returns     RGB, or RGBA where there is a piece that is not opaque; black where nothing is seen
/// Errors      bad_argument: those of check_shot, depth_bits;
///             limit_exceeded: limits.picture_pixels, limits.memory, more pixels touched than
///             most_surfel_pixels (surfel_footprint.h)
Result<DepthImage> draw_surfels(const Surfels& surfels, const Shot& shot, unsigned depth_bits,
                                unsigned threads, const Limits& limits);

}  // namespace afx
