// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/viewer/gl_backend.h"

#if AFX_HAS_GL
#include "render/gl/gl_renderer.h"
#endif

namespace afx::tools {

#if AFX_HAS_GL

struct GlBackend::Parts {
  std::unique_ptr<render::GlRenderer> renderer;
  std::shared_ptr<const ViewerModel> model;  // the renderer's
};

Status GlBackend::make_ready(const Wanted& wanted) {
  if (parts_->renderer == nullptr) {
    auto made = render::make_gl_renderer();
    if (!made.ok()) return std::move(made).error();
    parts_->renderer = std::move(made).value();
  }
  if (parts_->model == wanted.model) return {};
  parts_->model = nullptr;
  if (Status set = parts_->renderer->set_scene(wanted.model->scene); !set.ok()) return set;
  parts_->model = wanted.model;
  return {};
}

Status GlBackend::present(const Wanted& wanted, unsigned samples) {
  if (Status ready = make_ready(wanted); !ready.ok()) return ready;
  render::RenderOptions options = draw_options(wanted, samples, 1);
  options.background.a = 255;  // nothing is behind the window
  return parts_->renderer->present(wanted.camera, options);
}

Status GlBackend::draw(const Wanted& wanted, unsigned samples, double scale,
                       render::RenderedImage& image) {
  if (Status ready = make_ready(wanted); !ready.ok()) return ready;
  return parts_->renderer->draw(wanted.camera, draw_options(wanted, samples, scale), image);
}

std::string GlBackend::name() const { return parts_->renderer ? parts_->renderer->name() : ""; }

#else

struct GlBackend::Parts {};

Status GlBackend::make_ready(const Wanted& /*wanted*/) {
  return Error{Errc::not_available, Place::none(), "this build has no OpenGL renderer"};
}

Status GlBackend::present(const Wanted& wanted, unsigned /*samples*/) { return make_ready(wanted); }

Status GlBackend::draw(const Wanted& wanted, unsigned /*samples*/, double /*scale*/,
                       render::RenderedImage& /*image*/) {
  return make_ready(wanted);
}

std::string GlBackend::name() const { return {}; }

#endif

GlBackend::GlBackend() : parts_(std::make_unique<Parts>()) {}
GlBackend::~GlBackend() = default;

}  // namespace afx::tools
