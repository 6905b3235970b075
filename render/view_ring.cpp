// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/view_ring.h"

#include <numbers>

namespace afx::render {

std::vector<View> view_ring(unsigned count) {
  std::vector<View> views(count);
  for (unsigned k = 0; k < count; ++k) {
    views[k].azimuth = 2 * std::numbers::pi * k / count;
    views[k].elevation = k % 2 == 0 ? -kRingElevation : kRingElevation;
  }
  return views;
}

}  // namespace afx::render
