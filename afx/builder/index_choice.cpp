// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/index_choice.h"

#include <algorithm>
#include <utility>

namespace afx {
namespace {

using Costs = std::vector<double>;

size_t best_of(const Costs& costs) {
  return static_cast<size_t>(std::min_element(costs.begin(), costs.end()) - costs.begin());
}

// The nodes that hold the voxel at hand, one at each level: what has been gathered of each.
class Gatherer {
 public:
  Gatherer(unsigned levels, unsigned images, double price)
      : open_(levels, Node{Costs(images), 0}), decisions_(levels), price_(price) {}

  // A voxel; from level `first` on its nodes are others than those of the voxel before.
  void add(const Costs& costs, size_t first) {
    close_below(first);
    if (open_.empty()) return;
    add_to(open_.back(), costs, costs[best_of(costs)] + price_);
  }

  // For each level from the root down, the image that each of its nodes is given to as a whole, or
  // 0.
  std::vector<std::vector<uint8_t>> finish() {
    close_below(0);
    return std::move(decisions_);
  }

 private:
  struct Node {
    Costs costs;       // the sum of what lies below for each image
    double least = 0;  // that its subtree can cost
  };

  static void add_to(Node& parent, const Costs& costs, double least) {
    for (size_t k = 0; k < costs.size(); ++k) parent.costs[k] += costs[k];
    parent.least += least;
  }

  // Ends the nodes of level `level` and deeper.
  void close_below(size_t level) {
    if (!any_) {
      any_ = true;
      return;
    }
    for (size_t n = open_.size(); n-- > level;) {
      Node& node = open_[n];
      const size_t best = best_of(node.costs);
      const bool whole = node.costs[best] <= node.least;
      decisions_[n].push_back(whole ? static_cast<uint8_t>(best + 1) : uint8_t{0});
      const double least = (whole ? node.costs[best] : node.least) + price_;
      if (n > 0) add_to(open_[n - 1], node.costs, least);
      std::fill(node.costs.begin(), node.costs.end(), 0.0);
      node.least = 0;
    }
  }

  std::vector<Node> open_;  // [n] at level n
  std::vector<std::vector<uint8_t>> decisions_;
  double price_;
  bool any_ = false;  // voxel before
};

// The first level at which two voxels lie in different nodes.
size_t first_difference(uint64_t a, uint64_t b, unsigned levels) {
  size_t level = levels;
  while (level > 0 && a != b) {
    a >>= 3;
    b >>= 3;
    --level;
  }
  return level + 1;
}

// What the nodes of a level inherit from the level above: the number of children is not stored, so
// the parents' codes are walked along.
std::vector<uint8_t> inherit(std::span<const uint64_t> codes, unsigned shift,
                             std::span<const uint8_t> above) {
  std::vector<uint8_t> result;
  size_t parent = 0;
  for (size_t i = 0; i < codes.size(); ++i) {
    const uint64_t code = codes[i] >> shift;
    if (i > 0 && codes[i - 1] >> shift == code) continue;
    if (i > 0 && codes[i - 1] >> (shift + 3) != code >> 3) ++parent;
    result.push_back(above[parent]);
  }
  return result;
}

}  // namespace

std::vector<uint8_t> choose_index(std::span<const uint64_t> codes, unsigned levels, unsigned images,
                                  const ChoiceCosts& cost, double price) {
  if (codes.empty()) return {};
  Costs costs(images);
  Gatherer gatherer(levels, images, price);
  for (size_t i = 0; i < codes.size(); ++i) {
    cost(i, costs);
    gatherer.add(costs, i == 0 ? 0 : first_difference(codes[i - 1], codes[i], levels));
  }
  std::vector<std::vector<uint8_t>> decisions = gatherer.finish();
  std::vector<uint8_t> given{0};  // by level, from the root: each node's image, 0 = to its children
  for (unsigned level = 0; level < levels; ++level) {
    std::vector<uint8_t>& own = decisions[level];
    for (size_t i = 0; i < own.size(); ++i)
      if (given[i] != 0) own[i] = given[i];
    given = inherit(codes, 3 * (levels - 1 - level), own);
    own = {};
  }
  for (size_t i = 0; i < given.size(); ++i) {
    if (given[i] != 0) continue;
    cost(i, costs);
    given[i] = static_cast<uint8_t>(best_of(costs) + 1);
  }
  return given;
}

}  // namespace afx
