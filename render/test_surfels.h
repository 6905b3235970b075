// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Surfaces of surfels for the tests of this folder.
#pragma once

#include <cmath>
#include <memory>

#include "afx/surfels.h"
#include "render/test_scenes.h"

namespace afx::render {

inline Scene scene_of(const Surfels& surfels) {
  return {.surfels = {{.surfels = std::make_shared<Surfels>(surfels)}}};
}

/// The square |x| <= half, |y| <= half at that z, of n x n pieces.
inline void add_square(Surfels& surfels, double half, double z, int n, Rgba8 colour) {
  const auto side = static_cast<float>(half / n);
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const glm::dvec3 centre(half * ((2 * i + 1.0) / n - 1), half * ((2 * j + 1.0) / n - 1), z);
      surfels.push_back(centre, {side, 0, 0}, {0, side, 0}, colour);
    }
  }
}

/// The sphere around the origin as six parallel cameras see it, with n x n pixels each: a pixel is
/// the piece of the tangent plane that it looks at. Each sees what leans away by up to 60 degrees,
/// so that they overlap.
inline void add_surfel_sphere(Surfels& surfels, double radius, int n, Rgba8 colour) {
  const double h = radius / n;  // half a pixel
  for (int face = 0; face < 6; ++face) {
    const int axis = face / 2;
    const double sign = face % 2 == 0 ? 1 : -1;
    const auto turned = [&](double x, double y, double z) {
      glm::dvec3 p;
      p[axis] = sign * z;
      p[(axis + 1) % 3] = x;
      p[(axis + 2) % 3] = y;
      return p;
    };
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const double x = h * (2 * i + 1 - n), y = h * (2 * j + 1 - n);
        const double z2 = radius * radius - x * x - y * y;
        if (z2 < radius * radius / 4) continue;
        const double z = std::sqrt(z2);
        surfels.push_back(turned(x, y, z), glm::vec3(turned(h, 0, -h * x / z)),
                          glm::vec3(turned(0, h, -h * y / z)), colour);
      }
    }
  }
}

}  // namespace afx::render
