// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/shot.h"

#include <algorithm>
#include <string>

namespace afx {

Status check_shot(const Shot& shot, uint64_t pixel_bytes, const Limits& limits) {
  if (Status right = check_depth_camera(shot.camera); !right.ok()) return right;
  const std::string size = std::to_string(shot.width) + " x " + std::to_string(shot.height);
  const auto fits = [](uint32_t side) { return side >= 1 && side <= kMostPixelsAlong; };
  if (!fits(shot.width) || !fits(shot.height))
    return Error{Errc::bad_argument, Place::none(),
                 "the picture is " + size + " pixels (expected 1 to 65535 along a side)"};
  const uint64_t pixels = uint64_t{shot.width} * shot.height;
  if (pixels > std::min(limits.picture_pixels, limits.memory / pixel_bytes))
    return Error{Errc::limit_exceeded, Place::none(),
                 "the picture has " + size + " pixels (more than the limit)"};
  return {};
}

}  // namespace afx
