// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "afx/builder/mesh.h"
#include "afx/builder/texture_sampler.h"
#include "afx/octree_model.h"

namespace afx {

/// A colour in linear light times alpha, and alpha.
struct Paint {
  glm::dvec3 light{0, 0, 0};
  double alpha = 1;
};

/// What the surface of a mesh shows: material * vertex colour * texture. The mesh must stay as it
/// is. For use by several threads at once.
class SurfacePaint {
 public:
  explicit SurfacePaint(const Mesh& mesh);

  /// A place on a triangle: its corner 0 has the weight 1 - b - c.
  struct Weights {
    double b, c;
  };

  /// The mean around a place.
  /// texels   the area to take it over
  [[nodiscard]] Paint at(size_t triangle, Weights place, double texels) const;

  /// The texels that a triangle covers, 0 without texture.
  [[nodiscard]] double texels(size_t triangle) const;

  [[nodiscard]] const Material& material(size_t triangle) const {
    return mesh_.materials[mesh_.material_of[triangle]];
  }

 private:
  [[nodiscard]] bool is_textured(size_t triangle) const {
    return material(triangle).texture != Material::kNoTexture && !mesh_.texture_coords.empty();
  }

  const Mesh& mesh_;
  std::vector<TextureSampler> samplers_;
};

}  // namespace afx
