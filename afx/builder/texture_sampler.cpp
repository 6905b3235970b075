// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/texture_sampler.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "afx/srgb.h"

namespace afx {
namespace {

constexpr float kOne = 65535.0F;

// A texel and its right neighbour, with the weight of the neighbour.
struct Pair {
  uint32_t first, second;
  float weight;
};

// Brings a coordinate into [0, 1] by the rule for outside; done before it becomes an integer, for
// it may be as large as a float can be.
double into_unit(double place, Wrap wrap) {
  if (wrap == Wrap::clamp) return std::clamp(place, 0.0, 1.0);
  if (wrap == Wrap::repeat) return place - std::floor(place);
  const double folded = place - 2 * std::floor(place / 2);
  return folded <= 1 ? folded : 2 - folded;
}

Pair neighbours(double unit, uint32_t size, Wrap wrap) {
  const double at = unit * size - 0.5;
  const auto first = at < 0 ? -1 : static_cast<int64_t>(at);  // rounded down: at is -0.5 at least
  const auto last = static_cast<int64_t>(size) - 1;
  const auto place = [&](int64_t i) {
    if (wrap == Wrap::repeat) i = i < 0 ? last : (i > last ? 0 : i);
    return static_cast<uint32_t>(std::clamp<int64_t>(i, 0, last));
  };
  return {place(first), place(first + 1), static_cast<float>(at - static_cast<double>(first))};
}

}  // namespace

TextureSampler::TextureSampler(const Picture& picture)
    : picture_(&picture), has_alpha_(picture.components % 2 == 0) {
  levels_.push_back({picture.width, picture.height, {}});
  while (levels_.back().width > 1 || levels_.back().height > 1)
    levels_.push_back(half(levels_.size() - 1));
}

// Times alpha.
glm::vec3 TextureSampler::light(size_t level, uint32_t x, uint32_t y) const {
  if (level > 0) {
    const uint16_t* rgb = texel(levels_[level], x, y);
    return glm::vec3(rgb[0], rgb[1], rgb[2]) / kOne;
  }
  const auto& linear = srgb_to_linear();
  const uint8_t* sample = picture_->pixel(x, y);
  const glm::vec3 plain = picture_->components < 3
                              ? glm::vec3(linear[sample[0]])
                              : glm::vec3(linear[sample[0]], linear[sample[1]], linear[sample[2]]);
  return has_alpha_ ? plain * alpha(level, x, y) : plain;
}

float TextureSampler::alpha(size_t level, uint32_t x, uint32_t y) const {
  if (level > 0) return texel(levels_[level], x, y)[3] / kOne;
  return static_cast<float>(picture_->pixel(x, y)[picture_->components - 1]) / 255;
}

// The mean of what lies under each new texel; where a side is odd, of 2 or 3 texels by their share.
TextureSampler::Level TextureSampler::half(size_t level) const {
  const Level& fine = levels_[level];
  Level coarse{std::max(1U, fine.width / 2), std::max(1U, fine.height / 2), {}};
  coarse.samples.resize(size_t{coarse.width} * coarse.height * samples_a_texel());
  // In units of 1/coarse of a fine texel, new texel i covers [i*fine, (i+1)*fine).
  const auto share = [](uint64_t i, uint64_t cell, uint64_t fine_size, uint64_t coarse_size) {
    const uint64_t low = std::max(i * fine_size, cell * coarse_size);
    const uint64_t high = std::min((i + 1) * fine_size, (cell + 1) * coarse_size);
    return static_cast<float>(high - low) / static_cast<float>(fine_size);
  };
  for (uint32_t y = 0; y < coarse.height; ++y) {
    const auto y0 = static_cast<uint32_t>(uint64_t{y} * fine.height / coarse.height);
    const auto y1 = static_cast<uint32_t>((uint64_t{y + 1} * fine.height - 1) / coarse.height);
    for (uint32_t x = 0; x < coarse.width; ++x) {
      const auto x0 = static_cast<uint32_t>(uint64_t{x} * fine.width / coarse.width);
      const auto x1 = static_cast<uint32_t>((uint64_t{x + 1} * fine.width - 1) / coarse.width);
      glm::vec4 sum(0);
      for (uint32_t b = y0; b <= y1; ++b)
        for (uint32_t a = x0; a <= x1; ++a) {
          const glm::vec4 one(light(level, a, b), has_alpha_ ? alpha(level, a, b) : 1);
          sum +=
              one * share(x, a, fine.width, coarse.width) * share(y, b, fine.height, coarse.height);
        }
      uint16_t* to = coarse.samples.data() + (size_t{y} * coarse.width + x) * samples_a_texel();
      for (int k = 0; k < static_cast<int>(samples_a_texel()); ++k)
        to[k] = static_cast<uint16_t>(std::min(sum[k], 1.0F) * kOne + 0.5F);
    }
  }
  return coarse;
}

glm::vec4 TextureSampler::sample(glm::dvec2 place, double area, Wrap wrap_u, Wrap wrap_v) const {
  // Texels of level n have the area 4^n; that level stands for areas from half to twice as large.
  // An area beyond all of the texture, up to infinity, is the coarsest.
  size_t level = levels_.size() - 1;
  if (!(area > 1))
    level = 0;
  else if (area < 0x1p62)
    level = std::min(level, static_cast<size_t>(std::ilogb(area) + 1) / 2);
  const Level& at = levels_[level];
  const Pair x = neighbours(into_unit(place.x, wrap_u), at.width, wrap_u);
  const Pair y =
      neighbours(1 - into_unit(place.y, wrap_v), at.height, wrap_v);  // rows from the top
  const auto blend = [&](const auto& value) {
    const auto upper = glm::mix(value(x.first, y.first), value(x.second, y.first), x.weight);
    const auto lower = glm::mix(value(x.first, y.second), value(x.second, y.second), x.weight);
    return glm::mix(upper, lower, y.weight);
  };
  const glm::vec3 light_here =
      blend([&](uint32_t column, uint32_t row) { return light(level, column, row); });
  if (!has_alpha_) return {light_here, 1};
  return {light_here,
          blend([&](uint32_t column, uint32_t row) { return alpha(level, column, row); })};
}

}  // namespace afx
