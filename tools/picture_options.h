// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Options that commands which draw have in common.
#pragma once

#include <cstdint>
#include <string>

#include "afx/picture.h"

namespace afx::tools {

/// "640x480", each side 1..render::kMaxSide; false: it is not.
bool parse_size(const std::string& text, uint32_t& width, uint32_t& height);
/// "#rrggbb", "#rrggbbaa", "transparent", "white" or "black"; false: none of these.
bool parse_colour(const std::string& text, Rgba8& colour);

}  // namespace afx::tools
