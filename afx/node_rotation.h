// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "nodes/field_value.h"

namespace afx {

/// The rotation of an SFRotation as a quaternion; an axis of length 0 means no rotation.
/// T   float or double
template <class T>
glm::qua<T> quaternion_of(const nodes::Rotation& rotation) {
  const glm::vec<3, T> axis(rotation.x, rotation.y, rotation.z);
  const T length = glm::length(axis);
  if (!(length > 0)) return {1, 0, 0, 0};
  return glm::angleAxis(static_cast<T>(rotation.angle), axis / length);
}

/// The other way round. quaternion   of length 1
template <class T>
nodes::Rotation rotation_of(const glm::qua<T>& quaternion) {
  const glm::vec3 axis(glm::axis(quaternion));
  return {axis.x, axis.y, axis.z, static_cast<float>(glm::angle(quaternion))};
}

}  // namespace afx
