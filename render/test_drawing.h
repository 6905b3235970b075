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

/// The sum of alpha, in pixels.
inline double covered_area(const Picture& picture) {
  double sum = 0;
  for (size_t i = 3; i < picture.samples.size(); i += 4) sum += picture.samples[i] / 255.0;
  return sum;
}

}  // namespace afx::render
