// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Lays splats into the samples of a tile: first all their depths, then their colours.
#pragma once

#include "render/software/surfel_splats.h"
#include "render/software/tile_samples.h"
#include "render/splats.h"

namespace afx::render {

/// The functions that touch samples, as one kind of processor runs them. All kinds give the same
/// results, bit for bit.
struct SplatPainter {
  /// Whether all samples of the splat's rectangle are nearer than it, by more than its tolerance;
  /// also if it lies beside the tile. Its light is not looked at.
  bool (*is_hidden)(const Splat& splat, const TileSamples& tile);
  /// Lets the depths of the samples that a disc covers sink to its own. Where there are walls it
  /// must lie before them. Returns whether it is seen anywhere so far, if only in the mixture.
  bool (*lay_disc_depth)(const Splat& splat, const Tilt& tilt, TileSamples& tile);
  /// Adds its colour to the samples where it is not farther behind the nearest than its tolerance.
  void (*lay_disc_colour)(const Splat& splat, const Tilt& tilt, TileSamples& tile);
  /// The same for parallelograms.
  bool (*lay_surfel_depth)(const Splat& splat, const Slant& slant, TileSamples& tile);
  void (*lay_surfel_colour)(const Splat& splat, const Slant& slant, TileSamples& tile);

  /// Turns the sums into colours with coverage: premultiplied, the weight 0 or 1. Where no splat
  /// is, the walls.
  void (*finish)(TileSamples& tile);

  /// For any processor.
  static const SplatPainter& plain();
  /// The fastest for this one.
  static const SplatPainter& best();
};

}  // namespace afx::render
