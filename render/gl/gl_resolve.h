// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// From samples to pixels.
#pragma once

#include "render/gl/gl_backdrop.h"
#include "render/gl/gl_objects.h"
#include "render/gl/gl_view.h"
#include "render/scene.h"

namespace afx::render {

/// Finishes the samples of a tile and draws its pixels.
class GlResolve {
 public:
  /// Errors  as GlProgram::make
  static Result<GlResolve> make(const GlFeatures& features);

  /// Draws finished samples from sums of colours, walls and fog. Samples and walls must be bound,
  /// and the target ready (GlTarget::begin_finish).
  void finish(const GlView& view, const Scene& scene, bool walls) const;
  /// Draws the pixels of a tile from its samples: their mean over the background. Into the current
  /// framebuffer and viewport, which has the size of the tile. The samples must be bound.
  /// x, y       of the viewport's lower left corner
  /// top_first  row 0 is the top of the tile, otherwise its bottom
  /// depth      into the second colour buffer too; -1 where nothing is
  /// finished   the samples are
  void draw(const GlView& view, const GlBackdrop& backdrop, int x, int y, bool top_first,
            bool depth, bool finished) const;

 private:
  GlProgram finish_, colours_, with_depths_;
  GlArray nothing_;
};

}  // namespace afx::render
