// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/tile_painter.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "afx/srgb.h"
#include "render/splat_shapes.h"

namespace afx::render {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();
constexpr float kLeastWeight = 1e-3F;  // at the rim, so that a disc alone has a colour there too

/// The first whole number from `at` on, in [0, side]. Here and below by conversion, since floor and
/// ceil are calls on processors without SSE 4.1.
size_t first_from(float at, float side) {
  const float inside = std::clamp(at, 0.0F, side);
  const auto whole = static_cast<size_t>(inside);
  return whole + (static_cast<float>(whole) < inside ? 1 : 0);
}

/// One more than the last whole number up to `at`, in [0, side].
size_t end_after(float at, float side) {
  return static_cast<size_t>(std::clamp(at + 1, 0.0F, side));
}

}  // namespace

TilePainter::TilePainter(const RenderOptions& options)
    : options_(options), side_(size_t{kTile} * options.samples) {
  depths_.resize(side_ * side_);
  sums_.resize(side_ * side_);
}

void TilePainter::clear() {
  std::fill(depths_.begin(), depths_.end(), kFar);
  std::fill(sums_.begin(), sums_.end(), Sum{});
}

/// Visits the runs of samples whose centres the shape covers, with the place of the first one in
/// respect of the splat's. Both passes see the same samples.
template <class Shape, class Visit>
void TilePainter::for_rows(const Shape& shape, const Visit& visit) const {
  // Sample k of the tile has its centre at k + 1/2.
  const Splat& splat = shape.splat;
  const float x = splat.x - left_ - 0.5F;
  const float y = splat.y - top_ - 0.5F;
  const auto side = static_cast<float>(side_);
  const size_t end = end_after(y + splat.radius, side);
  for (size_t row = first_from(y - splat.radius, side); row < end; ++row) {
    const float dy = static_cast<float>(row) - y;
    const Run run = shape.run(dy);
    const size_t x0 = first_from(x + run.first, side);
    const size_t x1 = end_after(x + run.last, side);
    if (x0 < x1) visit(row * side_ + x0, row * side_ + x1, static_cast<float>(x0) - x, dy);
  }
}

template <class Shape>
void TilePainter::lay_depth(const Shape& shape) {
  for_rows(shape, [&](size_t first, size_t end, float dx, float dy) {
    for (size_t i = first; i < end; ++i, dx += 1) {
      depths_[i] = std::min(depths_[i], shape.at(dx, dy).depth);
    }
  });
}

template <class Shape>
void TilePainter::lay_colour(const Shape& shape) {
  const Splat& splat = shape.splat;
  const std::array<float, 256>& linear = srgb_to_linear();
  const float r = linear[splat.colour.r], g = linear[splat.colour.g], b = linear[splat.colour.b];
  const float tolerance = splat.tolerance;
  for_rows(shape, [&](size_t first, size_t end, float dx, float dy) {
    for (size_t i = first; i < end; ++i, dx += 1) {
      const Hit hit = shape.at(dx, dy);
      if (hit.depth - tolerance > depths_[i]) continue;
      const float inner = std::max(0.0F, 1 - hit.out);
      const float weight = shape.weight * (inner * inner + kLeastWeight);
      Sum& sum = sums_[i];
      sum.r += weight * r;
      sum.g += weight * g;
      sum.b += weight * b;
      sum.weight += weight;
    }
  });
}

/// The mean of the samples over the background, both in linear light.
void TilePainter::resolve_pixel(size_t first, uint8_t* pixel, float* depth) const {
  float r = 0, g = 0, b = 0, covered = 0;
  float nearest = kFar;
  for (size_t y = 0; y < options_.samples; ++y) {
    for (size_t x = 0; x < options_.samples; ++x) {
      const Sum& sum = sums_[first + y * side_ + x];
      if (sum.weight == 0) continue;
      r += sum.r / sum.weight;
      g += sum.g / sum.weight;
      b += sum.b / sum.weight;
      covered += 1;
      nearest = std::min(nearest, depths_[first + y * side_ + x]);
    }
  }
  if (depth != nullptr) *depth = nearest;
  const std::array<float, 256>& linear = srgb_to_linear();
  const Rgba8 back = options_.background;
  const auto samples = static_cast<float>(options_.samples * options_.samples);
  const float through = (samples - covered) * static_cast<float>(back.a) / 255;
  const float opaque = covered + through;
  if (opaque == 0) {  // keeps the background's colour, for those who drop alpha
    pixel[0] = back.r, pixel[1] = back.g, pixel[2] = back.b, pixel[3] = 0;
    return;
  }
  pixel[0] = linear_to_srgb((r + through * linear[back.r]) / opaque);
  pixel[1] = linear_to_srgb((g + through * linear[back.g]) / opaque);
  pixel[2] = linear_to_srgb((b + through * linear[back.b]) / opaque);
  pixel[3] = static_cast<uint8_t>(std::lround(255 * opaque / samples));
}

void TilePainter::resolve(uint32_t x, uint32_t y, RenderedImage& image) const {
  const uint32_t x_end = std::min(x + kTile, options_.width);
  const uint32_t y_end = std::min(y + kTile, options_.height);
  for (uint32_t py = y; py < y_end; ++py) {
    for (uint32_t px = x; px < x_end; ++px) {
      const size_t first = (size_t{py - y} * side_ + (px - x)) * options_.samples;
      float* depth = image.depth.empty() ? nullptr : &image.depth[size_t{py} * options_.width + px];
      resolve_pixel(first, image.picture.pixel(px, py), depth);
    }
  }
}

/// The splats of the tile, the largest first; without those that share its cell only.
void TilePainter::collect(const SplatTiles& tiles, uint32_t column, uint32_t row) {
  touching_.clear();
  const auto side = static_cast<float>(side_);
  for (uint32_t level = tiles.levels(); level-- > 0;) {
    for (const uint32_t number : tiles.around(level, column, row)) {
      const Splat& s = tiles.splat(number);
      if (s.x + s.radius >= left_ && s.x - s.radius <= left_ + side && s.y + s.radius >= top_ &&
          s.y - s.radius <= top_ + side)
        touching_.push_back(number);
    }
  }
}

template <class Visit>
void TilePainter::for_shapes(const SplatTiles& tiles, const Visit& visit) const {
  for (const uint32_t number : touching_) {
    const Splat& splat = tiles.splat(number);
    if (const Slant* slant = tiles.slant(number)) {
      visit(Parallelogram(splat, *slant));
    } else {
      visit(Disc(splat));
    }
  }
}

void TilePainter::paint(const SplatTiles& tiles, uint32_t column, uint32_t row,
                        RenderedImage& image) {
  clear();
  left_ = static_cast<float>(column * side_);
  top_ = static_cast<float>(row * side_);
  collect(tiles, column, row);
  for_shapes(tiles, [this](const auto& shape) { lay_depth(shape); });
  for_shapes(tiles, [this](const auto& shape) { lay_colour(shape); });
  resolve(column * kTile, row * kTile, image);
}

}  // namespace afx::render
