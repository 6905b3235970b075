// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The window of the viewer by GLFW: opens it and hands its events on in the terms of
// viewer_state.h.
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <string>

#include "codec/error.h"
#include "tools/viewer/viewer_keys.h"
#include "tools/viewer/viewer_state.h"

struct GLFWwindow;

namespace afx::tools {

/// Who hears of events. Places are pixels of the framebuffer from its upper left corner.
class WindowEvents {
 public:
  virtual ~WindowEvents() = default;
  virtual void key(int key, const Modifiers& modifiers, bool down) = 0;
  virtual void button(Button button, const Modifiers& modifiers, bool down,
                      const glm::dvec2& at) = 0;
  virtual void move(const glm::dvec2& at) = 0;
  virtual void scroll(double steps, const glm::dvec2& at) = 0;
  virtual void lost_focus() = 0;
  virtual void damaged() = 0;  ///< it must be painted again
  virtual void dropped(const std::string& file) = 0;
};

/// GLFW as long as it is needed. For the main thread.
class GlfwLibrary {
 public:
  GlfwLibrary() = default;
  ~GlfwLibrary();
  GlfwLibrary(const GlfwLibrary&) = delete;
  GlfwLibrary& operator=(const GlfwLibrary&) = delete;
  /// Errors  not_available: there is no display
  [[nodiscard]] Status start();

 private:
  bool started_ = false;
};

/// A window with an OpenGL 3.3 context, which is made current. For the main thread, but wake().
class GlfwWindow {
 public:
  GlfwWindow() = default;
  ~GlfwWindow();
  GlfwWindow(const GlfwWindow&) = delete;
  GlfwWindow& operator=(const GlfwWindow&) = delete;

  /// Errors  not_available: it cannot be opened
  [[nodiscard]] Status open(uint32_t width, uint32_t height, WindowEvents& events);

  /// Waits for events, at most so many seconds, and hands them on.
  void wait(std::optional<double> seconds);
  /// Ends a wait(), from any thread.
  static void wake();
  void show_painted();
  [[nodiscard]] bool wants_to_close() const;
  /// In pixels; 0 where it is hidden.
  [[nodiscard]] glm::ivec2 size() const;
  /// How much larger than usual text is to be.
  [[nodiscard]] double text_scale() const;
  void set_title(const std::string& title);
  void switch_fullscreen();
  void hide();

 private:
  void listen();
  [[nodiscard]] glm::dvec2 pixels(double x, double y) const;
  static WindowEvents& events_of(GLFWwindow* window);

  GLFWwindow* window_ = nullptr;
  WindowEvents* events_ = nullptr;
  glm::ivec4 windowed_{0};  // place and size before it was all over the screen
};

}  // namespace afx::tools
