// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The samples of a tile, and the pixels that become of them.
#pragma once

#include <cstdint>

#include "render/gl/gl_objects.h"
#include "render/gl/gl_view.h"

namespace afx::render {

/// The longest side of a tile, in samples: 80 MB for its colours and depths.
inline constexpr uint32_t kMostTileSamples = 2048;

/// Sums of colours and depths, row 0 at the top of the tile; and pixels that can be read back.
class GlTarget {
 public:
  /// Makes room for tiles of that size.
  /// Errors  not_available: the graphics system refused
  Status reserve(uint32_t width, uint32_t height, unsigned samples);

  /// Clears the samples and makes ready for the first pass, which finds depths.
  void begin_depths() const;
  /// Goes on with the second pass, which adds colours.
  void begin_colours() const;
  /// Makes the samples textures of units 0 (colours) and 1 (depths).
  void bind_samples() const;
  /// Makes the pixels what is drawn into; in the end `read` reads them into their place.
  void begin_pixels(const GlTile& tile, bool depth) const;
  void read(const GlTile& tile, RenderedImage& image) const;

 private:
  GLsizei width_ = 0, height_ = 0;  // of the samples
  GlTexture sums_, depths_;
  GlFramebuffer samples_;
  GLsizei columns_ = 0, rows_ = 0;  // of the pixels
  GlTexture colours_, nearest_;
  GlFramebuffer pixels_;
};

}  // namespace afx::render
