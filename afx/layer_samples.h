// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The samples of a PointTexture, pixel by pixel.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "afx/depth_image.h"
#include "afx/pixel_pieces.h"

namespace afx {

/// The pixels of a PointTexture, counted from the lower left.
class LayerSamples {
 public:
  LayerSamples(const DepthImage& image, const PointTexture& texture)
      : camera_(image.camera), texture_(texture), dmax_(texture.dmax()), sorted_(texture.depths) {
    for (size_t p = 0; p + 1 < texture.starts.size(); ++p)
      std::sort(sorted_.begin() + texture.starts[p], sorted_.begin() + texture.starts[p + 1]);
  }

  [[nodiscard]] size_t count(uint32_t i, uint32_t j) const {
    if (texture_.starts.empty()) return 0;
    return texture_.starts[pixel(i, j) + 1] - texture_.starts[pixel(i, j)];
  }
  [[nodiscard]] PixelSample sample(uint32_t i, uint32_t j, size_t n) const {
    const size_t at = first(i, j) + n;
    return {distance(texture_.depths[at]), texture_.colours[at]};
  }
  /// The depths of a pixel, ascending.
  [[nodiscard]] std::span<const uint32_t> depths(uint32_t i, uint32_t j) const {
    if (texture_.starts.empty()) return {};
    return std::span(sorted_).subspan(texture_.starts[pixel(i, j)], count(i, j));
  }
  /// The number of a pixel's first sample.
  [[nodiscard]] size_t first(uint32_t i, uint32_t j) const {
    return texture_.starts.empty() ? 0 : texture_.starts[pixel(i, j)];
  }
  /// A sample as it is stored: n counts all of them.
  [[nodiscard]] uint32_t depth(size_t n) const { return texture_.depths[n]; }
  [[nodiscard]] double distance(uint32_t depth) const {
    return depth_to_distance(depth, dmax_, camera_);
  }
  /// Of the distances in a pixel the one next to another pixel's.
  [[nodiscard]] std::optional<double> nearest(uint32_t i, uint32_t j, double other) const {
    const std::span<const uint32_t> all = depths(i, j);
    const auto begin = all.begin(), end = all.end();
    if (begin == end) return std::nullopt;
    // The greater the depth, the nearer.
    const auto nearer =
        std::partition_point(begin, end, [&](uint32_t depth) { return distance(depth) > other; });
    if (nearer == end) return distance(*(end - 1));
    if (nearer == begin) return distance(*begin);
    const double before = distance(*(nearer - 1)), after = distance(*nearer);
    return before - other < other - after ? before : after;
  }

 private:
  [[nodiscard]] size_t pixel(uint32_t i, uint32_t j) const {
    return size_t{j} * texture_.width + i;
  }

  const DepthCamera& camera_;
  const PointTexture& texture_;
  uint64_t dmax_;
  std::vector<uint32_t> sorted_;  // the depths, ascending within each pixel
};

}  // namespace afx
