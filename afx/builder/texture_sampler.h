// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "afx/builder/mesh.h"
#include "afx/picture.h"

namespace afx {

/// A texture with the means over 2 x 2, 4 x 4, ... texels (a mip pyramid), all taken in linear
/// light and weighted by alpha where there is alpha. The picture must stay where it is.
class TextureSampler {
 public:
  /// picture   not empty, 1..4 components, sRGB
  explicit TextureSampler(const Picture& picture);

  /// The means of linear light times alpha (r, g, b) and of alpha (a; 1 where the picture has none)
  /// around a place: bilinear at the level whose texels are nearest in size to the area asked for.
  /// place   texture coordinates, finite, (0, 0) the lower left corner
  /// area    in texels of the picture; 1 and less: the picture itself
  [[nodiscard]] glm::vec4 sample(glm::dvec2 place, double area, Wrap wrap_u, Wrap wrap_v) const;

  [[nodiscard]] double texels() const {
    return static_cast<double>(picture_->width) * picture_->height;
  }

 private:
  struct Level {
    uint32_t width, height;
    // Linear light times alpha in three samples, and alpha if the picture has it; 65535 = 1. Empty
    // at level 0: the picture has them.
    std::vector<uint16_t> samples;
  };
  [[nodiscard]] size_t samples_a_texel() const { return has_alpha_ ? 4 : 3; }
  [[nodiscard]] const uint16_t* texel(const Level& level, uint32_t x, uint32_t y) const {
    return level.samples.data() + (size_t{y} * level.width + x) * samples_a_texel();
  }
  [[nodiscard]] glm::vec3 light(size_t level, uint32_t x, uint32_t y) const;
  [[nodiscard]] float alpha(size_t level, uint32_t x, uint32_t y) const;
  [[nodiscard]] Level half(size_t level) const;

  const Picture* picture_;
  const std::array<float, 256>* linear_;  // of sRGB values
  bool has_alpha_;
  std::vector<Level> levels_;
};

}  // namespace afx
