// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "conformance/generator/choices.h"

namespace afx::conformance {

/// Whether the case that these choices make fails.
using Fails = std::function<bool(Choices& choices)>;

/// Makes the draws of a failing case fewer and smaller as long as it still fails: leaves pieces
/// out, sets pieces to 0, lowers single draws. Of two rows of draws the shorter is the smaller,
/// then the one that is so at the first difference. It ends when nothing gets smaller, or after
/// that many tries.
std::vector<uint32_t> shrink(std::vector<uint32_t> draws, const Fails& fails,
                             unsigned most_tries = 20000);

}  // namespace afx::conformance
