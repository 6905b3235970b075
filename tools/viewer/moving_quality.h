// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <algorithm>
#include <cmath>

namespace afx::tools {

/// How large a picture is drawn while the view moves: as large as the window if that takes no
/// longer than kMost milliseconds, otherwise smaller.
class MovingQuality {
 public:
  static constexpr double kMost = 50;  ///< milliseconds
  static constexpr double kLeastScale = 0.2;

  /// Of width and height, kLeastScale..1.
  [[nodiscard]] double scale() const { return scale_; }

  /// Learns from a picture of that scale that took so long. Time is taken to grow with the pixels.
  void learn(double scale, double milliseconds) {
    const double fitting = scale * std::sqrt(0.8 * kMost / std::max(milliseconds, 1e-3));
    const bool too_slow = milliseconds > kMost;
    const bool far_too_small = fitting > scale_ * 1.15;  // not up and down all the time
    if (too_slow || far_too_small) scale_ = std::clamp(fitting, kLeastScale, 1.0);
    if (scale_ > 0.9) scale_ = 1;  // hardly faster, but no longer sharp
  }

 private:
  double scale_ = 1;
};

}  // namespace afx::tools
