// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Pictures of a camera that measures distances too (RGB-D), and the surface that they show.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <vector>

#include "afx/picture.h"
#include "afx/surfels.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx {

/// One picture of the camera. The pixel in column x of row y, from the upper left, has its centre
/// at (x, y); at distance d from the plane through the camera it shows the point
/// ((x - cx) / fx * d, -(y - cy) / fy * d, -d) of the camera's system.
struct RgbdFrame {
  uint32_t width = 0, height = 0;  ///< of the distances
  std::vector<float> distances;    ///< scene units, the top row first; 0 = none
  double step = 0;                 ///< between distances, scene units; 0 = none
  Picture colour;                  ///< RGB or grey, sRGB, of any size, showing the same view
  double fx = 1, fy = 1;           ///< focal lengths in pixels, > 0
  double cx = 0, cy = 0;           ///< principal point in pixels
  glm::dmat4 to_world{1};          ///< affine; from x right, y up, z towards the viewer
};

/// Takes away what lies in the air: pixels between two neighbours, left and right or above and
/// below, that are on different surfaces (kSurfaceStep, pixel_pieces.h), and on neither of them.
/// Cameras give them at the edges of things, where a pixel sees both.
void drop_flying_pixels(RgbdFrame& frame);

/// The pixels as pieces of surface in the world (pixel_pieces.h). The colour is that of the pixel,
/// or where the pictures differ in size the mean over its area at the same place.
/// Errors  limit_exceeded
Result<Surfels> surfels_of(const RgbdFrame& frame, unsigned threads, const Limits& limits);

}  // namespace afx
