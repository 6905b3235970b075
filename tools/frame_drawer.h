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

/// Draws pictures of one Drawing, which must outlive it and is read again for each camera if it
/// depends on the viewer. What can be made ready once is.
class FrameDrawer {
 public:
  /// mesh_by_itself   a mesh is drawn by MeshLook, otherwise by the renderer as shapes
  /// Errors           those of Renderer::set_scene and Drawing::scene
  static Result<FrameDrawer> make(Drawing& drawing, std::unique_ptr<render::Renderer> renderer,
                                  bool mesh_by_itself);

  /// Errors  those of Renderer::draw, Drawing::draw and Drawing::set_viewer
  Status draw(const render::Camera& camera, const render::RenderOptions& options,
              render::RenderedImage& image);

  /// What draws, for people.
  [[nodiscard]] std::string name() const;

 private:
  FrameDrawer(Drawing& drawing, std::unique_ptr<render::Renderer> renderer)
      : drawing_(&drawing), renderer_(std::move(renderer)) {}

  Status take_scene();
  Status show_to(const render::Camera& camera);

  Drawing* drawing_;
  std::unique_ptr<render::Renderer> renderer_;  // null: a mesh draws itself
};

}  // namespace afx::tools
