// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/nearest_points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nanoflann.hpp>

namespace afx {
namespace {

// The points as the tree wants to see them.
struct Points {
  std::span<const glm::vec3> points;
  [[nodiscard]] size_t kdtree_get_point_count() const { return points.size(); }
  [[nodiscard]] double kdtree_get_pt(size_t point, size_t axis) const {
    return points[point][static_cast<int>(axis)];
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

// Collects all that are equally near. The tree looks for points nearer than worstDist(), so that is
// just beyond the distance of those found.
class EquallyNear {
 public:
  explicit EquallyNear(NearestPoints::Nearest& found) : found_(found) {
    found_.squared = std::numeric_limits<double>::infinity();
  }
  bool addPoint(double squared, uint32_t point) {
    if (squared > found_.squared) return true;  // the tree had asked before a nearer one was found
    if (squared < found_.squared) {
      found_.squared = squared;
      found_.count = 0;
    }
    if (found_.count < found_.numbers.size()) found_.numbers[found_.count++] = point;
    return true;
  }
  [[nodiscard]] double worstDist() const {
    if (found_.count == found_.numbers.size()) return found_.squared;
    return std::nextafter(found_.squared, std::numeric_limits<double>::infinity());
  }
  [[nodiscard]] bool full() const { return found_.count > 0; }
  [[nodiscard]] size_t size() const { return found_.count; }

 private:
  NearestPoints::Nearest& found_;
};

}  // namespace

class NearestPoints::Tree {
 public:
  explicit Tree(std::span<const glm::vec3> points) : points_{points}, index_(3, points_) {}

  template <class Found>
  void search(const glm::dvec3& place, Found& found) const {
    // The tree's bounds of distances are sums of rounded terms: a little less than they say is
    // safe.
    const nanoflann::SearchParams exact(0, -1e-6F, true);
    const double at[3] = {place.x, place.y, place.z};
    if (!points_.points.empty()) index_.findNeighbors(found, at, exact);
  }
  [[nodiscard]] size_t size() const { return points_.points.size(); }

 private:
  using Distance = nanoflann::L2_Simple_Adaptor<double, Points, double, uint32_t>;
  Points points_;
  nanoflann::KDTreeSingleIndexAdaptor<Distance, Points, 3, uint32_t> index_;
};

NearestPoints::NearestPoints(std::span<const glm::vec3> points)
    : tree_(std::make_unique<Tree>(points)) {}

NearestPoints::~NearestPoints() = default;

NearestPoints::Nearest NearestPoints::nearest(const glm::dvec3& place) const {
  Nearest nearest;
  EquallyNear found(nearest);
  tree_->search(place, found);
  std::sort(nearest.numbers.begin(),
            nearest.numbers.begin() + static_cast<std::ptrdiff_t>(nearest.count));
  return nearest;
}

std::vector<uint32_t> NearestPoints::nearest(const glm::dvec3& place, size_t count) const {
  count = std::min(count, tree_->size());
  std::vector<uint32_t> numbers(count);
  std::vector<double> squared(count);
  if (count == 0) return numbers;
  nanoflann::KNNResultSet<double, uint32_t> found(count);
  found.init(numbers.data(), squared.data());
  tree_->search(place, found);
  return numbers;
}

}  // namespace afx
