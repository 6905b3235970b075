// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/backend.h"

#if AFX_HAS_GL
#include "render/gl/egl_context.h"
#include "render/gl/gl_renderer.h"
#endif

namespace afx::tools {
namespace {

#if AFX_HAS_GL
#error "to be filled in: make an EGL context that the renderer keeps, and a renderer in it"
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
