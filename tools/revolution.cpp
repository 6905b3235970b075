// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/revolution.h"

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <numbers>

namespace afx::tools {
namespace {

/// Positive where o, a, b turn left.
double turn(const glm::dvec2& o, const glm::dvec2& a, const glm::dvec2& b) {
  return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

/// Of (radius, height): the corners of the hull's side away from the axis, upwards.
std::vector<glm::dvec2> outer_profile(std::vector<glm::dvec2> points) {
  std::sort(points.begin(), points.end(), [](const glm::dvec2& a, const glm::dvec2& b) {
    return a.y != b.y ? a.y < b.y : a.x < b.x;
  });
  std::vector<glm::dvec2> profile;
  for (const glm::dvec2& point : points) {
    while (profile.size() >= 2 && turn(profile[profile.size() - 2], profile.back(), point) <= 0)
      profile.pop_back();
    profile.push_back(point);
  }
  return profile;
}

}  // namespace

std::vector<glm::dvec3> revolution_outline(std::span<const glm::dvec3> points,
                                           const glm::dvec3& around) {
  constexpr int kSides = 256;
  // A polygon around the circle, not in it.
  const double wider = 1 / std::cos(std::numbers::pi / kSides);
  std::vector<glm::dvec2> places;
  for (const glm::dvec3& point : points)
    places.emplace_back(std::hypot(point.x - around.x, point.z - around.z), point.y);
  std::vector<glm::dvec3> outline;
  for (const glm::dvec2& corner : outer_profile(std::move(places))) {
    for (int side = 0; side < kSides; ++side) {
      const double angle = 2 * std::numbers::pi * side / kSides;
      outline.emplace_back(around.x + wider * corner.x * std::cos(angle), corner.y,
                           around.z + wider * corner.x * std::sin(angle));
    }
  }
  return outline;
}

}  // namespace afx::tools
