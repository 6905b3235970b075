// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <span>

#include "conformance/judge.h"

namespace afx::conformance {

/// Whether a picture file is near enough to the one that is expected; if not, both and their
/// difference are in the outcome.
Outcome judge_picture(const RenderCheck& check, std::span<const uint8_t> expected,
                      std::span<const uint8_t> found);

}  // namespace afx::conformance
