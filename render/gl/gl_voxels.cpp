// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/gl/gl_voxels.h"

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include "codec/octree_voxels.h"

namespace afx::render {
namespace {

constexpr GLuint kSides = 6;
constexpr uint64_t kCellBytes = 8;         // of a vertex: three coordinates of 21 bits
constexpr GLuint kNormal = 7, kShift = 8;  // where a vertex has its facet, after cell and colours

const void* offset_of(uint64_t bytes) { return reinterpret_cast<const void*>(bytes); }

std::vector<uint64_t> cells_of(const VoxelTree& tree, unsigned level) {
  std::vector<uint64_t> cells = tree.codes(level);
  for (uint64_t& cell : cells) {
    const Voxel v = codec::morton_decode(cell);
    cell = v.x | uint64_t{v.y} << 21 | uint64_t{v.z} << 42;
  }
  return cells;
}

void upload(GlBuffer& buffer, const void* data, uint64_t bytes) {
  buffer = GlBuffer::make();
  glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), data, GL_STATIC_DRAW);
}

float bounded(double value) { return static_cast<float>(std::clamp(value, -3e38, 3e38)); }

/// A cell of a level, its centre and the steps from cell to cell in the camera's system.
struct Anchor {
  glm::ivec3 cell;
  glm::dvec3 centre;
};

/// The cell that the eye is in, or the nearest of the cube.
Anchor anchor_of(const glm::dmat3& cube, const glm::dvec3& root, int level) {
  const double cells = std::ldexp(1.0, level);
  glm::dvec3 at = (glm::inverse(cube) * -root + 0.5) * cells;
  for (int k = 0; k < 3; ++k)  // of a flat cube there is no inverse
    at[k] = std::isfinite(at[k]) ? std::clamp(std::floor(at[k]), 0.0, cells - 1) : 0;
  return {glm::ivec3(at), root + cube * ((at + 0.5) / cells - 0.5)};
}

}  // namespace

uint64_t GlTree::bytes(const VoxelTree& tree) {
  constexpr uint64_t kPlace = kCellBytes + sizeof(VoxelTree::Facet);
  uint64_t bytes = tree.voxels() * (kPlace + sizeof(Rgba8));
  for (unsigned level = 0; level < tree.level(); ++level)
    bytes += tree.nodes(level) * (kPlace + sizeof(VoxelTree::Sides));
  return bytes;
}

GlTree::Level& GlTree::uploaded(unsigned number) {
  Level& level = levels_[number];
  if (level.cells) return level;
  const std::vector<uint64_t> cells = cells_of(*tree_, number);
  upload(level.cells, cells.data(), cells.size() * kCellBytes);
  if (number == tree_->level()) {
    upload(level.colours, tree_->colours().data(), tree_->colours().size_bytes());
  } else {
    upload(level.colours, tree_->sides(number).data(), tree_->sides(number).size_bytes());
  }
  upload(level.facets, tree_->facets(number).data(), tree_->facets(number).size_bytes());
  level.points = GlArray::make();
  level.quads = GlArray::make();
  glBindVertexArray(level.points.id());
  point_at(level, number < tree_->level(), 0, 0);
  return level;
}

/// Cells are x and y in the low, y and z in the high 32 bits: the memory of a little-endian machine
/// holds them in the order in which the shader takes them.
void GlTree::point_at(const Level& level, bool sides, int32_t first, GLuint divisor) const {
  const auto from = static_cast<uint64_t>(first);
  glBindBuffer(GL_ARRAY_BUFFER, level.cells.id());
  glEnableVertexAttribArray(0);
  glVertexAttribDivisor(0, divisor);
  glVertexAttribIPointer(0, 2, GL_UNSIGNED_INT, kCellBytes, offset_of(from * kCellBytes));
  glBindBuffer(GL_ARRAY_BUFFER, level.facets.id());
  for (const GLuint place : {kNormal, kShift}) {
    constexpr GLsizei kStride = sizeof(VoxelTree::Facet);
    glEnableVertexAttribArray(place);
    glVertexAttribDivisor(place, divisor);
    glVertexAttribPointer(place, 3, GL_BYTE, GL_FALSE, kStride,
                          offset_of(from * kStride + (place == kShift ? 3 : 0)));
  }
  glBindBuffer(GL_ARRAY_BUFFER, level.colours.id());
  const GLuint colours = sides ? kSides : 1;
  const uint64_t stride = colours * sizeof(Rgba8);
  for (GLuint i = 0; i < colours; ++i) {
    glEnableVertexAttribArray(1 + i);
    glVertexAttribDivisor(1 + i, divisor);
    glVertexAttribPointer(1 + i, 3, GL_UNSIGNED_BYTE, GL_TRUE, static_cast<GLsizei>(stride),
                          offset_of(from * stride + i * sizeof(Rgba8)));
  }
}

