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

AFX_PART_OF_CALLER Rectangle rectangle_of(const Splat& splat, const TileSamples& tile) {
  const auto side = static_cast<float>(static_cast<int>(tile.side));
  const float x = splat.x - tile.left - 0.5F, y = splat.y - tile.top - 0.5F;
  return {x,
          y,
          first_from(x - splat.reach_x, side),
          end_after(x + splat.reach_x, side),
          first_from(y - splat.reach_y, side),
          end_after(y + splat.reach_y, side)};
}

AFX_PART_OF_CALLER void place_discs(const EightDiscs& discs, const TileSamples& tile,
                                    EightRectangles& out) {
  const auto side = static_cast<float>(static_cast<int>(tile.side));
  const float left = tile.left, top = tile.top;
  uint32_t filled = 0;
  for (int i = 0; i < 8; ++i) {
    const float x = discs.x[i] - left - 0.5F, y = discs.y[i] - top - 0.5F;
    out.x[i] = x;
    out.y[i] = y;
    out.x0[i] = first_from(x - discs.reach_x[i], side);
    out.x1[i] = end_after(x + discs.reach_x[i], side);
    out.y0[i] = first_from(y - discs.reach_y[i], side);
    out.y1[i] = end_after(y + discs.reach_y[i], side);
    const bool is_filled = (out.x0[i] < out.x1[i]) & (out.y0[i] < out.y1[i]);
    filled |= uint32_t{is_filled} << i;
  }
  out.filled = filled;
}

/// Eight samples of a row, from number `at` on.
struct RowSamples {
  size_t at;
  LaneMask inside;  // those in the shape's rectangle or run
  Lanes dx;         // from the splat
  float dy;

  [[nodiscard]] AFX_PART_OF_CALLER Lanes of(const float* list) const { return load(list + at); }
  AFX_PART_OF_CALLER void put(float* list, Lanes lanes) const { store(list + at, lanes); }
};

/// Four samples of a row, from number `at` on, and four of the next one.
struct PairSamples {
  size_t at, below;
  LaneMask inside;
  Lanes dx, dy;

  [[nodiscard]] AFX_PART_OF_CALLER Lanes of(const float* list) const {
    return load(list + at, list + below);
  }
  AFX_PART_OF_CALLER void put(float* list, Lanes lanes) const {
    store(list + at, list + below, lanes);
  }
};

/// Most discs are as narrow as that.
AFX_PART_OF_CALLER bool is_narrow(const Rectangle& box) { return box.x1 - box.x0 <= kLanes / 2; }

template <class Visit>
AFX_PART_OF_CALLER void for_pairs(const Rectangle box, const size_t side, const Visit& visit) {
  const LaneMask columns = LaneMask{0, 1, 2, 3, 0, 1, 2, 3} < box.x1 - box.x0;
  const Lanes dx = Lanes{0, 1, 2, 3, 0, 1, 2, 3} + (static_cast<float>(box.x0) - box.x);
  Lanes row = Lanes{0, 0, 0, 0, 1, 1, 1, 1} + static_cast<float>(box.y0);
  const Lanes end = all(static_cast<float>(box.y1));
  size_t at = static_cast<size_t>(box.y0) * side + static_cast<size_t>(box.x0);
  for (int y = box.y0; y < box.y1; y += 2, row += 2, at += 2 * side)
    visit(PairSamples{at, at + side, columns & (row < end), dx, row - box.y});
}

/// Visits the samples whose centres the shape may cover. Both passes see the same ones.
template <class Shape, class Visit>
AFX_PART_OF_CALLER void for_rows(const Shape& shape, const Rectangle box, const TileSamples& tile,
                                 const Visit& visit) {
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
      visit(RowSamples{start + static_cast<size_t>(column), first_lanes(x1 - column), dx, dy});
    }
  }
}

template <class Shape, class Visit>
AFX_PART_OF_CALLER void for_samples(const Shape& shape, const Rectangle& box,
                                    const TileSamples& tile, const Visit& visit) {
  if constexpr (!Shape::kHasRuns) {
    if (is_narrow(box)) return for_pairs(box, tile.side, visit);
  }
  for_rows(shape, box, tile, visit);
}

/// Looks at blocks of 8 x 8.
AFX_PART_OF_CALLER bool is_box_hidden(const Rectangle box, float depth, const TileSamples& tile) {
  const size_t side = tile.side;
  const float* line = tile.depths.data() + static_cast<size_t>(box.y0) * side;
  for (int row = box.y0; row < box.y1; row += kLanes, line += kLanes * side) {
    const int rows = std::min(kLanes, box.y1 - row);
    for (int column = box.x0; column < box.x1; column += kLanes) {
      const float* at = line + column;
      Lanes farthest = load(at);
      for (int i = 1; i < rows; ++i) farthest = most(farthest, load(at += side));
      if (any(first_lanes(box.x1 - column) & (farthest >= depth))) return false;
    }
  }
  return true;
}

