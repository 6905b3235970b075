// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Pictures for the tests of this folder.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <utility>

#include "render/renderer.h"

namespace afx::render {

/// Draws a scene that can be drawn.
inline RenderedImage drawn(const Scene& scene, const Camera& camera, const RenderOptions& options) {
  auto image = render(scene, camera, options);
  EXPECT_TRUE(image.ok()) << (image.ok() ? "" : image.error().text);
  return image.ok() ? std::move(image).value() : RenderedImage{};
}

/// The colour of a pixel, row 0 at the top.
inline Rgba8 at(const RenderedImage& image, uint32_t x, uint32_t y) {
  const uint8_t* p = image.picture.pixel(x, y);
  return {p[0], p[1], p[2], p[3]};
}

/// Looks along -z from z = 10, in parallel.
inline Camera front(double view_height) {
  return {.position = {0, 0, 10},
          .projection = Projection::orthographic,
          .view_height = view_height,
          .near_plane = 0.1};
}

/// The sum of alpha, in pixels.
inline double covered_area(const Picture& picture) {
  double sum = 0;
  for (size_t i = 3; i < picture.samples.size(); i += 4) sum += picture.samples[i] / 255.0;
  return sum;
}

}  // namespace afx::render
