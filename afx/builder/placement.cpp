// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/placement.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <string>

namespace afx {
namespace {

constexpr double kMostCoordinate = 1e37;  // what floats hold, with room to reckon

Error refused(std::string text) { return Error{Errc::bad_argument, {}, std::move(text), {}, {}}; }

Status check(const Placement& placement) {
  if (!(placement.scale > 0) || std::isinf(placement.scale))
    return refused("the scale is no positive number");
  if (!(placement.fit >= 0) || std::isinf(placement.fit))
    return refused("the length to fit the model to is no positive number");
  if (placement.fit > 0 && placement.scale != 1)
    return refused("a model is scaled or fitted to a length, not both");
  return {};
}

// z up becomes y up: a quarter turn about x.
template <class Vector>
Vector turned(const Vector& v, UpAxis up) {
  return up == UpAxis::z ? Vector(v.x, v.z, -v.y) : v;
}

// (turned(point) - centre) * scale.
struct Move {
  UpAxis up;
  glm::dvec3 centre;
  double scale;
  [[nodiscard]] glm::dvec3 operator()(const glm::dvec3& point) const {
    return (turned(point, up) - centre) * scale;
  }
};

Result<Move> move_of(const Bounds& bounds, const Placement& placement) {
  if (Status status = check(placement); !status.ok()) return status.error();
  Move move{placement.up, glm::dvec3(0), placement.scale};
  if (placement.fit > 0) {
    const glm::dvec3 sides = bounds.high - bounds.low;
    const double longest = std::max({sides.x, sides.y, sides.z});
    move.centre = turned(0.5 * (bounds.low + bounds.high), placement.up);
    move.scale = longest > 0 ? placement.fit / longest : 1;
  }
  const glm::dvec3 low = glm::abs(move(bounds.low)), high = glm::abs(move(bounds.high));
  const glm::dvec3 most = glm::max(low, high);
  if (!(std::max({most.x, most.y, most.z}) < kMostCoordinate))
    return refused("so large a scale makes coordinates that are not finite");
  return move;
}

}  // namespace

Bounds bounds_of(const Mesh& mesh) {
  BoundsFinder finder;
  for (const glm::uvec3& triangle : mesh.triangles)
    for (int k = 0; k < 3; ++k) finder.add(glm::dvec3(mesh.positions[triangle[k]]));
  return finder.bounds();
}

Bounds bounds_of(const Surfels& surfels) {
  BoundsFinder finder;
  for (const glm::dvec3& centre : surfels.centres) finder.add(centre);
  return finder.bounds();
}

Status place(Mesh& mesh, const Placement& placement) {
  const Result<Move> move = move_of(bounds_of(mesh), placement);
  if (!move.ok()) return move.error();
  for (glm::vec3& p : mesh.positions) {
    // Vertices that no triangle uses may lie anywhere; they stay finite.
    const glm::dvec3 moved = move.value()(glm::dvec3(p));
    p = glm::vec3(glm::clamp(moved, -kMostCoordinate, kMostCoordinate));
  }
  return {};
}

Status place(PointCloud& cloud, const Placement& placement) {
  const Result<Move> move = move_of(bounds_of(cloud.positions), placement);
  if (!move.ok()) return move.error();
  for (glm::vec3& p : cloud.positions) p = glm::vec3(move.value()(glm::dvec3(p)));
  for (glm::vec3& n : cloud.normals) n = turned(n, placement.up);
  cloud.origin =
      placement.fit > 0 ? glm::dvec3(0) : turned(cloud.origin, placement.up) * placement.scale;
  return {};
}

Status place(Surfels& surfels, const Placement& placement) {
  const Result<Move> move = move_of(bounds_of(surfels), placement);
  if (!move.ok()) return move.error();
  const auto longer = static_cast<float>(move.value().scale);
  for (size_t i = 0; i < surfels.size(); ++i) {
    surfels.centres[i] = move.value()(surfels.centres[i]);
    surfels.u[i] = turned(surfels.u[i], placement.up) * longer;
    surfels.v[i] = turned(surfels.v[i], placement.up) * longer;
  }
  return {};
}

void move_by(Mesh& mesh, const glm::dvec3& offset) {
  for (glm::vec3& p : mesh.positions)
    p = glm::vec3(glm::clamp(glm::dvec3(p) + offset, -kMostCoordinate, kMostCoordinate));
}

void move_by(PointCloud& cloud, const glm::dvec3& offset) { cloud.origin += offset; }

void move_by(Surfels& surfels, const glm::dvec3& offset) {
  for (glm::dvec3& centre : surfels.centres) centre += offset;
}

}  // namespace afx
