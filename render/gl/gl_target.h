// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The samples of a tile, and the pixels that become of them.
#pragma once

#include <cstdint>

#include "render/gl/gl_objects.h"
#include "render/gl/gl_view.h"

namespace afx::render {

/// The longest side of a tile, in samples: 80 MB for its colours and depths, 80 MB more where there
/// are shapes or fog.
inline constexpr uint32_t kMostTileSamples = 2048;

/// Sums of colours and depths, row 0 at the top of the tile; and pixels that can be read back.
class GlTarget {
 public:
  /// Makes room for tiles of that size.
  /// layers   there will be walls or glass
  /// Errors   not_available: the graphics system refused
  Status reserve(uint32_t width, uint32_t height, unsigned samples, bool layers);

  /// Clears the walls and makes ready to draw opaque shapes, with a depth test.
  void begin_walls() const;
  /// Clears the samples and makes ready for the first pass over splats, which finds depths.
  /// walls   they begin with the walls' depths instead
  void begin_depths(bool walls) const;
  /// Goes on with the second pass, which adds colours.
  void begin_colours() const;
  /// Goes on to finish the samples: no depth test. bind_samples() comes before.
  void begin_finish() const;
  /// Goes on with transparent shapes over them, with the depth test of the splats.
  void begin_glass() const;
  /// Makes textures of the samples: unit 0 sums of colours or, when they are finished, colours;
  /// 1 depths.
  void bind_samples(bool finished) const;
  /// Units 2 and 3: depths and colours of walls.
  void bind_walls() const;
  /// Makes the pixels what is drawn into; in the end `read` reads them into their place.
  void begin_pixels(const GlTile& tile, bool depth) const;
  void read(const GlTile& tile, RenderedImage& image) const;

 private:
  Status grow(GLsizei wide, GLsizei high, GLsizei columns, GLsizei rows, bool layers);
  Status make_samples();
  Status make_layers();
  Status make_pixels();

  GLsizei width_ = 0, height_ = 0;  // of the samples
  GlTexture sums_, depths_;
  GlFramebuffer samples_;
  bool layers_ = false;
  GlTexture wall_colours_, wall_depths_, finished_;
  GlFramebuffer walls_, finish_, glass_;
  GLsizei columns_ = 0, rows_ = 0;  // of the pixels
  GlTexture colours_, nearest_;
  GlFramebuffer pixels_;
};

}  // namespace afx::render
