// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/point_surfels.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <string>

#include "afx/builder/grid.h"
#include "afx/builder/nearest_points.h"
#include "afx/builder/point_normals.h"
#include "afx/surfel_sources.h"

namespace afx {
namespace {

glm::vec3 unit_or_zero(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0 ? glm::vec3(v / length) : glm::vec3(0);
}

/// The normals of the cloud, those that are unknown as the points around tell.
std::vector<glm::vec3> all_normals(const PointCloud& cloud, const NearestPoints& index,
                                   unsigned threads) {
  std::vector<glm::vec3> normals;
  normals.reserve(cloud.positions.size());
  for (const glm::vec3& n : cloud.normals) normals.push_back(unit_or_zero(glm::dvec3(n)));
  if (!normals.empty() && std::find(normals.begin(), normals.end(), glm::vec3(0)) == normals.end())
    return normals;
  std::vector<glm::vec3> told = estimate_normals(cloud.positions, index, threads);
  const Bounds bounds = bounds_of(cloud.positions);
  const glm::vec3 middle((bounds.low + bounds.high) / 2.0);
  for (size_t n = 0; n < told.size(); ++n) {
    if (glm::dot(told[n], cloud.positions[n] - middle) < 0) told[n] = -told[n];
    if (!normals.empty() && normals[n] != glm::vec3(0)) told[n] = normals[n];
  }
  return told;
}

}  // namespace

Result<Surfels> surfels_of(const PointCloud& cloud, unsigned threads, const Limits& limits) {
  constexpr uint64_t kWorkBytes = 72;  // of the search tree and the normals
  const size_t count = cloud.positions.size();
  if (count > std::min<uint64_t>(limits.memory / (kSurfelBytes + kWorkBytes), 0xffffffff))
    return Error{Errc::limit_exceeded, Place::none(),
                 std::to_string(count) + " points take more memory than the limit"};
  const NearestPoints index(cloud.positions);
  const double spacing = index.spacing();
  const std::vector<glm::vec3> normals = all_normals(cloud, index, threads);
  Surfels surfels;
  surfels.reserve(count);
  for (size_t n = 0; n < count; ++n)
    push_square(surfels, cloud.origin + glm::dvec3(cloud.positions[n]), normals[n],
                static_cast<float>(kPointHalfSide * spacing),
                cloud.colours.empty() ? Rgba8{255, 255, 255, 255} : cloud.colours[n]);
  return surfels;
}

PointCloud points_of(const Surfels& surfels) {
  PointCloud cloud;
  if (surfels.size() != 0) cloud.origin = surfels.centres[0];
  cloud.positions.reserve(surfels.size());
  cloud.normals.reserve(surfels.size());
  cloud.colours = surfels.colours;
  for (size_t n = 0; n < surfels.size(); ++n) {
    cloud.positions.emplace_back(surfels.centres[n] - cloud.origin);
    cloud.normals.push_back(
        unit_or_zero(glm::cross(glm::dvec3(surfels.u[n]), glm::dvec3(surfels.v[n]))));
  }
  return cloud;
}

}  // namespace afx
