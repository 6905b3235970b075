// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/software/shape_shader.h"

#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <vector>

namespace afx::render {
namespace {

/// The mean of what the corners of a primitive have, of a list with one for each position.
template <class Value>
Value between(const std::vector<Value>& values, const ShapeView& view, uint32_t primitive,
              const glm::dvec3& parts) {
  Value sum(0);
  const auto count = static_cast<uint32_t>(corners_of(view.geometry->kind));
  for (uint32_t k = 0; k < count; ++k) {
    const auto part = static_cast<typename Value::value_type>(parts[static_cast<int>(k)]);
    sum += part * values[view.corner(primitive, k)];
  }
  return sum;
}

/// How the parts of a triangle's corners change with each sample, to the right or down.
glm::dvec3 change(const Piece& piece, double sum, const glm::dvec3& parts, int axis) {
  const glm::dvec3 values(piece.parts[0][axis], piece.parts[1][axis], piece.parts[2][axis]);
  return (values - parts * (values.x + values.y + values.z)) / sum;
}

}  // namespace

glm::vec4 ShapeShader::texel(const Piece& piece, double x, double y,
                             const glm::dvec3& parts) const {
  const ShapeView& view = shapes_.views()[piece.shape];
  const Look& look = *view.look;
  double sum = 0;
  for (size_t k = 0; k < 3; ++k) sum += value_at(piece.parts[k], x, y);
  const auto& places = view.geometry->texture_coordinates;
  const glm::mat2 turn(look.texture_transform);
  const auto change_of_place = [&](int axis) {
    const glm::dvec3 d = change(piece, sum, parts, axis) * static_cast<double>(n_);
    return turn * between(places, view, piece.primitive, d);
  };
  const glm::vec2 place(look.texture_transform *
                        glm::vec3(between(places, view, piece.primitive, parts), 1));
  const float level = view.texture->level_for(change_of_place(0), change_of_place(1));
  return view.texture->at(place, level, look.repeat_s, look.repeat_t);
}

/// Emissive light and what the surface sends back from all lights; display values.
glm::vec3 ShapeShader::lit(const Piece& piece, const glm::dvec3& parts,
                           const glm::vec3& diffuse) const {
  const ShapeView& view = shapes_.views()[piece.shape];
  const Look& look = *view.look;
  SurfacePoint point;
  point.position = glm::vec3(between(view.corners, view, piece.primitive, parts));
  if (lens_.perspective) point.to_eye = -glm::normalize(point.position);
  const glm::dvec3 normal =
      view.normals * glm::dvec3(between(view.geometry->normals, view, piece.primitive, parts));
  const double length = glm::length(normal);
  point.normal = length > 0 ? glm::vec3(normal / length) : point.to_eye;
  if (piece.back) point.normal = -point.normal;
  const Material material{diffuse, look.specular, look.ambient_intensity, look.shininess};
  glm::vec3 sum = look.emissive;
  if (scene_.headlight) sum += reflected(headlight(), material, point);
  for (const uint32_t light : view.shape->lights)
    sum += reflected(shapes_.lights()[light], material, point);
  return sum;
}

Fragment ShapeShader::shade(const Piece& piece, double x, double y) const {
  const ShapeView& view = shapes_.views()[piece.shape];
  const Geometry& geometry = *view.geometry;
  const glm::dvec3 parts = corner_parts(piece, geometry.kind, x, y);
  glm::vec3 corner(0);
  if (!geometry.colours.empty()) corner = between(geometry.colours, view, piece.primitive, parts);
  glm::vec4 texture(0);
  if (view.texture != nullptr) texture = texel(piece, x, y, parts);
  SurfaceColour surface =
      surface_colour(*view.look, geometry.kind, geometry.colours.empty() ? nullptr : &corner,
                     view.texture != nullptr ? &texture : nullptr,
                     view.texture != nullptr ? view.texture->components() : 0);
  if (view.look->lit && geometry.kind == Geometry::Kind::triangles)
    surface.colour = lit(piece, parts, surface.colour);
  return {linear_light(surface.colour), surface.opacity};
}

}  // namespace afx::render
