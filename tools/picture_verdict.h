// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include "afx/picture.h"
#include "codec/error.h"
#include "codec/limits.h"
#include "tools/input.h"
#include "tools/verdict.h"

namespace afx::tools {

/// Whether two pictures are the same, and if not, how far apart they are.
/// Errors  those of decode_picture
Result<Verdict> compare_two_pictures(const Input& a, const Input& b, const Limits& limits);
/// The same of pictures at hand. Errors  those of compare_pictures
Result<Verdict> compare_two_pictures(const Picture& a, const Picture& b);

}  // namespace afx::tools
