// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// From where else an object must be looked at so that all of its outside is seen.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace afx {

/// What is looked for in choose_directions().
struct ViewChoice {
  unsigned most = 121;    ///< directions
  double least_gain = 0;  ///< a further one shows at least this part of the exposed voxels anew
  unsigned threads = 0;   ///< 0 = all cores; the result is the same for any number
};

/// Chooses directions to cameras (unit vectors), the most useful first, from 92 that are spread
/// evenly: those with coordinates as -2..2, but for the axes. Each shows the most exposed voxels
/// (exposure.h) that neither the six views from the sides nor those before it show. Surfaces of
/// more than 8 levels are looked at in their 8 upper ones, so that the time is bounded.
///
/// codes    Morton codes of all voxels, ascending, levels deep
/// Memory   some 16 MB for each thread
std::vector<glm::dvec3> choose_directions(std::span<const uint64_t> codes, unsigned levels,
                                          const ViewChoice& choice);

}  // namespace afx
