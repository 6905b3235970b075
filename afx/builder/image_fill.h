// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <vector>

#include "afx/picture.h"

namespace afx {

/// Gives the pixels that nothing uses colours that continue their surroundings smoothly, so that a
/// lossy image coder spends nothing on them and no foreign colour bleeds into the object at the
/// borders of its blocks. First two rings of pixels repeat the mean of their used neighbours, then
/// means over ever larger squares fill the rest (push and pull). picture   RGB used      one for
/// each pixel; those stay as they are. All false: the picture becomes mid grey
void fill_unused(Picture& picture, const std::vector<bool>& used);

}  // namespace afx
