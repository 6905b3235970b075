// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Background, Fog, Viewpoint and NavigationInfo as plain structs. Source: ISO/IEC 14772-1:1997
// (VRML97), those nodes (clauses not checked).
#pragma once

#include <glm/mat4x4.hpp>
#include <optional>

#include "afx/scene_files.h"
#include "afx/surroundings.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"
#include "nodes/node_view.h"

namespace afx {

/// The sky of a Background, not turned; of a Background2D its colour.
/// Errors    bad_argument: colours and angles that are not numbers; limit_exceeded
/// Warnings  background_angles: numbers of colours and angles that do not fit each other (what is
///           left over is left out), angles that do not rise (they are raised);
///           background_picture: a picture that cannot be read, and those of Background2D
Result<Backdrop> read_backdrop(const nodes::NodeView& node, const UrlBase& base,
                               const Limits& limits, Diagnostics& diagnostics);

/// None where visibilityRange is 0. The range grows with the mean scale of the matrix.
/// Errors  bad_argument: fields that are not numbers, a negative range
Result<std::optional<Fog>> read_fog(const nodes::NodeView& node, const glm::dmat4& to_world);

/// Scale in the matrix moves the position and does nothing else.
/// Errors  bad_argument: fields that are not numbers, fieldOfView not above 0 and below pi
Result<Viewpoint> read_viewpoint(const nodes::NodeView& node, const glm::dmat4& to_world);

/// Errors  bad_argument: fields that are not numbers or negative
Result<Navigation> read_navigation(const nodes::NodeView& node);

}  // namespace afx
