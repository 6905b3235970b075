// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/viewer/glfw_window.h"

#include <epoxy/gl.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

namespace afx::tools {
namespace {

/// What GLFW said last, for messages.
std::string glfw_reason() {
  const char* text = nullptr;
  return glfwGetError(&text) != GLFW_NO_ERROR && text != nullptr ? text : "no reason is known";
}

struct SpecialKey {
  int glfw;
  int ours;
};
constexpr SpecialKey kSpecialKeys[] = {
    {GLFW_KEY_ESCAPE, kKeyEscape},  {GLFW_KEY_TAB, kKeyTab},
    {GLFW_KEY_LEFT, kKeyLeft},      {GLFW_KEY_RIGHT, kKeyRight},
    {GLFW_KEY_UP, kKeyUp},          {GLFW_KEY_DOWN, kKeyDown},
    {GLFW_KEY_PAGE_UP, kKeyPageUp}, {GLFW_KEY_PAGE_DOWN, kKeyPageDown},
    {GLFW_KEY_F1, kKeyF1},          {GLFW_KEY_F11, kKeyF11},
    {GLFW_KEY_F12, kKeyF12}};

/// The sign on the key as the user's keyboard has it; on keyboards without Latin letters the one
/// that is there on others.
int our_key(int key, int scancode) {
  for (const SpecialKey& special : kSpecialKeys)
    if (special.glfw == key) return special.ours;
  const char* name = glfwGetKeyName(key, scancode);
  if (name != nullptr && name[0] > ' ' && name[0] <= '~' && name[1] == 0) {
    const char c = name[0];
    return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c;
  }
  if (key >= GLFW_KEY_A && key <= GLFW_KEY_Z) return key - GLFW_KEY_A + 'a';
  if (key >= GLFW_KEY_0 && key <= GLFW_KEY_9) return key - GLFW_KEY_0 + '0';
  return kKeyNone;
}

Modifiers modifiers_of(int mods) {
  return {(mods & GLFW_MOD_SHIFT) != 0, (mods & GLFW_MOD_CONTROL) != 0};
}

Button button_of(int button) {
  if (button == GLFW_MOUSE_BUTTON_LEFT) return Button::left;
  return button == GLFW_MOUSE_BUTTON_RIGHT ? Button::right : Button::middle;
}

GlfwWindow& window_of(GLFWwindow* window) {
  return *static_cast<GlfwWindow*>(glfwGetWindowUserPointer(window));
}

}  // namespace

GlfwLibrary::~GlfwLibrary() {
  if (started_) glfwTerminate();
}

Status GlfwLibrary::start() {
  started_ = glfwInit() == GLFW_TRUE;
  if (started_) return {};
  return Error{
      Errc::not_available, Place::none(),
      "there is no display: " + glfw_reason() + " ('afx render' makes pictures without one)"};
}

GlfwWindow::~GlfwWindow() {
  if (window_ != nullptr) glfwDestroyWindow(window_);
}

Status GlfwWindow::open(uint32_t width, uint32_t height, WindowEvents& events) {
  events_ = &events;
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "afx");
  glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "afx");
  window_ =
      glfwCreateWindow(static_cast<int>(width), static_cast<int>(height), "afx", nullptr, nullptr);
  if (window_ == nullptr) {
    return Error{Errc::not_available, Place::none(),
                 "no window can be opened: " + glfw_reason() + " (expected OpenGL 3.3)"};
  }
  glfwMakeContextCurrent(window_);
  glfwSwapInterval(1);
  glfwSetWindowUserPointer(window_, this);
  listen();
  return {};
}

WindowEvents& GlfwWindow::events_of(GLFWwindow* window) { return *window_of(window).events_; }

void GlfwWindow::listen() {
  glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int scancode, int action, int mods) {
    if (action == GLFW_REPEAT) return;
    const int ours = our_key(key, scancode);
    if (ours != kKeyNone) events_of(w).key(ours, modifiers_of(mods), action == GLFW_PRESS);
  });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int mods) {
    double x = 0, y = 0;
    glfwGetCursorPos(w, &x, &y);
    events_of(w).button(button_of(button), modifiers_of(mods), action == GLFW_PRESS,
                        window_of(w).pixels(x, y));
  });
  glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) {
    events_of(w).move(window_of(w).pixels(x, y));
  });
  glfwSetScrollCallback(window_, [](GLFWwindow* w, double /*dx*/, double dy) {
    double x = 0, y = 0;
    glfwGetCursorPos(w, &x, &y);
    events_of(w).scroll(dy, window_of(w).pixels(x, y));
  });
  glfwSetWindowFocusCallback(window_, [](GLFWwindow* w, int focused) {
    if (focused == GLFW_FALSE) events_of(w).lost_focus();
  });
  glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { events_of(w).damaged(); });
  glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { events_of(w).damaged(); });
  glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** paths) {
    if (count > 0) events_of(w).dropped(paths[count - 1]);
  });
}

glm::dvec2 GlfwWindow::pixels(double x, double y) const {
  glm::ivec2 points(0);
  glfwGetWindowSize(window_, &points.x, &points.y);
  return glm::dvec2(x, y) * glm::dvec2(size()) / glm::max(glm::dvec2(points), glm::dvec2(1));
}

void GlfwWindow::wait(std::optional<double> seconds) {
  if (!seconds) return glfwWaitEvents();
  if (*seconds <= 0) return glfwPollEvents();
  glfwWaitEventsTimeout(*seconds);
}

void GlfwWindow::wake() { glfwPostEmptyEvent(); }
void GlfwWindow::show_painted() { glfwSwapBuffers(window_); }
bool GlfwWindow::wants_to_close() const { return glfwWindowShouldClose(window_) != 0; }

glm::ivec2 GlfwWindow::size() const {
  glm::ivec2 size(0);
  glfwGetFramebufferSize(window_, &size.x, &size.y);
  return size;
}

double GlfwWindow::text_scale() const {
  float x = 1, y = 1;
  glfwGetWindowContentScale(window_, &x, &y);
  return std::max(x, y);
}

void GlfwWindow::set_title(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }

void GlfwWindow::hide() {
  if (window_ != nullptr) glfwHideWindow(window_);
  glfwPollEvents();  // now, not when something else is sent
}

void GlfwWindow::switch_fullscreen() {
  if (glfwGetWindowMonitor(window_) != nullptr) {
    return glfwSetWindowMonitor(window_, nullptr, windowed_.x, windowed_.y, windowed_.z,
                                windowed_.w, GLFW_DONT_CARE);
  }
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  const GLFWvidmode* mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
  if (mode == nullptr) return;
  glfwGetWindowPos(window_, &windowed_.x, &windowed_.y);
  glfwGetWindowSize(window_, &windowed_.z, &windowed_.w);
  glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

}  // namespace afx::tools
