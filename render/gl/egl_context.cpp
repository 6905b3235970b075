// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/gl/egl_context.h"

#include <dlfcn.h>
#include <epoxy/egl.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace afx::render {
namespace {

Error missing(const std::string& what) {
  return {Errc::not_available, Place::none(), "no OpenGL: " + what};
}

/// libepoxy ends the process where a library is missing, so they are tried first. They stay loaded.
bool has_library(const char* name) { return dlopen(name, RTLD_LAZY) != nullptr; }

/// Whether a list of words parted by spaces has that word.
bool has_word(const char* list, std::string_view word) {
  std::string_view rest = list == nullptr ? "" : list;
  while (!rest.empty()) {
    const size_t end = std::min(rest.find(' '), rest.size());
    if (rest.substr(0, end) == word) return true;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return false;
}

/// Displays that need no window system, the surfaceless one first, then those of the devices.
EGLDisplay first_display() {
  const char* const client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (!has_word(client, "EGL_EXT_platform_base")) return EGL_NO_DISPLAY;
  EGLint major = 0, minor = 0;
  if (has_word(client, "EGL_MESA_platform_surfaceless")) {
    EGLDisplay display =
        eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display != EGL_NO_DISPLAY && eglInitialize(display, &major, &minor) == EGL_TRUE)
      return display;
  }
  if (!has_word(client, "EGL_EXT_platform_device") ||
      !(has_word(client, "EGL_EXT_device_enumeration") || has_word(client, "EGL_EXT_device_base")))
    return EGL_NO_DISPLAY;
  std::array<EGLDeviceEXT, 16> devices{};
  EGLint count = 0;
  if (eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count) != EGL_TRUE)
    return EGL_NO_DISPLAY;
  for (size_t i = 0; i < static_cast<size_t>(count); ++i) {
    EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr);
    if (display != EGL_NO_DISPLAY && eglInitialize(display, &major, &minor) == EGL_TRUE)
      return display;
  }
  return EGL_NO_DISPLAY;
}

EGLContext make_current(EGLDisplay display, EGLenum api, const EGLint* attributes) {
  if (eglBindAPI(api) != EGL_TRUE) return EGL_NO_CONTEXT;
  EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
  if (context == EGL_NO_CONTEXT) return context;
  if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE) return context;
  eglDestroyContext(display, context);
  return EGL_NO_CONTEXT;
}

EGLContext first_context(EGLDisplay display) {
  constexpr EGLint kDesktop[] = {EGL_CONTEXT_MAJOR_VERSION_KHR,
                                 3,
                                 EGL_CONTEXT_MINOR_VERSION_KHR,
                                 3,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_KHR,
                                 EGL_NONE};
  constexpr EGLint kEs[] = {EGL_CONTEXT_MAJOR_VERSION_KHR, 3, EGL_CONTEXT_MINOR_VERSION_KHR, 0,
                            EGL_NONE};
  EGLContext context = EGL_NO_CONTEXT;
  if (has_library("libOpenGL.so.0") || has_library("libGL.so.1"))
    context = make_current(display, EGL_OPENGL_API, kDesktop);
  if (context == EGL_NO_CONTEXT && has_library("libGLESv2.so.2"))
    context = make_current(display, EGL_OPENGL_ES_API, kEs);
  return context;
}

}  // namespace

Result<std::unique_ptr<EglContext>> EglContext::make() {
  if (!has_library("libEGL.so.1")) return missing("libEGL.so.1 cannot be loaded");
  EGLDisplay display = first_display();
  if (display == EGL_NO_DISPLAY) {
    return missing(
        "EGL has no display without a window system (expected EGL_MESA_platform_surfaceless or "
        "EGL_EXT_platform_device)");
  }
  const char* const extensions = eglQueryString(display, EGL_EXTENSIONS);
  for (const char* need : {"EGL_KHR_surfaceless_context", "EGL_KHR_create_context"})
    if (!has_word(extensions, need)) return missing(std::string("EGL lacks ") + need);
  if (!has_word(extensions, "EGL_KHR_no_config_context") &&
      !has_word(extensions, "EGL_MESA_configless_context"))
    return missing("EGL lacks EGL_KHR_no_config_context");
  EGLContext context = first_context(display);
  if (context == EGL_NO_CONTEXT) {
    return missing(
        "EGL makes no context (expected OpenGL 3.3 core, with libOpenGL.so.0 or libGL.so.1, or "
        "OpenGL ES 3.0, with libGLESv2.so.2)");
  }
  return std::unique_ptr<EglContext>(new EglContext(display, context));
}

// The display stays initialised: others of this process may use it, and it costs much to make.
EglContext::~EglContext() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
}

}  // namespace afx::render
