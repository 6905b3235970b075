// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/index_choice.h"

#include <algorithm>

namespace afx {
namespace {

// A node: the sum of what lies below for each image, and the least that its subtree can cost.
struct Node {
  uint64_t code = 0;
  ChoiceCosts costs;
  double least = 0;
};

unsigned best_of(const ChoiceCosts& costs, unsigned images) {
  return static_cast<unsigned>(std::min_element(costs.of, costs.of + images) - costs.of);
}

// Gathers nodes into their parents.
class ParentBuilder {
 public:
  explicit ParentBuilder(unsigned images) : images_(images) {}

  void add(const Node& child) {
    if (parents_.empty() || parents_.back().code != child.code >> 3) {
      close();
      parents_.push_back({child.code >> 3, {}, 0});
    }
    Node& parent = parents_.back();
    for (unsigned k = 0; k < images_; ++k) parent.costs.of[k] += child.costs.of[k];
    parent.least += child.least;
  }

  // The parents, and for each the image that it is given to as a whole, or 0.
  std::pair<std::vector<Node>, std::vector<uint8_t>> finish() {
    close();
    return {std::move(parents_), std::move(decisions_)};
  }

 private:
  void close() {
    if (parents_.empty()) return;
    Node& parent = parents_.back();
    const unsigned best = best_of(parent.costs, images_);
    const bool whole = parent.costs.of[best] <= parent.least;
    decisions_.push_back(whole ? static_cast<uint8_t>(best + 1) : uint8_t{0});
    parent.least = (whole ? parent.costs.of[best] : parent.least) + kSymbolPrice;
  }

  unsigned images_;
  std::vector<Node> parents_;
  std::vector<uint8_t> decisions_;
};

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
                                  const std::function<ChoiceCosts(size_t)>& cost) {
  if (codes.empty()) return {};
  const auto leaf = [&](size_t i) {
    Node node{codes[i], cost(i), 0};
    node.least = node.costs.of[best_of(node.costs, images)] + kSymbolPrice;
    return node;
  };
  // decisions[n]: of the nodes at level levels - 1 - n.
  std::vector<std::vector<uint8_t>> decisions;
  std::vector<Node> nodes;
  for (unsigned level = 0; level < levels; ++level) {
    ParentBuilder parents(images);
    if (level == 0)
      for (size_t i = 0; i < codes.size(); ++i) parents.add(leaf(i));
    for (const Node& node : nodes) parents.add(node);
    auto [built, decided] = parents.finish();
    nodes = std::move(built);
    decisions.push_back(std::move(decided));
  }
  std::vector<uint8_t> given{
      0};  // by level, from the root: the image of each node, 0 = left to its children
  for (unsigned level = 0; level < levels; ++level) {
    std::vector<uint8_t>& own = decisions[levels - 1 - level];
    for (size_t i = 0; i < own.size(); ++i)
      if (given[i] != 0) own[i] = given[i];
    given = inherit(codes, 3 * (levels - 1 - level), own);
    own = {};
  }
  for (size_t i = 0; i < given.size(); ++i)
    if (given[i] == 0) given[i] = static_cast<uint8_t>(best_of(cost(i), images) + 1);
  return given;
}

}  // namespace afx
