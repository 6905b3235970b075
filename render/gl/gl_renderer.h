// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Draws with OpenGL.
#pragma once

#include <memory>

#include "render/renderer.h"

namespace afx::render {

/// Draws with OpenGL 3.3 or OpenGL ES 3.0, in the context that was current when it was made, which
/// must be current in each call and when it goes. Draws what every renderer draws (renderer.h).
///
/// A tile of the picture after the other: opaque shapes; of splats in a first pass the nearest
/// depth of each sample, in a second the colours of what lies not far behind it; fog; transparent
/// shapes; the mean of the samples. Shapes are shaded at each sample. Octrees, surfels, geometries
/// and pictures are uploaded once, however many objects share them, also if the next scene has them
/// too. Memory of the graphics system: 12 bytes a voxel, 32 a node above, 40 a surfel, 44 a corner
/// and 4 an index (48 a line or point), 16 / 3 a pixel of a texture, and 84 MB for a tile, 80 MB
/// more where there are shapes or fog.
///
/// Leaves the framebuffer and the viewport as it finds them; of other state nothing is kept.
class GlRenderer : public Renderer {
 public:
  /// Draws into the framebuffer that is bound, as large as the viewport; options.width and height
  /// are not looked at, nor is options.depth. Colours are sRGB, alpha straight.
  /// Errors  those of draw()
  virtual Status present(const Camera& camera, const RenderOptions& options) = 0;
};

/// A renderer for the current context.
/// Errors  not_available: the context lacks something (the text says what)
[[nodiscard]] Result<std::unique_ptr<GlRenderer>> make_gl_renderer(const Limits& limits = {});

}  // namespace afx::render
