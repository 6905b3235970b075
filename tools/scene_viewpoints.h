// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "afx/surroundings.h"
#include "codec/error.h"

namespace afx::tools {

/// The place in the list of the one that has that DEF name, else that description, else that number
/// from 1.
/// Errors  bad_argument: there is none; the text lists those there are and offers the nearest
Result<size_t> pick_viewpoint(const std::vector<Viewpoint>& viewpoints, const std::string& name);

}  // namespace afx::tools
