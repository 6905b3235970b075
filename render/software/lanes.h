// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Four samples at once. The vectors of g++ and clang: SSE on x86-64, NEON on ARM, plain code
// elsewhere; each lane is reckoned as a float by itself, so the results are the same everywhere.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace afx::render {

using Lanes = float __attribute__((vector_size(16)));
using LaneMask = int32_t __attribute__((vector_size(16)));  // -1 or 0
inline constexpr size_t kLanes = 4;

inline constexpr Lanes kLaneNumbers{0, 1, 2, 3};

inline Lanes all(float value) { return Lanes{value, value, value, value}; }
inline Lanes load(const float* from) {
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}
inline void store(float* to, Lanes lanes) { std::memcpy(to, &lanes, sizeof lanes); }
inline Lanes least(Lanes a, Lanes b) { return b < a ? b : a; }
inline Lanes most(Lanes a, Lanes b) { return a < b ? b : a; }
inline bool any(LaneMask mask) {
  int64_t halves[2];
  std::memcpy(halves, &mask, sizeof halves);
  return (halves[0] | halves[1]) != 0;
}

}  // namespace afx::render
