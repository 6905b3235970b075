// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What the renderers draw: plain lists of objects with their matrices.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "afx/shape.h"
#include "afx/surfels.h"
#include "afx/surroundings.h"
#include "codec/error.h"
#include "codec/limits.h"
#include "render/voxel_tree.h"

namespace afx::render {

/// An octree in its place. Clouds may share a tree.
struct VoxelCloud {
  std::shared_ptr<const VoxelTree> tree;  ///< not null
  glm::dmat4 local_to_world{1};           ///< affine: the last row is (0, 0, 0, 1)
};

/// Surfels more transparent than this are not drawn, the others as if they were opaque.
inline constexpr uint8_t kLeastOpacity = 128;

/// Small flat pieces of surface, seen from both sides, in their place. Clouds may share them.
struct SurfelCloud {
  std::shared_ptr<const Surfels> surfels;  ///< not null
  glm::dmat4 local_to_world{1};            ///< affine: the last row is (0, 0, 0, 1)
};

/// All that is drawn into one depth buffer. Splats, which are voxels and surfels, are mixed where
/// they lie at about the same depth and place (renderer.h), whatever cloud they are of; shapes are
/// solid.
struct Scene {
  std::vector<VoxelCloud> voxels{};
  std::vector<SurfelCloud> surfels{};
  std::vector<Shape> shapes{};  ///< afx/shape.h; their lights are numbers of `lights`
  std::vector<Light> lights{};
  bool headlight = false;  ///< a white directional light from the viewer falls on all shapes
  std::optional<Fog> fog{};
  std::optional<Backdrop> backdrop{};
};

/// Checks what came from elsewhere: null pointers, lists of different lengths, numbers out of
/// range, matrices that are not affine or not finite.
/// Errors  bad_argument (the text names what is wrong); limit_exceeded: 2^30 voxels, surfels and
///         indices of corners or more
[[nodiscard]] Status check_scene(const Scene& scene);

/// Points in world coordinates whose convex hull holds everything in the scene that is drawn,
/// closely: the corners of the voxels' occupied cells at octree level 5 or coarser; for each cloud
/// of surfels, in 32 x 32 x 32 cells of its bounding box, the boxes around the corners of surfels
/// that fall into each; the corners of shapes. Of scenes with more than 256 objects, and of shapes
/// with more than 2^20 corners, boxes instead. For fit_camera.
///
/// scene   one that check_scene finds right; surfels whose coordinates are not finite are passed
///         over
[[nodiscard]] std::vector<glm::dvec3> outline(const Scene& scene);

}  // namespace afx::render
