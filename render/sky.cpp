// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/sky.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <vector>

namespace afx::render {
namespace {

/// Colour 0 is at the angle 0, colour k + 1 at angle k, the last one beyond.
glm::vec3 gradient(const std::vector<glm::vec3>& colours, const std::vector<float>& angles,
                   float angle) {
  const auto next = std::upper_bound(angles.begin(), angles.end(), angle);
  if (next == angles.end()) return colours.back();
  const auto k = static_cast<size_t>(next - angles.begin());
  const float first = k == 0 ? 0 : angles[k - 1];
  return glm::mix(colours[k], colours[k + 1], (angle - first) / (*next - first));
}

/// The way one looks at a face from the middle, what is to the right then, and what is up.
struct Face {
  glm::dvec3 ahead, right, up;
};

const Face kFaces[6] = {
    {{0, 0, -1}, {1, 0, 0}, {0, 1, 0}},  {{0, 0, 1}, {-1, 0, 0}, {0, 1, 0}},
    {{-1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
    {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},   {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
};

constexpr double kParallelAngle = std::numbers::pi / 4;

}  // namespace

glm::vec3 sky_colour(const Backdrop& backdrop, const glm::dvec3& direction) {
  const double length = glm::length(direction);
  const double height = length > 0 ? std::clamp(direction.y / length, -1.0, 1.0) : 1;
  const double angle = std::acos(height);
  const auto from_nadir = static_cast<float>(std::numbers::pi - angle);
  if (!backdrop.ground_angles.empty() && from_nadir <= backdrop.ground_angles.back())
    return gradient(backdrop.ground_colours, backdrop.ground_angles, from_nadir);
  return gradient(backdrop.sky_colours, backdrop.sky_angles, static_cast<float>(angle));
}

CubePlace cube_place(const glm::dvec3& direction) {
  const glm::dvec3 size = glm::abs(direction);
  size_t face = direction.z > 0 ? 1 : 0;
  if (size.x > size.z && size.x >= size.y) face = direction.x > 0 ? 3 : 2;
  if (size.y > size.z && size.y > size.x) face = direction.y > 0 ? 4 : 5;
  return {face, place_on_face(face, direction)};
}

glm::vec2 place_on_face(size_t face, const glm::dvec3& direction) {
  const Face& f = kFaces[face];
  const glm::dvec2 slope(glm::dot(direction, f.right), glm::dot(direction, f.up));
  return glm::vec2((slope / glm::dot(direction, f.ahead) + 1.0) / 2.0);
}

SkyRays::SkyRays(const Backdrop& backdrop, const Lens& lens)
    : to_backdrop_(glm::transpose(lens.to_view * backdrop.to_world)),
      middle_(lens.middle),
      focal_(lens.perspective ? lens.focal : lens.middle.y / std::tan(kParallelAngle / 2)) {}

}  // namespace afx::render
