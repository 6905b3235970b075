// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/texture_sampler.h"

#include <algorithm>
#include <array>
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

// The texels under a texel of the next level, along one side: two, or three where the side is odd,
// each with its share of it.
struct Cover {
  uint32_t first, count;
  std::array<float, 3> shares;
};

std::vector<Cover> covers(uint64_t fine, uint64_t coarse) {
  std::vector<Cover> all(coarse);
  for (uint64_t i = 0; i < coarse; ++i) {
    // In units of 1/coarse of a fine texel, new texel i covers [i*fine, (i+1)*fine).
    const uint64_t first = i * fine / coarse, last = ((i + 1) * fine - 1) / coarse;
    all[i].first = static_cast<uint32_t>(first);
    all[i].count = static_cast<uint32_t>(last - first + 1);
    for (uint64_t cell = first; cell <= last; ++cell) {
      const uint64_t low = std::max(i * fine, cell * coarse);
      const uint64_t high = std::min((i + 1) * fine, (cell + 1) * coarse);
      all[i].shares[cell - first] = static_cast<float>(high - low) / static_cast<float>(fine);
    }
  }
  return all;
}

}  // namespace

TextureSampler::TextureSampler(const Picture& picture)
    : picture_(&picture), linear_(&srgb_to_linear()), has_alpha_(picture.components % 2 == 0) {
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
  const auto& linear = *linear_;
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

// The mean of what lies under each new texel.
TextureSampler::Level TextureSampler::half(size_t level) const {
  const Level& fine = levels_[level];
  Level coarse{std::max(1U, fine.width / 2), std::max(1U, fine.height / 2), {}};
  coarse.samples.resize(size_t{coarse.width} * coarse.height * samples_a_texel());
  const std::vector<Cover> columns = covers(fine.width, coarse.width);
  const std::vector<Cover> rows = covers(fine.height, coarse.height);
  uint16_t* to = coarse.samples.data();
  for (const Cover& row : rows)
    for (const Cover& column : columns) {
      glm::vec4 sum(0);
      for (uint32_t j = 0; j < row.count; ++j)
        for (uint32_t i = 0; i < column.count; ++i) {
          const uint32_t x = column.first + i, y = row.first + j;
          const glm::vec4 one(light(level, x, y), has_alpha_ ? alpha(level, x, y) : 1);
          sum += one * column.shares[i] * row.shares[j];
        }
      for (int k = 0; k < static_cast<int>(samples_a_texel()); ++k)
        *to++ = static_cast<uint16_t>(std::min(sum[k], 1.0F) * kOne + 0.5F);
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
