// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/lens.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace afx::render {

Lens::Lens(const Camera& camera, const RenderOptions& options)
    : to_view(glm::mat3_cast(glm::conjugate(glm::normalize(camera.orientation)))),
      position(camera.position),
      perspective(camera.projection == Projection::perspective),
      near_plane(camera.near_plane) {
  const double columns = static_cast<double>(uint64_t{options.width} * options.samples);
  const double rows = static_cast<double>(uint64_t{options.height} * options.samples);
  const double half_height =
      perspective ? std::tan(camera.field_of_view / 2) : camera.view_height / 2;
  focal = rows / 2 / half_height;
  middle = {columns / 2, rows / 2};
  slope = {half_height * columns / rows, half_height};
  secant = glm::sqrt(1.0 + slope * slope);
}

bool Lens::in_view(const glm::dvec3& centre, double radius) const {
  const double distance = -centre.z;
  if (!(distance >= near_plane)) return false;
  if (!perspective) return true;
  const glm::dvec2 beyond = glm::abs(glm::dvec2(centre)) - slope * distance;
  return beyond.x <= radius * secant.x && beyond.y <= radius * secant.y;
}

}  // namespace afx::render
