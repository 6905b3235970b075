// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

#include "render/lens.h"
#include "render/mip_picture.h"
#include "render/sky.h"

namespace afx::render {

/// What a backdrop shows at the pixels of a picture. May be used by several threads.
class BackdropPainter {
 public:
  /// All must outlive it; the backdrop's pictures are among `pictures`.
  BackdropPainter(const Backdrop& backdrop, const Lens& lens, const RenderOptions& options,
                  const MipPictures& pictures);

  /// Linear light at the middle of a pixel.
  [[nodiscard]] glm::vec3 light(uint32_t x, uint32_t y) const;

 private:
  const Backdrop& backdrop_;
  SkyRays rays_;
  double samples_;  // along the side of a pixel
  std::array<const MipPicture*, 6> pictures_;
};

}  // namespace afx::render
