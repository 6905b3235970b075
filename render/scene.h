// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What the renderer draws: plain lists of primitives in world coordinates.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "afx/octree_model.h"

namespace afx::render {

/// Voxels of one level of an octree over the cube of side 1 centred at the origin of their local
/// system. The caller keeps the lists alive while they are drawn.
struct VoxelCloud {
  unsigned level = 0;               ///< voxel side = 2^-level, level <= 21
  std::span<const uint64_t> codes;  ///< Morton codes (codec/octree_voxels.h), fewer than 2^32
  std::span<const Rgba8> colours;   ///< sRGB, one for each code; drawn opaque, a is not looked at
  glm::dmat4 local_to_world{1};     ///< affine: the last row is (0, 0, 0, 1)
};

/// All that is drawn into one depth buffer. Voxels at about the same depth and place are mixed
/// (renderer.h), whatever cloud they are of.
struct Scene {
  std::vector<VoxelCloud> voxels;
};

/// Points in world coordinates whose convex hull holds every voxel of the scene, closely: the
/// corners of the occupied cells at octree level 5 or coarser. For fit_camera.
[[nodiscard]] std::vector<glm::dvec3> outline(const Scene& scene);

}  // namespace afx::render
