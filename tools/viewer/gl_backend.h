// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The one place where the viewer makes and calls the OpenGL renderer.
#pragma once

#include <memory>
#include <string>

#include "tools/viewer/picture_source.h"

namespace afx::tools {

/// The OpenGL renderer in the window's own context, which must be current in all calls.
class GlBackend {
 public:
  GlBackend();
  ~GlBackend();
  GlBackend(const GlBackend&) = delete;
  GlBackend& operator=(const GlBackend&) = delete;

  /// Draws into the window. Errors  not_available: there is no such renderer; those of Renderer
  [[nodiscard]] Status present(const Wanted& wanted, unsigned samples);
  /// Draws into a picture. scale   of width and height
  [[nodiscard]] Status draw(const Wanted& wanted, unsigned samples, double scale,
                            render::RenderedImage& image);
  /// What it is, for people.
  [[nodiscard]] std::string name() const;

 private:
  [[nodiscard]] Status make_ready(const Wanted& wanted);

  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace afx::tools
