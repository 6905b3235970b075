// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Lays splats into the samples of a tile: first all their depths, then their colours.
#pragma once

#include <cstdint>

#include "render/octree_view.h"
#include "render/software/surfel_splats.h"
#include "render/software/tile_samples.h"
#include "render/splats.h"

namespace afx::render {

/// The samples of a tile in the rectangle that holds a splat: [x0, x1) and [y0, y1).
struct Rectangle {
  float x, y;  ///< the splat's place; sample k of the tile has its centre at k + 1/2, here at k
  int x0, x1, y0, y1;
};

/// Those of eight discs.
struct EightRectangles {
  float x[8], y[8];
  int32_t x0[8], x1[8], y0[8], y1[8];
  uint32_t filled;  ///< bit i: there are samples in rectangle i

  [[nodiscard]] Rectangle at(unsigned i) const { return {x[i], y[i], x0[i], x1[i], y0[i], y1[i]}; }
};

/// A disc as it lies in a tile.
struct TileDisc {
  Splat splat;
  Tilt tilt;
  Rectangle box;
};

/// The functions that touch samples, as one kind of processor runs them. All kinds give the same
/// results, bit for bit.
struct SplatPainter {
  /// Whether all samples of a tile in a square around (x, y), in samples from the corner of the
  /// picture, are nearer than `depth`; also if it lies beside the tile.
  bool (*is_hidden)(float x, float y, float reach, float depth, const TileSamples& tile);
  /// Where discs lie in a tile.
  void (*place)(const EightDiscs& discs, const TileSamples& tile, EightRectangles& out);
  /// Lets the depths of the samples that a disc covers sink to its own. Where there are walls it
  /// must lie before them. Returns whether it is seen anywhere so far, if only in the mixture.
  bool (*lay_disc_depth)(const TileDisc& disc, TileSamples& tile);
  /// Adds its colour to the samples where it is not farther behind the nearest than its tolerance.
  void (*lay_disc_colour)(const TileDisc& disc, TileSamples& tile);
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
