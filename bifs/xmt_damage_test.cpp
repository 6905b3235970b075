// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Damaged XMT-A: every truncation fails with a place, corruptions fail or give something that can
// be written.
#include <random>
#include <string>

#include "bifs/vectors_test_support.h"
#include "bifs/xmt_reader.h"
#include "bifs/xmt_writer.h"

namespace afx::bifs {

namespace {

std::string text_of(const std::string& name) {
  const auto path =
      std::filesystem::path(AFX_SOURCE_DIR) / "conformance/suites/bifs-gpac" / name / "gpac.xmt";
  const Bytes bytes = file_bytes(path);
  return {bytes.begin(), bytes.end()};
}

constexpr const char* kSmall[] = {"26-commands-routes", "29-script-conditional",
                                  "13-media-object-descriptors", "30-names"};

}  // namespace

TEST(XmtDamage, EveryTruncationIsAnErrorWithAPlace) {
  for (const char* name : kSmall) {
    const std::string text = text_of(name);
    const size_t end = text.rfind('>');
    for (size_t size = 0; size <= end; ++size) {
      Diagnostics warnings;
      const auto read = read_xmt(std::string_view(text).substr(0, size), {}, warnings);
      ASSERT_FALSE(read.ok()) << name << " cut at " << size;
      ASSERT_EQ(read.error().code, Errc::malformed);
      ASSERT_EQ(read.error().place.kind, Place::Kind::text);
    }
  }
}

TEST(XmtDamage, CorruptionsFailOrGiveWhatCanBeWrittenAndRead) {
  std::mt19937 random(7);
  for (const char* name : kSmall) {
    const std::string whole = text_of(name);
    for (int run = 0; run < 1500; ++run) {
      std::string text = whole;
      for (unsigned change = 0; change < 1 + random() % 3; ++change)
        text[random() % text.size()] = static_cast<char>(32 + random() % 95);
      Diagnostics warnings;
      auto read = read_xmt(text, {}, warnings);
      if (!read.ok()) continue;
      std::string again;
      XmtWriter writer([&](std::string_view piece) {
        again += piece;
        return Status{};
      });
      ASSERT_TRUE(play(read.value(), writer, warnings).ok()) << text;
      const auto second = read_xmt(again, {}, warnings);
      ASSERT_TRUE(second.ok()) << to_string(second.error()) << "\n" << again;
    }
  }
}

}  // namespace afx::bifs
