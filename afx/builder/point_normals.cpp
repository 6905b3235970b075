// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/point_normals.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "afx/plane_fit.h"
#include "codec/parallel.h"

namespace afx {
namespace {

constexpr size_t kBlock = 4096;

glm::vec3 normal_of(std::span<const glm::vec3> points, std::span<const uint32_t> chosen) {
  glm::dvec3 mean(0);
  for (const uint32_t i : chosen) mean += glm::dvec3(points[i]);
  mean /= static_cast<double>(chosen.size());
  glm::dmat3 covariance(0);
  for (const uint32_t i : chosen) {
    const glm::dvec3 d = glm::dvec3(points[i]) - mean;
    for (int k = 0; k < 3; ++k) covariance[k] += d[k] * d;
  }
  return glm::vec3(plane_normal(covariance));
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
