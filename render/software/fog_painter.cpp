// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/software/fog_painter.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "render/shading.h"

namespace afx::render {
namespace {

/// As a part of the fog's range. Fog changes by at most 1.5 parts of it for each part of the way,
/// and no depth is farther than half of this from the middle.
constexpr double kSameDepth = 1.0 / 1024;

}  // namespace

FogPainter::FogPainter(const std::optional<Fog>& fog, const Lens& lens, unsigned n)
    : fog_(fog), lens_(lens), n_(n) {
  if (!fog) return;
  light_ = linear_light(fog->colour);
  same_depth_ = static_cast<float>(std::min(fog->visibility_range * kSameDepth, 1e30));
}

float FogPainter::leaves(double x, double y, float depth) const {
  double slant = 1;
  if (lens_.perspective) {
    const double right = (x - lens_.middle.x) / lens_.focal;
    const double down = (y - lens_.middle.y) / lens_.focal;
    slant = std::sqrt(1 + right * right + down * down);
  }
  const double distance = std::min(slant * static_cast<double>(depth), 1e38);
  return fog_leaves(*fog_, static_cast<float>(distance));
}

glm::vec3 FogPainter::mixed(const glm::vec3& light, double x, double y, float depth) const {
  return fog_ ? glm::mix(light_, light, leaves(x, y, depth)) : light;
}

void FogPainter::lay_sample(TileSamples& tile, size_t at, float part) const {
  const float fog = tile.sum_weight[at] * (1 - part);
  tile.sum_r[at] = part * tile.sum_r[at] + fog * light_.r;
  tile.sum_g[at] = part * tile.sum_g[at] + fog * light_.g;
  tile.sum_b[at] = part * tile.sum_b[at] + fog * light_.b;
}

void FogPainter::lay_pixel(TileSamples& tile, size_t first) const {
  float least = kFar, most = 0;
  for (size_t y = 0; y < n_; ++y) {
    for (size_t x = 0; x < n_; ++x) {
      const size_t i = first + y * tile.side + x;
      if (tile.sum_weight[i] == 0) continue;
      least = std::min(least, tile.depths[i]);
      most = std::max(most, tile.depths[i]);
    }
  }
  if (!(least <= most)) return;
  const double half = static_cast<double>(n_) / 2;
  const double x = static_cast<double>(tile.left) + static_cast<double>(first % tile.side) + half;
  const double y = static_cast<double>(tile.top) + static_cast<double>(first / tile.side) + half;
  const bool same = most - least <= same_depth_;
  const float part = same ? leaves(x, y, least + (most - least) / 2) : 0;
  for (size_t row = 0; row < n_; ++row) {
    for (size_t column = 0; column < n_; ++column) {
      const size_t i = first + row * tile.side + column;
      lay_sample(tile, i, same ? part : leaves(x, y, tile.depths[i]));
    }
  }
}

void FogPainter::lay(TileSamples& tile) const {
  if (!fog_) return;
  for (size_t y = 0; y < tile.side; y += n_)
    for (size_t x = 0; x < tile.side; x += n_) lay_pixel(tile, y * tile.side + x);
}

}  // namespace afx::render
