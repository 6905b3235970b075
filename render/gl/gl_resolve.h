// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// From samples to pixels.
#pragma once

#include "render/gl/gl_objects.h"
#include "render/gl/gl_view.h"

namespace afx::render {

/// Draws the pixels of a tile from its samples: their mean over the background.
class GlResolve {
 public:
  /// Errors  as GlProgram::make
  static Result<GlResolve> make(const GlFeatures& features);

  /// Draws into the current framebuffer and viewport, which has the size of the tile. The samples
  /// must be bound (GlTarget::bind_samples).
  /// x, y      of the viewport's lower left corner
  /// top_first row 0 is the top of the tile, otherwise its bottom
  /// depth     into the second colour buffer too; -1 where nothing is
  void draw(const GlView& view, int x, int y, bool top_first, bool depth) const;

 private:
  GlProgram colours_, with_depths_;
  GlArray nothing_;
};

}  // namespace afx::render
