// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/shapes/matrix_parts.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace afx {

double uniform_scale(const glm::dmat4& matrix) {
  return std::cbrt(std::abs(glm::determinant(glm::dmat3(matrix))));
}

glm::dmat3 rotation_part(const glm::dmat4& matrix) {
  const glm::dmat3 m(matrix);
  const double length = glm::length(m[0]);
  if (!(length > 0) || !std::isfinite(length)) return glm::dmat3(1);
  const glm::dvec3 x = m[0] / length;
  const glm::dvec3 across = glm::cross(x, m[1]);
  const double height = glm::length(across);
  if (!(height > 0) || !std::isfinite(height)) return glm::dmat3(1);
  const glm::dvec3 z = across / height;
  return {x, glm::cross(z, x), z};
}

bool is_usable(const glm::dmat4& matrix) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      if (!(std::abs(matrix[column][row]) <= 1e60)) return false;
  return true;
}

}  // namespace afx
