// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What the README shows is what there is.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>

namespace {

const std::string kTop = AFX_SOURCE_DIR "/";

std::string read_file(const std::string& name) {
  std::ifstream in(kTop + name);
  EXPECT_TRUE(in) << name;
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

TEST(Readme, TheExampleIsTheConsumerThatIsBuiltAndRun) {
  const std::string readme = read_file("README.md");
  const size_t from = readme.find("```cpp\n");
  ASSERT_NE(from, std::string::npos);
  const size_t to = readme.find("```", from + 7);
  EXPECT_EQ(readme.substr(from + 7, to - from - 7), read_file("conformance/consumer/main.cpp"));
}

TEST(Readme, ItsFilesFoldersAndScriptsAreThere) {
  const std::string readme = read_file("README.md");
  const std::regex name(
      "(?:^|[` (])((?:tools|codec|nodes|bifs|afx|render|conformance)(?:/[a-z_0-9.-]+)+)");
  int names = 0;
  for (std::sregex_iterator at(readme.begin(), readme.end(), name); at != std::sregex_iterator();
       ++at) {
    EXPECT_TRUE(std::filesystem::exists(kTop + (*at)[1].str())) << (*at)[1];
    ++names;
  }
  EXPECT_GT(names, 8);
}

}  // namespace
