// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace afx::tools {

/// Points whose convex hull holds `points` however they are turned around the vertical axis (y)
/// through `around`, and no more than a 10,000th of the radius beyond that. They are
/// symmetrical to the planes through `around` that face x and z.
std::vector<glm::dvec3> revolution_outline(std::span<const glm::dvec3> points,
                                           const glm::dvec3& around);

}  // namespace afx::tools
