// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "codec/diagnostics.h"

namespace afx {

void Diagnostics::warn(std::string code, Place place, std::string text) {
  ++count_;
  if (warnings_.size() < kKept) {
    warnings_.push_back({std::move(code), place, std::move(text)});
  }
}

void Diagnostics::append(const Diagnostics& other, const std::string& file) {
  for (const Warning& warning : other.warnings_) {
    if (warnings_.size() == kKept) break;
    warnings_.push_back(warning);
    if (warning.file.empty()) warnings_.back().file = file;
  }
  count_ += other.count_;
}

}  // namespace afx
