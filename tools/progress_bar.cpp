// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/progress_bar.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace afx::tools {

ProgressBar::ProgressBar(const std::string& mode, bool quiet)
    : enabled_(!quiet && (mode == "always" || (mode == "auto" && isatty(STDERR_FILENO) != 0))),
      next_(Clock::now() + std::chrono::milliseconds(mode == "always" ? 0 : 800)) {}

ProgressBar::~ProgressBar() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void ProgressBar::show(const char* stage, double done) {
  if (!enabled_ || Clock::now() < next_) return;
  next_ = Clock::now() + std::chrono::milliseconds(100);
  shown_ = true;
  constexpr int kWidth = 30;
  const int filled = static_cast<int>(std::clamp(done, 0.0, 1.0) * kWidth);
  std::fprintf(stderr, "\r[%-*.*s] %3d %% %s\033[K", kWidth, filled,
               "##############################", static_cast<int>(done * 100), stage);
}

}  // namespace afx::tools
