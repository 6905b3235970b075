// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/surfel_layers.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "afx/srgb.h"
#include "afx/surfel_footprint.h"

namespace afx {
namespace {

struct Sample {
  uint64_t key;  // pixel << 32 | ~depth: in the order of pixels, and near to far
  Rgba8 colour;
  bool filling;  // of a pixel that is covered, but not the one of the piece's centre

  [[nodiscard]] uint32_t pixel() const { return static_cast<uint32_t>(key >> 32); }
  [[nodiscard]] uint32_t depth() const { return ~static_cast<uint32_t>(key); }
  /// In this order sums do not depend on the order of the pieces.
  bool operator<(const Sample& other) const {
    const auto all = [](const Sample& s) {
      return std::tuple(s.key, s.filling, s.colour.r, s.colour.g, s.colour.b);
    };
    return all(*this) < all(other);
  }
};

Rgba8 mean_colour(std::span<const Sample> samples) {
  glm::dvec3 sum(0);
  for (const Sample& sample : samples) sum += linear_light(sample.colour);
  return to_srgb(sum / static_cast<double>(samples.size()));
}

class Layering {
 public:
  Layering(const Surfels& surfels, const DepthCamera& camera, PointTexture& texture)
      : surfels_(surfels),
        camera_(camera),
        view_(camera, texture.width, texture.height),
        texture_(texture),
        step_((camera.far_plane - camera.near_plane) /
              static_cast<double>(std::max<uint64_t>(texture.dmax(), 2) - 1)) {}

  Status run(const Limits& limits) {
    const uint64_t most = std::min<uint64_t>(limits.memory / sizeof(Sample), 0xffffffff);
    uint64_t touched = 0;
    samples_.reserve(std::min<uint64_t>(surfels_.size(), most));
    for (size_t n = 0; n < surfels_.size(); ++n) {
      if (surfels_.colours[n].a == 0) continue;
      const SurfelFootprint piece = view_.footprint(surfels_, n);
      touched += piece.range.count();
      if (touched > most_surfel_pixels(texture_.width, texture_.height))
        return beyond_limit("the pieces of surface touch " + std::to_string(touched) + " pixels");
      if (samples_.size() + piece.range.count() + 1 > most)
        return beyond_limit("the samples of the pieces of surface take memory");
      add(piece, surfels_.colours[n]);
    }
    std::sort(samples_.begin(), samples_.end());
    drop_fillings();
    fill_texture();
    return {};
  }

 private:
  void add(const SurfelFootprint& piece, Rgba8 colour) {
    if (piece.owns_pixel) add_sample(piece.own_i, piece.own_j, piece.distance, colour, false);
    piece.for_each_pixel(0, texture_.height, [&](uint32_t i, uint32_t j, double at) {
      const bool own = piece.owns_pixel && i == piece.own_i && j == piece.own_j;
      if (!own) add_sample(i, j, at, colour, true);
    });
  }

  void add_sample(uint32_t i, uint32_t j, double distance, Rgba8 colour, bool filling) {
    const uint64_t depth = distance_to_depth(distance, texture_.dmax(), camera_);
    const uint64_t pixel = uint64_t{j} * texture_.width + i;
    if (depth != 0) samples_.push_back({pixel << 32 | (0xffffffff - depth), colour, filling});
  }

  /// Whether one sample lies within a pixel's side of another of the same pixel.
  [[nodiscard]] bool close(const Sample& a, const Sample& b) const {
    if (a.pixel() != b.pixel()) return false;
    const auto [less, more] = std::minmax({a.depth(), b.depth()});
    const double distance = depth_to_distance(a.depth(), texture_.dmax(), camera_);
    return step_ * (more - less) <= view_.pixel_side(distance);
  }

  /// Leaves out the fillings next to centres, and those next to a filling that is kept.
  void drop_fillings() {
    std::vector<bool> dropped(samples_.size());
    const Sample* centre = nullptr;
    for (size_t n = samples_.size(); n-- > 0;) {
      if (!samples_[n].filling)
        centre = &samples_[n];
      else
        dropped[n] = centre != nullptr && close(samples_[n], *centre);
    }
    size_t kept = 0;
    for (size_t n = 0; n < samples_.size(); ++n) {
      const Sample sample = samples_[n];
      if (dropped[n]) continue;
      if (sample.filling && kept > 0 && close(sample, samples_[kept - 1])) continue;
      samples_[kept++] = sample;
    }
    samples_.resize(kept);
  }

  void fill_texture() {
    if (samples_.empty()) return;
    texture_.starts.assign(size_t{texture_.width} * texture_.height + 1, 0);
    for (size_t n = 0; n < samples_.size();) {
      size_t end = n + 1;
      while (end < samples_.size() && samples_[end].key == samples_[n].key) ++end;
      texture_.depths.push_back(samples_[n].depth());
      texture_.colours.push_back(mean_colour(std::span(samples_).subspan(n, end - n)));
      ++texture_.starts[size_t{samples_[n].pixel()} + 1];
      n = end;
    }
    for (size_t p = 1; p < texture_.starts.size(); ++p)
      texture_.starts[p] += texture_.starts[p - 1];
  }

  const Surfels& surfels_;
  const DepthCamera& camera_;
  SurfelCamera view_;
  PointTexture& texture_;
  double step_;  // of the depth
  std::vector<Sample> samples_;
};

}  // namespace

unsigned depth_bits_for(double range, double pixel_side) {
  unsigned bits = 8;
  // 2^bits - 1 values have one step fewer.
  while (bits < 16 && range / ((1U << bits) - 2) > pixel_side / 2) ++bits;
  return bits;
}

Result<DepthImage> layer_surfels(const Surfels& surfels, const Shot& shot, unsigned depth_bits,
                                 const Limits& limits) {
  if (Status s = check_shot(shot, sizeof(uint32_t), limits); !s.ok()) return s.error();
  if (Status s = check_depth_bits(depth_bits, 32); !s.ok()) return s.error();
  PointTexture texture;
  texture.width = shot.width;
  texture.height = shot.height;
  texture.depth_bits = depth_bits;
  if (Status run = Layering(surfels, shot.camera, texture).run(limits); !run.ok())
    return run.error();
  return DepthImage{shot.camera, std::move(texture)};
}

}  // namespace afx
