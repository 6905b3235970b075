// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/shapes/solids.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace afx {
namespace {

uint32_t add_vertex(Geometry& out, const glm::dvec3& position, const glm::dvec3& normal,
                    const glm::dvec2& texture) {
  out.positions.emplace_back(position);
  out.normals.emplace_back(normal);
  out.texture_coordinates.emplace_back(texture);
  return static_cast<uint32_t>(out.positions.size() - 1);
}

void add_triangle(Geometry& out, uint32_t a, uint32_t b, uint32_t c) {
  out.indices.insert(out.indices.end(), {a, b, c});
}

/// One side of a box: where its picture's left, lower edges lie. All of -1..1 in two axes.
struct BoxSide {
  glm::vec3 normal, right, up;
};
constexpr glm::vec3 kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};
// The pictures stand upright as one sees them walking around the box; on top and bottom as one sees
// them when those are turned to the front.
const BoxSide kBoxSides[] = {{kZ, kX, kY},  {-kZ, -kX, kY}, {kX, -kZ, kY},
                             {-kX, kZ, kY}, {kY, kX, -kZ},  {-kY, kX, kZ}};

/// The direction from the axis at a part of the way around, from the back over the left (-x).
glm::dvec3 around(uint32_t step) {
  if (step == kSolidSides) step = 0;  // the seam closes exactly
  const double angle = 2 * std::numbers::pi * step / kSolidSides;
  return {-std::sin(angle), 0, -std::cos(angle)};
}

void add_disc(Geometry& out, const RoundSolid& solid, bool top) {
  const double y = (top ? 0.5 : -0.5) * static_cast<double>(solid.height), sign = top ? 1 : -1;
  const glm::dvec3 normal(0, sign, 0);
  const uint32_t centre = add_vertex(out, {0, y, 0}, normal, {0.5, 0.5});
  for (uint32_t i = 0; i < kSolidSides; ++i) {
    const glm::dvec3 d = around(i);
    add_vertex(out, d * static_cast<double>(solid.radius) + glm::dvec3(0, y, 0), normal,
               {0.5 + 0.5 * d.x, 0.5 - sign * 0.5 * d.z});
  }
  for (uint32_t i = 0; i < kSolidSides; ++i) {
    const uint32_t a = centre + 1 + i, b = centre + 1 + (i + 1) % kSolidSides;
    add_triangle(out, centre, top ? a : b, top ? b : a);
  }
}

}  // namespace

Geometry box_geometry(const glm::vec3& size) {
  Geometry out;
  const glm::vec3 half = size / 2.0F;
  for (const BoxSide& side : kBoxSides) {
    const auto corner = [&](float s, float t) {
      return add_vertex(out,
                        half * (side.normal + side.right * (2 * s - 1) + side.up * (2 * t - 1)),
                        side.normal, {s, t});
    };
    const uint32_t a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
    add_triangle(out, a, b, c);
    add_triangle(out, a, c, d);
  }
  return out;
}

Geometry sphere_geometry(float radius) {
  Geometry out;
  constexpr uint32_t kRow = kSolidSides + 1;
  for (uint32_t ring = 0; ring <= kSphereRings; ++ring) {  // from the south pole
    const double t = static_cast<double>(ring) / kSphereRings;
    const bool pole = ring == 0 || ring == kSphereRings;
    const double flat = pole ? 0 : std::sin(std::numbers::pi * t);
    for (uint32_t i = 0; i <= kSolidSides; ++i) {
      const glm::dvec3 n = around(i) * flat + glm::dvec3(0, -std::cos(std::numbers::pi * t), 0);
      // At a pole each triangle has a corner of its own, in the middle of its piece of picture.
      add_vertex(out, n * static_cast<double>(radius), n,
                 {(i + (pole ? 0.5 : 0.0)) / kSolidSides, t});
    }
  }
  for (uint32_t ring = 0; ring < kSphereRings; ++ring) {
    for (uint32_t i = 0; i < kSolidSides; ++i) {
      const uint32_t a = ring * kRow + i, b = a + 1, c = b + kRow, d = a + kRow;
      if (ring == 0) {
        add_triangle(out, a, c, d);
      } else if (ring + 1 == kSphereRings) {
        add_triangle(out, a, b, d);
      } else {
        add_triangle(out, a, b, c);
        add_triangle(out, a, c, d);
      }
    }
  }
  return out;
}

Geometry cone_geometry(const RoundSolid& cone) {
  Geometry out;
  const double r = cone.radius, h = cone.height;
  // Perpendicular to the line from the apex down the side.
  const auto normal = [&](const glm::dvec3& d) {
    const glm::dvec3 n(d * h + glm::dvec3(0, r, 0));
    return glm::length(n) > 0 ? glm::normalize(n) : d;
  };
  if (cone.side) {
    for (uint32_t i = 0; i <= kSolidSides; ++i) {
      const glm::dvec3 d = around(i);
      add_vertex(out, d * r - glm::dvec3(0, h / 2, 0), normal(d),
                 {static_cast<double>(i) / kSolidSides, 0});
    }
    for (uint32_t i = 0; i < kSolidSides; ++i) {
      const glm::dvec3 middle = glm::normalize(around(i) + around(i + 1));
      const uint32_t apex =
          add_vertex(out, {0, h / 2, 0}, normal(middle), {(i + 0.5) / kSolidSides, 1});
      add_triangle(out, i, i + 1, apex);
    }
  }
  if (cone.bottom) add_disc(out, cone, false);
  return out;
}

Geometry cylinder_geometry(const RoundSolid& cylinder) {
  Geometry out;
  const double r = cylinder.radius, h = cylinder.height;
  if (cylinder.side) {
    for (uint32_t i = 0; i <= kSolidSides; ++i) {
      const glm::dvec3 d = around(i);
      const double s = static_cast<double>(i) / kSolidSides;
      add_vertex(out, d * r - glm::dvec3(0, h / 2, 0), d, {s, 0});
      add_vertex(out, d * r + glm::dvec3(0, h / 2, 0), d, {s, 1});
    }
    for (uint32_t i = 0; i < kSolidSides; ++i) {
      add_triangle(out, 2 * i, 2 * i + 2, 2 * i + 3);
      add_triangle(out, 2 * i, 2 * i + 3, 2 * i + 1);
    }
  }
  if (cylinder.top) add_disc(out, cylinder, true);
  if (cylinder.bottom) add_disc(out, cylinder, false);
  return out;
}

}  // namespace afx
