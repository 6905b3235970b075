// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Text over the viewer's picture: status, messages, help.
#pragma once

#include <glm/vec2.hpp>
#include <string>

namespace afx::tools {

/// What is to be read.
struct OverlayText {
  std::string status;   ///< lines, upper left; empty: none
  std::string waiting;  ///< in the middle: what is being done before there is a picture
  std::string message;  ///< a line, below
  std::string error;    ///< lines, below, in red
  bool help = false;
};

/// Draws by Dear ImGui into the current OpenGL context; only one at a time.
class Overlay {
 public:
  /// scale   of the screen: 1 on ordinary ones, 2 where text is twice as many pixels high
  explicit Overlay(double scale);
  ~Overlay();
  Overlay(const Overlay&) = delete;
  Overlay& operator=(const Overlay&) = delete;

  void draw(const OverlayText& text, const glm::ivec2& window);

 private:
  void draw_status(const OverlayText& text) const;
  void draw_waiting(const OverlayText& text, const glm::vec2& window) const;
  void draw_bottom(const OverlayText& text, const glm::vec2& window) const;
  void draw_help(const glm::vec2& window) const;

  float scale_;
};

}  // namespace afx::tools
