// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/software/shape_tiles.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "codec/parallel.h"

namespace afx::render {
namespace {

constexpr size_t kChunk = 16384;

}  // namespace

ShapeTiles::ShapeTiles(const Scene& scene, const Lens& lens, const RenderOptions& options,
                       const MipPictures& pictures)
    : lens_(lens), samples_(options.samples) {
  if (scene.shapes.empty()) return;
  views_.reserve(scene.shapes.size());
  for (const Shape& shape : scene.shapes) views_.emplace_back(shape, lens, pictures);
  const auto transparent = std::stable_partition(
      views_.begin(), views_.end(), [](const ShapeView& view) { return !view.transparent; });
  size_t primitives = 0;
  for (auto view = views_.begin(); view != views_.end(); ++view) {
    if (view == transparent) opaque_count_ = primitives;
    firsts_.push_back(primitives);
    primitives += view->primitives();
  }
  if (transparent == views_.end()) opaque_count_ = primitives;
  for (const Light& light : scene.lights) lights_.push_back(view_light(light, lens));
  boxes_.assign(primitives, kNoBox);
  place_corners(options.threads);
  make_boxes(options.threads);
  const TileGrid grid(options);
  opaque_ = BoxCells(opaque_boxes(), grid, samples_, options.threads);
  transparent_ = BoxCells(transparent_boxes(), grid, samples_, options.threads);
}

template <class Count>
std::vector<ShapeTiles::Chunk> ShapeTiles::chunks(const Count& count) const {
  std::vector<Chunk> all;
  for (size_t shape = 0; shape < views_.size(); ++shape) {
    const size_t total = count(views_[shape]);
    for (size_t first = 0; first < total; first += kChunk)
      all.push_back({shape, first, std::min(kChunk, total - first)});
  }
  return all;
}

void ShapeTiles::place_corners(unsigned threads) {
  for (ShapeView& view : views_) view.corners.resize(view.geometry->positions.size());
  const std::vector<Chunk> all =
      chunks([](const ShapeView& view) { return view.geometry->positions.size(); });
  parallel_for(all.size(), threads,
               [&](size_t i) { views_[all[i].shape].place_corners(all[i].first, all[i].count); });
}

void ShapeTiles::make_boxes(unsigned threads) {
  const std::vector<Chunk> all =
      chunks([](const ShapeView& view) { return size_t{view.primitives()}; });
  parallel_for(all.size(), threads, [&](size_t i) {
    const Chunk& chunk = all[i];
    Piece piece;
    for (size_t k = chunk.first; k < chunk.first + chunk.count; ++k) {
      if (make_piece(views_[chunk.shape], static_cast<uint32_t>(k), lens_, samples_, piece))
        boxes_[firsts_[chunk.shape] + k] = piece.box;
    }
  });
}

/// numbers   rising
void ShapeTiles::collect(const std::vector<uint32_t>& numbers, size_t offset,
                         std::vector<Piece>& pieces) const {
  pieces.clear();
  size_t shape = 0;
  for (const uint32_t number : numbers) {
    const size_t primitive = offset + number;
    if (shape + 1 < firsts_.size() && primitive >= firsts_[shape + 1]) {
      const auto next = std::upper_bound(firsts_.begin(), firsts_.end(), primitive);
      shape = static_cast<size_t>(next - firsts_.begin()) - 1;
    }
    Piece piece;
    if (!make_piece(views_[shape], static_cast<uint32_t>(primitive - firsts_[shape]), lens_,
                    samples_, piece))
      continue;
    piece.shape = static_cast<uint32_t>(shape);
    pieces.push_back(piece);
  }
}

void ShapeTiles::collect_opaque(uint32_t column, uint32_t row, std::vector<Piece>& pieces) const {
  std::vector<uint32_t> numbers;
  opaque_.collect(opaque_boxes(), column, row, numbers);
  collect(numbers, 0, pieces);
}

double ShapeTiles::distance(const Piece& piece) const {
  const ShapeView& view = views_[piece.shape];
  const size_t count = corners_of(view.geometry->kind);
  glm::dvec3 middle(0);
  for (uint32_t k = 0; k < count; ++k) middle += view.corners[view.corner(piece.primitive, k)];
  middle /= static_cast<double>(count);
  return lens_.perspective ? glm::length(middle) : -middle.z;
}

void ShapeTiles::collect_transparent(uint32_t column, uint32_t row,
                                     std::vector<Piece>& pieces) const {
  std::vector<uint32_t> numbers;
  transparent_.collect(transparent_boxes(), column, row, numbers);
  collect(numbers, opaque_count_, pieces);
  if (pieces.size() < 2) return;
  std::vector<std::pair<double, size_t>> order;
  for (const Piece& piece : pieces) order.emplace_back(-distance(piece), order.size());
  std::sort(order.begin(), order.end());
  std::vector<Piece> sorted;
  sorted.reserve(pieces.size());
  for (const auto& [distance, number] : order) sorted.push_back(pieces[number]);
  pieces.swap(sorted);
}

}  // namespace afx::render
