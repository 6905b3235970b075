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
#include "afx/surfels.h"

namespace afx::render {

/// Voxels of one level of an octree over the cube of side 1 centred at the origin of their local
/// system. The caller keeps the lists alive while they are drawn.
struct VoxelCloud {
  unsigned level = 0;               ///< voxel side = 2^-level, level <= 21
  std::span<const uint64_t> codes;  ///< Morton codes (codec/octree_voxels.h), fewer than 2^32
  std::span<const Rgba8> colours;   ///< sRGB, one for each code; drawn opaque, a is not looked at
  glm::dmat4 local_to_world{1};     ///< affine: the last row is (0, 0, 0, 1)
};

/// Surfels more transparent than this are not drawn, the others as if they were opaque.
inline constexpr uint8_t kLeastOpacity = 128;

/// Small flat pieces of surface, seen from both sides. The caller keeps them alive while they are
/// drawn.
struct SurfelCloud {
  const Surfels* surfels = nullptr;  ///< not null
  glm::dmat4 local_to_world{1};      ///< affine: the last row is (0, 0, 0, 1)
};

/// All that is drawn into one depth buffer. Splats at about the same depth and place are mixed
/// (renderer.h), whatever cloud they are of.
struct Scene {
  std::vector<VoxelCloud> voxels{};
  std::vector<SurfelCloud> surfels{};
};

/// Points in world coordinates whose convex hull holds everything in the scene that is drawn,
/// closely: the corners of the voxels' occupied cells at octree level 5 or coarser; for each cloud
/// of surfels, in 32 x 32 x 32 cells of its bounding box, the boxes around the corners of surfels
/// that fall into each. For fit_camera.
///
/// scene   one that render() takes; surfels whose coordinates are not finite are passed over
[[nodiscard]] std::vector<glm::dvec3> outline(const Scene& scene);

}  // namespace afx::render
