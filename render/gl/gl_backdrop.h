// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <string>

#include "afx/surroundings.h"
#include "render/gl/gl_objects.h"
#include "render/gl/gl_pictures.h"
#include "render/gl/gl_view.h"

namespace afx::render {

/// Reckons what a backdrop shows (render/sky.h): vec3 backdrop_light(vec2), linear, of a place in
/// samples.
std::string backdrop_part();

/// The colours of sky and ground, and the pictures of a backdrop, as one picture sees them.
class GlBackdrop {
 public:
  /// backdrop   null: none. Its pictures are among `pictures`. All must outlive it.
  GlBackdrop(const Backdrop* backdrop, const GlPictures& pictures);

  /// Sets the uniforms of backdrop_part(). The program must be in use.
  void set_uniforms(const GlProgram& program, const GlView& view) const;

 private:
  const Backdrop* backdrop_;
  const GlPictures& pictures_;
  GlTexture colours_;
};

}  // namespace afx::render
