// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/mip_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "afx/srgb.h"

namespace afx::render {
namespace {

uint8_t to_byte(float value) { return static_cast<uint8_t>(value + 0.5F); }

MipPicture::Level first_level(const Picture& picture, bool& opaque) {
  MipPicture::Level level{picture.width, picture.height, {}};
  level.pixels.resize(size_t{picture.width} * picture.height * 4);
  uint8_t* out = level.pixels.data();
  for (uint32_t y = 0; y < picture.height; ++y) {
    for (uint32_t x = 0; x < picture.width; ++x, out += 4) {
      const Rgba8 c = colour_at(picture, x, y);
      const auto times = [&](uint8_t part) {
        return c.a == 255 ? part : static_cast<uint8_t>((part * c.a + 127) / 255);
      };
      out[0] = times(c.r), out[1] = times(c.g), out[2] = times(c.b), out[3] = c.a;
      opaque = opaque && c.a == 255;
    }
  }
  return level;
}

/// The pixels of the finer level that one pixel of the next one covers along a side, and how much
/// of each: two, or three of an odd number.
struct Taps {
  uint32_t first, count;
  std::array<float, 3> part;
};

Taps taps(uint32_t at, uint32_t fine, uint32_t coarse) {
  if (fine == 1) return {0, 1, {1, 0, 0}};
  if (fine % 2 == 0) return {2 * at, 2, {0.5F, 0.5F, 0}};
  const auto whole = static_cast<float>(fine), k = static_cast<float>(at);
  const auto n = static_cast<float>(coarse);
  return {2 * at, 3, {(n - k) / whole, n / whole, (k + 1) / whole}};
}

void store_mean(const glm::vec4& sum, uint8_t* out) {
  const float alpha = sum.w;
  out[3] = to_byte(alpha * 255);
  for (int k = 0; k < 3; ++k) {
    const float straight = alpha > 0 ? linear_to_srgb(sum[k] / alpha) : 0;
    out[k] = to_byte(straight * alpha);
  }
}

/// Linear light times alpha, and alpha.
glm::vec4 weighted_light(const uint8_t* pixel) {
  const std::array<float, 256>& linear = srgb_to_linear();
  if (pixel[3] == 255) return {linear[pixel[0]], linear[pixel[1]], linear[pixel[2]], 1};
  if (pixel[3] == 0) return glm::vec4(0);
  const float alpha = static_cast<float>(pixel[3]) / 255;
  glm::vec4 light(0, 0, 0, alpha);
  for (int k = 0; k < 3; ++k)
    light[k] = srgb_to_linear(static_cast<float>(pixel[k]) / static_cast<float>(pixel[3])) * alpha;
  return light;
}

MipPicture::Level next_level(const MipPicture::Level& fine) {
  const uint32_t width = std::max(1U, fine.width / 2), height = std::max(1U, fine.height / 2);
  MipPicture::Level level{width, height, {}};
  level.pixels.resize(size_t{width} * height * 4);
  uint8_t* out = level.pixels.data();
  for (uint32_t y = 0; y < height; ++y) {
    const Taps rows = taps(y, fine.height, height);
    for (uint32_t x = 0; x < width; ++x, out += 4) {
      const Taps columns = taps(x, fine.width, width);
      glm::vec4 sum(0);
      for (uint32_t j = 0; j < rows.count; ++j) {
        const size_t row = size_t{rows.first + j} * fine.width + columns.first;
        for (uint32_t i = 0; i < columns.count; ++i)
          sum += rows.part[j] * columns.part[i] * weighted_light(&fine.pixels[(row + i) * 4]);
      }
      store_mean(sum, out);
    }
  }
  return level;
}

/// Two neighbouring pixels along a side and how much the second one counts.
struct Pair {
  size_t first, second;
  float part;
};

Pair pair_at(float place, uint32_t count, bool repeat) {
  if (!std::isfinite(place)) place = 0;
  const auto size = static_cast<float>(count);
  const auto last = static_cast<int64_t>(count) - 1;
  const float inside = repeat ? place - std::floor(place) : std::clamp(place, 0.0F, 1.0F);
  const float at = inside * size - 0.5F;
  const float whole = std::floor(at);
  const auto number = static_cast<int64_t>(whole);
  const auto wrap = [&](int64_t k) {
    if (k < 0) return static_cast<size_t>(repeat ? last : 0);
    if (k > last) return static_cast<size_t>(repeat ? 0 : last);
    return static_cast<size_t>(k);
  };
  return {wrap(number), wrap(number + 1), at - whole};
}

}  // namespace

MipPicture::MipPicture(const Picture& picture) : components_(picture.components) {
  levels_.push_back(first_level(picture, opaque_));
  while (levels_.back().width > 1 || levels_.back().height > 1)
    levels_.push_back(next_level(levels_.back()));
}

glm::vec4 MipPicture::between(const Level& level, const glm::vec2& place, bool repeat_s,
                              bool repeat_t) const {
  const Pair x = pair_at(place.x, level.width, repeat_s);
  const Pair y = pair_at(1 - place.y, level.height, repeat_t);
  const auto pixel = [&](size_t column, size_t row) {
    const uint8_t* p = &level.pixels[(row * level.width + column) * 4];
    return glm::vec4(p[0], p[1], p[2], p[3]);
  };
  const glm::vec4 upper = glm::mix(pixel(x.first, y.first), pixel(x.second, y.first), x.part);
  const glm::vec4 lower = glm::mix(pixel(x.first, y.second), pixel(x.second, y.second), x.part);
  return glm::mix(upper, lower, y.part) / 255.0F;
}

glm::vec4 MipPicture::at(const glm::vec2& place, float level, bool repeat_s, bool repeat_t) const {
  const auto last = static_cast<float>(levels_.size() - 1);
  const float fine = level > 0 ? std::min(level, last) : 0;
  const auto number = static_cast<size_t>(fine);
  glm::vec4 colour = between(levels_[number], place, repeat_s, repeat_t);
  const float part = fine - static_cast<float>(number);
  if (part > 0)
    colour = glm::mix(colour, between(levels_[number + 1], place, repeat_s, repeat_t), part);
  if (opaque_) return {glm::vec3(colour), 1};
  return colour.w > 0 ? glm::vec4(glm::vec3(colour) / colour.w, colour.w) : glm::vec4(0);
}

float MipPicture::level_for(const glm::vec2& to_right, const glm::vec2& down) const {
  const glm::vec2 size(static_cast<float>(levels_[0].width), static_cast<float>(levels_[0].height));
  const glm::vec2 a = to_right * size, b = down * size;
  return std::log2(std::max(glm::dot(a, a), glm::dot(b, b))) / 2;
}

void MipPictures::add(const std::shared_ptr<const Picture>& picture) {
  if (picture != nullptr) pictures_.try_emplace(picture.get(), *picture);
}

const MipPicture* MipPictures::find(const Picture* picture) const {
  const auto found = pictures_.find(picture);
  return found == pictures_.end() ? nullptr : &found->second;
}

}  // namespace afx::render
