// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/software/pixel_row.h"

#include <algorithm>

#include "afx/srgb.h"

namespace afx::render {
namespace {

/// Lets the samples of a row of pixels, n x n in each, flow together.
template <class Join>
void join(const float* samples, size_t stride, size_t n, std::vector<float>& pixels,
          const Join& join_one) {
  for (size_t y = 0; y < n; ++y) {
    const float* sample = samples + y * stride;
    for (float& pixel : pixels)
      for (size_t x = 0; x < n; ++x) join_one(pixel, *sample++);
  }
}

}  // namespace

PixelRow::PixelRow(const TileGrid& grid)
    : r_(grid.side), g_(grid.side), b_(grid.side), a_(grid.side), depths_(grid.side) {}

void PixelRow::sum(const TileSamples& samples, uint32_t row, const RenderOptions& options) {
  const size_t n = options.samples;
  const size_t first = row * n * samples.side;
  const float part = 1 / static_cast<float>(n * n);
  const auto mean = [&](const std::vector<float>& from, std::vector<float>& to) {
    if (n == 1) return void(std::copy_n(&from[first], to.size(), to.begin()));
    std::fill(to.begin(), to.end(), 0.0F);
    join(&from[first], samples.side, n, to, [](float& pixel, float sample) { pixel += sample; });
    for (float& pixel : to) pixel *= part;
  };
  mean(samples.sum_r, r_);
  mean(samples.sum_g, g_);
  mean(samples.sum_b, b_);
  mean(samples.sum_weight, a_);
  if (!options.depth) return;
  std::fill(depths_.begin(), depths_.end(), kFar);
  join(&samples.depths[first], samples.side, n, depths_,
       [](float& pixel, float sample) { pixel = std::min(pixel, sample); });
}

void PixelRow::blend(Rgba8 background) {
  const std::array<float, 256>& linear = srgb_to_linear();
  const float r = linear[background.r], g = linear[background.g], b = linear[background.b];
  const float a = static_cast<float>(background.a) / 255;
  for (size_t i = 0; i < r_.size(); ++i) {
    const float through = std::max(0.0F, 1 - a_[i]) * a;
    const float opacity = a_[i] + through;
    // What is wholly transparent keeps the background's colour, for those who drop alpha.
    const bool nothing = opacity == 0;
    const float part = 1 / (nothing ? 1 : opacity), rest = nothing ? 1 : through;
    r_[i] = (r_[i] + rest * r) * part;
    g_[i] = (g_[i] + rest * g) * part;
    b_[i] = (b_[i] + rest * b) * part;
    a_[i] = opacity;
  }
}

void PixelRow::blend(const BackdropPainter& backdrop, uint32_t x, uint32_t y, size_t count) {
  for (size_t i = 0; i < count; ++i) {
    const float through = std::max(0.0F, 1 - a_[i]);
    a_[i] = 1;
    if (through == 0) continue;
    const glm::vec3 light = backdrop.light(x + static_cast<uint32_t>(i), y);
    r_[i] += through * light.r;
    g_[i] += through * light.g;
    b_[i] += through * light.b;
  }
}

void PixelRow::encode(uint8_t* pixels, size_t count) const {
  const SrgbEncoder& encoded = SrgbEncoder::get();
  for (size_t i = 0; i < count; ++i, pixels += 4) {
    pixels[0] = encoded(r_[i]);
    pixels[1] = encoded(g_[i]);
    pixels[2] = encoded(b_[i]);
    pixels[3] = static_cast<uint8_t>(static_cast<int>(255 * a_[i] + 0.5F));
  }
}

}  // namespace afx::render
