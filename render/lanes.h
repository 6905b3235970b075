// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Eight samples at once, by the vectors of g++ and clang: one register with AVX, two with SSE or
// NEON. Each lane is reckoned as a float by itself, so the results are the same everywhere.
#pragma once

#include <cstdint>
#include <cstring>

/// For what is compiled once for each kind of processor: it must become part of its caller.
#define AFX_PART_OF_CALLER __attribute__((always_inline)) inline

namespace afx::render {

/// Whether this processor has AVX2.
inline bool has_avx2() {
#if defined(__x86_64__)
  static const bool has = __builtin_cpu_supports("avx2") != 0;
  return has;
#else
  return false;
#endif
}

using Lanes = float __attribute__((vector_size(32)));
using LaneMask = int32_t __attribute__((vector_size(32)));  // -1 or 0
inline constexpr int kLanes = 8;

AFX_PART_OF_CALLER Lanes all(float value) { return Lanes{} + value; }
AFX_PART_OF_CALLER LaneMask all_lanes() { return LaneMask{} == LaneMask{}; }
AFX_PART_OF_CALLER Lanes load(const float* from) {
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}
AFX_PART_OF_CALLER void store(float* to, Lanes lanes) { std::memcpy(to, &lanes, sizeof lanes); }
AFX_PART_OF_CALLER Lanes least(Lanes a, Lanes b) { return b < a ? b : a; }
AFX_PART_OF_CALLER Lanes most(Lanes a, Lanes b) { return a < b ? b : a; }
AFX_PART_OF_CALLER bool any(LaneMask mask) {
  using Words = int64_t __attribute__((vector_size(32)));
  Words words;
  std::memcpy(&words, &mask, sizeof words);
  return (words[0] | words[1] | words[2] | words[3]) != 0;
}

/// Four and four, from two places: of the upper row and of the lower one.
using HalfLanes = float __attribute__((vector_size(16)));
AFX_PART_OF_CALLER Lanes load(const float* upper, const float* lower) {
  HalfLanes low, high;
  std::memcpy(&low, upper, sizeof low);
  std::memcpy(&high, lower, sizeof high);
  return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}
AFX_PART_OF_CALLER void store(float* upper, float* lower, Lanes lanes) {
  const HalfLanes low = __builtin_shufflevector(lanes, lanes, 0, 1, 2, 3);
  const HalfLanes high = __builtin_shufflevector(lanes, lanes, 4, 5, 6, 7);
  std::memcpy(upper, &low, sizeof low);
  std::memcpy(lower, &high, sizeof high);
}

AFX_PART_OF_CALLER Lanes lane_numbers() { return Lanes{0, 1, 2, 3, 4, 5, 6, 7}; }
AFX_PART_OF_CALLER LaneMask first_lanes(int count) {
  return LaneMask{0, 1, 2, 3, 4, 5, 6, 7} < count;
}

}  // namespace afx::render
