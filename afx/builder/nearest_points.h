// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

namespace afx {

/// Points arranged in a k-d tree to find the nearest ones. Searching changes nothing: for use by
/// several threads at once. Memory: about 48 bytes a point.
class NearestPoints {
 public:
  /// So many points equally near are told; of more in one place, those with the lowest numbers.
  static constexpr size_t kMostEqual = 32;

  /// The points at the smallest distance, most often one.
  struct Nearest {
    double squared = 0;  ///< the square of their distance
    std::array<uint32_t, kMostEqual> numbers;
    size_t count = 0;
    [[nodiscard]] std::span<const uint32_t> points() const { return {numbers.data(), count}; }
  };

  /// points   finite, at most 2^32 - 1; any number of them may lie in one place
  explicit NearestPoints(std::span<const glm::vec3> points);
  ~NearestPoints();
  NearestPoints(const NearestPoints&) = delete;
  NearestPoints& operator=(const NearestPoints&) = delete;

  /// The nearest to a place; none where there are no points.
  [[nodiscard]] Nearest nearest(const glm::dvec3& place) const;

  /// The `count` nearest, or all if there are fewer, from near to far.
  [[nodiscard]] std::vector<uint32_t> nearest(const glm::dvec3& place, size_t count) const;

  /// How far apart the points are: the median distance from a place where one is to the nearest
  /// other one, of about 1000 places taken evenly. 0: all are in one place, or there are none.
  [[nodiscard]] double spacing() const;

 private:
  class Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace afx
