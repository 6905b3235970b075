// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/point_grid.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "afx/builder/grid.h"
#include "codec/octree_voxels.h"
#include "codec/parallel.h"

namespace afx {
namespace {

constexpr unsigned kLevels = codec::kMortonLevels;
constexpr size_t kAsked = 1000;     // points whose nearest is looked for
constexpr size_t kMostInCell = 64;  // points of a cell that are looked at
constexpr size_t kCellsInTask = 256;

glm::dmat3 adjugate(const glm::dmat3& m) {  // of a symmetric matrix
  return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

/// The direction of the least spread: the adjugate has the same axes, with the least the greatest,
/// so multiplying by it turns any vector there.
glm::dvec3 least_axis(const glm::dmat3& spread) {
  const glm::dmat3 inverse = adjugate(spread);
  const double size = spread[0][0] + spread[1][1] + spread[2][2];
  glm::dvec3 axis(0);
  for (int k = 0; k < 3; ++k)
    if (glm::length(inverse[k]) > glm::length(axis)) axis = inverse[k];
  if (!(glm::length(axis) > 1e-9 * size * size)) return glm::dvec3(0);  // in a line
  axis = glm::normalize(axis);
  for (int round = 0; round < 8; ++round) axis = glm::normalize(inverse * axis);
  return axis;
}

}  // namespace

PointGrid::PointGrid(std::span<const glm::vec3> points) : points_(points) {
  const Bounds bounds = bounds_of(points);
  const glm::dvec3 extent = bounds.high - bounds.low;
  low_ = bounds.low;
  middle_ = bounds.low + 0.5 * extent;
  side_ = std::max({extent.x, extent.y, extent.z});
  constexpr double kCells = 1U << kLevels;
  const double scale = side_ > 0 ? kCells / side_ : 0;
  entries_.resize(points.size());
  for (size_t n = 0; n < points.size(); ++n) {
    const glm::dvec3 place = (glm::dvec3(points[n]) - low_) * scale;
    const auto whole = [](double v) { return static_cast<uint32_t>(std::min(v, kCells - 1)); };
    entries_[n] = {codec::morton_code({whole(place.x), whole(place.y), whole(place.z)}),
                   static_cast<uint32_t>(n)};
  }
  std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
    return a.code != b.code ? a.code < b.code : a.point < b.point;
  });
}

double PointGrid::side_of(unsigned level) const {
  return std::ldexp(side_, -static_cast<int>(level));
}

std::span<const PointGrid::Entry> PointGrid::cell(const Voxel& at, unsigned level) const {
  const unsigned shift = 3 * (kLevels - level);
  const uint64_t first = codec::morton_code(at) << shift;
  const uint64_t end = first + (uint64_t{1} << shift);
  const auto from = std::partition_point(entries_.begin(), entries_.end(),
                                         [&](const Entry& e) { return e.code < first; });
  const auto to =
      std::partition_point(from, entries_.end(), [&](const Entry& e) { return e.code < end; });
  return {from, to};
}

// Visits the points of a cell and of those around it.
template <class Visit>
void PointGrid::for_each_around(uint64_t cell_code, unsigned level, Visit&& visit) const {
  const Voxel at = codec::morton_decode(cell_code);
  const uint32_t cells = 1U << level;
  for (uint32_t k = 0; k < 27; ++k) {
    // Below zero wraps around and is out of range as well.
    const Voxel there{at.x + k % 3 - 1, at.y + k / 3 % 3 - 1, at.z + k / 9 - 1};
    if (std::max({there.x, there.y, there.z}) >= cells) continue;
    const std::span<const Entry> entries = cell(there, level);
    const size_t step = entries.size() / kMostInCell + 1;
    for (size_t n = 0; n < entries.size(); n += step) visit(entries[n]);
  }
}

double PointGrid::nearest(const Entry& entry) const {
  double best = 0;
  for (unsigned level = kLevels + 1; level-- > 0;) {
    for_each_around(entry.code >> (3 * (kLevels - level)), level, [&](const Entry& other) {
      if (other.code == entry.code) return;
      const double far =
          glm::distance(glm::dvec3(points_[entry.point]), glm::dvec3(points_[other.point]));
      if (best == 0 || far < best) best = far;
    });
    if (best > 0 && best <= side_of(level)) break;  // nothing outside of these cells is nearer
  }
  return best;
}

double PointGrid::spacing() const {
  std::vector<double> distances;
  const size_t asked = std::min(kAsked, entries_.size());
  for (size_t n = 0; n < asked; ++n)
    distances.push_back(nearest(entries_[n * entries_.size() / asked]));
  if (distances.empty()) return 0;
  const auto median = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), median, distances.end());
  return *median;
}

glm::vec3 PointGrid::normal_at(const glm::dvec3& point, std::span<const glm::dvec3> around,
                               double radius) const {
  glm::dvec3 sum(0);
  glm::dmat3 products(0);
  double count = 0;
  for (const glm::dvec3& other : around) {
    const glm::dvec3 off = (other - point) / radius;
    if (glm::dot(off, off) > 1) continue;
    sum += off;
    products += glm::outerProduct(off, off);
    ++count;
  }
  if (count < 3) return glm::vec3(0);
  const glm::dvec3 axis =
      least_axis(products / count - glm::outerProduct(sum, sum) / (count * count));
  return glm::vec3(glm::dot(axis, point - middle_) < 0 ? -axis : axis);
}

std::vector<glm::vec3> PointGrid::normals(double radius, unsigned threads) const {
  std::vector<glm::vec3> normals(points_.size());
  if (!(radius > 0)) return normals;
  unsigned level = 0;
  while (level < kLevels && side_of(level + 1) >= radius) ++level;
  const unsigned shift = 3 * (kLevels - level);
  std::vector<size_t> starts;  // of each cell that has points
  for (size_t n = 0; n < entries_.size(); ++n)
    if (n == 0 || entries_[n].code >> shift != entries_[n - 1].code >> shift) starts.push_back(n);
  starts.push_back(entries_.size());
  const size_t cells = starts.size() - 1;
  parallel_for((cells + kCellsInTask - 1) / kCellsInTask, threads, [&](size_t task) {
    std::vector<glm::dvec3> around;
    for (size_t c = task * kCellsInTask; c < std::min(cells, (task + 1) * kCellsInTask); ++c) {
      around.clear();
      for_each_around(entries_[starts[c]].code >> shift, level,
                      [&](const Entry& e) { around.emplace_back(points_[e.point]); });
      for (size_t n = starts[c]; n < starts[c + 1]; ++n) {
        const uint32_t point = entries_[n].point;
        normals[point] = normal_at(glm::dvec3(points_[point]), around, radius);
      }
    }
  });
  return normals;
}

}  // namespace afx
