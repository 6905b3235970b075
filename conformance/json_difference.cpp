// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "conformance/json_difference.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace afx::conformance {
namespace {

using nlohmann::json;

std::string brief(const json& value) {
  constexpr size_t kLongest = 120;
  if (value.is_structured() && value.size() > 30)
    return (value.is_array() ? "a list of " : "an object of ") + std::to_string(value.size());
  std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
  if (text.size() > kLongest) text = text.substr(0, kLongest) + "...";
  return text;
}

/// The part of a pointer that begins at `at`, behind its slash; moves `at` on.
std::string_view next_part(std::string_view path, size_t& at) {
  const size_t end = std::min(path.find('/', at + 1), path.size());
  const std::string_view part = path.substr(at + 1, end - at - 1);
  at = end;
  return part;
}

/// Whether the path is at or below the pattern.
bool matches(std::string_view path, std::string_view pattern) {
  size_t in_path = 0;
  for (size_t in_pattern = 0; in_pattern < pattern.size();) {
    if (in_path >= path.size()) return false;
    const std::string_view wanted = next_part(pattern, in_pattern);
    const std::string_view part = next_part(path, in_path);
    if (wanted != "*" && wanted != part) return false;
  }
  return true;
}

std::string escaped(const std::string& name) {
  std::string text;
  for (const char c : name) {
    if (c == '~')
      text += "~0";
    else if (c == '/')
      text += "~1";
    else
      text += c;
  }
  return text;
}

/// Walks both documents; one path serves all of the way.
class Comparison {
 public:
  explicit Comparison(std::span<const Tolerance> tolerances) : tolerances_(tolerances) {}

  /// Whether they are the same; otherwise `difference` says where not.
  bool same(const json& a, const json& b) {
    if (a.is_number() && b.is_number())
      return a == b || is_near(a, b) || differ(brief(a), brief(b));
    if (a.type() != b.type()) return differ(brief(a), brief(b));
    if (a.is_array()) return same_lists(a, b);
    if (a.is_object()) return same_objects(a, b);
    return a == b || differ(brief(a), brief(b));
  }

  JsonDifference difference;

 private:
  bool differ(std::string expected, std::string found) {
    difference = {path_, std::move(expected), std::move(found)};
    return false;
  }

  bool is_near(const json& a, const json& b) const {
    return std::any_of(tolerances_.begin(), tolerances_.end(), [&](const Tolerance& tolerance) {
      return std::abs(a.get<double>() - b.get<double>()) <= tolerance.abs &&
             matches(path_, tolerance.path);
    });
  }

  /// Goes on one step below.
  template <class Step>
  bool below(const std::string& part, const Step& step) {
    const size_t size = path_.size();
    path_ += '/';
    path_ += part;
    const bool good = step();
    path_.resize(size);
    return good;
  }

  bool same_lists(const json& a, const json& b) {
    for (size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
      const bool good = below(std::to_string(i), [&] {
        if (i >= b.size()) return differ(brief(a[i]), "nothing");
        return i < a.size() ? same(a[i], b[i]) : differ("nothing", brief(b[i]));
      });
      if (!good) return false;
    }
    return true;
  }

  bool same_objects(const json& a, const json& b) {
    for (const auto& [name, value] : a.items()) {
      const auto found = b.find(name);
      const auto step = [&, &value = value] {
        return found == b.end() ? differ(brief(value), "nothing") : same(value, *found);
      };
      if (!below(escaped(name), step)) return false;
    }
    for (const auto& [name, value] : b.items()) {
      const auto step = [&, &value = value] { return differ("nothing", brief(value)); };
      if (!a.contains(name) && !below(escaped(name), step)) return false;
    }
    return true;
  }

  std::span<const Tolerance> tolerances_;
  std::string path_;
};

}  // namespace

std::optional<JsonDifference> first_difference(const json& expected, const json& found,
                                               std::span<const Tolerance> tolerances) {
  Comparison comparison(tolerances);
  if (comparison.same(expected, found)) return {};
  return std::move(comparison.difference);
}

}  // namespace afx::conformance
