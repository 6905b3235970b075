// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdlib>

namespace afx {

/// What a fuzz target says of every input: where it is not so, the target aborts.
inline void require(bool claim) {
  if (!claim) std::abort();
}

}  // namespace afx
