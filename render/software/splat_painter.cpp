// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/software/splat_painter.h"

#include <algorithm>

#include "render/software/splat_shapes.h"

namespace afx::render {
namespace {

constexpr float kLeastWeight = 1e-3F;  // at the rim, so that a disc alone has a colour there too

/// The first whole number from `at` on, in [0, side]. Here and below by conversion, since floor and
/// ceil are calls on processors without SSE 4.1.
AFX_PART_OF_CALLER int first_from(float at, float side) {
  const float inside = std::clamp(at, 0.0F, side);
  const int whole = static_cast<int>(inside);
  return whole + (static_cast<float>(whole) < inside ? 1 : 0);
}

/// One more than the last whole number up to `at`, in [0, side].
AFX_PART_OF_CALLER int end_after(float at, float side) {
  return static_cast<int>(std::clamp(at + 1, 0.0F, side));
}

/// The samples of the tile in the rectangle that holds a splat: [x0, x1) and [y0, y1).
struct Rectangle {
  AFX_PART_OF_CALLER Rectangle(const Splat& splat, const TileSamples& tile)
      : x(splat.x - tile.left - 0.5F), y(splat.y - tile.top - 0.5F) {
    const auto side = static_cast<float>(static_cast<int>(tile.side));
    x0 = first_from(x - splat.reach_x, side);
    x1 = end_after(x + splat.reach_x, side);
    y0 = first_from(y - splat.reach_y, side);
    y1 = end_after(y + splat.reach_y, side);
  }
  [[nodiscard]] bool is_empty() const { return x0 >= x1 || y0 >= y1; }

