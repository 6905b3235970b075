// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/srgb.h"

#include <cmath>

namespace afx {
namespace {

double decode(double value) {
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

/// Element k: the least linear value that rounds to k or more.
std::array<float, 257> make_thresholds() {
  std::array<float, 257> thresholds{};
  for (int k = 1; k < 256; ++k) {
    thresholds[static_cast<size_t>(k)] = static_cast<float>(decode((k - 0.5) / 255));
  }
  thresholds[256] = 2;
  return thresholds;
}

constexpr size_t kBuckets = 4096;  // fewer than one step of the scale in each, at its steepest

std::array<uint8_t, kBuckets + 1> make_starts(const std::array<float, 257>& thresholds) {
  std::array<uint8_t, kBuckets + 1> starts{};
  size_t k = 0;
  for (size_t bucket = 0; bucket <= kBuckets; ++bucket) {
    const float least = static_cast<float>(bucket) / static_cast<float>(kBuckets);
    while (least >= thresholds[k + 1]) ++k;
    starts[bucket] = static_cast<uint8_t>(k);
  }
  return starts;
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

uint8_t linear_to_srgb(float linear) {
  static const std::array<float, 257> thresholds = make_thresholds();
  static const std::array<uint8_t, kBuckets + 1> starts = make_starts(thresholds);
  if (!(linear > 0)) return 0;
  if (linear >= 1) return 255;
  size_t k = starts[static_cast<size_t>(linear * static_cast<float>(kBuckets))];
  while (linear >= thresholds[k + 1]) ++k;
  return static_cast<uint8_t>(k);
}

}  // namespace afx
