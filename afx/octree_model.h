// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "afx/picture.h"
#include "codec/octree.h"

namespace afx {

/// An orthographic reference image of an OctreeImage: a DepthImage of its `images`, resolved.
/// Pixel (i, j) counts from the lower left; see octree_colours.h for the exact rule.
struct ReferenceImage {
  glm::vec3 position{0, 0, 10};       ///< of the camera, in the cube's coordinates
  glm::quat orientation{1, 0, 0, 0};  ///< (w, x, y, z); identity looks along -z with +y up
  glm::vec2 field_of_view{1, 1};      ///< width and height of the view box
  Picture picture;                    ///< RGB or RGBA; empty where the scene has none
};

/// An OctreeImage, resolved from its node: what renderers and builders work with. The cube of side
/// 1 centred at the origin is divided `levels` times. Source: ISO/IEC 14496-16 OctreeImage (clause
/// not checked); the paper, section IV.
struct OctreeModel {
  uint32_t resolution = 1;  ///< octreeResolution, >= 1
  OctreeFields fields;      ///< an empty voxel_image_index: the renderer chooses the images
  std::vector<ReferenceImage> images;  ///< at most 255
};

}  // namespace afx
