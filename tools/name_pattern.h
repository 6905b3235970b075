// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <string>

namespace afx::tools {

/// An output name with a place for a number: the first %d, %4d or %04d in it (zeros fill up to the
/// width either way). Any other '%' is an ordinary character.
struct NamePattern {
  std::string before, after;
  size_t digits = 0;
  bool has_number = false;

  explicit NamePattern(const std::string& name) : before(name) {
    for (size_t at = name.find('%'); at != std::string::npos; at = name.find('%', at + 1)) {
      const size_t end = name.find_first_not_of("0123456789", at + 1);
      if (end == std::string::npos || name[end] != 'd' || end - at > 3) continue;
      has_number = true;
      before = name.substr(0, at);
      after = name.substr(end + 1);
      if (end > at + 1) digits = std::stoul(name.substr(at + 1, end - at - 1));
      return;
    }
  }
  /// The name for a number; without a place for it, the name itself.
  [[nodiscard]] std::string name(uint32_t number) const {
    if (!has_number) return before;
    std::string text = std::to_string(number);
    if (text.size() < digits) text.insert(0, digits - text.size(), '0');
    return before + text + after;
  }
};

}  // namespace afx::tools
