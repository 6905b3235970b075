// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "codec/error.h"
#include "render/renderer.h"
#include "tools/drawing.h"

namespace afx::tools {

/// Draws pictures of one Drawing, which must outlive it and stay as it is. What can be made ready
/// once is.
class FrameDrawer {
 public:
  /// renderer   draws splats; a mesh draws itself
  /// Errors     those of Renderer::set_scene
  static Result<FrameDrawer> make(const Drawing& drawing,
                                  std::unique_ptr<render::Renderer> renderer);

  /// Errors  those of Renderer::draw and Drawing::draw
  Status draw(const render::Camera& camera, const render::RenderOptions& options,
              render::RenderedImage& image);

  /// What draws, for people.
  [[nodiscard]] std::string name() const;

 private:
  FrameDrawer(const Drawing& drawing, std::unique_ptr<render::Renderer> renderer)
      : drawing_(&drawing), renderer_(std::move(renderer)) {}

  const Drawing* drawing_;
  std::unique_ptr<render::Renderer> renderer_;  // null: of a mesh
};

}  // namespace afx::tools
