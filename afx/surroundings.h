// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What a scene has around its objects: background, fog, viewpoints, navigation. Source: ISO/IEC
// 14772-1:1997 (VRML97), Background, Fog, Viewpoint, NavigationInfo (clauses not checked).
#pragma once

#include <array>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

#include "afx/picture.h"

namespace afx {

/// A sky around everything, infinitely far away. Colours are display values, 0..1.
struct Backdrop {
  std::vector<glm::vec3> sky_colours{glm::vec3(0)};  ///< from the zenith (+y) down; at least one
  std::vector<float> sky_angles{};  ///< radians from the zenith, rising; one less than colours.
                                    ///< Below the last the last colour stays
  std::vector<glm::vec3> ground_colours{};  ///< from the nadir up; none: no ground
  std::vector<float> ground_angles{};       ///< radians from the nadir; above the last: the sky
  /// Pictures on a cube around the viewer, over sky and ground: front (-z), back, left, right, top,
  /// bottom; null: none. Seen from the middle with +y up; top and bottom as one sees them turning
  /// up or down from the front.
  std::array<std::shared_ptr<const Picture>, 6> pictures{};
  glm::dmat3 to_world{1};  ///< a rotation
};

/// Fog mixes all colours with its own by the distance from the viewer, d:
/// linear: (V - d) / V of the object's colour is left; exponential: exp(-d / (V - d)); from d = V
/// on none.
struct Fog {
  bool exponential = false;
  glm::vec3 colour{1};          ///< display values
  double visibility_range = 0;  ///< V in world units, > 0
};

/// A place to look from that the scene names.
struct Viewpoint {
  std::string name;                    ///< the DEF name; may be empty
  std::string description;             ///< may be empty
  glm::dvec3 position{0, 0, 10};       ///< in the world
  glm::dquat orientation{1, 0, 0, 0};  ///< in the world; identity looks along -z with +y up
  double field_of_view = 0.785398;     ///< radians: the smaller of both full angles of the picture
};

/// How the viewer moves.
struct Navigation {
  bool headlight = true;
  double speed = 1;                               ///< scene units a second
  double visibility_limit = 0;                    ///< 0 = no limit
  std::vector<std::string> types{"WALK", "ANY"};  ///< "EXAMINE", "FLY", ...
};

}  // namespace afx
