// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Runs the built program in a folder of the test's own.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace afx::tools {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;

inline const std::string kVectors = AFX_SOURCE_DIR "/conformance/suites/octree-model/";

inline std::string read_file(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

inline void write_file(const fs::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

struct Outcome {
  int code;
  std::string out;
  std::string err;
};

class Program : public testing::Test {
 protected:
  void SetUp() override {
    char name[] = "/tmp/afx_program_XXXXXX";
    ASSERT_NE(mkdtemp(name), nullptr);
    folder_ = name;
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// Runs the program in the test's own folder, with the words as a shell has them.
  [[nodiscard]] Outcome run(const std::string& words) const {
    const std::string line =
        "cd '" + folder_.string() + "' && " AFX_PROGRAM " " + words + " >out.log 2>err.log";
    const int status = std::system(line.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(folder_ / "out.log"),
            read_file(folder_ / "err.log")};
  }
  /// The JSON result of a run that must end with this code.
  [[nodiscard]] nlohmann::json result(const std::string& words, int code = 0) const {
    const Outcome outcome = run(words + " --json");
    EXPECT_EQ(outcome.code, code) << words << "\n" << outcome.err;
    return nlohmann::json::parse(outcome.out, nullptr, false);
  }
  [[nodiscard]] fs::path file(const std::string& name) const { return folder_ / name; }
  /// What all files hold.
  [[nodiscard]] std::map<std::string, std::string> contents() const {
    std::map<std::string, std::string> contents;
    for (const std::string& name : files()) contents[name] = read_file(file(name));
    return contents;
  }
  [[nodiscard]] std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      const std::string name = entry.path().filename().string();
      if (!name.ends_with(".log")) names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    return names;
  }

  fs::path folder_;
};

constexpr const char* kTwoTriangles = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0.5\nf 1 2 3\nf 2 4 3\n";

/// Four sides that face in slanting directions.
constexpr const char* kTetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

}  // namespace afx::tools
