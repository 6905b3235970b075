// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// How an object lies in the octree's cube.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

namespace afx {

/// Fixed-point voxel coordinates: kSubvoxels units a voxel. All decisions about which voxels a
/// surface passes through are made on these integers, so they are exact and the same everywhere; a
/// vertex moves by at most 1/512 of a voxel, and vertices that were equal stay equal.
inline constexpr int kSubvoxelBits = 8;
inline constexpr int32_t kSubvoxels = 1 << kSubvoxelBits;

/// The smallest upright box around points.
struct Bounds {
  glm::dvec3 low{0, 0, 0};
  glm::dvec3 high{0, 0, 0};
};

/// Of no points: the origin.
Bounds bounds_of(std::span<const glm::vec3> points);

/// Fits an object into the cube of 2^levels voxels a side, octree coordinates x, y, z each from 0:
/// its centre at the centre of `resolution` voxels, which begin (2^levels - resolution)/2 (rounded
/// down) voxels from the border; its longest side is `resolution` voxels long.
struct Grid {
  /// resolution   1..2048
  Grid(const Bounds& bounds, uint32_t resolution);

  /// A point of the object in voxels.
  [[nodiscard]] glm::dvec3 to_voxels(const glm::vec3& point) const;

  /// The same in fixed point. Where the object ends on a border between voxels, its end is taken
  /// back by one unit: the surface there sets the last voxel inside, not the first one outside.
  [[nodiscard]] glm::ivec3 to_fixed(const glm::vec3& point) const;

  unsigned levels = 0;
  uint32_t resolution = 1;
  double scale = 1;  ///< voxels per unit of the object; 1 for an object without extent
  glm::dvec3 object_centre{0, 0, 0};
  double middle = 0.5;       ///< where the centre lies, in voxels, on each axis
  glm::ivec3 last{0, 0, 0};  ///< the greatest fixed-point coordinate of each axis
};

}  // namespace afx
