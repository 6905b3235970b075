// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "conformance/generator/shrink.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace afx::conformance {

namespace {

using Draws = std::vector<uint32_t>;

/// Pieces of every size up to this are tried, above only halves of halves.
constexpr size_t kSmallPiece = 8;

bool is_smaller(const Draws& a, const Draws& b) {
  return a.size() != b.size() ? a.size() < b.size() : a < b;
}

class Shrinker {
 public:
  Shrinker(Draws draws, const Fails& fails, unsigned most_tries)
      : best_(std::move(draws)), fails_(fails), tries_left_(most_tries) {}

  Draws run() {
    Draws before;
    do {
      before = best_;
      for (const size_t size : piece_sizes()) leave_out(size);
      for (const size_t size : piece_sizes()) set_to_zero(size);
      for (size_t i = 0; i < best_.size(); ++i) lower(i);
      for (size_t i = 0; i + 1 < best_.size(); ++i) lower_and_leave_out(i);
    } while (tries_left_ > 0 && best_ != before);
    return std::move(best_);
  }

 private:
  /// Takes the draws if they are smaller and the case still fails.
  bool take(Draws draws) {
    if (tries_left_ == 0 || !is_smaller(draws, best_)) return false;
    --tries_left_;
    Choices choices(std::move(draws));
    if (!fails_(choices) || !is_smaller(choices.draws(), best_)) return false;
    best_ = choices.draws();
    return true;
  }

  [[nodiscard]] std::vector<size_t> piece_sizes() const {
    std::vector<size_t> sizes;
    for (size_t size = best_.size(); size > kSmallPiece; size /= 2) sizes.push_back(size);
    for (size_t size = kSmallPiece; size > 0; --size) sizes.push_back(size);
    return sizes;
  }

  /// From the end, where the least depends on what is left out.
  void leave_out(size_t size) {
    for (size_t end = best_.size(); end >= size && tries_left_ > 0;) {
      end = std::min(end, best_.size());
      if (end < size) return;
      if (!take(without(best_, end - size, size)))
        end -= end > size ? std::max<size_t>(1, size / 2) : end;
    }
  }

  static Draws without(Draws draws, size_t at, size_t size) {
    const auto begin = draws.begin() + static_cast<ptrdiff_t>(at);
    draws.erase(begin, begin + static_cast<ptrdiff_t>(size));
    return draws;
  }

  void set_to_zero(size_t size) {
    for (size_t at = 0; at + size <= best_.size(); at += size) {
      Draws draws = best_;
      std::fill_n(draws.begin() + static_cast<ptrdiff_t>(at), size, 0U);
      take(std::move(draws));
    }
  }

  void lower(size_t i) {
    uint32_t passes = 0;  // taken as the greatest that is known not to fail, plus 1
    while (i < best_.size() && passes < best_[i] && tries_left_ > 0) {
      Draws draws = best_;
      draws[i] = passes + (best_[i] - passes) / 2;
      const uint32_t tried = draws[i];
      if (!take(std::move(draws))) passes = tried + 1;
    }
  }

  /// A count and the pieces that it counts.
  void lower_and_leave_out(size_t i) {
    for (size_t size = 1; size <= kSmallPiece; ++size) {
      while (i + size < best_.size() && best_[i] > 0) {
        Draws draws = without(best_, i + 1, size);
        --draws[i];
        if (!take(std::move(draws))) break;
      }
    }
  }

  Draws best_;
  const Fails& fails_;
  unsigned tries_left_;
};

}  // namespace

Draws shrink(Draws draws, const Fails& fails, unsigned most_tries) {
  return Shrinker(std::move(draws), fails, most_tries).run();
}

}  // namespace afx::conformance
