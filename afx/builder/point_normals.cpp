// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/point_normals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "codec/parallel.h"

namespace afx {
namespace {

constexpr size_t kBlock = 4096;

// Eigenvalues of a symmetric matrix and the vectors to them, as columns. Source: Jacobi's method.
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
  Eigen eigen;
  for (int sweep = 0; sweep < 12; ++sweep) {  // it converges by squares: five are enough
    rotate(m, eigen.vectors, 0, 1);
    rotate(m, eigen.vectors, 0, 2);
    rotate(m, eigen.vectors, 1, 2);
  }
  eigen.values = {m[0][0], m[1][1], m[2][2]};
  return eigen;
}

glm::vec3 normal_of(std::span<const glm::vec3> points, std::span<const uint32_t> chosen) {
  glm::dvec3 mean(0);
  for (const uint32_t i : chosen) mean += glm::dvec3(points[i]);
  mean /= static_cast<double>(chosen.size());
  glm::dmat3 covariance(0);
  for (const uint32_t i : chosen) {
    const glm::dvec3 d = glm::dvec3(points[i]) - mean;
    for (int k = 0; k < 3; ++k) covariance[k] += d[k] * d;
  }
  const Eigen eigen = eigen_of(covariance);
  std::array<int, 3> order = {0, 1, 2};
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return eigen.values[a] < eigen.values[b]; });
  constexpr double kFlat = 1e-9;  // less across a line than this, in squares, is rounding
  if (!(eigen.values[order[1]] > kFlat * eigen.values[order[2]])) return glm::vec3(0);
  return glm::vec3(eigen.vectors[order[0]]);
}

}  // namespace

std::vector<glm::vec3> estimate_normals(std::span<const glm::vec3> points,
                                        const NearestPoints& index, unsigned threads) {
  std::vector<glm::vec3> normals(points.size());
  parallel_for((points.size() + kBlock - 1) / kBlock, threads, [&](size_t block) {
    const size_t end = std::min(points.size(), (block + 1) * kBlock);
    for (size_t i = block * kBlock; i < end; ++i)
      normals[i] = normal_of(points, index.nearest(glm::dvec3(points[i]), kNormalNeighbours));
  });
  return normals;
}

void DirectionMean::add(const glm::dvec3& direction) {
  sum_ += glm::dot(sum_, direction) < 0 ? -direction : direction;
}

glm::dvec3 DirectionMean::value() const {
  const double length = glm::length(sum_);
  return length > 0 ? sum_ / length : glm::dvec3(0);
}

}  // namespace afx
