// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/local_mean.h"

#include <algorithm>

namespace afx {

Picture local_mean(const Picture& picture) {
  Picture result(picture.width, picture.height, picture.components);
  for (uint32_t y = 0; y < picture.height; ++y) {
    const uint32_t y0 = y > 0 ? y - 1 : 0, y1 = std::min(y + 1, picture.height - 1);
    for (uint32_t x = 0; x < picture.width; ++x) {
      const uint32_t x0 = x > 0 ? x - 1 : 0, x1 = std::min(x + 1, picture.width - 1);
      const uint32_t count = (x1 - x0 + 1) * (y1 - y0 + 1);
      for (uint32_t k = 0; k < picture.components; ++k) {
        uint32_t sum = 0;
        for (uint32_t b = y0; b <= y1; ++b)
          for (uint32_t a = x0; a <= x1; ++a) sum += picture.pixel(a, b)[k];
        result.pixel(x, y)[k] = static_cast<uint8_t>(sum / count);
      }
    }
  }
  return result;
}

}  // namespace afx
