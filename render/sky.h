// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What a backdrop shows in a direction: formulas that all renderers share. Source: ISO/IEC
// 14772-1:1997 (VRML97), Background (clause not checked).
#pragma once

#include <cstddef>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "afx/surroundings.h"
#include "render/lens.h"

namespace afx::render {

/// The sky's colour, or the ground's where there is ground: display values. Between two angles the
/// colours are mixed linearly, in display values, by the angle.
///
/// direction   in the backdrop's system, of any length; 0 is taken for the zenith
[[nodiscard]] glm::vec3 sky_colour(const Backdrop& backdrop, const glm::dvec3& direction);

/// A place on the cube of pictures.
struct CubePlace {
  size_t face;      ///< as in Backdrop::pictures
  glm::vec2 place;  ///< (s, t), (0, 0) the lower left corner of the picture
};

/// Where a direction meets the cube: on the face of its largest coordinate.
[[nodiscard]] CubePlace cube_place(const glm::dvec3& direction);
/// Where it meets the plane of that face: beyond 0..1 outside of the face. Not finite if it runs
/// along the plane.
[[nodiscard]] glm::vec2 place_on_face(size_t face, const glm::dvec3& direction);

/// The directions in which the places on the screen see the backdrop. A parallel projection sees it
/// as a perspective one of 45 degrees, full vertical angle, would: else all of it would have one
/// colour.
class SkyRays {
 public:
  SkyRays(const Backdrop& backdrop, const Lens& lens);
  /// The direction in the backdrop's system; not of length 1. Places as in Lens.
  [[nodiscard]] glm::dvec3 at(const glm::dvec2& place) const {
    return to_backdrop_ *
           glm::dvec3((place.x - middle_.x) / focal_, (middle_.y - place.y) / focal_, -1);
  }

 private:
  glm::dmat3 to_backdrop_;
  glm::dvec2 middle_;
  double focal_;
};

}  // namespace afx::render
