// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Surfels in the memory of the graphics system, and how they are drawn.
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "render/gl/gl_objects.h"
#include "render/gl/gl_view.h"
#include "render/gl/surfel_blocks.h"
#include "render/scene.h"

namespace afx::render {

/// One list of surfels, uploaded: 40 bytes each.
class GlSurfels {
 public:
  explicit GlSurfels(std::shared_ptr<const Surfels> surfels);

  [[nodiscard]] const std::shared_ptr<const Surfels>& surfels() const { return surfels_; }
  [[nodiscard]] std::span<const SurfelBlock> blocks() const { return blocks_; }
  void bind_points() const { glBindVertexArray(points_.id()); }
  /// Makes a vertex array current whose instances are the surfels from `first` on.
  void bind_quads(uint32_t first) const;

 private:
  void point_at(uint32_t first, GLuint divisor) const;

  std::shared_ptr<const Surfels> surfels_;
  std::vector<SurfelBlock> blocks_;
  GlBuffer vertices_;
  GlArray points_, quads_;
};

/// One cloud as it is drawn into one tile.
class GlSurfelCloud {
 public:
  /// All must outlive it.
  GlSurfelCloud(const SurfelCloud& cloud, const GlSurfels& surfels, const Lens& lens,
                const RenderOptions& options);

  /// How far away its farthest corner is, about.
  [[nodiscard]] double farthest() const;
  /// Finds what is to be drawn in the view's tile.
  void look(const GlView& view);
  /// Draws with the program in use, whose other uniforms are set.
  void draw_points(const GlProgram& program) const;
  void draw_quads(const GlProgram& program) const;

 private:
  struct Seen {
    const SurfelBlock* block;
    glm::dvec3 centre;  // in the camera's system
    bool large;         // splats may be too large for points
  };
  void set_uniforms(const GlProgram& program) const;
  [[nodiscard]] bool is_large(const SurfelBlock& block, const glm::dvec3& centre,
                              const GlView& view) const;

  const GlSurfels& surfels_;
  const Lens& lens_;
  double scale_;
  double tolerance_;
  glm::dmat3 axes_;
  double stretch_;  // no length grows more by the axes
  glm::dvec3 origin_;
  std::vector<Seen> seen_;
};

}  // namespace afx::render
