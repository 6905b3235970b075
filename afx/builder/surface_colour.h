// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The colour of the surface inside a voxel: the mean over its area.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "afx/builder/grid.h"
#include "afx/builder/mesh.h"
#include "afx/builder/texture_sampler.h"

namespace afx {

/// What the pieces of surface in one voxel add up to.
struct SurfaceSum {
  glm::dvec3 light{0, 0, 0};   ///< colour in linear light times area
  glm::dvec3 normal{0, 0, 0};  ///< unit normal times area
  double area = 0;             ///< in squares of the voxel's side
};

/// Adds up pieces of a mesh's triangles. The mesh must stay as it is. For use by several threads at
/// once.
class SurfaceColour {
 public:
  SurfaceColour(const Mesh& mesh, const Grid& grid);

  /// A triangle of the mesh, made ready for add().
  struct Piece {
    std::array<glm::dvec3, 3> corners;  ///< in voxels
    glm::dvec3 normal;                  ///< unit, or zero for a triangle without area
    glm::uvec3 vertices;
    const Material* material;
    double texels = 0;  ///< of its texture, on one square voxel side of it
  };
  [[nodiscard]] Piece piece(size_t triangle) const;

  /// Adds what of `piece` lies in the box from `low`, side 1, grown by `margin` on all sides.
  void add(const Piece& piece, const glm::ivec3& low, double margin, SurfaceSum& sum) const;

  /// Adds the middle of the triangle with the area 1: for voxels that it only touches.
  void add_touch(const Piece& piece, SurfaceSum& sum) const;

 private:
  /// A place on a triangle: corner 0 has the weight 1 - b - c.
  struct Weights {
    double b, c;
  };
  [[nodiscard]] glm::dvec3 colour_at(const Piece& piece, Weights at, double area) const;
  void add_light(const Piece& piece, const std::array<Weights, 3>& corners, double area,
                 SurfaceSum& sum) const;

  const Mesh& mesh_;
  const Grid& grid_;
  std::vector<TextureSampler> samplers_;
};

}  // namespace afx