void GlTree::bind_points(unsigned level) { glBindVertexArray(uploaded(level).points.id()); }

void GlTree::bind_quads(unsigned number, int32_t first) {
  const Level& level = uploaded(number);
  glBindVertexArray(level.quads.id());
  point_at(level, number < tree_->level(), first, 1);
}

void GlVoxelCloud::set_uniforms(const GlProgram& program, unsigned level) const {
  const OctreeView::Size& size = octree_.size(level);
  const glm::dmat3 axes(size.offsets[1] - size.offsets[0], size.offsets[2] - size.offsets[0],
                        size.offsets[4] - size.offsets[0]);
  const glm::dmat3 cube = axes * std::ldexp(1.0, static_cast<int>(level));
  constexpr const char* kAnchors[] = {"anchor0", "anchor1", "anchor2"};
  constexpr const char* kCentres[] = {"centre0", "centre1", "centre2"};
  for (int up = 0; up < 3; ++up) {
    const Anchor anchor =
        anchor_of(cube, octree_.root(), std::max(static_cast<int>(level) - up, 0));
    program.set(kAnchors[up], anchor.cell);
    program.set(kCentres[up], glm::vec3(anchor.centre));
  }
  const glm::dvec3* d = size.diagonals;
  program.set("axes", glm::mat3(axes));
  program.set("diagonals", glm::mat3(glm::dmat3(d[0], d[1], d[2])));
  program.set("diagonal3", glm::vec3(d[3]));
  program.set("reach", static_cast<float>(size.reach));
  program.set("half_depth", static_cast<float>(size.half_depth));
  program.set("flat_radius", static_cast<float>(size.flat_radius));
  program.set("bulge", size.bulge);
  program.set("tolerance", size.tolerance);
  program.set("scale", options_.splats == SplatKind::points
                           ? 0.0F
                           : static_cast<float>(options_.splat_scale));
  program.set("ball", static_cast<float>(octree_.disc_reach(level)));
  program.set("facet_radius", static_cast<float>(size.radius));
  program.set("to_shift", glm::mat3(size.shift));
  program.set("normals", glm::mat3(octree_.normals()));
  program.set("last_from", glm::vec2(bounded(ranges_->last_from(level)),
                                     level == 0 ? 3e38F : bounded(ranges_->last_from(level - 1))));
  glm::dmat3 to_cube = glm::inverse(axes) * size.side;  // its lengths do not matter
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i)
      if (!std::isfinite(to_cube[k][i])) to_cube = glm::dmat3(0);
  program.set("to_cube", glm::mat3(to_cube));
}

void GlVoxelCloud::draw_points(const GlProgram& program, unsigned level, bool es) {
  const NodeRuns& runs = ranges_->points(level);
  if (runs.first.empty()) return;
  set_uniforms(program, level);
  tree_.bind_points(level);
  const auto count = static_cast<GLsizei>(runs.first.size());
  if (!es) return glMultiDrawArrays(GL_POINTS, runs.first.data(), runs.count.data(), count);
  for (size_t i = 0; i < runs.first.size(); ++i)
    glDrawArrays(GL_POINTS, runs.first[i], runs.count[i]);
}

void GlVoxelCloud::draw_quads(const GlProgram& program, unsigned level) {
  const NodeRuns& runs = ranges_->quads(level);
  if (runs.first.empty()) return;
  set_uniforms(program, level);
  for (size_t i = 0; i < runs.first.size(); ++i) {
    tree_.bind_quads(level, runs.first[i]);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, runs.count[i]);
  }
}

}  // namespace afx::render
