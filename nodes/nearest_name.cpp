// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The distance is the restricted one of Damerau and Levenshtein.
#include "nodes/nearest_name.h"

#include <algorithm>
#include <vector>

namespace afx::nodes {

namespace {

constexpr size_t kMaxOffers = 4096;
constexpr size_t kLongestName =
    100;  // beyond, nobody misspells a known name; and the cost is quadratic

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

}  // namespace

size_t edit_distance(std::string_view a, std::string_view b) {
  const size_t width = b.size() + 1;
  std::vector<size_t> before(width), last(width), now(width);
  for (size_t j = 0; j < width; ++j) last[j] = j;
  for (size_t i = 1; i <= a.size(); ++i) {
    now[0] = i;
    for (size_t j = 1; j < width; ++j) {
      const size_t replace = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      now[j] = std::min({replace, last[j] + 1, now[j - 1] + 1});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) now[j] = std::min(now[j], before[j - 2] + 1);
    }
    before.swap(last);
    last.swap(now);
  }
  return last[b.size()];
}

void NearestName::offer(std::string_view name) {
  if (++offers_ > kMaxOffers) return;
  if (wanted_.size() > kLongestName || name.size() > kLongestName) return;
  const size_t longer = std::max(wanted_.size(), name.size());
  const size_t shorter = std::min(wanted_.size(), name.size());
  if (longer - shorter > longer / 3 + 1) return;
  std::string a(wanted_), b(name);
  std::transform(a.begin(), a.end(), a.begin(), lower);
  std::transform(b.begin(), b.end(), b.begin(), lower);
  const size_t distance = edit_distance(a, b);
  const size_t allowed = longer < 3 ? 0 : longer / 3;
  if (distance > allowed || distance > best_distance_) return;
  if (distance == best_distance_ && best_ <= name) return;
  best_distance_ = distance;
  best_ = std::string(name);
}

std::string NearestName::hint() const {
  return best_.empty() ? std::string() : " (did you mean '" + best_ + "'?)";
}

}  // namespace afx::nodes
