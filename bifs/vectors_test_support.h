// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The project's BIFS vectors (conformance/suites/bifs-gpac/README.md) for tests.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bifs/config.h"

namespace afx::bifs {

using Bytes = std::vector<uint8_t>;

inline Bytes file_bytes(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  EXPECT_TRUE(in.good()) << path;
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

struct BifsVector {
  std::string name;
  nlohmann::json decoded;
  BifsConfig config;
  std::vector<Bytes> units;
};

inline const std::vector<std::string>& vector_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(
             std::filesystem::path(AFX_SOURCE_DIR) / "conformance/suites/bifs-gpac"))
      if (entry.is_directory()) found.push_back(entry.path().filename().string());
    std::sort(found.begin(), found.end());
    return found;
  }();
  return names;
}

inline BifsVector load_vector(const std::string& name) {
  const auto folder = std::filesystem::path(AFX_SOURCE_DIR) / "conformance/suites/bifs-gpac" / name;
  BifsVector vector;
  vector.name = name;
  std::ifstream json(folder / "decoded.json");
  vector.decoded = nlohmann::json::parse(json);
  Diagnostics diagnostics;
  const auto oti = vector.decoded["config"]["version"].get<uint8_t>();
  const auto config = read_config(file_bytes(folder / "cfg.bin"), oti, diagnostics);
  EXPECT_TRUE(config.ok());
  if (config.ok()) vector.config = config.value();
  for (size_t i = 0; i < vector.decoded["accessUnits"].size(); ++i)
    vector.units.push_back(file_bytes(folder / ("au" + std::to_string(i) + ".bifs")));
  return vector;
}

/// The first difference between two documents, as a path; empty if there is none. Numbers are equal
/// if they are the same binary64, or, below the normal range of binary32, the same binary32: the
/// reader printed more digits there than the shortest form has.
inline std::string difference(const nlohmann::json& a, const nlohmann::json& b,
                              const std::string& path) {
  if (a.is_number() && b.is_number()) {
    const double x = a.get<double>();
    const double y = b.get<double>();
    const bool denormal = std::abs(x) < 1.2e-38 && std::abs(x) > 1e-46;
    if (x == y || (denormal && static_cast<float>(x) == static_cast<float>(y))) return {};
    return path + ": " + a.dump() + " and " + b.dump();
  }
  if (a.type() != b.type()) return path + ": " + a.dump() + " and " + b.dump();
  if (a.is_object()) {
    for (const auto& [key, value] : a.items()) {
      if (!b.contains(key)) return path + "/" + key + " is missing";
      const std::string found = difference(value, b[key], path + "/" + key);
      if (!found.empty()) return found;
    }
    for (const auto& [key, value] : b.items())
      if (!a.contains(key)) return path + "/" + key + " is too much";
    return {};
  }
  if (a.is_array()) {
    if (a.size() != b.size())
      return path + ": " + std::to_string(a.size()) + " and " + std::to_string(b.size());
    for (size_t i = 0; i < a.size(); ++i) {
      const std::string found = difference(a[i], b[i], path + "/" + std::to_string(i));
      if (!found.empty()) return found;
    }
    return {};
  }
  return a == b ? std::string{} : path + ": " + a.dump() + " and " + b.dump();
}

}  // namespace afx::bifs
