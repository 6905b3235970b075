// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Layers go down only: a file includes its own folder and those below it.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>

namespace {

const std::map<std::string, int> kRank{{"codec", 0},  {"nodes", 1},       {"bifs", 2}, {"afx", 3},
                                       {"render", 4}, {"conformance", 5}, {"tools", 6}};

bool is_source(const std::filesystem::path& path) {
  return path.extension() == ".h" || path.extension() == ".cpp";
}
bool is_check(const std::string& name) {
  return std::regex_search(name, std::regex("_(test|bench|fuzz)\\.cpp$|_test_[a-z_]+\\.h$"));
}

TEST(Layers, NoFileIncludesAFolderAboveItsOwn) {
  const std::regex include("^#include \"(([a-z]+)/[^\"]*)\"");
  int files = 0;
  int includes = 0;
  for (const auto& [folder, rank] : kRank) {
    const std::filesystem::path root = std::filesystem::path(AFX_SOURCE_DIR) / folder;
    ASSERT_TRUE(std::filesystem::is_directory(root)) << root;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
      if (!is_source(entry.path())) continue;
      ++files;
      std::ifstream in(entry.path());
      std::smatch match;
      for (std::string line; std::getline(in, line);) {
        if (!std::regex_search(line, match, include)) continue;
        ++includes;
        const auto target = kRank.find(match[2]);
        ASSERT_NE(target, kRank.end()) << entry.path() << ": " << line;
        EXPECT_LE(target->second, rank) << entry.path() << ": " << line;
        const bool gl = entry.path().string().find("render/gl/") != std::string::npos;
        EXPECT_FALSE(gl && match[1].str().starts_with("render/software/"))
            << entry.path() << ": " << line << " (renderers do not know each other)";
        const bool plain = match[1].str().starts_with("codec/plain/");
        const bool own = entry.path().string().find("codec/plain/") != std::string::npos ||
                         folder == "conformance";
        EXPECT_TRUE(!plain || own || is_check(entry.path().filename().string()))
            << entry.path() << ": " << line;
      }
    }
  }
  EXPECT_GT(files, 50);
  EXPECT_GT(includes, 200);
}

}  // namespace
