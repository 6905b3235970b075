// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The one form that every model can be taken to: small flat pieces of coloured surface. The paper's
// point-based representation (section VII.A), with the extent that each sample stands for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "afx/picture.h"

namespace afx {

/// Pieces of surface. The lists are parallel. Piece n is the parallelogram of the points
/// centres[n] + s * u[n] + t * v[n] with s and t in [-1, 1]; its outside is where u x v points.
/// Both zero: a point without extent.
struct Surfels {
  std::vector<glm::dvec3> centres;
  std::vector<glm::vec3> u, v;
  std::vector<Rgba8> colours;  ///< sRGB; a is opacity

  [[nodiscard]] size_t size() const { return centres.size(); }
  void reserve(size_t count) {
    centres.reserve(count);
    u.reserve(count);
    v.reserve(count);
    colours.reserve(count);
  }
  void push_back(const glm::dvec3& centre, const glm::vec3& half_u, const glm::vec3& half_v,
                 Rgba8 colour) {
    centres.push_back(centre);
    u.push_back(half_u);
    v.push_back(half_v);
    colours.push_back(colour);
  }
};

/// Memory of one piece in bytes, for limits.
inline constexpr uint64_t kSurfelBytes = sizeof(glm::dvec3) + 2 * sizeof(glm::vec3) + sizeof(Rgba8);

}  // namespace afx
