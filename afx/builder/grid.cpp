// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/grid.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "codec/octree.h"

namespace afx {
namespace {

int32_t last_fixed(unsigned levels) { return static_cast<int32_t>(kSubvoxels << levels) - 1; }

}  // namespace

Bounds bounds_of(std::span<const glm::vec3> points) {
  BoundsFinder finder;
  for (const glm::vec3& point : points) finder.add(glm::dvec3(point));
  return finder.bounds();
}

double Bounds::longest_side() const {
  const glm::dvec3 sides = high - low;
  const double longest = std::max({sides.x, sides.y, sides.z});
  return longest > 0 ? longest : 1;
}

Grid::Grid(const Bounds& bounds, uint32_t wanted)
    : levels(octree_levels(wanted)), resolution(wanted) {
  const glm::dvec3 extent = bounds.high - bounds.low;
  const double longest = std::max({extent.x, extent.y, extent.z});
  if (longest > 0 && std::isfinite(resolution / longest)) scale = resolution / longest;
  object_centre = bounds.low + 0.5 * extent;
  const uint32_t border = ((1U << levels) - resolution) / 2;
  middle = border + 0.5 * resolution;
  for (int axis = 0; axis < 3; ++axis) {
    const double high = (bounds.high[axis] - object_centre[axis]) * scale + middle;
    const auto end = static_cast<int32_t>(std::llround(high * kSubvoxels));
    const bool flat =
        !(extent[axis] * scale * kSubvoxels > 1);  // nothing but this end: no taking back
    last[axis] = std::min(flat ? end : end - 1, last_fixed(levels));
  }
}

Grid::Grid(const Cube& cube, uint32_t wanted)
    : levels(octree_levels(wanted)),
      resolution(wanted),
      scale(std::ldexp(1.0, static_cast<int>(levels)) / cube.side),
      object_centre(cube.centre),
      middle(std::ldexp(0.5, static_cast<int>(levels))),
      rounding(0),
      last(last_fixed(levels)) {}

glm::dvec3 Grid::to_voxels(const glm::dvec3& point) const {
  return (point - object_centre) * scale + glm::dvec3(middle);
}

bool Grid::holds(const glm::dvec3& point) const {
  const glm::dvec3 place = to_voxels(point);
  const double end = std::ldexp(1.0, static_cast<int>(levels));
  const auto is_in = [&](double v) { return v >= 0 && v < end; };
  return is_in(place.x) && is_in(place.y) && is_in(place.z);
}

glm::ivec3 Grid::to_fixed(const glm::vec3& point) const {
  const glm::dvec3 place = to_voxels(glm::dvec3(point)) * static_cast<double>(kSubvoxels);
  const glm::dvec3 rounded = glm::floor(place + rounding);
  return glm::ivec3(glm::clamp(rounded, glm::dvec3(0), glm::dvec3(last)));
}

}  // namespace afx
