// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <algorithm>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "render/gl/gl_shapes.h"

namespace afx::render {
namespace {

struct Corner {
  glm::vec3 position, colour, normal;
  glm::vec2 place;
};
struct Band {
  glm::vec3 position, colour, other_position, other_colour;
};

void point_at(GLuint number, GLint parts, size_t stride, size_t offset) {
  glEnableVertexAttribArray(number);
  glVertexAttribPointer(number, parts, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                        reinterpret_cast<const void*>(offset));
}

template <class Value>
GlBuffer uploaded(GLenum target, const std::vector<Value>& values) {
  GlBuffer buffer = GlBuffer::make();
  glBindBuffer(target, buffer.id());
  glBufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof(Value)), values.data(),
               GL_STATIC_DRAW);
  return buffer;
}

}  // namespace

GlGeometry::GlGeometry(std::shared_ptr<const Geometry> geometry)
    : geometry_(std::move(geometry)), array_(GlArray::make()) {
  glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
  for (const uint32_t index : geometry_->indices) {
    low = glm::min(low, glm::dvec3(geometry_->positions[index]));
    high = glm::max(high, glm::dvec3(geometry_->positions[index]));
  }
  if (!geometry_->indices.empty()) {
    centre_ = low + (high - low) / 2.0;
    radius_ = glm::length(high - low) / 2;
  }
  glBindVertexArray(array_.id());
  if (is_bands()) {
    upload_bands();
  } else {
    upload_triangles();
  }
  glBindVertexArray(0);
}

void GlGeometry::upload_triangles() {
  const Geometry& g = *geometry_;
  std::vector<Corner> corners(g.positions.size());
  for (size_t i = 0; i < corners.size(); ++i) {
    corners[i].position = g.positions[i];
    corners[i].colour = g.colours.empty() ? glm::vec3(0) : g.colours[i];
    corners[i].normal = g.normals[i];
    corners[i].place = g.texture_coordinates.empty() ? glm::vec2(0) : g.texture_coordinates[i];
  }
  vertices_ = uploaded(GL_ARRAY_BUFFER, corners);
  indices_ = uploaded(GL_ELEMENT_ARRAY_BUFFER, g.indices);
  point_at(0, 3, sizeof(Corner), offsetof(Corner, position));
  point_at(1, 3, sizeof(Corner), offsetof(Corner, colour));
  point_at(2, 3, sizeof(Corner), offsetof(Corner, normal));
  point_at(3, 2, sizeof(Corner), offsetof(Corner, place));
}

void GlGeometry::upload_bands() {
  const Geometry& g = *geometry_;
  const size_t each = corners_of(g.kind);
  const auto colour = [&](uint32_t i) { return g.colours.empty() ? glm::vec3(0) : g.colours[i]; };
  std::vector<Band> bands;
  for (size_t i = 0; i < g.indices.size(); i += each) {
    const uint32_t a = g.indices[i], b = g.indices[i + each - 1];
    bands.push_back({g.positions[a], colour(a), g.positions[b], colour(b)});
  }
  vertices_ = uploaded(GL_ARRAY_BUFFER, bands);
}

void GlGeometry::bind(size_t first) const {
  glBindVertexArray(array_.id());
  if (!is_bands()) return;
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  const size_t from = first * sizeof(Band);
  for (GLuint i = 0; i < 4; ++i) {
    point_at(i, 3, sizeof(Band), from + i * sizeof(glm::vec3));
    glVertexAttribDivisor(i, 1);
  }
}

}  // namespace afx::render
