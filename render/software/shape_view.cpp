// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/software/shape_view.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace afx::render {
namespace {

/// The inverse transposed, but for a positive factor; there is one for flat matrices too.
glm::dmat3 normal_matrix(const glm::dmat3& m, bool mirrored) {
  const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]),
                             glm::cross(m[0], m[1]));
  return mirrored ? -cofactors : cofactors;
}

bool is_transparent(const Look& look, const MipPicture* texture) {
  if (texture != nullptr && texture->components() % 2 == 0) return !texture->opaque();
  return look.transparency > 0;
}

}  // namespace

ShapeView::ShapeView(const Shape& the_shape, const Lens& lens, const MipPictures& pictures)
    : shape(&the_shape),
      geometry(shape->geometry.get()),
      look(shape->look.get()),
      texture(geometry->kind == Geometry::Kind::triangles && !geometry->texture_coordinates.empty()
                  ? pictures.find(look->texture.get())
                  : nullptr),
      transparent(is_transparent(*look, texture)),
      axes(lens.to_view * glm::dmat3(shape->to_world)),
      origin(lens.to_view * (glm::dvec3(shape->to_world[3]) - lens.position)) {
  mirrored = glm::dot(axes[0], glm::cross(axes[1], axes[2])) < 0;
  normals = normal_matrix(axes, mirrored);
}

void ShapeView::place_corners(size_t first, size_t count) {
  for (size_t i = first; i < first + count; ++i)
    corners[i] = axes * glm::dvec3(geometry->positions[i]) + origin;
}

}  // namespace afx::render
