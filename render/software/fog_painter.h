// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>

#include "afx/surroundings.h"
#include "render/lens.h"
#include "render/software/tile_samples.h"

namespace afx::render {

/// Mixes fog into what is drawn. May be used by several threads.
class FogPainter {
 public:
  /// All must outlive it. Without fog it does nothing. n   samples along the side of a pixel
  FogPainter(const std::optional<Fog>& fog, const Lens& lens, unsigned n);

  /// Into all samples of a tile where something is. To be called when the sums are colours with
  /// coverage. A pixel whose samples lie at nearly the same depth gets the same fog in all of them:
  /// what is left differs by less than 1/1000.
  void lay(TileSamples& tile) const;
  /// The light that is left of something at a place on the screen and a depth, and of the fog.
  [[nodiscard]] glm::vec3 mixed(const glm::vec3& light, double x, double y, float depth) const;

 private:
  [[nodiscard]] float leaves(double x, double y, float depth) const;
  void lay_pixel(TileSamples& tile, size_t first) const;
  void lay_sample(TileSamples& tile, size_t at, float part) const;

  const std::optional<Fog>& fog_;
  const Lens& lens_;
  size_t n_;
  glm::vec3 light_{0};
  float same_depth_ = 0;
};

}  // namespace afx::render
