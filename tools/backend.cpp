// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/backend.h"

#include <utility>

#if AFX_HAS_GL
#include "render/gl/egl_context.h"
#include "render/gl/gl_renderer.h"
#endif

namespace afx::tools {
namespace {

#if AFX_HAS_GL
/// A renderer with a context of its own.
class OffscreenGl : public render::Renderer {
 public:
  OffscreenGl(std::unique_ptr<render::EglContext> context,
              std::unique_ptr<render::GlRenderer> renderer)
      : context_(std::move(context)), renderer_(std::move(renderer)) {}

  [[nodiscard]] std::string name() const override { return renderer_->name(); }
  Status set_scene(render::Scene scene) override { return renderer_->set_scene(std::move(scene)); }
  Status draw(const render::Camera& camera, const render::RenderOptions& options,
              render::RenderedImage& image) override {
    return renderer_->draw(camera, options, image);
  }

 private:
  std::unique_ptr<render::EglContext> context_;  // goes after what was made in it
  std::unique_ptr<render::GlRenderer> renderer_;
};

Result<std::unique_ptr<render::Renderer>> make_gl(const Limits& limits) {
  auto context = render::EglContext::make();
  if (!context.ok()) return std::move(context).error();
  auto renderer = render::make_gl_renderer(limits);
  if (!renderer.ok()) return std::move(renderer).error();
  return std::unique_ptr<render::Renderer>(
      std::make_unique<OffscreenGl>(std::move(context).value(), std::move(renderer).value()));
}
#else
Result<std::unique_ptr<render::Renderer>> make_gl(const Limits& /*limits*/) {
  return Error{Errc::not_available, Place::none(), "this build has no OpenGL"};
}
#endif

}  // namespace

Result<std::unique_ptr<render::Renderer>> make_renderer(const std::string& backend,
                                                        const Limits& limits) {
  if (backend == "gl") return make_gl(limits);
  return render::make_software_renderer(limits);
}

}  // namespace afx::tools
