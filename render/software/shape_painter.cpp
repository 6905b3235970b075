// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/software/shape_painter.h"

#include <algorithm>
#include <cstring>

#include "render/lanes.h"
#include "render/software/piece_samples.h"

namespace afx::render {
namespace {

constexpr int32_t kNone = -1;

void store_where(LaneMask where, int32_t number, int32_t* to) {
  LaneMask old;
  std::memcpy(&old, to, sizeof old);
  const LaneMask mixed = (where & number) | (~where & old);
  std::memcpy(to, &mixed, sizeof mixed);
}

}  // namespace

ShapePainter::ShapePainter(const Frame& frame)
    : frame_(frame),
      shader_(frame.scene, frame.shapes, frame.lens, frame.options.samples),
      fog_(frame.scene.fog, frame.lens, frame.options.samples) {
  if (frame.shapes.empty()) return;
  const size_t side = size_t{frame.grid.side} * frame.options.samples;
  seen_.assign(side * side + TileSamples::kPadding, kNone);
}

/// Takes away all samples of a pixel that see the same as one of them.
ShapePainter::Group ShapePainter::take_group(const TileSamples& tile, size_t first, size_t sample) {
  const size_t n = frame_.options.samples;
  const int32_t number = seen_[sample];
  Group group;
  group.count = 0;
  size_t x_sum = 0, y_sum = 0;
  for (size_t y = (sample - first) / tile.side; y < n; ++y) {
    for (size_t x = 0; x < n; ++x) {
      const size_t i = first + y * tile.side + x;
      if (seen_[i] != number) continue;
      seen_[i] = kNone;
      group.samples[group.count++] = i;
      x_sum += x, y_sum += y;
    }
  }
  const auto count = static_cast<double>(group.count);
  group.x = static_cast<double>(tile.left) + static_cast<double>(first % tile.side) + 0.5 +
            static_cast<double>(x_sum) / count;
  group.y = static_cast<double>(tile.top) + static_cast<double>(first / tile.side) + 0.5 +
            static_cast<double>(y_sum) / count;
  return group;
}

template <class Lay>
void ShapePainter::shade_pixel(const TileSamples& tile, size_t first, const Lay& lay) {
  const size_t n = frame_.options.samples;
  for (size_t y = 0; y < n; ++y) {
    for (size_t x = 0; x < n; ++x) {
      const size_t i = first + y * tile.side + x;
      if (seen_[i] == kNone) continue;
      const Piece& piece = pieces_[static_cast<size_t>(seen_[i])];
      const Group group = take_group(tile, first, i);
      lay(group, shader_.shade(piece, group.x, group.y));
    }
  }
}

template <class Lay>
void ShapePainter::shade_tile(const TileSamples& tile, const Lay& lay) {
  const size_t n = frame_.options.samples;
  for (size_t y = 0; y < tile.side; y += n)
    for (size_t x = 0; x < tile.side; x += n) shade_pixel(tile, y * tile.side + x, lay);
}

void ShapePainter::lay_walls(uint32_t column, uint32_t row, TileSamples& tile) {
  if (frame_.shapes.empty()) return;
  frame_.shapes.collect_opaque(column, row, pieces_);
  if (pieces_.empty()) return;
  std::fill(tile.walls.begin(), tile.walls.end(), kFar);
  for (size_t k = 0; k < pieces_.size(); ++k) {
    for_covered(pieces_[k], tile, [&](size_t at, LaneMask covered, Lanes depth) {
      const Lanes old = load(&tile.walls[at]);
      covered &= depth < old;
      if (!any(covered)) return;
      store(&tile.walls[at], covered ? depth : old);
      store_where(covered, static_cast<int32_t>(k), &seen_[at]);
      tile.has_walls = true;
    });
  }
  if (!tile.has_walls) return;
  shade_tile(tile, [&](const Group& group, const Fragment& fragment) {
    for (size_t k = 0; k < group.count; ++k) {
      const size_t i = group.samples[k];
      tile.wall_r[i] = fragment.light.r;
      tile.wall_g[i] = fragment.light.g;
      tile.wall_b[i] = fragment.light.b;
    }
  });
  tile.depths = tile.walls;
}

/// The samples of `seen_` see `piece` before what is there.
void ShapePainter::blend(const Piece& piece, TileSamples& tile) {
  const auto last = static_cast<float>(tile.side) - 1;
  const size_t n = frame_.options.samples;
  const auto pixel = [&](float at) { return static_cast<size_t>(std::clamp(at, 0.0F, last)) / n; };
  const auto lay = [&](const Group& group, const Fragment& fragment) {
    const auto value = static_cast<float>(value_at(piece.depth, group.x, group.y));
    const float depth = std::clamp(piece.inverse ? 1 / value : value, piece.least, piece.most);
    const glm::vec3 light = fog_.mixed(fragment.light, group.x, group.y, depth);
    const float through = 1 - fragment.opacity;
    for (size_t k = 0; k < group.count; ++k) {
      const size_t i = group.samples[k];
      tile.sum_r[i] = fragment.opacity * light.r + through * tile.sum_r[i];
      tile.sum_g[i] = fragment.opacity * light.g + through * tile.sum_g[i];
      tile.sum_b[i] = fragment.opacity * light.b + through * tile.sum_b[i];
      tile.sum_weight[i] = fragment.opacity + through * tile.sum_weight[i];
    }
  };
  // for_covered looks at whole fours, so a little beyond the box.
  const size_t x0 = pixel(piece.box.x0 - tile.left - 5), x1 = pixel(piece.box.x1 - tile.left + 5);
  const size_t y1 = pixel(piece.box.y1 - tile.top + 2);
  for (size_t y = pixel(piece.box.y0 - tile.top - 2); y <= y1; ++y)
    for (size_t x = x0; x <= x1; ++x) shade_pixel(tile, (y * tile.side + x) * n, lay);
}

void ShapePainter::lay_glass(uint32_t column, uint32_t row, TileSamples& tile) {
  if (frame_.shapes.empty()) return;
  frame_.shapes.collect_transparent(column, row, pieces_);
  for (size_t k = 0; k < pieces_.size(); ++k) {
    bool some = false;
    for_covered(pieces_[k], tile, [&](size_t at, LaneMask covered, Lanes depth) {
      covered &= depth < load(&tile.depths[at]);
      store_where(covered, static_cast<int32_t>(k), &seen_[at]);
      some = some || any(covered);
    });
    if (some) blend(pieces_[k], tile);
  }
}

}  // namespace afx::render
