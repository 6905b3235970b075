// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/thresholds.h"

#include <charconv>
#include <cmath>
#include <optional>

namespace afx::tools {
namespace {

using Json = nlohmann::ordered_json;

/// A measure that can have a threshold.
struct Measure {
  const char* name;
  bool at_most;  ///< else at least
};
constexpr Measure kMeasures[] = {{"d1", true},      {"d2", true},    {"hausdorff", true},
                                 {"colour", false}, {"psnr", false}, {"ssim", false}};

struct Threshold {
  Measure measure{};
  double value = 0;
};

std::optional<Threshold> parse_threshold(const std::string& text) {
  const size_t equals = text.find('=');
  if (equals == std::string::npos) return {};
  Threshold threshold;
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data() + equals + 1, end, threshold.value);
  if (parsed.ec != std::errc() || parsed.ptr != end || !std::isfinite(threshold.value)) return {};
  for (const Measure& measure : kMeasures)
    if (text.compare(0, equals, measure.name) == 0) {
      threshold.measure = measure;
      return threshold;
    }
  return {};
}

}  // namespace

std::string check_thresholds(const std::vector<std::string>& thresholds) {
  for (const std::string& text : thresholds)
    if (!parse_threshold(text))
      return "--max-error is " + text +
             " (expected NAME=NUMBER, NAME one of d1, d2, hausdorff, colour, psnr, ssim)";
  return {};
}

std::vector<std::string> broken_thresholds(const std::vector<std::string>& thresholds,
                                           const Json& measured) {
  std::vector<std::string> broken;
  for (const std::string& text : thresholds) {
    const std::optional<Threshold> threshold = parse_threshold(text);
    if (!threshold) continue;
    const std::string name = threshold->measure.name;
    const auto found = measured.find(name);
    if (found == measured.end()) {
      broken.push_back(name + " was not measured");
      continue;
    }
    if (found->is_null()) continue;  // infinite: nothing differs
    const double value = found->get<double>();
    const bool kept =
        threshold->measure.at_most ? value <= threshold->value : value >= threshold->value;
    if (!kept)
      broken.push_back(name + " is " + found->dump() + " (expected at " +
                       (threshold->measure.at_most ? "most " : "least ") +
                       text.substr(text.find('=') + 1) + ")");
  }
  return broken;
}

}  // namespace afx::tools
