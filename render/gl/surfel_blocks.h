// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Surfels as vertices, in blocks that can be passed over as wholes.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "afx/surfels.h"

namespace afx::render {

/// A run of surfels that lie close together, in the local system.
struct SurfelBlock {
  glm::dvec3 centre;
  double radius;  ///< around it, of their centres
  double reach;   ///< the longest of |u| + |v|
  uint32_t first, count;
};

/// A surfel as a vertex.
struct SurfelVertex {
  glm::vec3 offset;  ///< from the centre of its block
  glm::vec3 u, v;
  Rgba8 colour;
};

/// Sorts the surfels that are drawn, those neither transparent nor without a place, into blocks,
/// in an order that depends on them alone.
std::vector<SurfelBlock> make_blocks(const Surfels& surfels, std::vector<SurfelVertex>& vertices);

}  // namespace afx::render
