// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/mesh_pictures.h"

#include <algorithm>
#include <array>

#include "afx/srgb.h"

namespace afx {

Picture tinted(const Picture& picture, const glm::vec3& colour, bool keep_alpha) {
  const bool has_alpha = picture.components % 2 == 0 && keep_alpha;
  std::array<std::array<uint8_t, 256>, 3> curves{};
  for (int k = 0; k < 3; ++k)
    for (size_t value = 0; value < 256; ++value)
      curves[static_cast<size_t>(k)][value] = linear_to_srgb(srgb_to_linear()[value] * colour[k]);
  Picture out(picture.width, picture.height, has_alpha ? 4 : 3);
  for (uint32_t y = 0; y < picture.height; ++y)
    for (uint32_t x = 0; x < picture.width; ++x) {
      const Rgba8 c = colour_at(picture, x, y);
      uint8_t* to = out.pixel(x, y);
      to[0] = curves[0][c.r];
      to[1] = curves[1][c.g];
      to[2] = curves[2][c.b];
      if (has_alpha) to[3] = c.a;
    }
  return out;
}

Picture with_mirror_image(const Picture& picture, bool u, bool v) {
  const uint32_t width = picture.width, height = picture.height, n = picture.components;
  Picture out(u ? 2 * width : width, v ? 2 * height : height, n);
  for (uint32_t y = 0; y < out.height; ++y) {
    // The rows run from the top, the mirror image is above.
    const uint32_t row = !v ? y : (y < height ? height - 1 - y : y - height);
    for (uint32_t x = 0; x < out.width; ++x)
      std::copy_n(picture.pixel(x < width ? x : 2 * width - 1 - x, row), n, out.pixel(x, y));
  }
  return out;
}

}  // namespace afx
