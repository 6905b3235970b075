// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <string>
#include <string_view>

namespace afx::nodes {

/// Number of letters to insert, delete, replace or swap with the next to turn one name into the
/// other.
size_t edit_distance(std::string_view a, std::string_view b);

/// Finds the known name that a misspelt one most likely means.
class NearestName {
 public:
  explicit NearestName(std::string_view wanted) : wanted_(wanted) {}
  /// Offers a known name. Of equally near ones the alphabetically first wins. Only the first few
  /// thousand offers count: a text with a million names is no reason to take minutes for a hint.
  void offer(std::string_view name);
  /// " (did you mean 'X'?)", empty if nothing is near: more than a third of the letters differ.
  [[nodiscard]] std::string hint() const;

 private:
  std::string_view wanted_;
  std::string best_;
  size_t best_distance_ = static_cast<size_t>(-1);
  size_t offers_ = 0;
};

}  // namespace afx::nodes
