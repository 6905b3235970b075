// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace afx {

/// The normal of the plane that points lie on best: the direction in which they vary least
/// (principal components). Of length 1, on either side of the plane; (0, 0, 0) where the points lie
/// on a line or in one place.
///
/// covariance   of the points: the mean, or the sum, of d d^T, d a point's offset from their mean
/// Source       Jacobi's method for the eigenvectors of a symmetric matrix
glm::dvec3 plane_normal(const glm::dmat3& covariance);

}  // namespace afx
