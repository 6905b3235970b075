// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/plane_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace afx {
namespace {

// Eigenvalues of a symmetric matrix and the vectors to them, as columns.
struct Eigen {
  glm::dvec3 values;
  glm::dmat3 vectors{1};
};

// Turns the axes p and q so that the element between them becomes 0.
void rotate(glm::dmat3& m, glm::dmat3& vectors, int p, int q) {
  if (m[p][q] == 0) return;
  const double theta = (m[q][q] - m[p][p]) / (2 * m[p][q]);
  const double t = (theta < 0 ? -1 : 1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
  const double c = 1 / std::sqrt(t * t + 1), s = t * c;
  for (int k = 0; k < 3; ++k) {
    const double a = m[k][p], b = m[k][q];
    m[k][p] = c * a - s * b;
    m[k][q] = s * a + c * b;
  }
  for (int k = 0; k < 3; ++k) {
    const double a = m[p][k], b = m[q][k];
    m[p][k] = c * a - s * b;
    m[q][k] = s * a + c * b;
  }
  m[p][q] = m[q][p] = 0;
  const glm::dvec3 a = vectors[p], b = vectors[q];
  vectors[p] = c * a - s * b;
  vectors[q] = s * a + c * b;
}

Eigen eigen_of(glm::dmat3 m) {
  constexpr double kNothing = 1e-15;  // off the diagonal this is rounding
  Eigen eigen;
  const double least = kNothing * (m[0][0] + m[1][1] + m[2][2]);
  const auto is_diagonal = [&] {
    return std::max({std::abs(m[0][1]), std::abs(m[0][2]), std::abs(m[1][2])}) <= least;
  };
  // It converges by squares: five are enough.
  for (int sweep = 0; sweep < 12 && !is_diagonal(); ++sweep) {
    rotate(m, eigen.vectors, 0, 1);
    rotate(m, eigen.vectors, 0, 2);
    rotate(m, eigen.vectors, 1, 2);
  }
  eigen.values = {m[0][0], m[1][1], m[2][2]};
  return eigen;
}

}  // namespace

glm::dvec3 plane_normal(const glm::dmat3& covariance) {
  const Eigen eigen = eigen_of(covariance);
  std::array<int, 3> order = {0, 1, 2};
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return eigen.values[a] < eigen.values[b]; });
  constexpr double kFlat = 1e-9;  // less across a line than this, in squares, is rounding
  if (!(eigen.values[order[1]] > kFlat * eigen.values[order[2]])) return glm::dvec3(0);
  return eigen.vectors[order[0]];
}

}  // namespace afx
