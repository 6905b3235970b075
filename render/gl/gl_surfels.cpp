// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/gl/gl_surfels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <limits>

#include "render/splats.h"

namespace afx::render {
namespace {

/// No vector grows by more than this.
double stretch_of(const glm::dmat3& m) {
  return std::sqrt(glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]));
}

}  // namespace

GlSurfels::GlSurfels(std::shared_ptr<const Surfels> surfels) : surfels_(std::move(surfels)) {
  std::vector<SurfelVertex> vertices;
  blocks_ = make_blocks(*surfels_, vertices);
  vertices_ = GlBuffer::make();
  points_ = GlArray::make();
  quads_ = GlArray::make();
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(SurfelVertex)),
               vertices.data(), GL_STATIC_DRAW);
  glBindVertexArray(points_.id());
  point_at(0, 0);
}

void GlSurfels::point_at(uint32_t first, GLuint divisor) const {
  constexpr GLsizei kStride = sizeof(SurfelVertex);
  const size_t from = size_t{first} * sizeof(SurfelVertex);
  const auto place = [from](size_t at) { return reinterpret_cast<const void*>(from + at); };
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  for (GLuint i = 0; i < 4; ++i) {
    glEnableVertexAttribArray(i);
    glVertexAttribDivisor(i, divisor);
  }
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, kStride, place(offsetof(SurfelVertex, offset)));
  glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, kStride, place(offsetof(SurfelVertex, u)));
  glVertexAttribPointer(2, 3, GL_FLOAT, GL_FALSE, kStride, place(offsetof(SurfelVertex, v)));
  glVertexAttribPointer(3, 3, GL_UNSIGNED_BYTE, GL_TRUE, kStride,
                        place(offsetof(SurfelVertex, colour)));
}

void GlSurfels::bind_quads(uint32_t first) const {
  glBindVertexArray(quads_.id());
  point_at(first, 1);
}

GlSurfelCloud::GlSurfelCloud(const SurfelCloud& cloud, const GlSurfels& surfels, const Lens& lens,
                             const RenderOptions& options)
    : surfels_(surfels),
      lens_(lens),
      scale_(options.splats == SplatKind::points ? 0 : options.splat_scale * kSurfelMargin),
      tolerance_(options.splats == SplatKind::smooth ? kSurfelTolerance : 0),
      axes_(lens.to_view * glm::dmat3(cloud.local_to_world)),
      stretch_(stretch_of(axes_)),
      origin_(lens.to_view * (glm::dvec3(cloud.local_to_world[3]) - lens.position)) {}

double GlSurfelCloud::farthest() const {
  double farthest = 0;
  for (const SurfelBlock& block : surfels_.blocks()) {
    const glm::dvec3 centre = axes_ * block.centre + origin_;
    farthest = std::max(farthest, stretch_ * (block.radius + scale_ * block.reach) - centre.z);
  }
  return farthest;
}

/// A surfel reaches at most s over its centre, at distance d: on the screen s sqrt(1 + x^2 + y^2) /
/// (d - s) at the slopes x, y.
bool GlSurfelCloud::is_large(const SurfelBlock& block, const glm::dvec3& centre,
                             const GlView& view) const {
  const double reach = scale_ * stretch_ * block.reach, ball = stretch_ * block.radius;
  const auto most = static_cast<double>(view.most_point);
  if (!lens_.perspective) return 1.01 * reach * lens_.focal + 2 > most;
  const double nearest = -centre.z - ball - reach;
  if (!(nearest > reach)) return true;
  const double slopes = (std::abs(centre.x) + std::abs(centre.y) + 2 * ball) / nearest;
  return 1.01 * lens_.focal * reach * (1 + slopes) / nearest + 2 > most;
}

void GlSurfelCloud::look(const GlView& view) {
  seen_.clear();
  for (const SurfelBlock& block : surfels_.blocks()) {
    const glm::dvec3 centre = axes_ * block.centre + origin_;
    if (view.touches(centre, stretch_ * (block.radius + scale_ * block.reach)))
      seen_.push_back({&block, centre, is_large(block, centre, view)});
  }
}

void GlSurfelCloud::set_uniforms(const GlProgram& program) const {
  program.set("axes", glm::mat3(axes_));
  program.set("scale", static_cast<float>(scale_));
  program.set("tolerance", static_cast<float>(tolerance_));
}

void GlSurfelCloud::draw_points(const GlProgram& program) const {
  if (seen_.empty()) return;
  set_uniforms(program);
  surfels_.bind_points();
  for (const Seen& seen : seen_) {
    program.set("block", glm::vec3(seen.centre));
    glDrawArrays(GL_POINTS, static_cast<GLint>(seen.block->first),
                 static_cast<GLsizei>(seen.block->count));
  }
}

void GlSurfelCloud::draw_quads(const GlProgram& program) const {
  if (seen_.empty()) return;
  set_uniforms(program);
  for (const Seen& seen : seen_) {
    if (!seen.large) continue;
    program.set("block", glm::vec3(seen.centre));
    surfels_.bind_quads(seen.block->first);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(seen.block->count));
  }
}

}  // namespace afx::render
