// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// DepthImages, resolved from their nodes: what builders, converters and renderers work with.
// Source: ISO/IEC 14496-16, DepthImage, SimpleTexture, PointTexture (clauses not checked); the
// paper, section III.
#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "afx/depth_camera.h"
#include "afx/picture.h"
#include "codec/error.h"

namespace afx {

/// A picture and the depth of each of its pixels.
struct SimpleTexture {
  Picture colour;     ///< sRGB; 2 or 4 components: the last is opacity (never the depth)
  DeepPicture depth;  ///< one component, of the same size; 0 = not part of the model, 1 = far
                      ///< plane, 2^bits - 1 = near plane

  [[nodiscard]] uint64_t dmax() const { return (uint64_t{1} << depth.bits) - 1; }
};

/// Layers of depths: any number of samples for each pixel.
struct PointTexture {
  uint32_t width = 0;
  uint32_t height = 0;
  unsigned depth_bits = 8;  ///< depthNbBits + 1, 1..32
  /// The samples of pixel (i, j), counted from the lower left corner, are those from
  /// starts[j * width + i] up to the next start; so there is one start more than pixels. Empty: no
  /// pixel has samples.
  std::vector<uint32_t> starts;
  std::vector<uint32_t> depths;  ///< 1..dmax; writers give them near to far within a pixel
  std::vector<Rgba8> colours;    ///< one for each depth, opaque

  [[nodiscard]] uint64_t dmax() const { return (uint64_t{1} << depth_bits) - 1; }
  bool operator==(const PointTexture&) const = default;
};

/// One DepthImage.
struct DepthImage {
  DepthCamera camera;
  std::variant<SimpleTexture, PointTexture> texture;

  [[nodiscard]] uint32_t width() const;
  [[nodiscard]] uint32_t height() const;
};

/// Checks what came from elsewhere: the camera (check_depth_camera), sizes above 0 and fitting the
/// numbers of samples, 1 to 16 bits of depth (PointTexture 1 to 32), no depth above dmax.
/// Errors  bad_argument
[[nodiscard]] Status check_depth_image(const DepthImage& image);

}  // namespace afx
