// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "afx/builder/view_source.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx {

/// Reads cameras from JSON:
///
///     {"cameras": [{"position": [x, y, z], "orientation": [x, y, z, angle], "orthographic": true,
///                   "fieldOfView": [width, height], "nearPlane": n, "farPlane": f,
///                   "width": pixels, "height": pixels}]}
///
/// The members are named after the fields of DepthImage and mean the same; all but orientation and
/// orthographic must be there. Cameras are rounded to what a node can hold (as_in_node).
/// Errors  those of parse_json; malformed: a member that is missing, of another type or
///         not known, each with its path ("cameras[2].width"); bad_argument: check_depth_camera's,
///         sizes outside 1..65535, no cameras or more than 255
Result<std::vector<Shot>> read_camera_list(std::span<const uint8_t> json, const Limits& limits);

}  // namespace afx
