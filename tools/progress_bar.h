// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <chrono>
#include <string>

namespace afx::tools {

/// A bar on standard error for work that takes longer than about a second. Calls must not overlap.
class ProgressBar {
 public:
  /// mode  "auto" (only on a terminal), "always" or "never"
  ProgressBar(const std::string& mode, bool quiet);
  ~ProgressBar();  ///< clears the line
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(const char* stage, double done);  ///< done: 0..1 of the whole

 private:
  using Clock = std::chrono::steady_clock;
  bool enabled_;
  bool shown_ = false;
  Clock::time_point next_;
};

}  // namespace afx::tools
