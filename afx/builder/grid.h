// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// How an object lies in the octree's cube, or the cube in the object's space.
#pragma once

#include <cstdint>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <span>

namespace afx {

/// Fixed-point voxel coordinates: kSubvoxels units a voxel. All decisions about which voxels a
/// surface passes through are made on these integers, so they are exact and the same everywhere; a
/// vertex moves by at most 1/512 of a voxel, and vertices that were equal stay equal.
inline constexpr int kSubvoxelBits = 8;
inline constexpr int32_t kSubvoxels = 1 << kSubvoxelBits;

/// The smallest upright box around points. Of none it is the origin.
struct Bounds {
  glm::dvec3 low{0, 0, 0};
  glm::dvec3 high{0, 0, 0};

  /// Its longest side, or 1 where that is 0.
  [[nodiscard]] double longest_side() const;
};

/// Finds the box of points that are put in one by one.
class BoundsFinder {
 public:
  void add(const glm::dvec3& point) {
    low_ = glm::min(low_, point);
    high_ = glm::max(high_, point);
  }
  [[nodiscard]] Bounds bounds() const { return low_.x <= high_.x ? Bounds{low_, high_} : Bounds{}; }

 private:
  static constexpr double kFar = std::numeric_limits<double>::infinity();
  glm::dvec3 low_{kFar};
  glm::dvec3 high_{-kFar};
};

Bounds bounds_of(std::span<const glm::vec3> points);

/// An upright cube in the coordinates of an object.
struct Cube {
  glm::dvec3 centre{0, 0, 0};
  double side = 1;  ///< > 0
};

/// How the object's coordinates and those of the octree, 2^levels voxels a side, each axis from 0,
/// belong together.
struct Grid {
  /// Fits an object: its centre at the centre of `resolution` voxels, which begin
  /// (2^levels - resolution)/2 (rounded down) voxels from the border; its longest side is
  /// `resolution` voxels long.
  /// resolution   1..2048
  Grid(const Bounds& bounds, uint32_t resolution);

  /// Lays the octree's cube into a cube of the object's space: a point is in the voxel
  /// floor((point - centre) * 2^levels / side + 2^levels / 2). Here fixed point rounds down.
  Grid(const Cube& cube, uint32_t resolution);

  /// A point of the object in voxels.
  [[nodiscard]] glm::dvec3 to_voxels(const glm::dvec3& point) const;

  /// Whether a point lies in the octree's cube, the upper borders not in it.
  [[nodiscard]] bool holds(const glm::dvec3& point) const;

  /// A point in fixed point. Where an object that was fitted ends on a border between voxels, its
  /// end is taken back by one unit: the surface there sets the last voxel inside, not the first one
  /// outside.
  [[nodiscard]] glm::ivec3 to_fixed(const glm::vec3& point) const;

  unsigned levels = 0;
  uint32_t resolution = 1;
  double scale = 1;  ///< voxels per unit of the object; 1 for an object without extent
  glm::dvec3 object_centre{0, 0, 0};
  double middle = 0.5;       ///< where the centre lies, in voxels, on each axis
  double rounding = 0.5;     ///< added before fixed point is rounded down
  glm::ivec3 last{0, 0, 0};  ///< the greatest fixed-point coordinate of each axis
};

}  // namespace afx
