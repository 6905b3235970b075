// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What the neighbours of points tell of the surface they lie on.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "codec/octree.h"

namespace afx {

/// Points in a grid of 2^21 cells a side around all of them, in the order of Morton codes: the
/// cells of every coarser grid are ranges of it. 16 bytes a point. The points must stay.
class PointGrid {
 public:
  /// points   finite, fewer than 2^32
  explicit PointGrid(std::span<const glm::vec3> points);

  /// The median distance from a point to the nearest other one, of about 1000 points taken evenly;
  /// points at the same place count as one. 0: all are at one place.
  [[nodiscard]] double spacing() const;

  /// The direction in which the points within `radius` of each point spread least, a unit vector,
  /// or zero where they are fewer than three or in a line. Of its two ends the one that points away
  /// from the middle of all points. Cells with many points are taken in part.
  [[nodiscard]] std::vector<glm::vec3> normals(double radius, unsigned threads) const;

 private:
  struct Entry {
    uint64_t code;
    uint32_t point;
  };
  [[nodiscard]] double side_of(unsigned level) const;
  [[nodiscard]] double nearest(const Entry& entry) const;
  [[nodiscard]] std::span<const Entry> cell(const Voxel& at, unsigned level) const;
  template <class Visit>
  void for_each_around(uint64_t cell_code, unsigned level, Visit&& visit) const;
  [[nodiscard]] glm::vec3 normal_at(const glm::dvec3& point, std::span<const glm::dvec3> around,
                                    double radius) const;

  std::span<const glm::vec3> points_;
  glm::dvec3 low_{0}, middle_{0};
  double side_ = 0;  // of the grid
  std::vector<Entry> entries_;
};

}  // namespace afx
