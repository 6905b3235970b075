// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/frame_drawer.h"

#include <optional>
#include <utility>

namespace afx::tools {

Result<FrameDrawer> FrameDrawer::make(Drawing& drawing, std::unique_ptr<render::Renderer> renderer,
                                      bool mesh_by_itself) {
  if (drawing.is_mesh() && mesh_by_itself) return FrameDrawer(drawing, nullptr);
  FrameDrawer drawer(drawing, std::move(renderer));
  if (Status taken = drawer.take_scene(); !taken.ok()) return taken.error();
  return drawer;
}

Status FrameDrawer::take_scene() {
  auto scene = drawing_->scene();
  if (!scene.ok()) return std::move(scene).error();
  return renderer_->set_scene(std::move(scene).value());
}

Status FrameDrawer::draw(const render::Camera& camera, const render::RenderOptions& options,
                         render::RenderedImage& image) {
  if (renderer_ != nullptr) {
    if (Status shown = show_to(camera); !shown.ok()) return shown;
    return renderer_->draw(camera, options, image);
  }
  auto drawn = drawing_->draw(camera, options);
  if (!drawn.ok()) return drawn.error();
  image = std::move(drawn).value();
  return {};
}

/// What is there to be warned of was said for the first camera.
Status FrameDrawer::show_to(const render::Camera& camera) {
  if (!drawing_->depends_on_viewer()) return {};
  const nodes::Viewer viewer = viewer_of(camera);
  const std::optional<nodes::Viewer>& known = drawing_->viewer();
  if (known && known->position == viewer.position && known->up == viewer.up) return {};
  Diagnostics unheard;
  if (Status shown = drawing_->set_viewer(viewer, unheard); !shown.ok()) return shown;
  return take_scene();
}

std::string FrameDrawer::name() const {
  return renderer_ != nullptr ? renderer_->name() : "software";
}

}  // namespace afx::tools
