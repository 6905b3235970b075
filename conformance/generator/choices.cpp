// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "conformance/generator/choices.h"

#include <utility>

namespace afx::conformance {

namespace {

/// SplitMix64 (Steele, Lea, Flood 2014).
uint64_t mixed(uint64_t x) {
  x = (x ^ x >> 30) * 0xBF58476D1CE4E5B9U;
  x = (x ^ x >> 27) * 0x94D049BB133111EBU;
  return x ^ x >> 31;
}
constexpr uint64_t kStep = 0x9E3779B97F4A7C15U;

}  // namespace

Choices::Choices(uint64_t seed, uint64_t number) : state_(mixed(seed + kStep) ^ mixed(number)) {}

Choices::Choices(std::vector<uint32_t> draws) : played_(true), to_play_(std::move(draws)) {}

uint64_t Choices::next() { return mixed(state_ += kStep); }

uint32_t Choices::below(uint32_t n) {
  uint32_t draw = 0;
  if (!played_) {
    draw = static_cast<uint32_t>((next() >> 32) * n >> 32);
  } else if (draws_.size() == to_play_.size()) {
    return 0;
  } else {
    draw = to_play_[draws_.size()] % n;
  }
  draws_.push_back(draw);
  return draw;
}

}  // namespace afx::conformance
