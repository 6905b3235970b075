// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/software/splat_painter.h"

#include <algorithm>

namespace afx::render {
namespace {

constexpr float kLeastWeight = 1e-3F;  // at the rim, so that a disc alone has a colour there too

/// The first whole number from `at` on, in [0, side]. Here and below by conversion, since floor and
/// ceil are calls on processors without SSE 4.1.
int first_from(float at, float side) {
  const float inside = std::clamp(at, 0.0F, side);
  const int whole = static_cast<int>(inside);
  return whole + (static_cast<float>(whole) < inside ? 1 : 0);
}

/// One more than the last whole number up to `at`, in [0, side].
int end_after(float at, float side) { return static_cast<int>(std::clamp(at + 1, 0.0F, side)); }

/// Four samples of a row, from number `at` on.
struct Four {
  size_t at;
  LaneMask inside;  // those that the shape covers
  Lanes dx;         // from the splat
  float dy;
};

/// Visits the samples whose centres the shape covers. Both passes see the same ones.
template <class Shape, class Visit>
void for_samples(const Shape& shape, const TileSamples& tile, const Visit& visit) {
  // Sample k of the tile has its centre at k + 1/2.
  const Splat& splat = shape.splat;
  const float x = splat.x - tile.left - 0.5F;
  const float y = splat.y - tile.top - 0.5F;
  const auto side = static_cast<float>(tile.side);
  const int end = end_after(y + splat.radius, side);
  for (int row = first_from(y - splat.radius, side); row < end; ++row) {
    const float dy = static_cast<float>(row) - y;
    const Run run = shape.run(dy);
    const int x1 = end_after(x + run.last, side);
    for (int column = first_from(x + run.first, side); column < x1;
         column += static_cast<int>(kLanes)) {
      const LaneMask inside = kLaneNumbers < static_cast<float>(x1 - column);
      const Lanes dx = kLaneNumbers + (static_cast<float>(column) - x);
      visit(
          Four{static_cast<size_t>(row) * tile.side + static_cast<size_t>(column), inside, dx, dy});
    }
  }
}

/// The square that holds the splat has changed.
void touch_around(const Splat& splat, TileSamples& tile) {
  const float x = splat.x - tile.left - 0.5F;
  const float y = splat.y - tile.top - 0.5F;
  const auto side = static_cast<float>(tile.side);
  const int x0 = first_from(x - splat.radius, side), x1 = end_after(x + splat.radius, side);
  const int y0 = first_from(y - splat.radius, side), y1 = end_after(y + splat.radius, side);
  if (x0 < x1 && y0 < y1)
    tile.touch(static_cast<size_t>(x0), static_cast<size_t>(y0), static_cast<size_t>(x1),
               static_cast<size_t>(y1));
}

}  // namespace

template <class Shape>
bool lay_depth(const Shape& shape, TileSamples& tile) {
  LaneMask seen{};
  const float tolerance = shape.splat.tolerance;
  for_samples(shape, tile, [&](const Four& four) {
    const Lanes depth = shape.at(four.dx, four.dy).depth;
    float* const place = &tile.depths[four.at];
    const Lanes old = load(place);
    LaneMask open = four.inside;
    if (tile.has_walls) open &= depth < load(&tile.walls[four.at]);
    seen |= open & (depth - tolerance <= old);
    store(place, (open & (depth < old)) ? depth : old);
  });
  if (!any(seen)) return false;
  touch_around(shape.splat, tile);
  return true;
}

template <class Shape>
void lay_colour(const Shape& shape, TileSamples& tile) {
  const Splat& splat = shape.splat;
  for_samples(shape, tile, [&](const Four& four) {
    const Hit hit = shape.at(four.dx, four.dy);
    LaneMask open = four.inside & (hit.depth - splat.tolerance <= load(&tile.depths[four.at]));
    if (tile.has_walls) open &= hit.depth < load(&tile.walls[four.at]);
    if (!any(open)) return;
    const Lanes inner = most(all(0), 1 - hit.out);
    const Lanes weight = open ? shape.weight * (inner * inner + kLeastWeight) : all(0);
    const auto add = [&](std::vector<float>& sums, Lanes amount) {
      store(&sums[four.at], load(&sums[four.at]) + amount);
    };
    add(tile.sum_r, weight * splat.light.r);
    add(tile.sum_g, weight * splat.light.g);
    add(tile.sum_b, weight * splat.light.b);
    add(tile.sum_weight, weight);
  });
}

template bool lay_depth(const Disc& shape, TileSamples& tile);
template bool lay_depth(const Parallelogram& shape, TileSamples& tile);
template void lay_colour(const Disc& shape, TileSamples& tile);
template void lay_colour(const Parallelogram& shape, TileSamples& tile);

}  // namespace afx::render
