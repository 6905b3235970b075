// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The colour of the surface inside a voxel: the mean over its area.
#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "afx/builder/grid.h"
#include "afx/builder/mesh.h"
#include "afx/builder/surface_paint.h"

namespace afx {

/// What the pieces of surface in one voxel add up to.
struct SurfaceSum {
  glm::dvec3 light{0, 0, 0};   ///< colour in linear light times area times alpha
  glm::dvec3 normal{0, 0, 0};  ///< unit normal times area times alpha
  double weight = 0;           ///< area times alpha
  double area = 0;             ///< in squares of the voxel's side
  double surplus = 0;          ///< area times what alpha is above its cutoff
  bool has_opaque = false;     ///< a triangle without alpha is in it, if only a corner

  void add(const Paint& paint, const glm::dvec3& direction, double of_area, double alpha_cutoff);

  /// Whether there is surface to be seen: something opaque, or alpha not below the cutoff in the
  /// mean.
  [[nodiscard]] bool is_there() const { return has_opaque || (surplus >= 0 && weight > 0); }
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
    size_t triangle;
    double alpha_cutoff;
    double texels = 0;  ///< of its texture, on one square voxel side of it
  };
  [[nodiscard]] Piece piece(size_t triangle) const;

  /// Adds what of `piece` lies in the box from `low`, side 1, grown by `margin` on all sides.
  void add(const Piece& piece, const glm::ivec3& low, double margin, SurfaceSum& sum) const;

  /// Adds the middle of the triangle as if it had this area: for voxels that it only touches.
  void add_touch(const Piece& piece, double area, SurfaceSum& sum) const;

 private:
  using Weights = SurfacePaint::Weights;
  [[nodiscard]] Paint mean_paint(const Piece& piece, const std::array<Weights, 3>& corners,
                                 double area) const;

  const Mesh& mesh_;
  const Grid& grid_;
  SurfacePaint paint_;
};

}  // namespace afx
