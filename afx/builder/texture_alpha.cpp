// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/texture_alpha.h"

#include <algorithm>
#include <utility>

namespace afx {
namespace {

bool has_alpha(const Picture& picture) { return picture.components % 2 == 0 && !picture.empty(); }

uint8_t alpha_of(const Picture& picture, size_t pixel) {
  return picture.samples[(pixel + 1) * picture.components - 1];
}

size_t pixels(const Picture& picture) { return size_t{picture.width} * picture.height; }

bool is_opaque(const Picture& picture) {
  for (size_t i = 0; i < pixels(picture); ++i)
    if (alpha_of(picture, i) != 255) return false;
  return true;
}

Picture without_alpha(const Picture& picture) {
  Picture plain(picture.width, picture.height, picture.components - 1);
  for (size_t i = 0; i < pixels(picture); ++i)
    std::copy_n(picture.samples.data() + i * picture.components, plain.components,
                plain.samples.data() + i * plain.components);
  return plain;
}

// The red, green and blue of a pixel, whatever the picture has.
void copy_colour(const uint8_t* from, uint32_t components, uint8_t* to) {
  for (int k = 0; k < 3; ++k) to[k] = from[components < 3 ? 0 : k];
}

uint8_t mean_colour(const uint8_t* pixel, uint32_t components) {
  uint8_t rgb[3];
  copy_colour(pixel, components, rgb);
  return static_cast<uint8_t>((rgb[0] + rgb[1] + rgb[2] + 1) / 3);
}

}  // namespace

bool has_mixed_alpha(const Picture& picture) {
  if (!has_alpha(picture)) return false;
  bool below = false, above = false;
  for (size_t i = 0; i < pixels(picture) && !(below && above); ++i)
    (alpha_of(picture, i) < 128 ? below : above) = true;
  return below && above;
}

Picture with_alpha_by_rule(Picture picture, AlphaRule rule) {
  if (!has_alpha(picture)) return picture;
  const bool counts = rule == AlphaRule::if_mixed ? has_mixed_alpha(picture)
                                                  : rule == AlphaRule::as_is && !is_opaque(picture);
  return counts ? std::move(picture) : without_alpha(picture);
}

Picture with_opacity(const Picture& colours, const Picture& opacity) {
  const Picture& sized = colours.empty() ? opacity : colours;
  const bool by_alpha = has_mixed_alpha(opacity);
  Picture result(sized.width, sized.height, 4);
  for (uint32_t y = 0; y < result.height; ++y) {
    const auto row = static_cast<uint32_t>(uint64_t{y} * opacity.height / result.height);
    for (uint32_t x = 0; x < result.width; ++x) {
      const auto column = static_cast<uint32_t>(uint64_t{x} * opacity.width / result.width);
      const uint8_t* from = opacity.pixel(column, row);
      uint8_t* to = result.pixel(x, y);
      std::fill_n(to, 3, uint8_t{255});
      if (!colours.empty()) copy_colour(colours.pixel(x, y), colours.components, to);
      to[3] = by_alpha ? from[opacity.components - 1] : mean_colour(from, opacity.components);
    }
  }
  return result;
}

}  // namespace afx
