// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Lays splats into the samples of a tile: first all their depths, then their colours.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "render/software/splat_shapes.h"
#include "render/software/tile_samples.h"

namespace afx::render {

/// Lets the depths of the samples that the shape (splat_shapes.h) covers sink to its own. Where
/// there are walls it must lie before them. Returns whether it is seen anywhere so far, if only in
/// the mixture.
template <class Shape>
bool lay_depth(const Shape& shape, TileSamples& tile);

/// Adds the shape's colour to the samples where it is not farther behind the nearest than its
/// tolerance.
template <class Shape>
void lay_colour(const Shape& shape, TileSamples& tile);

extern template bool lay_depth(const Disc& shape, TileSamples& tile);
extern template bool lay_depth(const Parallelogram& shape, TileSamples& tile);
extern template void lay_colour(const Disc& shape, TileSamples& tile);
extern template void lay_colour(const Parallelogram& shape, TileSamples& tile);

}  // namespace afx::render
