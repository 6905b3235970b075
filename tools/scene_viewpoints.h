// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <string>
#include <vector>

#include "afx/surroundings.h"
#include "codec/error.h"

namespace afx::tools {

/// Picks one by its DEF name, its description or, where it has neither of that, its number from 1.
/// Errors  bad_argument: there is none; the text lists those there are and offers the nearest
Result<Viewpoint> pick_viewpoint(const std::vector<Viewpoint>& viewpoints, const std::string& name);

}  // namespace afx::tools
