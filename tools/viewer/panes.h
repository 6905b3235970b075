// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What the viewer draws by OpenGL 3.3: the finished picture, and lines over it.
#pragma once

#include <glm/vec2.hpp>
#include <span>

#include "render/renderer.h"
#include "tools/viewer/line_art.h"

namespace afx::tools {

/// A program of a vertex and a fragment shader. All objects here belong to the current context.
class ShaderProgram {
 public:
  ShaderProgram(const char* vertex, const char* fragment);
  ~ShaderProgram();
  ShaderProgram(const ShaderProgram&) = delete;
  ShaderProgram& operator=(const ShaderProgram&) = delete;

  /// Empty, or what the compiler says.
  [[nodiscard]] const std::string& problem() const { return problem_; }
  void use() const;
  [[nodiscard]] int place(const char* uniform) const;

 private:
  unsigned attach(unsigned kind, const char* source);
  unsigned id_;
  std::string problem_;
};

/// The picture, all over the window.
class PicturePane {
 public:
  PicturePane();
  ~PicturePane();
  PicturePane(const PicturePane&) = delete;
  PicturePane& operator=(const PicturePane&) = delete;

  void upload(const render::RenderedImage& image);
  /// A picture of another shape than the window keeps its own, as high as the window. Where it is
  /// transparent a checkerboard shows.
  void draw(const glm::ivec2& window) const;
  /// The texture of the picture's distances, and one that is infinite all over.
  [[nodiscard]] unsigned depths() const { return depths_; }
  [[nodiscard]] unsigned no_depths() const { return no_depths_; }
  [[nodiscard]] const std::string& problem() const { return program_.problem(); }

 private:
  ShaderProgram program_;
  unsigned array_ = 0, picture_ = 0, depths_ = 0, no_depths_ = 0;
  glm::dvec2 size_{0};
};

/// Lines over it; what the picture hides shows faintly.
class LinePane {
 public:
  LinePane();
  ~LinePane();
  LinePane(const LinePane&) = delete;
  LinePane& operator=(const LinePane&) = delete;

  void draw(std::span<const LineVertex> vertices, bool perspective, double width, unsigned depths,
            const glm::ivec2& window) const;
  [[nodiscard]] const std::string& problem() const { return program_.problem(); }

 private:
  ShaderProgram program_;
  unsigned array_ = 0, buffer_ = 0;
};

/// The whole window as it was drawn, before it is shown.
[[nodiscard]] Picture read_window(const glm::ivec2& window);

}  // namespace afx::tools
