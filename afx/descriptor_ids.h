// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <set>

#include "nodes/scene.h"

namespace afx {

/// The IDs of object descriptors that a scene speaks of: in its nodes, and in its PROTOs.
std::set<uint16_t> used_descriptors(const nodes::Scene& scene);

/// Gives numbers from 1 on that are not used, the smallest first.
class FreeIds {
 public:
  explicit FreeIds(std::set<uint16_t> used = {}) : used_(std::move(used)) {}

  uint16_t next() {
    while (used_.count(next_) != 0) ++next_;
    return next_++;
  }
  /// How many of 1..last are not used; those that next() gave are not counted as used.
  [[nodiscard]] size_t free_up_to(uint16_t last) const {
    const auto taken = std::distance(used_.upper_bound(0), used_.upper_bound(last));
    return last - static_cast<size_t>(taken);
  }

 private:
  std::set<uint16_t> used_;
  uint16_t next_ = 1;
};

}  // namespace afx
