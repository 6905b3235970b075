// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>

#include "nodes/scene_reader.h"

namespace afx::nodes {

inline std::string file_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file.good()) << path;
  std::ostringstream text;
  text << file.rdbuf();
  return std::move(text).str();
}

inline std::filesystem::path source_path(const std::string& name) {
  return std::filesystem::path(AFX_SOURCE_DIR) / name;
}

/// The texts of conformance/suites/bifs-gpac that are scenes alone, by the name of their folder:
/// `scene.bt`, or where that has commands or object descriptors too, `plain.bt`.
inline std::map<std::string, std::string> plain_scenes() {
  std::map<std::string, std::string> scenes;
  for (const auto& entry :
       std::filesystem::directory_iterator(source_path("conformance/suites/bifs-gpac"))) {
    const bool plain = std::filesystem::exists(entry.path() / "plain.bt");
    const auto path = entry.path() / (plain ? "plain.bt" : "scene.bt");
    if (!std::filesystem::exists(path)) continue;
    std::string text = file_text(path);
    if (text.find("\nAT ") == std::string::npos) scenes[entry.path().filename()] = std::move(text);
  }
  return scenes;
}

/// The scene of a text that is expected to be good.
inline Scene read_scene(const std::string& text) {
  Diagnostics diagnostics;
  Result<Scene> scene = read_scene_text(text, Limits{}, diagnostics);
  EXPECT_TRUE(scene.ok()) << (scene.ok() ? ""
                                         : to_string(scene.error()) + "\n" + scene.error().excerpt);
  if (!scene.ok()) return {};
  return std::move(scene).value();
}

/// The error of a text that is expected to be bad; code not_available if it was good.
inline Error read_error(const std::string& text, const Limits& limits = {}) {
  Diagnostics diagnostics;
  const Result<Scene> scene = read_scene_text(text, limits, diagnostics);
  EXPECT_FALSE(scene.ok()) << text;
  return scene.ok() ? Error{Errc::not_available, {}, "", "", ""} : scene.error();
}

/// A value as the facts and the decoded vectors have it: numbers, "inf" and "+inf" and so on,
/// booleans, texts, arrays of them; {"od": n}; images with hex pixels.
bool json_equals(const FieldValue& value, const nlohmann::json& json);

}  // namespace afx::nodes
