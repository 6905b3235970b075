// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What a scene shows by depth images and octrees, resolved.
#pragma once

#include <glm/mat4x4.hpp>
#include <variant>
#include <vector>

#include "afx/depth_image.h"
#include "afx/octree_model.h"
#include "afx/scene_files.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"
#include "nodes/scene.h"

namespace afx {

/// One object: DepthImages that belong together, or an OctreeImage.
struct DibrModel {
  glm::dmat4 to_world{1};  ///< from the coordinates of its nodes
  std::variant<std::vector<DepthImage>, OctreeModel> shape;
};

/// Reads all objects of a scene, in its order (nodes/traversal.h), with their pictures.
/// Errors    those of find_dibr_objects, read_depth_image, read_octree_model; limit_exceeded: all
///           together take more than limits.memory
/// Warnings  those of the readers
Result<std::vector<DibrModel>> read_dibr_models(const nodes::Scene& scene, const UrlBase& base,
                                                const Limits& limits, Diagnostics& diagnostics);

}  // namespace afx
