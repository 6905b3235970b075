// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// How the samples of a PointTexture lean where its surfaces are steep.
#pragma once

#include "afx/layer_samples.h"
#include "afx/pixel_pieces.h"
#include "afx/surfels.h"

namespace afx {

/// Lays the pieces of samples along the surface where there are several samples in a pixel or one
/// next to it: steep surfaces have one for each pixel side of depth, and differences between
/// pixels do not tell how they lean.
///
/// A sample's surface are the samples of its pixel and the eight around that are linked to it: in
/// one pixel without a gap of more than 1.25 pixel sides (and one step of the depths, for
/// rounding), from its pixel to others from near enough for slopes of 55 degrees, and up to
/// kSurfaceStep from it in depth. The piece lies in the plane that fits them best and is as large
/// as a cell of 1.64 pixel sides on the grid along the axis that this plane faces most; u x v is on
/// the viewer's side. On steep planes its centre moves to the plane, by less than half a pixel and
/// without change of distance: across the line of sight a sample is only known up to its pixel. In
/// its own camera a piece stays in its pixel and covers no other's centre. A sample whose surface
/// is a line or a point keeps its piece.
///
/// threads   0 = all cores; the result is the same for any number
/// surfels   a piece for each sample, in the samples' order
void lean_along_layers(const PixelGrid& grid, const LayerSamples& samples, unsigned threads,
                       Surfels& surfels);

}  // namespace afx
