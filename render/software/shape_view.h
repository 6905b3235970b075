// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "afx/shape.h"
#include "render/lens.h"
#include "render/mip_picture.h"

namespace afx::render {

/// One shape as one camera sees it.
struct ShapeView {
  /// All checked; they must outlive it. Leaves `corners` empty.
  ShapeView(const Shape& the_shape, const Lens& lens, const MipPictures& pictures);

  /// Fills corners [first, first + count).
  void place_corners(size_t first, size_t count);
  [[nodiscard]] uint32_t primitives() const {
    return static_cast<uint32_t>(geometry->indices.size() / corners_of(geometry->kind));
  }
  /// The number of a primitive's corner, 0..2, among the positions.
  [[nodiscard]] uint32_t corner(uint32_t primitive, uint32_t k) const {
    return geometry->indices[primitive * corners_of(geometry->kind) + k];
  }

  const Shape* shape;
  const Geometry* geometry;
  const Look* look;
  const MipPicture* texture;  ///< null where there is none, or no coordinates for it
  bool transparent;           ///< some of it may be
  bool mirrored;              ///< corners that run counter-clockwise run clockwise in the view
  glm::dmat3 axes;            ///< local directions to the camera's system
  glm::dvec3 origin;          ///< of the local system, in the camera's
  glm::dmat3 normals;         ///< local normals to the camera's system; lengths change
  std::vector<glm::dvec3> corners;  ///< the positions in the camera's system
};

}  // namespace afx::render
