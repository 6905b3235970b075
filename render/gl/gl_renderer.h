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
/// A tile of the picture after the other: a first pass finds the nearest depth of each sample, a
/// second adds the colours of what lies not far behind it, a third takes the mean of the samples.
/// Octrees and surfels are uploaded once, however many clouds share them, also if the next scene
/// has them too. Memory of the graphics system: 12 bytes a voxel, 32 a node above, 40 a surfel, and
/// 84 MB for a tile.
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
