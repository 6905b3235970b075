// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The suites of OctreeImage streams, by the decoder and encoder of the library.
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "afx/octree_stream.h"
#include "codec/octree_symmetry.h"
#include "conformance/octree_test_cases.h"

namespace afx::conformance {
namespace {

OctreeStream stream_of(const Stream& values) {
  return {values.resolution, values.textures, values.frames};
}

codec::plain::Finding finding_of(std::string_view code, const Place& place) {
  if (place.kind == Place::Kind::bit) return {code, place.bit};
  return {code, {}};
}

/// Names of warnings live as long as the program.
std::string_view kept(const std::string& code) {
  for (const std::string_view known : {"non_minimal_width", "align_bits", "trailing_bytes",
                                       "octree_childless_node", "octree_bad_ending"})
    if (known == code) return known;
  return "unknown";
}

Stream decode(const std::vector<uint8_t>& data, unsigned levels, unsigned threads) {
  Diagnostics diagnostics;
  DecodedOctreeStream decoded =
      decode_octree_stream(data, {.levels = levels, .threads = threads}, diagnostics);
  Stream stream{
      decoded.stream.resolution, decoded.stream.textures, std::move(decoded.stream.frames), {}, {}};
  if (!decoded.infos.empty()) stream.resolution = decoded.infos.back().resolution;
  for (const Warning& warning : diagnostics.warnings())
    stream.warnings.push_back(finding_of(kept(warning.code), warning.place));
  if (!decoded.status.ok()) {
    const Error& error = decoded.status.error();
    stream.error = finding_of(to_string(error.code), error.place);
  }
  return stream;
}

OctreeCoder library(unsigned threads) {
  return {[=](const std::vector<uint8_t>& data, unsigned levels) {
            return decode(data, levels, threads);
          },
          [=](const Stream& values) {
            return encode_octree_stream(stream_of(values), threads).value();
          }};
}

/// Small whole streams; large ones are cut by fuzzing.
std::vector<OctreeCase> small_model_cases() {
  std::vector<OctreeCase> cases = read_octree_cases("octree-model");
  std::erase_if(cases, [](const OctreeCase& one) { return one.data.size() > 400; });
  return cases;
}

std::vector<OctreeCase> all_cases() {
  std::vector<OctreeCase> all;
  for (const char* suite : {"octree-model", "octree-rules", "octree-rejects"}) {
    const std::vector<OctreeCase> cases = read_octree_cases(suite);
    all.insert(all.end(), cases.begin(), cases.end());
  }
  return all;
}

class OctreeSuites : public testing::TestWithParam<OctreeCase> {};

TEST_P(OctreeSuites, HoldsOnAnyNumberOfThreads) {
  for (const unsigned threads : {1U, 3U}) {
    const std::optional<size_t> failure = first_failure(GetParam(), library(threads));
    EXPECT_FALSE(failure) << "check " << *failure << ", " << threads << " threads";
  }
}

class SmallOctreeStreams : public testing::TestWithParam<OctreeCase> {};

TEST_P(SmallOctreeStreams, EveryTruncationIsOneClearErrorAndNeverAWrongSymbol) {
  const std::vector<uint8_t>& whole = GetParam().data;
  const std::vector<OctreeFields>& fields = GetParam().values.front().frames;
  for (size_t size = 0; size < whole.size(); ++size) {
    const std::vector<uint8_t> data(whole.begin(), whole.begin() + static_cast<ptrdiff_t>(size));
    const Stream decoded = decode(data, 32, 1);
    if (!decoded.error) {  // frames cut off whole: the stream ends after the others
      ASSERT_LT(decoded.frames.size(), fields.size()) << size;
      continue;
    }
    EXPECT_EQ(decoded.error->code, "truncated") << size;
    EXPECT_LE(*decoded.error->bit, size * 8) << size;
    for (size_t i = 0; i < decoded.frames.size(); ++i) {
      const std::vector<uint8_t>& octree = decoded.frames[i].octree;
      const std::vector<uint8_t>& full = fields[i].octree;
      ASSERT_LE(octree.size(), full.size());
      EXPECT_TRUE(std::equal(octree.begin(), octree.end(), full.begin())) << size;
    }
  }
}

std::string test_name(const testing::TestParamInfo<OctreeCase>& test) {
  std::string name = test.param.suite + "-" + test.param.info.name;
  for (char& c : name) c = c == '-' ? '_' : c;
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, OctreeSuites, testing::ValuesIn(all_cases()), test_name);
INSTANTIATE_TEST_SUITE_P(All, SmallOctreeStreams, testing::ValuesIn(small_model_cases()),
                         test_name);

TEST(OctreeSuites, AreAllThere) {
  EXPECT_EQ(read_octree_cases("octree-model").size(), 27U);
  EXPECT_GE(read_octree_cases("octree-rules").size(), 89U);
  EXPECT_GE(read_octree_cases("octree-rejects").size(), 106U);
  EXPECT_EQ(small_model_cases().size(), 18U);
}

TEST(OctreeSuites, SymmetriesAreThoseOfTheModel) {
  std::ifstream in(AFX_SOURCE_DIR "/conformance/suites/octree-model/symmetries.txt");
  unsigned rows = 0;
  for (unsigned symbol, number, base, symmetry; in >> symbol >> number >> base >> symmetry;
       ++rows) {
    EXPECT_EQ(codec::kSymbolClasses.number[symbol], number);
    EXPECT_EQ(codec::kSymbolClasses.base[symbol], base);
    EXPECT_EQ(codec::kSymbolClasses.symmetry[symbol], symmetry);
  }
  EXPECT_EQ(rows, 256U);
}

}  // namespace
}  // namespace afx::conformance
