// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What all passes over one tile of a picture share.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/lens.h"
#include "render/renderer.h"

namespace afx::render {

class GlProgram;

/// A rectangle of the picture, in pixels, row 0 at the top.
struct GlTile {
  uint32_t x, y, width, height;
};

/// One tile as a camera sees it.
struct GlView {
  /// All must outlive it.
  /// farthest   distance that nothing that is drawn is beyond, about
  GlView(const Lens& the_lens, const RenderOptions& the_options, double farthest,
         float largest_point);

  void set_tile(const GlTile& to);
  /// Whether something that lies in a ball may touch the tile, also if it is a disc that is as wide
  /// as the ball. May say yes where it is not so.
  [[nodiscard]] bool touches(const glm::dvec3& centre, double radius) const;
  /// Sets the uniforms that the shaders of all splats share. The program must be in use.
  void set_uniforms(const GlProgram& program) const;

  const RenderOptions& options;
  const Lens& lens;
  GlTile tile{};
  glm::dvec2 corner{0};  ///< of the tile, in samples
  glm::dvec2 size{0};    ///< of the tile, in samples
  /// What the depth buffer holds is a distance times this, a power of two, so that it keeps the
  /// distance to the last bit.
  float depth_part;
  float most_point;  ///< the largest radius that a point can have, in samples
};

}  // namespace afx::render
