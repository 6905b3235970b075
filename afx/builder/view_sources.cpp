// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/view_sources.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "afx/builder/surface_samples.h"
#include "afx/surfel_drawing.h"

namespace afx {
Bounds MeshViews::bounds_along(const glm::dmat3& axes) const {
  BoundsFinder finder;
  const Mesh& mesh = look_.mesh();
  for (const glm::uvec3& triangle : mesh.triangles)
    for (int k = 0; k < 3; ++k) finder.add(glm::dvec3(mesh.positions[triangle[k]]) * axes);
  return finder.bounds();
}

Result<DepthImage> MeshViews::take(const Shot& shot, unsigned depth_bits) const {
  return draw_depth_image(look_, shot, depth_bits, threads_, limits_);
}

Result<std::vector<float>> MeshViews::distances(const Shot& shot) const {
  return draw_distances(look_, shot, threads_, limits_);
}

Result<PointCloud> MeshViews::samples(size_t count) const {
  return sample_surface(look_.mesh(),
                        {.points = count, .spacing = 0, .threads = threads_, .limits = limits_});
}

Bounds SurfelViews::bounds_along(const glm::dmat3& axes) const {
  BoundsFinder finder;
  for (size_t i = 0; i < surfels_.size(); ++i) {
    const glm::dvec3 centre = surfels_.centres[i] * axes;
    const glm::dvec3 reach =
        glm::abs(glm::dvec3(surfels_.u[i]) * axes) + glm::abs(glm::dvec3(surfels_.v[i]) * axes);
    finder.add(centre - reach);
    finder.add(centre + reach);
  }
  return finder.bounds();
}

Result<DepthImage> SurfelViews::take(const Shot& shot, unsigned depth_bits) const {
  return draw_surfels(surfels_, shot, depth_bits, threads_, limits_);
}

Result<std::vector<float>> SurfelViews::distances(const Shot& shot) const {
  const auto image = draw_surfels(surfels_, shot, 16, threads_, limits_);
  if (!image.ok()) return image.error();
  const auto& texture = std::get<SimpleTexture>(image.value().texture);
  std::vector<float> distances;
  distances.reserve(texture.depth.samples.size());
  for (const uint16_t depth : texture.depth.samples)
    distances.push_back(
        depth == 0 ? std::numeric_limits<float>::infinity()
                   : static_cast<float>(depth_to_distance(depth, texture.dmax(), shot.camera)));
  return distances;
}

Result<PointCloud> SurfelViews::samples(size_t count) const {
  if (surfels_.size() == 0)
    return Error{Errc::bad_argument, Place::none(), "the model has no samples"};
  const size_t step = std::max<size_t>(1, surfels_.size() / std::max<size_t>(1, count));
  PointCloud cloud;
  cloud.origin = surfels_.centres.front();
  for (size_t i = 0; i < surfels_.size(); i += step) {
    cloud.positions.emplace_back(surfels_.centres[i] - cloud.origin);
    cloud.normals.push_back(glm::cross(surfels_.u[i], surfels_.v[i]));
    cloud.colours.push_back(surfels_.colours[i]);
  }
  return cloud;
}

}  // namespace afx
