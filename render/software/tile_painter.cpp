// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/software/tile_painter.h"

#include <algorithm>
#include <cmath>

#include "afx/srgb.h"
#include "render/software/lanes.h"
#include "render/software/splat_painter.h"

namespace afx::render {

/// The surfels of the tile, the largest first; without those that share its cell only.
void TilePainter::collect_surfels(uint32_t column, uint32_t row) {
  surfels_.clear();
  const auto side = static_cast<float>(samples_.side);
  const SplatTiles& tiles = frame_.surfels;
  for (uint32_t level = tiles.levels(); level-- > 0;) {
    for (const uint32_t number : tiles.around(level, column, row)) {
      const Splat& s = tiles.splat(number);
      if (s.x + s.radius >= samples_.left && s.x - s.radius <= samples_.left + side &&
          s.y + s.radius >= samples_.top && s.y - s.radius <= samples_.top + side)
        surfels_.push_back(number);
    }
  }
}

void TilePainter::lay_octrees() {
  voxels_.clear();
  for (const OctreeView& view : frame_.octrees) {
    walk_.run(view, samples_, [this](const Splat& splat) {
      if (lay_depth(Disc(splat), samples_)) voxels_.push_back(splat);
    });
  }
}

/// Turns the sums into colours with coverage: premultiplied, the weight 0 or 1.
void TilePainter::finish_samples() {
  TileSamples& s = samples_;
  for (size_t i = 0; i < s.side * s.side; i += kLanes) {
    const Lanes weight = load(&s.sum_weight[i]);
    const LaneMask some = weight > 0;
    LaneMask wall{};
    if (s.has_walls) wall = ~some & (load(&s.walls[i]) < kFar);
    const Lanes part = 1 / (some ? weight : all(1));
    const auto finish = [&](std::vector<float>& sums, const std::vector<float>& walls) {
      Lanes mean = load(&sums[i]) * part;
      if (s.has_walls) mean = wall ? load(&walls[i]) : mean;
      store(&sums[i], mean);
    };
    finish(s.sum_r, s.wall_r);
    finish(s.sum_g, s.wall_g);
    finish(s.sum_b, s.wall_b);
    store(&s.sum_weight[i], (some | wall) ? all(1) : all(0));
  }
}

/// The mean of the samples over the background, both in linear light.
void TilePainter::resolve_pixel(size_t first, uint32_t x, uint32_t y, RenderedImage& image) const {
  const unsigned n = frame_.options.samples;
  float r = 0, g = 0, b = 0, covered = 0;
  float nearest = kFar;
  for (size_t row = 0; row < n; ++row) {
    for (size_t column = 0; column < n; ++column) {
      const size_t i = first + row * samples_.side + column;
      r += samples_.sum_r[i];
      g += samples_.sum_g[i];
      b += samples_.sum_b[i];
      covered += samples_.sum_weight[i];
      nearest = std::min(nearest, samples_.depths[i]);
    }
  }
  if (!image.depth.empty()) image.depth[size_t{y} * frame_.options.width + x] = nearest;
  uint8_t* const pixel = image.picture.pixel(x, y);
  const std::array<float, 256>& linear = srgb_to_linear();
  const Rgba8 back = frame_.options.background;
  const auto samples = static_cast<float>(n * n);
  if (frame_.backdrop) {
    glm::vec3 light(r, g, b);
    if (covered < samples) light += (samples - covered) * frame_.backdrop->light(x, y);
    for (int k = 0; k < 3; ++k) pixel[k] = linear_to_srgb(light[k] / samples);
    pixel[3] = 255;
    return;
  }
  const float through = (samples - covered) * static_cast<float>(back.a) / 255;
  const float opaque = covered + through;
  if (opaque == 0) {  // keeps the background's colour, for those who drop alpha
    pixel[0] = back.r, pixel[1] = back.g, pixel[2] = back.b, pixel[3] = 0;
    return;
  }
  pixel[0] = linear_to_srgb((r + through * linear[back.r]) / opaque);
  pixel[1] = linear_to_srgb((g + through * linear[back.g]) / opaque);
  pixel[2] = linear_to_srgb((b + through * linear[back.b]) / opaque);
  pixel[3] = static_cast<uint8_t>(255 * opaque / samples + 0.5F);
}

void TilePainter::resolve(uint32_t x, uint32_t y, RenderedImage& image) const {
  const RenderOptions& options = frame_.options;
  const uint32_t x_end = std::min(x + frame_.grid.side, options.width);
  const uint32_t y_end = std::min(y + frame_.grid.side, options.height);
  for (uint32_t py = y; py < y_end; ++py) {
    for (uint32_t px = x; px < x_end; ++px) {
      const size_t first = (size_t{py - y} * samples_.side + (px - x)) * options.samples;
      resolve_pixel(first, px, py, image);
    }
  }
}

void TilePainter::paint(uint32_t column, uint32_t row, RenderedImage& image) {
  samples_.clear(column, row);
  shapes_.lay_walls(column, row, samples_);
  collect_surfels(column, row);
  const SplatTiles& tiles = frame_.surfels;
  for (const uint32_t i : surfels_)
    lay_depth(Parallelogram(tiles.splat(i), tiles.slant(i)), samples_);
  lay_octrees();
  for (const uint32_t i : surfels_)
    lay_colour(Parallelogram(tiles.splat(i), tiles.slant(i)), samples_);
  for (const Splat& splat : voxels_) lay_colour(Disc(splat), samples_);
  finish_samples();
  shapes_.lay_fog(samples_);
  shapes_.lay_glass(column, row, samples_);
  resolve(column * frame_.grid.side, row * frame_.grid.side, image);
}

}  // namespace afx::render
