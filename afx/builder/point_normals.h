// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "afx/builder/nearest_points.h"

namespace afx {

/// The neighbourhood that a normal is estimated from: so many points, the point itself among them.
inline constexpr size_t kNormalNeighbours = 12;

/// The normals of the surface that points lie on: for each, the direction in which its nearest
/// points vary least (principal components). Of length 1, on either side of the surface; zero where
/// the nearest points lie on a line or in one place.
///
/// points    as `index` was made of
/// threads   0 = all cores; the result is the same for any number
/// Source    Hoppe, DeRose, Duchamp, McDonald, Stuetzle, SIGGRAPH 1992, section 3.1
std::vector<glm::vec3> estimate_normals(std::span<const glm::vec3> points,
                                        const NearestPoints& index, unsigned threads);

/// The mean of directions whose sign means nothing: each is turned to the side of those before it.
class DirectionMean {
 public:
  void add(const glm::dvec3& direction);
  /// Of length 1; zero of nothing.
  [[nodiscard]] glm::dvec3 value() const;

 private:
  glm::dvec3 sum_{0, 0, 0};
};

}  // namespace afx
