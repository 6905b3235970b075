// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Light nodes as plain structs. Source: ISO/IEC 14772-1:1997 (VRML97), DirectionalLight,
// PointLight, SpotLight (clauses not checked).
#pragma once

#include <glm/mat4x4.hpp>

#include "afx/shape.h"
#include "codec/error.h"
#include "nodes/node_view.h"

namespace afx {

/// The light of a DirectionalLight, PointLight or SpotLight, in the world. Radius and attenuation
/// go by the mean scale of the matrix; under a singular one the radius is 0. Colours, intensities
/// and angles are drawn into their ranges, a direction of length 0 is -z.
///
/// to_world   usable (matrix_parts.h)
/// Errors  bad_argument: fields that are not numbers, a negative radius or attenuation
Result<Light> read_light(const nodes::NodeView& node, const glm::dmat4& to_world);

}  // namespace afx
