// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/nearest_points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nanoflann.hpp>
#include <numeric>
#include <tuple>

namespace afx {
namespace {

// Where points lie, one or several.
struct Place {
  glm::vec3 position;
  uint32_t first, count;  // of its points, in the list of numbers
};

// The places as the tree wants to see them. No two are the same: a search would visit all points of
// a place.
struct Places {
  std::vector<Place> list;
  [[nodiscard]] size_t kdtree_get_point_count() const { return list.size(); }
  [[nodiscard]] double kdtree_get_pt(size_t place, size_t axis) const {
    return list[place].position[static_cast<int>(axis)];
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

// The numbers of points, those in one place next to each other and ascending.
std::vector<uint32_t> by_place(std::span<const glm::vec3> points) {
  std::vector<uint32_t> numbers(points.size());
  std::iota(numbers.begin(), numbers.end(), 0U);
  std::sort(numbers.begin(), numbers.end(), [&](uint32_t a, uint32_t b) {
    const glm::vec3 &p = points[a], &q = points[b];
    return std::tie(p.x, p.y, p.z, a) < std::tie(q.x, q.y, q.z, b);
  });
  return numbers;
}

// In the order of their first points: where no place has two, places have their points' numbers.
std::vector<Place> places_of(std::span<const glm::vec3> points, std::span<const uint32_t> numbers) {
  std::vector<Place> places;
  for (uint32_t n = 0; n < numbers.size(); ++n) {
    const glm::vec3& at = points[numbers[n]];
    if (!places.empty() && places.back().position == at)
      ++places.back().count;
    else
      places.push_back({at, n, 1});
  }
  std::sort(places.begin(), places.end(),
            [&](const Place& a, const Place& b) { return numbers[a.first] < numbers[b.first]; });
  return places;
}

// Collects all places that are equally near. The tree looks for points nearer than worstDist(), so
// that is just beyond the distance of those found.
class EquallyNear {
 public:
  explicit EquallyNear(NearestPoints::Nearest& found) : found_(found) {
    found_.squared = std::numeric_limits<double>::infinity();
  }
  bool addPoint(double squared, uint32_t place) {
    if (squared > found_.squared) return true;  // the tree had asked before a nearer one was found
    if (squared < found_.squared) {
      found_.squared = squared;
      found_.count = 0;
    }
    if (found_.count < found_.numbers.size()) found_.numbers[found_.count++] = place;
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
  explicit Tree(std::span<const glm::vec3> points)
      : numbers_(by_place(points)), places_{places_of(points, numbers_)}, index_(3, places_) {}

  template <class Found>
  void search(const glm::dvec3& place, Found& found) const {
    // The tree's bounds of distances are sums of rounded terms: a little less than they say is
    // safe.
    const nanoflann::SearchParams exact(0, -1e-6F, true);
    const double at[3] = {place.x, place.y, place.z};
    if (!places_.list.empty()) index_.findNeighbors(found, at, exact);
  }
  [[nodiscard]] size_t places() const { return places_.list.size(); }

  /// From a place to the nearest other one; there are two at least.
  [[nodiscard]] double to_next(size_t place) const {
    nanoflann::KNNResultSet<double, uint32_t> found(2);
    std::array<uint32_t, 2> numbers{};
    std::array<double, 2> squared{};
    found.init(numbers.data(), squared.data());
    search(glm::dvec3(places_.list[place].position), found);
    return std::sqrt(squared[1]);
  }

  [[nodiscard]] bool has_one_point_a_place() const { return places() == numbers_.size(); }
  [[nodiscard]] std::span<const uint32_t> points_at(uint32_t place) const {
    const Place& at = places_.list[place];
    return std::span(numbers_).subspan(at.first, at.count);
  }

 private:
  using Distance = nanoflann::L2_Simple_Adaptor<double, Places, double, uint32_t>;
  std::vector<uint32_t> numbers_;
  Places places_;
  nanoflann::KDTreeSingleIndexAdaptor<Distance, Places, 3, uint32_t> index_;
};

NearestPoints::NearestPoints(std::span<const glm::vec3> points)
    : tree_(std::make_unique<Tree>(points)) {}

NearestPoints::~NearestPoints() = default;

NearestPoints::Nearest NearestPoints::nearest(const glm::dvec3& place) const {
  Nearest nearest;
  EquallyNear found(nearest);
  tree_->search(place, found);
  if (tree_->has_one_point_a_place()) {
    std::sort(nearest.numbers.begin(),
              nearest.numbers.begin() + static_cast<std::ptrdiff_t>(nearest.count));
    return nearest;
  }
  std::array<uint32_t, kMostEqual * kMostEqual> numbers;
  auto end = numbers.begin();
  for (const uint32_t at : nearest.points()) {
    const auto points = tree_->points_at(at);
    end = std::copy_n(points.begin(), std::min(points.size(), kMostEqual), end);
  }
  std::sort(numbers.begin(), end);
  nearest.count = std::min(static_cast<size_t>(end - numbers.begin()), kMostEqual);
  std::copy_n(numbers.begin(), nearest.count, nearest.numbers.begin());
  return nearest;
}

std::vector<uint32_t> NearestPoints::nearest(const glm::dvec3& place, size_t count) const {
  const size_t most = std::min(count, tree_->places());
  std::vector<uint32_t> places(most), numbers;
  std::vector<double> squared(most);
  if (most == 0) return numbers;
  nanoflann::KNNResultSet<double, uint32_t> found(most);
  found.init(places.data(), squared.data());
  tree_->search(place, found);
  if (tree_->has_one_point_a_place()) return places;
  numbers.reserve(most);
  for (const uint32_t at : places) {
    const auto points = tree_->points_at(at);
    const auto some = points.first(std::min(points.size(), count - numbers.size()));
    numbers.insert(numbers.end(), some.begin(), some.end());
  }
  return numbers;
}

double NearestPoints::spacing() const {
  constexpr size_t kAsked = 1000;
  const size_t places = tree_->places();
  if (places < 2) return 0;
  const size_t asked = std::min(kAsked, places);
  std::vector<double> distances;
  for (size_t n = 0; n < asked; ++n) distances.push_back(tree_->to_next(n * places / asked));
  const auto median = distances.begin() + static_cast<std::ptrdiff_t>(asked / 2);
  std::nth_element(distances.begin(), median, distances.end());
  return *median;
}

}  // namespace afx
