// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include "afx/picture.h"

namespace afx {

/// Each pixel becomes the mean of itself and its up to eight neighbours, sample by sample, rounded
/// down.
Picture local_mean(const Picture& picture);

}  // namespace afx
