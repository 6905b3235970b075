// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// OpenGL without a window and without a display.
#pragma once

#include <memory>

#include "codec/error.h"

namespace afx::render {

/// An OpenGL context that draws into framebuffer objects only, current in the thread that made it
/// until it goes: desktop OpenGL 3.3 core, or where there is none OpenGL ES 3.0. A context that was
/// current before is not made current again. For that one thread. All renderers (gl_renderer.h)
/// made for it must go first.
///
/// Source  EGL 1.5; EGL_MESA_platform_surfaceless, EGL_EXT_platform_device,
///         EGL_KHR_surfaceless_context
class EglContext {
 public:
  /// Errors  not_available: no libEGL or libGL, no display or context of these kinds (the text says
  ///         what was missing)
  static Result<std::unique_ptr<EglContext>> make();
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

 private:
  EglContext(void* display, void* context) : display_(display), context_(context) {}

  void* display_;  // EGLDisplay
  void* context_;  // EGLContext
};

}  // namespace afx::render
