// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/mp4_source.h"

#include <algorithm>

namespace afx::bifs {

Mp4Source mp4_source(std::span<const uint8_t> bytes) {
  Mp4Source source;
  source.size = bytes.size();
  source.read = [bytes](uint64_t offset, std::span<uint8_t> out) -> Status {
    std::copy_n(bytes.begin() + static_cast<ptrdiff_t>(offset), out.size(), out.begin());
    return {};
  };
  source.view = [bytes](uint64_t offset, uint64_t count) { return bytes.subspan(offset, count); };
  return source;
}

}  // namespace afx::bifs
