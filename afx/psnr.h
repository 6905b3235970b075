// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cmath>
#include <limits>

namespace afx {

/// Peak signal to noise ratio in dB: 10 log10(peak_squared / mean_squared); infinite without noise.
/// peak_squared   by default that of samples of 8 bits
inline double psnr_of(double mean_squared, double peak_squared = 255.0 * 255.0) {
  return mean_squared > 0 ? 10 * std::log10(peak_squared / mean_squared)
                          : std::numeric_limits<double>::infinity();
}

}  // namespace afx
