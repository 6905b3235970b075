// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "conformance/generator/quantized_difference.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace afx::conformance {

namespace {

using nlohmann::json;

class Comparison {
 public:
  explicit Comparison(const bifs::QuantizeReport& report) {
    for (const bifs::QuantizedField& field : report.fields) {
      double& bound = bounds_[field.field];
      bound = std::max(bound, field.category == "normal" ? INFINITY : field.bound);
    }
  }

  /// bound  of the numbers below
  std::string compare(const json& a, const json& b, double bound, const std::string& path) const {
    if (a.is_number() && b.is_number() && std::abs(a.get<double>() - b.get<double>()) <= bound)
      return {};
    // Of the quantizer itself what is default is left out.
    if (a.is_object() && b.is_object() && a.value("node", json()) == "QuantizationParameter")
      return {};
    if (a.type() != b.type() || !a.is_structured() || a.size() != b.size())
      return a == b ? std::string() : path + ": " + b.dump() + " (expected " + a.dump() + ")";
    for (const auto& [key, value] : a.items()) {
      const json& other = a.is_array() ? b[std::stoul(key)] : b.value(key, json());
      std::string wrong = compare(value, other, bound_below(a, key, bound), path + "/" + key);
      if (!wrong.empty()) return wrong;
    }
    return {};
  }

 private:
  /// `fields` of a node or command have members of their names; other commands name theirs.
  double bound_below(const json& object, const std::string& key, double bound) const {
    if (!object.is_object()) return bound;
    if (key == "value" || key == "values") {
      for (const char* name : {"childField", "field"})
        if (object.contains(name)) return bound_of(object[name].get<std::string>());
    }
    if (object.contains("cmd") || object.contains("node")) return 0;
    return std::max(bound, bound_of(key));
  }
  double bound_of(const std::string& field) const {
    const auto found = bounds_.find(field);
    return found == bounds_.end() ? 0 : found->second;
  }

  std::map<std::string, double> bounds_;
};

}  // namespace

std::string quantized_difference(const json& expected, const json& found,
                                 const bifs::QuantizeReport& report) {
  return Comparison(report).compare(expected, found, 0, "");
}

}  // namespace afx::conformance
