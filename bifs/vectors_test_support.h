// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The project's BIFS vectors (conformance/bifs/README.md) for tests.
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
             std::filesystem::path(AFX_SOURCE_DIR) / "conformance/bifs"))
      if (entry.is_directory()) found.push_back(entry.path().filename().string());
    std::sort(found.begin(), found.end());
    return found;
  }();
  return names;
}

inline BifsVector load_vector(const std::string& name) {
  const auto folder = std::filesystem::path(AFX_SOURCE_DIR) / "conformance/bifs" / name;
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

}  // namespace afx::bifs
