// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Cuts polygons that may be concave into triangles.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace afx {

/// Cuts a polygon into triangles by taking away corner after corner that has no other inside. A
/// polygon that crosses itself is cut somehow.
///
/// corners   3 or more, counter-clockwise, finite
/// work      how many tests of a corner are left; each costs one
/// Returns n - 2 triangles by numbers of corners, counter-clockwise; none where work ran out.
std::vector<std::array<uint32_t, 3>> clip_ears(std::span<const glm::dvec2> corners, uint64_t& work);

}  // namespace afx
