// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What a JSON file says of RGB-D pictures (rgbd_reader.h has its form).
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "afx/builder/rgbd_frame.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx {

/// A picture's name, and the member that has it, e.g. "frames[2].depth".
struct RgbdName {
  std::string name;
  std::string member;
};

/// A number above 0, or 0 where it is missing, and the member where it stands or would.
struct RgbdNumber {
  double value = 0;
  std::string member;
};

/// One frame before its pictures are read.
struct RgbdDescription {
  RgbdName colour, depth, mask;  ///< no name: no mask
  RgbdFrame frame;               ///< its camera
  std::string pose;              ///< the member that its camera stands in the world by
  RgbdNumber depth_scale, width, height;
  double near = 0, far = std::numeric_limits<double>::infinity();
};

/// Errors, warnings   as read_rgbd, without a file's name
Result<std::vector<RgbdDescription>> read_rgbd_description(std::span<const uint8_t> bytes,
                                                           const Limits& limits,
                                                           Diagnostics& diagnostics);

/// A number for messages.
std::string rgbd_text(double value);

}  // namespace afx
