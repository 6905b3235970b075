// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>

#include "afx/depth_camera.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx {

/// How a picture is taken.
struct Shot {
  DepthCamera camera;
  uint32_t width = 0, height = 0;  ///< in pixels, 1..kMostPixelsAlong
};

inline constexpr uint32_t kMostPixelsAlong = 65535;

/// pixel_bytes   that the one who takes the picture needs for a pixel
/// Errors        bad_argument: those of check_depth_camera, a size out of range; limit_exceeded:
///               more pixels than limits.picture_pixels, or than limits.memory holds
[[nodiscard]] Status check_shot(const Shot& shot, uint64_t pixel_bytes, const Limits& limits);

}  // namespace afx
