// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/surfel_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "afx/srgb.h"
#include "afx/surfel_footprint.h"
#include "codec/parallel.h"

namespace afx {
namespace {

constexpr uint32_t kBandRows = 32;
constexpr size_t kChunk = 16384;  // pieces that one task does
constexpr double kFarthest = std::numeric_limits<double>::max();

struct Rows {
  uint32_t first = 0, end = 0;
};

/// The numbers of the pieces that each band of rows sees, ascending.
struct Bands {
  std::vector<size_t> starts;  // of each band, and the end
  std::vector<uint32_t> pieces;
};

/// What the pieces in a pixel add up to.
struct PixelSum {
  glm::dvec3 light{0};
  double opacity = 0, weight = 0;
  double closest = kFarthest;  // of the centres, squared, in pixels
  double distance = 0;         // of the piece that is the closest
  bool facing = false;

  void add(const SurfelFootprint& piece, const glm::dvec2& pixel, double at, Rgba8 colour) {
    const bool faces = piece.area >= 0;
    if (faces != facing && weight > 0) {
      if (facing) return;
      *this = {};
    }
    facing = faces;
    const glm::dvec2 off = piece.centre - pixel;
    const double d2 = glm::dot(off, off);
    if (d2 < closest) {
      closest = d2;
      distance = at;
    }
    add_colour(colour, weight_of(std::abs(piece.area), d2));
  }

 private:
  static double weight_of(double area, double d2) {
    constexpr double kLeastArea = 1e-3;  // something is seen of what is seen from its edge
    return std::clamp(area, kLeastArea, 1.0) / (d2 + std::max(0.0, 1 - area) + 1e-6);
  }
  void add_colour(Rgba8 c, double w) {
    const double opaque = w * c.a / 255.0;
    light += opaque * linear_light(c);
    opacity += opaque;
    weight += w;
  }
};

class Drawing {
 public:
  Drawing(const Surfels& surfels, const DepthCamera& camera, SimpleTexture& picture)
      : surfels_(surfels),
        camera_(camera),
        width_(picture.colour.width),
        height_(picture.colour.height),
        view_(camera, width_, height_),
        picture_(picture) {
    const double range = camera.far_plane - camera.near_plane;
    const double half =
        0.5 * range / static_cast<double>(std::max<uint64_t>(picture.dmax(), 2) - 1);
    near_ = camera.near_plane - half;
    far_ = camera.far_plane + half;
  }

  Status draw(unsigned threads, const Limits& limits) {
    Result<std::vector<Rows>> rows = find_rows(threads);
    if (!rows.ok()) return rows.error();
    const Result<Bands> bands = sort_into_bands(rows.value(), limits);
    if (!bands.ok()) return bands.error();
    rows.value() = {};
    const Bands& all = bands.value();
    parallel_for(all.starts.size() - 1, threads, [&](size_t band) {
      draw_band(
          band,
          std::span(all.pieces).subspan(all.starts[band], all.starts[band + 1] - all.starts[band]));
    });
    return {};
  }

 private:
  Result<std::vector<Rows>> find_rows(unsigned threads) const {
    std::vector<Rows> rows(surfels_.size());
    const size_t chunks = (rows.size() + kChunk - 1) / kChunk;
    std::vector<uint64_t> touched(chunks, 0);
    parallel_for(chunks, threads, [&](size_t chunk) {
      for (size_t n = chunk * kChunk; n < std::min(rows.size(), (chunk + 1) * kChunk); ++n) {
        if (surfels_.colours[n].a == 0) continue;
        const SurfelFootprint piece = view_.footprint(surfels_, n);
        rows[n] = {piece.first_row(), piece.end_row()};
        touched[chunk] += piece.range.count();
      }
    });
    uint64_t all = 0;
    for (const uint64_t part : touched) all += part;
    if (all > most_surfel_pixels(width_, height_))
      return beyond_limit("the pieces of surface touch " + std::to_string(all) + " pixels");
    return rows;
  }

  Result<Bands> sort_into_bands(const std::vector<Rows>& rows, const Limits& limits) const {
    Bands bands;
    bands.starts.resize((size_t{height_} + kBandRows - 1) / kBandRows + 1, 0);
    const auto for_each_band = [&](const Rows& r, const auto& visit) {
      if (r.first >= r.end) return;
      for (size_t band = r.first / kBandRows; band <= (r.end - 1) / kBandRows; ++band) visit(band);
    };
    for (const Rows& r : rows) for_each_band(r, [&](size_t band) { ++bands.starts[band + 1]; });
    for (size_t band = 1; band < bands.starts.size(); ++band)
      bands.starts[band] += bands.starts[band - 1];
    if (bands.starts.back() > limits.memory / sizeof(uint32_t))
      return beyond_limit("the pieces of surface on the picture's rows take memory");
    bands.pieces.resize(bands.starts.back());
    std::vector<size_t> next(bands.starts);
    for (size_t n = 0; n < rows.size(); ++n)
      for_each_band(rows[n],
                    [&](size_t band) { bands.pieces[next[band]++] = static_cast<uint32_t>(n); });
    return bands;
  }

