// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What a matrix does to lengths and directions.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

namespace afx {

/// By how much an affine matrix scales lengths on average: the cube root of what it does to
/// volumes. 0 for a singular one.
double uniform_scale(const glm::dmat4& matrix);

/// Its rotation without scale, shear and mirroring: the x axis keeps its direction, y its plane
/// with x. A singular matrix gives the identity.
glm::dmat3 rotation_part(const glm::dmat4& matrix);

/// Whether all numbers are finite and at most 1e60, so that what is reckoned with them is finite
/// too.
bool is_usable(const glm::dmat4& matrix);

}  // namespace afx