AFX_PART_OF_CALLER bool is_square_hidden(float x, float y, float reach, float depth,
                                         const TileSamples& tile) {
  Splat square{};
  square.x = x, square.y = y, square.reach_x = square.reach_y = reach;
  return is_box_hidden(rectangle_of(square, tile), depth, tile);
}

template <class Shape>
AFX_PART_OF_CALLER bool lay_depth(const Shape& shape, const Rectangle& box, TileSamples& tile) {
  const float tolerance = shape.splat.tolerance;
  float* const depths = tile.depths.data();
  const float* const walls = tile.has_walls ? tile.walls.data() : nullptr;
  LaneMask seen{};
  for_samples(
      shape, box, tile, [&](const auto& samples) __attribute__((always_inline)) {
        const Hit hit = shape.at(samples.dx, samples.dy);
        const Lanes old = samples.of(depths);
        LaneMask open = samples.inside & hit.inside;
        if (walls != nullptr) open &= hit.depth < samples.of(walls);
        seen |= open & (hit.depth - tolerance <= old);
        samples.put(depths, (open & (hit.depth < old)) ? hit.depth : old);
      });
  return any(seen);
}

/// Larger ones are worth being looked at first.
AFX_PART_OF_CALLER bool lay_disc(const TileDisc& disc, TileSamples& tile) {
  const float nearest = disc.splat.nearest - disc.splat.tolerance;
  if (!is_narrow(disc.box) && is_box_hidden(disc.box, nearest, tile)) return false;
  return lay_depth(Disc{disc.splat, disc.tilt}, disc.box, tile);
}

template <class Shape>
AFX_PART_OF_CALLER void lay_colour(const Shape& shape, const Rectangle& box, TileSamples& tile) {
  const Splat& splat = shape.splat;
  const float* const depths = tile.depths.data();
  const float* const walls = tile.has_walls ? tile.walls.data() : nullptr;
  float* const sum_r = tile.sum_r.data();
  float* const sum_g = tile.sum_g.data();
  float* const sum_b = tile.sum_b.data();
  float* const sum_weight = tile.sum_weight.data();
  for_samples(
      shape, box, tile, [&](const auto& samples) __attribute__((always_inline)) {
        const Hit hit = shape.at(samples.dx, samples.dy);
        LaneMask open =
            samples.inside & hit.inside & (hit.depth - splat.tolerance <= samples.of(depths));
        if (walls != nullptr) open &= hit.depth < samples.of(walls);
        if (!any(open)) return;
        const Lanes inner = most(all(0), 1 - hit.out);
        const Lanes weight = open ? shape.weight * (inner * inner + kLeastWeight) : all(0);
        samples.put(sum_r, samples.of(sum_r) + weight * splat.light.r);
        samples.put(sum_g, samples.of(sum_g) + weight * splat.light.g);
        samples.put(sum_b, samples.of(sum_b) + weight * splat.light.b);
        samples.put(sum_weight, samples.of(sum_weight) + weight);
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
  attributes bool name##_is_hidden(float x, float y, float reach, float depth,                     \
                                   const TileSamples& tile) {                                      \
    return is_square_hidden(x, y, reach, depth, tile);                                             \
  }                                                                                                \
  attributes void name##_place(const EightDiscs& discs, const TileSamples& tile,                   \
                               EightRectangles& out) {                                             \
    place_discs(discs, tile, out);                                                                 \
  }                                                                                                \
  attributes bool name##_disc_depth(const TileDisc& disc, TileSamples& tile) {                     \
    return lay_disc(disc, tile);                                                                   \
  }                                                                                                \
  attributes void name##_disc_colour(const TileDisc& disc, TileSamples& tile) {                    \
    lay_colour(Disc{disc.splat, disc.tilt}, disc.box, tile);                                       \
  }                                                                                                \
  attributes bool name##_surfel_depth(const Splat& splat, const Slant& slant, TileSamples& tile) { \
    return lay_depth(Parallelogram(splat, slant), rectangle_of(splat, tile), tile);                \
  }                                                                                                \
  attributes void name##_surfel_colour(const Splat& splat, const Slant& slant,                     \
                                       TileSamples& tile) {                                        \
    lay_colour(Parallelogram(splat, slant), rectangle_of(splat, tile), tile);                      \
  }                                                                                                \
  attributes void name##_finish(TileSamples& tile) { finish_sums(tile); }                          \
  constexpr SplatPainter name{name##_is_hidden,   name##_place,        name##_disc_depth,          \
                              name##_disc_colour, name##_surfel_depth, name##_surfel_colour,       \
                              name##_finish};

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
