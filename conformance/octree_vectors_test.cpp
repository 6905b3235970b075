// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The streams of conformance/octree, both ways, byte for byte.
#include <gtest/gtest.h>
#include <zlib.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "afx/octree_stream.h"
#include "codec/octree_symmetry.h"

namespace afx {
namespace {

using nlohmann::json;
const std::string kFolder = AFX_SOURCE_DIR "/conformance/octree/";

std::vector<uint8_t> read_file(const std::string& name) {
  std::ifstream in(kFolder + name, std::ios::binary);
  EXPECT_TRUE(in) << name;
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

json read_fields(const std::string& name) {
  std::vector<uint8_t> text = read_file(name);
  if (name.ends_with(".z")) {
    std::vector<uint8_t> plain(16U << 20);
    uLongf size = plain.size();
    EXPECT_EQ(uncompress(plain.data(), &size, text.data(), text.size()), Z_OK) << name;
    plain.resize(size);
    text = std::move(plain);
  }
  return json::parse(text);
}

OctreeStream stream_of(const json& fields) {
  OctreeStream stream;
  stream.resolution = fields.at("octreeResolution");
  stream.textures = fields.at("numOfTextures");
  for (const json& frame : fields.at("frames")) {
    stream.frames.push_back({frame.at("octree").get<std::vector<uint8_t>>(),
                             frame.at("voxelImageIndex").get<std::vector<uint8_t>>()});
  }
  return stream;
}

const json& manifest() {
  static const json kManifest = read_fields("manifest.json").at("vectors");
  return kManifest;
}

class OctreeVector : public testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] static const json& entry() {
    for (const json& vector : manifest()) {
      if (vector.at("name") == GetParam()) return vector;
    }
    throw std::out_of_range(GetParam());
  }
};

TEST_P(OctreeVector, DecodesToItsFields) {
  const OctreeStream expected = stream_of(read_fields(entry().at("fields")));
  const std::vector<uint8_t> data = read_file(entry().at("stream"));
  ASSERT_EQ(data.size(), entry().at("stream_bytes").get<size_t>());
  for (const unsigned threads : {1U, 4U}) {
    Diagnostics diagnostics;
    const DecodedOctreeStream decoded =
        decode_octree_stream(data, {.threads = threads}, diagnostics);
    ASSERT_TRUE(decoded.status.ok()) << to_string(decoded.status.error());
    EXPECT_EQ(decoded.stream.resolution, expected.resolution);
    EXPECT_EQ(decoded.stream.textures, expected.textures);
    EXPECT_EQ(decoded.stream.frames, expected.frames);
    uint64_t nodes = 0;
    uint64_t textures = 0;
    for (const OctreeFrameInfo& info : decoded.infos) {
      EXPECT_TRUE(info.whole);
      nodes += info.node_symbols;
      textures += info.texture_symbols;
    }
    EXPECT_EQ(nodes, entry().at("node_symbols").get<uint64_t>());
    EXPECT_EQ(textures, entry().at("texture_symbols").get<uint64_t>());
    EXPECT_EQ(diagnostics.count(), GetParam() == "zero-symbol-inside" ? 1U : 0U);
  }
}

TEST_P(OctreeVector, IsEncodedFromItsFields) {
  const OctreeStream stream = stream_of(read_fields(entry().at("fields")));
  for (const unsigned threads : {1U, 3U}) {
    const auto encoded = encode_octree_stream(stream, threads);
    ASSERT_TRUE(encoded.ok()) << to_string(encoded.error());
    EXPECT_EQ(encoded.value(), read_file(entry().at("stream")));
  }
}

TEST_P(OctreeVector, EveryTruncationIsOneClearErrorAndNeverAWrongSymbol) {
  const std::vector<uint8_t> whole = read_file(entry().at("stream"));
  if (whole.size() > 400) GTEST_SKIP() << "a large one: fuzzing cuts it";
  const OctreeStream expected = stream_of(read_fields(entry().at("fields")));
  for (size_t size = 0; size < whole.size(); ++size) {
    const std::vector<uint8_t> data(whole.begin(), whole.begin() + static_cast<ptrdiff_t>(size));
    Diagnostics diagnostics;
    const DecodedOctreeStream decoded = decode_octree_stream(data, {}, diagnostics);
    if (decoded.status.ok()) {  // frames cut off whole: the stream ends after the others
      ASSERT_LT(decoded.stream.frames.size(), expected.frames.size()) << size;
      continue;
    }
    EXPECT_EQ(decoded.status.error().code, Errc::truncated) << size;
    EXPECT_LE(decoded.status.error().place.bit, size * 8) << size;
    for (size_t i = 0; i < decoded.stream.frames.size(); ++i) {
      const std::vector<uint8_t>& octree = decoded.stream.frames[i].octree;
      const std::vector<uint8_t>& full = expected.frames[i].octree;
      ASSERT_LE(octree.size(), full.size());
      EXPECT_TRUE(std::equal(octree.begin(), octree.end(), full.begin())) << size;
    }
  }
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const json& vector : manifest()) all.push_back(vector.at("name"));
  return all;
}

INSTANTIATE_TEST_SUITE_P(All, OctreeVector, testing::ValuesIn(names()), [](const auto& test) {
  std::string name = test.param;
  for (char& c : name) c = c == '-' ? '_' : c;
  return name;
});

TEST(OctreeVectors, AreAllThere) { EXPECT_EQ(manifest().size(), 27U); }

TEST(OctreeVectors, SymmetriesAreThoseOfTheModel) {
  std::ifstream in(kFolder + "symmetries.txt");
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
}  // namespace afx
