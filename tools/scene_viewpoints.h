// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <string>
#include <vector>

#include "afx/surroundings.h"
#include "codec/error.h"
#include "nodes/scene.h"

namespace afx::tools {

/// The Viewpoints of a scene in its order, in world coordinates. What is followed: `children` of
/// any node, what Switch chooses, the first level of LOD, the insides of PROTO instances.
/// Errors  limit_exceeded: nested too deep, or too many places of nodes
Result<std::vector<Viewpoint>> find_viewpoints(const nodes::Scene& scene);

/// Picks one by its DEF name, its description or, where it has neither of that, its number from 1.
/// Errors  bad_argument: there is none; the text lists those there are and offers the nearest
Result<Viewpoint> pick_viewpoint(const std::vector<Viewpoint>& viewpoints, const std::string& name);

}  // namespace afx::tools