  float x, y;  // the splat's place; sample k of the tile has its centre at k + 1/2, here at k
  int x0, x1, y0, y1;
};

/// Some samples of a row, from number `at` on.
struct Samples {
  size_t at;
  LaneMask inside;  // those in the shape's run
  Lanes dx;         // from the splat
  float dy;
};

/// Visits the samples whose centres the shape may cover. Both passes see the same ones.
template <class Shape, class Visit>
AFX_PART_OF_CALLER void for_samples(const Shape& shape, const Rectangle& box,
                                    const TileSamples& tile, const Visit& visit) {
  const auto side = static_cast<float>(static_cast<int>(tile.side));
  size_t start = static_cast<size_t>(box.y0) * tile.side;
  for (int row = box.y0; row < box.y1; ++row, start += tile.side) {
    const float dy = static_cast<float>(row) - box.y;
    int x0 = box.x0, x1 = box.x1;
    if constexpr (Shape::kHasRuns) {
      const Run run = shape.run(dy);
      x0 = first_from(box.x + run.first, side);
      x1 = end_after(box.x + run.last, side);
    }
    for (int column = x0; column < x1; column += kLanes) {
      const Lanes dx = lane_numbers() + (static_cast<float>(column) - box.x);
      visit(Samples{start + static_cast<size_t>(column), first_lanes(x1 - column), dx, dy});
    }
  }
}

AFX_PART_OF_CALLER bool is_splat_hidden(const Splat& splat, const TileSamples& tile) {
  const Rectangle box(splat, tile);
  const float depth = splat.nearest - splat.tolerance;
  const float* line = tile.depths.data() + static_cast<size_t>(box.y0) * tile.side;
  for (int row = box.y0; row < box.y1; ++row, line += tile.side) {
    LaneMask open{};
    for (int column = box.x0; column < box.x1; column += kLanes)
      open |= first_lanes(box.x1 - column) & (load(line + column) >= depth);
    if (any(open)) return false;
  }
  return true;
}

template <class Shape>
AFX_PART_OF_CALLER bool lay_depth(const Shape& shape, TileSamples& tile) {
  const float tolerance = shape.splat.tolerance;
  const Rectangle box(shape.splat, tile);
  if (box.is_empty()) return false;
  float* const depths = tile.depths.data();
  const float* const walls = tile.has_walls ? tile.walls.data() : nullptr;
  LaneMask seen{};
  for_samples(
      shape, box, tile, [&](const Samples& samples) __attribute__((always_inline)) {
        const Hit hit = shape.at(samples.dx, samples.dy);
        const Lanes old = load(depths + samples.at);
        LaneMask open = samples.inside & hit.inside;
        if (walls != nullptr) open &= hit.depth < load(walls + samples.at);
        seen |= open & (hit.depth - tolerance <= old);
        store(depths + samples.at, (open & (hit.depth < old)) ? hit.depth : old);
      });
  if (!any(seen)) return false;
  tile.touch(static_cast<size_t>(box.x0), static_cast<size_t>(box.y0), static_cast<size_t>(box.x1),
             static_cast<size_t>(box.y1));
  return true;
}

template <class Shape>
AFX_PART_OF_CALLER void lay_colour(const Shape& shape, TileSamples& tile) {
  const Splat& splat = shape.splat;
  const float* const depths = tile.depths.data();
  const float* const walls = tile.has_walls ? tile.walls.data() : nullptr;
  float* const sum_r = tile.sum_r.data();
  float* const sum_g = tile.sum_g.data();
  float* const sum_b = tile.sum_b.data();
  float* const sum_weight = tile.sum_weight.data();
  for_samples(
      shape, Rectangle(splat, tile),
      tile, [&](const Samples& samples) __attribute__((always_inline)) {
        const Hit hit = shape.at(samples.dx, samples.dy);
        const size_t at = samples.at;
        LaneMask open =
            samples.inside & hit.inside & (hit.depth - splat.tolerance <= load(depths + at));
        if (walls != nullptr) open &= hit.depth < load(walls + at);
        if (!any(open)) return;
        const Lanes inner = most(all(0), 1 - hit.out);
        const Lanes weight = open ? shape.weight * (inner * inner + kLeastWeight) : all(0);
        store(sum_r + at, load(sum_r + at) + weight * splat.light.r);
        store(sum_g + at, load(sum_g + at) + weight * splat.light.g);
        store(sum_b + at, load(sum_b + at) + weight * splat.light.b);
        store(sum_weight + at, load(sum_weight + at) + weight);
      });
}

AFX_PART_OF_CALLER void finish_sums(TileSamples& tile) {
  const bool has_walls = tile.has_walls;
  float* const sum_weight = tile.sum_weight.data();
  for (size_t i = 0; i < tile.side * tile.side; i += kLanes) {
    const Lanes weight = load(sum_weight + i);
    const LaneMask some = weight > 0;
    const Lanes part = 1 / (some ? weight : all(1));
    LaneMask wall{};
    if (has_walls) wall = ~some & (load(tile.walls.data() + i) < kFar);
    const auto finish = [&](float* sums, const float* walls) __attribute__((always_inline)) {
      Lanes mean = load(sums + i) * part;
      if (has_walls) mean = wall ? load(walls + i) : mean;
      store(sums + i, mean);
    };
    finish(tile.sum_r.data(), tile.wall_r.data());
    finish(tile.sum_g.data(), tile.wall_g.data());
    finish(tile.sum_b.data(), tile.wall_b.data());
    store(sum_weight + i, (some | wall) ? all(1) : all(0));
  }
}

/// The functions of a painter. attributes   what they are compiled for
#define AFX_DEFINE_PAINTER(name, attributes)                                                       \
  attributes bool name##_is_hidden(const Splat& splat, const TileSamples& tile) {                  \
    return is_splat_hidden(splat, tile);                                                           \
  }                                                                                                \
  attributes bool name##_disc_depth(const Splat& splat, const Tilt& tilt, TileSamples& tile) {     \
    return lay_depth(Disc{splat, tilt}, tile);                                                     \
  }                                                                                                \
  attributes void name##_disc_colour(const Splat& splat, const Tilt& tilt, TileSamples& tile) {    \
    lay_colour(Disc{splat, tilt}, tile);                                                           \
  }                                                                                                \
  attributes bool name##_surfel_depth(const Splat& splat, const Slant& slant, TileSamples& tile) { \
    return lay_depth(Parallelogram(splat, slant), tile);                                           \
  }                                                                                                \
  attributes void name##_surfel_colour(const Splat& splat, const Slant& slant,                     \
                                       TileSamples& tile) {                                        \
    lay_colour(Parallelogram(splat, slant), tile);                                                 \
  }                                                                                                \
  attributes void name##_finish(TileSamples& tile) { finish_sums(tile); }                          \
  constexpr SplatPainter name{name##_is_hidden,    name##_disc_depth,    name##_disc_colour,       \
                              name##_surfel_depth, name##_surfel_colour, name##_finish};

AFX_DEFINE_PAINTER(kPlain, )
#if defined(__x86_64__)
AFX_DEFINE_PAINTER(kAvx2, __attribute__((target("avx2"))))
#endif
#undef AFX_DEFINE_PAINTER

}  // namespace

const SplatPainter& SplatPainter::plain() { return kPlain; }

const SplatPainter& SplatPainter::best() {
#if defined(__x86_64__)
  if (has_avx2()) return kAvx2;
#endif
  return kPlain;
}

}  // namespace afx::render
