// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/rgbd_frame.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "afx/builder/texture_sampler.h"
#include "afx/pixel_pieces.h"
#include "afx/srgb.h"
#include "afx/surfel_sources.h"

namespace afx {
namespace {

/// The pixels of a frame, counted from the lower left.
class FrameSamples {
 public:
  explicit FrameSamples(const RgbdFrame& frame) : frame_(frame) {
    if (frame.colour.width != frame.width || frame.colour.height != frame.height)
      scaled_.emplace(frame.colour);
  }

  [[nodiscard]] size_t count(uint32_t i, uint32_t j) const { return at(i, j) > 0 ? 1 : 0; }
  [[nodiscard]] PixelSample sample(uint32_t i, uint32_t j, size_t) const {
    return {at(i, j), colour(i, j)};
  }
  [[nodiscard]] std::optional<double> nearest(uint32_t i, uint32_t j, double) const {
    const double distance = at(i, j);
    return distance > 0 ? std::optional(distance) : std::nullopt;
  }

 private:
  [[nodiscard]] double at(uint32_t i, uint32_t j) const {
    return static_cast<double>(frame_.distances[size_t{frame_.height - 1 - j} * frame_.width + i]);
  }

  [[nodiscard]] Rgba8 colour(uint32_t i, uint32_t j) const {
    if (!scaled_) return colour_at(frame_.colour, i, frame_.height - 1 - j);
    const double w = frame_.width, h = frame_.height;
    const glm::vec3 light(scaled_->sample({(i + 0.5) / w, (j + 0.5) / h},
                                          scaled_->texels() / (w * h), Wrap::clamp, Wrap::clamp));
    return {linear_to_srgb(light.x), linear_to_srgb(light.y), linear_to_srgb(light.z), 255};
  }

  const RgbdFrame& frame_;
  std::optional<TextureSampler> scaled_;
};

/// The frame's camera as one with the view in its middle, of which the picture shows a part.
PixelGrid grid_of(const RgbdFrame& frame) {
  PixelGrid grid;
  grid.width = frame.width;
  grid.height = frame.height;
  grid.step = frame.step;
  const double w = frame.width, h = frame.height;
  grid.camera.position = {0, 0, 0};
  grid.camera.orthographic = false;
  grid.camera.field_of_view = {2 * std::atan(w / (2 * frame.fx)),
                               2 * std::atan(h / (2 * frame.fy))};
  grid.shift = {(w / 2 - 0.5 - frame.cx) / w, (frame.cy + 0.5 - h / 2) / h};
  return grid;
}

bool lies_between(double before, double here, double after, double jump) {
  if (!(before > 0) || !(after > 0)) return false;
  const double nearer = std::min(before, after), farther = std::max(before, after);
  return here - nearer > jump && farther - here > jump;
}

}  // namespace

void drop_flying_pixels(RgbdFrame& frame) {
  const std::vector<float> seen = frame.distances;
  const size_t w = frame.width, h = frame.height;
  const auto at = [&](size_t x, size_t y) { return static_cast<double>(seen[y * w + x]); };
  for (size_t y = 0; y < h; ++y)
    for (size_t x = 0; x < w; ++x) {
      const double here = at(x, y);
      if (!(here > 0)) continue;
      const double across = kSurfaceStep * here / frame.fx + frame.step;
      const double along = kSurfaceStep * here / frame.fy + frame.step;
      if ((x > 0 && x + 1 < w && lies_between(at(x - 1, y), here, at(x + 1, y), across)) ||
          (y > 0 && y + 1 < h && lies_between(at(x, y - 1), here, at(x, y + 1), along)))
        frame.distances[y * w + x] = 0;
    }
}

Result<Surfels> surfels_of(const RgbdFrame& frame, unsigned threads, const Limits& limits) {
  const PixelGrid grid = grid_of(frame);
  const auto seen = pieces_of(grid, FrameSamples(frame), threads, limits);
  if (!seen.ok()) return seen.error();
  Surfels surfels;
  surfels.reserve(seen.value().size());
  append(seen.value(), frame.to_world, surfels);
  return surfels;
}

}  // namespace afx
