// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Models turned, scaled and moved before anything is built from them.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "afx/builder/grid.h"
#include "afx/builder/mesh.h"
#include "afx/surfels.h"
#include "codec/error.h"

namespace afx {

/// Which axis of the input points up; the model is turned so that it becomes y.
enum class UpAxis : uint8_t { y, z };

struct Placement {
  UpAxis up = UpAxis::y;  ///< turned first, about the origin
  double scale = 1;       ///< factor of all lengths, about the origin; > 0
  /// Length of the longest side of the upright box around the model, whose middle moves to the
  /// origin; 0: it stays where it is. A model without extent is moved only.
  double fit = 0;
  bool operator==(const Placement&) const = default;
};

/// Places a model. Normals turn with it and keep their length.
/// Errors  bad_argument, and nothing is changed: a scale that is no positive number, a length to
///         fit that is none, both at once, or coordinates that would be too large (1e37)
Status place(Mesh& mesh, const Placement& placement);
Status place(PointCloud& cloud, const Placement& placement);
Status place(Surfels& surfels, const Placement& placement);

/// Moves a model. Of points only the origin moves, so that they keep their precision.
void move_by(Mesh& mesh, const glm::dvec3& offset);
void move_by(PointCloud& cloud, const glm::dvec3& offset);
void move_by(Surfels& surfels, const glm::dvec3& offset);

/// The smallest upright box around the vertices that triangles use. Without triangles: the origin.
Bounds bounds_of(const Mesh& mesh);
/// The same around the centres of pieces of surface.
Bounds bounds_of(const Surfels& surfels);

}  // namespace afx
