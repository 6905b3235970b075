// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <glm/vec3.hpp>

#include "render/scene.h"
#include "render/shading.h"
#include "render/software/shape_tiles.h"

namespace afx::render {

/// What one sees of a shape at a place.
struct Fragment {
  glm::vec3 light;  ///< linear
  float opacity;
};

/// Reckons the colours of shapes. May be used by several threads.
class ShapeShader {
 public:
  /// All must outlive it. n   samples along the side of a pixel
  ShapeShader(const Scene& scene, const ShapeTiles& shapes, const Lens& lens, unsigned n)
      : scene_(scene), shapes_(shapes), lens_(lens), n_(n) {}

  /// The colour of a piece at a place on the screen, without fog.
  [[nodiscard]] Fragment shade(const Piece& piece, double x, double y) const;

 private:
  [[nodiscard]] glm::vec4 texel(const Piece& piece, double x, double y,
                                const glm::dvec3& parts) const;
  [[nodiscard]] glm::vec3 lit(const Piece& piece, const glm::dvec3& parts,
                              const glm::vec3& diffuse) const;

  const Scene& scene_;
  const ShapeTiles& shapes_;
  const Lens& lens_;
  unsigned n_;
};

}  // namespace afx::render
