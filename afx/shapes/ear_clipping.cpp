// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/shapes/ear_clipping.h"

namespace afx {
namespace {

/// Twice the area of a triangle; > 0: counter-clockwise.
double area2(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

class EarClipper {
 public:
  EarClipper(std::span<const glm::dvec2> corners, uint64_t& work) : corners_(corners), work_(work) {
    const auto n = static_cast<uint32_t>(corners.size());
    for (uint32_t i = 0; i < n; ++i) {
      next_.push_back((i + 1) % n);
      previous_.push_back((i + n - 1) % n);
    }
    for (uint32_t i = 0; i < n; ++i)
      if (!is_convex(i)) reflex_.push_back(i);
  }

  std::vector<std::array<uint32_t, 3>> run() {
    std::vector<std::array<uint32_t, 3>> triangles;
    auto left = static_cast<uint32_t>(corners_.size());
    uint32_t at = 0;
    while (left > 3) {
      uint32_t tried = 0;
      while (tried < left && !is_ear(at)) {
        at = next_[at];
        ++tried;
      }
      if (work_ == 0) return {};
      // None is an ear: the polygon crosses itself. Any corner brings the end nearer.
      triangles.push_back({previous_[at], at, next_[at]});
      cut(at);
      at = next_[at];
      --left;
    }
    triangles.push_back({previous_[at], at, next_[at]});
    return triangles;
  }

 private:
  [[nodiscard]] bool is_convex(uint32_t i) const {
    return area2(corners_[previous_[i]], corners_[i], corners_[next_[i]]) > 0;
  }

  /// Only corners that point inwards can lie in an ear.
  bool is_ear(uint32_t i) {
    take_work();
    if (!is_convex(i)) return false;
    const glm::dvec2 a = corners_[previous_[i]], b = corners_[i], c = corners_[next_[i]];
    for (const uint32_t other : reflex_) {
      if (!take_work()) return false;
      const glm::dvec2 p = corners_[other];
      if (p == a || p == b || p == c) continue;
      if (area2(a, b, p) >= 0 && area2(b, c, p) >= 0 && area2(c, a, p) >= 0) return false;
    }
    return true;
  }

  void cut(uint32_t i) {
    next_[previous_[i]] = next_[i];
    previous_[next_[i]] = previous_[i];
    // The neighbours' angles only become smaller: those that point outwards now leave the list.
    std::erase_if(reflex_, [&](uint32_t other) {
      return other == i || ((other == previous_[i] || other == next_[i]) && is_convex(other));
    });
  }

  bool take_work() {
    if (work_ > 0) --work_;
    return work_ > 0;
  }

  std::span<const glm::dvec2> corners_;
  uint64_t& work_;
  std::vector<uint32_t> next_, previous_;  // of each corner, among those that are left
  std::vector<uint32_t> reflex_;           // corners left that do not point outwards
};

}  // namespace

std::vector<std::array<uint32_t, 3>> clip_ears(std::span<const glm::dvec2> corners,
                                               uint64_t& work) {
  return EarClipper(corners, work).run();
}

}  // namespace afx
