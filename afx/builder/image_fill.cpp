// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/image_fill.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace afx {
namespace {

constexpr unsigned kRings = 2;

struct Mean {
  float r = 0, g = 0, b = 0;
  float weight = 0;  // 0: nothing known here

  void add(float red, float green, float blue, float w) {
    r += red * w;
    g += green * w;
    b += blue * w;
    weight += w;
  }
  [[nodiscard]] Mean normalized() const {
    return weight > 0 ? Mean{r / weight, g / weight, b / weight, 1} : Mean{};
  }
};

struct Layer {
  uint32_t width = 0, height = 0;
  std::vector<Mean> cells;
  [[nodiscard]] const Mean& at(int64_t x, int64_t y) const {
    const auto column = static_cast<size_t>(std::clamp<int64_t>(x, 0, int64_t{width} - 1));
    const auto row = static_cast<size_t>(std::clamp<int64_t>(y, 0, int64_t{height} - 1));
    return cells[row * width + column];
  }
};

void set_pixel(Picture& picture, uint32_t x, uint32_t y, const Mean& mean) {
  uint8_t* to = picture.pixel(x, y);
  to[0] = static_cast<uint8_t>(std::lround(mean.r));
  to[1] = static_cast<uint8_t>(std::lround(mean.g));
  to[2] = static_cast<uint8_t>(std::lround(mean.b));
}

Mean mean_of_neighbours(const Picture& picture, const std::vector<bool>& used, uint32_t x,
                        uint32_t y) {
  Mean mean;
  for (uint32_t b = y > 0 ? y - 1 : 0; b <= std::min(y + 1, picture.height - 1); ++b)
    for (uint32_t a = x > 0 ? x - 1 : 0; a <= std::min(x + 1, picture.width - 1); ++a) {
      if (!used[size_t{b} * picture.width + a]) continue;
      const uint8_t* from = picture.pixel(a, b);
      mean.add(from[0], from[1], from[2], 1);
    }
  return mean.normalized();
}

// One ring of pixels around those used, which count as used from then on.
void add_ring(Picture& picture, std::vector<bool>& used) {
  std::vector<std::pair<size_t, Mean>> ring;
  for (uint32_t y = 0; y < picture.height; ++y)
    for (uint32_t x = 0; x < picture.width; ++x) {
      const size_t place = size_t{y} * picture.width + x;
      if (used[place]) continue;
      const Mean mean = mean_of_neighbours(picture, used, x, y);
      if (mean.weight > 0) ring.emplace_back(place, mean);
    }
  for (const auto& [place, mean] : ring) {
    used[place] = true;
    set_pixel(picture, static_cast<uint32_t>(place % picture.width),
              static_cast<uint32_t>(place / picture.width), mean);
  }
}

Layer first_layer(const Picture& picture, const std::vector<bool>& used) {
  Layer layer{(picture.width + 1) / 2, (picture.height + 1) / 2, {}};
  layer.cells.resize(size_t{layer.width} * layer.height);
  for (uint32_t y = 0; y < picture.height; ++y)
    for (uint32_t x = 0; x < picture.width; ++x) {
      if (!used[size_t{y} * picture.width + x]) continue;
      const uint8_t* from = picture.pixel(x, y);
      layer.cells[size_t{y / 2} * layer.width + x / 2].add(from[0], from[1], from[2], 1);
    }
  for (Mean& cell : layer.cells) cell = cell.normalized();
  return layer;
}

Layer next_layer(const Layer& fine) {
  Layer layer{(fine.width + 1) / 2, (fine.height + 1) / 2, {}};
  layer.cells.resize(size_t{layer.width} * layer.height);
  for (uint32_t y = 0; y < fine.height; ++y)
    for (uint32_t x = 0; x < fine.width; ++x) {
      const Mean& from = fine.cells[size_t{y} * fine.width + x];
      layer.cells[size_t{y / 2} * layer.width + x / 2].add(from.r, from.g, from.b, from.weight);
    }
  for (Mean& cell : layer.cells) cell = cell.normalized();
  return layer;
}

// The colour at a cell's place in the next coarser layer: the nearest cell nine times, its
// neighbours towards the place three, three and one times (bilinear with the weights 3/4 and 1/4).
Mean pulled(const Layer& coarse, uint32_t x, uint32_t y) {
  const int64_t cx = x / 2, cy = y / 2;
  const int64_t dx = x % 2 == 0 ? -1 : 1, dy = y % 2 == 0 ? -1 : 1;
  Mean mean;
  const auto add = [&](const Mean& cell, float weight) {
    mean.add(cell.r, cell.g, cell.b, cell.weight * weight);
  };
  add(coarse.at(cx, cy), 9);
  add(coarse.at(cx + dx, cy), 3);
  add(coarse.at(cx, cy + dy), 3);
  add(coarse.at(cx + dx, cy + dy), 1);
  return mean.normalized();
}

}  // namespace

void fill_unused(Picture& picture, const std::vector<bool>& used_by_object) {
  std::vector<bool> used = used_by_object;
  if (std::find(used.begin(), used.end(), true) == used.end()) {
    std::fill(picture.samples.begin(), picture.samples.end(), uint8_t{128});
    return;
  }
  for (unsigned ring = 0; ring < kRings; ++ring) add_ring(picture, used);
  std::vector<Layer> layers{first_layer(picture, used)};
  while (layers.back().width > 1 || layers.back().height > 1)
    layers.push_back(next_layer(layers.back()));
  for (size_t n = layers.size() - 1; n-- > 0;)
    for (uint32_t y = 0; y < layers[n].height; ++y)
      for (uint32_t x = 0; x < layers[n].width; ++x) {
        Mean& cell = layers[n].cells[size_t{y} * layers[n].width + x];
        if (!(cell.weight > 0)) cell = pulled(layers[n + 1], x, y);
      }
  for (uint32_t y = 0; y < picture.height; ++y)
    for (uint32_t x = 0; x < picture.width; ++x)
      if (!used[size_t{y} * picture.width + x]) set_pixel(picture, x, y, pulled(layers[0], x, y));
}

}  // namespace afx
