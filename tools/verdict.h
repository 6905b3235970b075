// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>

namespace afx::tools {

/// What there is to say of a comparison. different: the exit code is 4.
struct Verdict {
  bool different = false;
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  std::string text;
};

inline Verdict differ(std::string text,
                      nlohmann::ordered_json json = nlohmann::ordered_json::object()) {
  json["same"] = false;
  json["difference"] = text;
  return {true, std::move(json), std::move(text)};
}

inline Verdict same(std::string text,
                    nlohmann::ordered_json json = nlohmann::ordered_json::object()) {
  json["same"] = true;
  return {false, std::move(json), std::move(text)};
}

}  // namespace afx::tools