  void draw_band(size_t band, std::span<const uint32_t> pieces) {
    const auto first = static_cast<uint32_t>(band * kBandRows);
    const uint32_t end = std::min(height_, first + kBandRows);
    const auto pixel = [&](uint32_t i, uint32_t j) { return size_t{j - first} * width_ + i; };
    std::vector<double> reach(size_t{end - first} * width_, kFarthest);
    for (const uint32_t n : pieces)
      view_.footprint(surfels_, n)
          .for_each_pixel(first, end, [&](uint32_t i, uint32_t j, double at) {
            if (at >= near_ && at <= far_) reach[pixel(i, j)] = std::min(reach[pixel(i, j)], at);
          });
    // What lies this far away belongs to the same surface, and with the piece's own length added.
    for (double& nearest : reach)
      if (nearest < kFarthest) nearest += view_.pixel_side(nearest);
    std::vector<PixelSum> sums(reach.size());
    for (const uint32_t n : pieces) {
      const SurfelFootprint piece = view_.footprint(surfels_, n);
      const double length = 2 * std::max(glm::length(glm::dvec3(surfels_.u[n])),
                                         glm::length(glm::dvec3(surfels_.v[n])));
      piece.for_each_pixel(first, end, [&](uint32_t i, uint32_t j, double at) {
        const size_t p = pixel(i, j);
        if (!(at >= near_ && at <= far_ && at - length <= reach[p])) return;
        sums[p].add(piece, glm::dvec2(i + 0.5, j + 0.5), at, surfels_.colours[n]);
      });
    }
    for (uint32_t j = first; j < end; ++j)
      for (uint32_t i = 0; i < width_; ++i) put(i, j, sums[pixel(i, j)]);
  }

  void put(uint32_t i, uint32_t j, const PixelSum& sum) {
    if (!(sum.weight > 0)) return;
    const uint32_t row = height_ - 1 - j;
    const uint64_t depth = distance_to_depth(
        std::clamp(sum.distance, camera_.near_plane, camera_.far_plane), picture_.dmax(), camera_);
    picture_.depth.samples[size_t{row} * width_ + i] = static_cast<uint16_t>(depth);
    const glm::vec3 light(sum.light / sum.opacity);
    uint8_t* to = picture_.colour.pixel(i, row);
    for (int c = 0; c < 3; ++c) to[c] = linear_to_srgb(light[c]);
    if (picture_.colour.components == 4)
      to[3] = static_cast<uint8_t>(std::lround(255 * sum.opacity / sum.weight));
  }

  const Surfels& surfels_;
  const DepthCamera& camera_;
  uint32_t width_, height_;
  SurfelCamera view_;
  SimpleTexture& picture_;
  double near_, far_;  // half a step of the depth beyond the planes
};

constexpr uint64_t kPixelBytes = 6;  // colour and depth

}  // namespace

Result<DepthImage> draw_surfels(const Surfels& surfels, const Shot& shot, unsigned depth_bits,
                                unsigned threads, const Limits& limits) {
  if (Status s = check_shot(shot, kPixelBytes, limits); !s.ok()) return s.error();
  if (Status s = check_depth_bits(depth_bits, 16); !s.ok()) return s.error();
  if (surfels.size() > std::min<uint64_t>(limits.memory / sizeof(Rows), 0xffffffff))
    return beyond_limit("there are " + std::to_string(surfels.size()) + " pieces of surface");
  const bool opaque = std::all_of(surfels.colours.begin(), surfels.colours.end(),
                                  [](Rgba8 c) { return c.a == 255 || c.a == 0; });
  SimpleTexture picture;
  picture.colour = Picture(shot.width, shot.height, opaque ? 3 : 4);
  picture.depth = {shot.width, shot.height, 1, depth_bits,
                   std::vector<uint16_t>(size_t{shot.width} * shot.height)};
  if (Status drawn = Drawing(surfels, shot.camera, picture).draw(threads, limits); !drawn.ok())
    return drawn.error();
  return DepthImage{shot.camera, std::move(picture)};
}

}  // namespace afx
