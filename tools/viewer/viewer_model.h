// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What the viewer shows, as the program hands it over.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "afx/surroundings.h"
#include "render/scene.h"

namespace afx::tools {

/// The camera of a picture that a model came with, in the world.
struct ReferenceCamera {
  glm::dvec3 position{0};
  glm::dvec3 right{1, 0, 0}, up{0, 1, 0}, ahead{0, 0, -1};  ///< of length 1, at right angles
  bool orthographic = false;
  /// Half the width and height of the view: in scene units, or, in perspective, at distance 1.
  glm::dvec2 half_view{1};
};

/// A model that has been read and made ready.
struct ViewerModel {
  std::string file;                 ///< as it was opened
  std::string size;                 ///< "759,197 voxels"
  render::Scene scene;              ///< checked
  std::vector<glm::dvec3> outline;  ///< render::outline of it
  unsigned levels = 0;              ///< of its finest octree; 0: none
  std::vector<Viewpoint> viewpoints;
  size_t first_viewpoint = 0;  ///< the one to begin with, counted from 1; 0: all of it is shown
  std::vector<ReferenceCamera> cameras;
  uint64_t warnings = 0;  ///< how many there were on reading
};

}  // namespace afx::tools
