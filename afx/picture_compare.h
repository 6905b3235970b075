// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>

#include "afx/picture.h"
#include "codec/error.h"

namespace afx {

/// How far two pictures of equal size are apart, over all their components alike (alpha too).
struct PictureDifference {
  uint64_t differing_pixels = 0;  ///< pixels with any component that differs
  uint32_t max_abs = 0;           ///< the largest difference of two samples, 0..255
  double mean_abs = 0;            ///< the mean of |a - b| over all samples
  double mean_squared = 0;        ///< the mean of (a - b)^2 over all samples
  double psnr = 0;                ///< 10 log10(255^2 / mean_squared) in dB; infinite when equal
  /// Structural similarity: 1 = equal. The mean over all components and all places of an 11 x 11
  /// Gaussian window (sigma 1.5) that lies wholly inside, with K1 = 0.01, K2 = 0.03, L = 255; a
  /// window is as narrow as the picture where that has fewer than 11 columns or rows.
  /// Source: Wang, Bovik, Sheikh, Simoncelli, IEEE TIP 13(4), 2004.
  double ssim = 1;
};

/// Compares sample by sample; the samples are taken as they are stored (sRGB, not premultiplied).
/// Errors  bad_argument: sizes or numbers of components differ, a picture is empty, or its samples
///         do not fit its size
[[nodiscard]] Result<PictureDifference> compare_pictures(const Picture& a, const Picture& b);

}  // namespace afx
