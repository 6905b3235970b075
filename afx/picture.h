// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace afx {

/// A picture in memory, 8 bits a sample, as files and screens have it: sRGB where it is colour, not
/// premultiplied, the top row first, rows without gaps, components interleaved.
struct Picture {
  uint32_t width = 0;
  uint32_t height = 0;
  uint32_t components = 0;       ///< 1 grey, 2 grey + alpha, 3 RGB, 4 RGBA
  std::vector<uint8_t> samples;  ///< height * width * components

  Picture() = default;
  /// A picture of zeros.
  Picture(uint32_t w, uint32_t h, uint32_t n)
      : width(w), height(h), components(n), samples(size_t{w} * h * n) {}

  [[nodiscard]] bool empty() const { return samples.empty(); }
  /// The first sample of the pixel in column x of row y, row 0 at the top.
  [[nodiscard]] uint8_t* pixel(uint32_t x, uint32_t y) {
    return samples.data() + (size_t{y} * width + x) * components;
  }
  [[nodiscard]] const uint8_t* pixel(uint32_t x, uint32_t y) const {
    return samples.data() + (size_t{y} * width + x) * components;
  }
};

struct Rgba8 {
  uint8_t r = 0, g = 0, b = 0, a = 255;
  bool operator==(const Rgba8&) const = default;
};

/// A picture with 16 bits a sample; depth pictures are read into it as they are stored.
struct DeepPicture {
  uint32_t width = 0;
  uint32_t height = 0;
  uint32_t components = 0;
  uint32_t bits = 16;             ///< significant bits of a sample: its largest value is 2^bits - 1
  std::vector<uint16_t> samples;  ///< height * width * components
};

/// A picture in floating point, as it is stored: distances and other data.
struct FloatPicture {
  uint32_t width = 0;
  uint32_t height = 0;
  uint32_t components = 0;
  std::vector<float> samples;  ///< height * width * components; may be infinite or NaN
};

/// The colour of the pixel in column x of row y, row 0 at the top: grey fills all three, alpha is
/// handed over as it is.
///
/// picture   1 to 4 components
[[nodiscard]] inline Rgba8 colour_at(const Picture& picture, uint32_t x, uint32_t y) {
  const uint8_t* p = picture.pixel(x, y);
  switch (picture.components) {
    case 1:
      return {p[0], p[0], p[0], 255};
    case 2:
      return {p[0], p[0], p[0], p[1]};
    case 3:
      return {p[0], p[1], p[2], 255};
    default:
      return {p[0], p[1], p[2], p[3]};
  }
}

}  // namespace afx
