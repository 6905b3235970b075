// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// A whole MPEG-4 scene as it is to be seen: DIBR objects, ordinary geometry, lights, surroundings.
#pragma once

#include <optional>
#include <vector>

#include "afx/dibr_model.h"
#include "afx/shape.h"
#include "afx/surroundings.h"

namespace afx {

/// What a scene shows, in plain lists.
struct VisualScene {
  std::vector<DibrModel> models;
  std::vector<Shape> shapes;
  std::vector<Light> lights;  ///< those that are on, without the headlight
  std::optional<Backdrop> backdrop;
  std::optional<Fog> fog;
  std::vector<Viewpoint> viewpoints;  ///< the first is the one to begin with
  Navigation navigation;
  bool depends_on_viewer = false;  ///< there are LOD or Billboard nodes: read anew as one moves
};

}  // namespace afx
