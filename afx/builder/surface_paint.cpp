// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/surface_paint.h"

#include <cmath>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "afx/srgb.h"

namespace afx {

SurfacePaint::SurfacePaint(const Mesh& mesh) : mesh_(mesh) {
  samplers_.reserve(mesh.textures.size());
  for (const Picture& texture : mesh.textures) samplers_.emplace_back(texture);
}

Paint SurfacePaint::at(size_t triangle, Weights place, double texels) const {
  const double a = 1 - place.b - place.c;
  const glm::uvec3 v = mesh_.triangles[triangle];
  const Material& covering = material(triangle);
  Paint paint{glm::dvec3(covering.colour)};
  if (!mesh_.colours.empty())
    paint.light *= a * glm::dvec3(mesh_.colours[v[0]]) + place.b * glm::dvec3(mesh_.colours[v[1]]) +
                   place.c * glm::dvec3(mesh_.colours[v[2]]);
  if (!is_textured(triangle)) return paint;
  const glm::dvec2 on_texture = a * glm::dvec2(mesh_.texture_coords[v[0]]) +
                                place.b * glm::dvec2(mesh_.texture_coords[v[1]]) +
                                place.c * glm::dvec2(mesh_.texture_coords[v[2]]);
  const glm::vec4 shown =
      samplers_[covering.texture].sample(on_texture, texels, covering.wrap_u, covering.wrap_v);
  paint.light *= glm::dvec3(shown);
  paint.alpha = shown.a;
  return paint;
}

double SurfacePaint::texels(size_t triangle) const {
  if (!is_textured(triangle)) return 0;
  const glm::uvec3 v = mesh_.triangles[triangle];
  const glm::dvec2 p(mesh_.texture_coords[v[0]]), q(mesh_.texture_coords[v[1]]),
      r(mesh_.texture_coords[v[2]]);
  const double doubled = std::abs((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x));
  return 0.5 * doubled * samplers_[material(triangle).texture].texels();
}

}  // namespace afx
