// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <vector>

#include "render/camera.h"

namespace afx::render {

/// How far the views of a ring look from below and from above: radians, 20 degrees.
inline constexpr double kRingElevation = 0.3490658503988659;

/// Views from all around, to compare pictures of models: view k of n from the azimuth 2 pi k / n,
/// beginning at the front (+z) and going to the right (+x), and by turns from below (the first) and
/// above. Of an odd number the last and the first, which are neighbours, are both from below. All
/// else is as in a View by default.
[[nodiscard]] std::vector<View> view_ring(unsigned count);

}  // namespace afx::render
