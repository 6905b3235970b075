// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/frame_drawer.h"

#include <utility>

namespace afx::tools {

Result<FrameDrawer> FrameDrawer::make(const Drawing& drawing,
                                      std::unique_ptr<render::Renderer> renderer) {
  if (drawing.is_mesh()) return FrameDrawer(drawing, nullptr);
  if (Status set = renderer->set_scene(drawing.scene()); !set.ok()) return set.error();
  return FrameDrawer(drawing, std::move(renderer));
}

Status FrameDrawer::draw(const render::Camera& camera, const render::RenderOptions& options,
                         render::RenderedImage& image) {
  if (renderer_ != nullptr) return renderer_->draw(camera, options, image);
  auto drawn = drawing_->draw(camera, options);
  if (!drawn.ok()) return drawn.error();
  image = std::move(drawn).value();
  return {};
}

std::string FrameDrawer::name() const {
  return renderer_ != nullptr ? renderer_->name() : "software";
}

}  // namespace afx::tools
