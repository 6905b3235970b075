// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "conformance/finding_reader.h"

#include <limits>

namespace afx::conformance {

Finding read_finding(JsonFields& in) {
  Finding finding{in.text("code"), Place::none()};
  constexpr uint64_t kMost = std::numeric_limits<uint32_t>::max();
  if (in.has("bit")) {
    finding.place = Place::at_bit(in.number("bit", std::numeric_limits<int64_t>::max()));
  } else if (in.has("line")) {
    const auto line = static_cast<uint32_t>(in.number("line", kMost));
    finding.place = Place::at_line(line, static_cast<uint32_t>(in.number("column", kMost)));
  }
  return finding;
}

}  // namespace afx::conformance
