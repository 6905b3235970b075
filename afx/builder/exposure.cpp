// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/exposure.h"

#include <algorithm>
#include <array>
#include <atomic>

#include "codec/parallel.h"

namespace afx {
namespace {

// The 26 directions without their opposites: each is looked along from both ends.
struct Direction {
  int x, y, z;
};
constexpr std::array<Direction, 13> kDirections{{{1, 0, 0},
                                                 {0, 1, 0},
                                                 {0, 0, 1},
                                                 {1, 1, 0},
                                                 {1, -1, 0},
                                                 {1, 0, 1},
                                                 {1, 0, -1},
                                                 {0, 1, 1},
                                                 {0, 1, -1},
                                                 {1, 1, 1},
                                                 {1, 1, -1},
                                                 {1, -1, 1},
                                                 {1, -1, -1}}};

constexpr unsigned kMostThreads = 4;  // each has a table of its own

struct Ends {
  uint16_t first = 0xFFFF, last = 0;
};

// A line of voxels along a direction: its number in a table of (2 * side)^2, and the place on it.
// The first axis that the direction has counts the places; the two others are sheared until they
// stay the same along the line.
class Lines {
 public:
  Lines(const Direction& d, unsigned levels) : side_(1U << levels) {
    main_ = d.x != 0 ? 0 : (d.y != 0 ? 1 : 2);
    const std::array<int, 3> steps{d.x, d.y, d.z};
    for (size_t k = 0; k < 2; ++k) {
      other_[k] = (main_ + 1 + k) % 3;
      slope_[k] = steps[other_[k]];
    }
  }

  [[nodiscard]] uint16_t place(const Voxel& voxel) const {
    return static_cast<uint16_t>(of(voxel, main_));
  }

  [[nodiscard]] size_t number(const Voxel& voxel) const {
    const uint32_t along = of(voxel, main_);
    size_t result = 0;
    for (size_t k = 0; k < 2; ++k) {
      uint32_t at = of(voxel, other_[k]);
      if (slope_[k] > 0) at = at + side_ - along;
      if (slope_[k] < 0) at = at + along;
      result = result * (2 * size_t{side_}) + at;
    }
    return result;
  }

  [[nodiscard]] size_t count() const { return 4 * size_t{side_} * side_; }

 private:
  static uint32_t of(const Voxel& voxel, size_t axis) {
    return axis == 0 ? voxel.x : (axis == 1 ? voxel.y : voxel.z);
  }

  uint32_t side_;
  size_t main_;
  std::array<size_t, 2> other_{};
  std::array<int, 2> slope_{};
};

std::vector<Ends> ends_of(const Lines& lines, std::span<const Voxel> coordinates) {
  std::vector<Ends> ends(lines.count());
  for (const Voxel& voxel : coordinates) {
    Ends& line = ends[lines.number(voxel)];
    line.first = std::min(line.first, lines.place(voxel));
    line.last = std::max(line.last, lines.place(voxel));
  }
  return ends;
}

// Whether one of the cells at the voxel's sides lies before the first or behind the last voxel on
// its line. Such a cell is empty, and so needs no looking up.
bool is_exposed(const Voxel& voxel, const Lines& lines, std::span<const Ends> ends,
                unsigned levels) {
  const uint32_t last = (1U << levels) - 1;
  const auto is_free = [&](const Voxel& cell) {
    if (cell.x > last || cell.y > last || cell.z > last)
      return true;  // outside the cube; -1 wraps around
    const Ends& line = ends[lines.number(cell)];
    const uint16_t place = lines.place(cell);
    return place < line.first || place > line.last;
  };
  const auto [x, y, z] = voxel;
  return is_free({x - 1, y, z}) || is_free({x + 1, y, z}) || is_free({x, y - 1, z}) ||
         is_free({x, y + 1, z}) || is_free({x, y, z - 1}) || is_free({x, y, z + 1});
}

}  // namespace

std::vector<uint8_t> exposed_voxels(std::span<const Voxel> coordinates, unsigned levels,
                                    unsigned threads) {
  // Threads only ever write 1, so their order does not matter; atomic, for they may write the same
  // voxel.
  std::vector<std::atomic<uint8_t>> exposed(coordinates.size());
  parallel_for(kDirections.size(), std::min(thread_count(threads), kMostThreads), [&](size_t d) {
    const Lines lines(kDirections[d], levels);
    const std::vector<Ends> ends = ends_of(lines, coordinates);
    for (size_t i = 0; i < coordinates.size(); ++i)
      if (exposed[i].load(std::memory_order_relaxed) == 0 &&
          is_exposed(coordinates[i], lines, ends, levels))
        exposed[i].store(1, std::memory_order_relaxed);
  });
  return {exposed.begin(), exposed.end()};
}

}  // namespace afx
