// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/srgb.h"

#include <cmath>

namespace afx {
namespace {

double decode(double value) {
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

}  // namespace

const std::array<float, 256>& srgb_to_linear() {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> values{};
    for (size_t k = 0; k < 256; ++k) {
      values[k] = static_cast<float>(decode(static_cast<double>(k) / 255));
    }
    return values;
  }();
  return table;
}

float srgb_to_linear(float srgb) {
  if (!(srgb > 0)) return 0;
  return srgb >= 1 ? 1.0F : static_cast<float>(decode(static_cast<double>(srgb)));
}

SrgbEncoder::SrgbEncoder() {
  for (size_t k = 1; k < 256; ++k)
    thresholds_[k] = static_cast<float>(decode((static_cast<double>(k) - 0.5) / 255));
  thresholds_[256] = 2;
  size_t k = 0;
  for (size_t bucket = 0; bucket <= kBuckets; ++bucket) {
    const float least = static_cast<float>(bucket) / kBuckets;
    while (least >= thresholds_[k + 1]) ++k;
    starts_[bucket] = static_cast<uint8_t>(k);
  }
}

const SrgbEncoder& SrgbEncoder::get() {
  static const SrgbEncoder encoder;
  return encoder;
}

}  // namespace afx
