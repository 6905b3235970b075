// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <vector>

namespace afx::conformance {

/// Where everything random of a case comes from: a row of draws, which is recorded and can be
/// played again. Whoever makes something of it takes care that smaller draws make it smaller and
/// simpler (0: stop, the default, nothing), so that a case is made smaller by its draws alone
/// (shrink.h).
class Choices {
 public:
  /// New draws: always the same for a seed and the number of a case.
  Choices(uint64_t seed, uint64_t number);
  /// These draws again; behind their end every draw is 0.
  explicit Choices(std::vector<uint32_t> draws);

  /// A number of 0 .. n - 1; n > 0. Draws that are played are taken modulo n.
  uint32_t below(uint32_t n);
  /// True once in n times; false is the simple case.
  bool one_in(uint32_t n) { return below(n) == n - 1; }
  /// One of a list; its first element is the simplest.
  template <class List>
  const auto& of(const List& list) {
    return list[below(static_cast<uint32_t>(list.size()))];
  }

  /// The draws so far, as they were used; those behind the end of played ones are left out.
  [[nodiscard]] const std::vector<uint32_t>& draws() const { return draws_; }

 private:
  uint64_t next();

  bool played_ = false;
  uint64_t state_ = 0;
  std::vector<uint32_t> to_play_;
  std::vector<uint32_t> draws_;
};

}  // namespace afx::conformance
