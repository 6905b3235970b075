// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "conformance/generator/octree_property.h"

#include <algorithm>

#include "codec/octree_contexts.h"
#include "conformance/conformance_test_support.h"
#include "conformance/generator/random_octree.h"

namespace afx::conformance {
namespace {

using nlohmann::json;

TEST(OctreeGenerator, OurCoderHolds) {
  const auto failed = find_failure(octree_property(), {.cases = 3000, .threads = 0});
  EXPECT_FALSE(failed) << failed->number << ": " << failed->failure.text;
}

TEST(OctreeGenerator, MakesEveryKindOfStream) {
  int stages = 0, images = 0, many_images = 0, frames = 0, deep = 0, uneven = 0, childless = 0;
  for (uint64_t number = 0; number < 2000; ++number) {
    Choices choices(1, number);
    const OctreeStream stream = random_octree(choices);
    const OctreeFields& first = stream.frames[0];
    stages += first.octree.size() > codec::kStage2Start ? 1 : 0;
    images += first.voxel_image_index.empty() ? 0 : 1;
    many_images += stream.textures > 64 ? 1 : 0;
    frames += stream.frames.size() > 1 ? 1 : 0;
    deep += octree_levels(stream.resolution) > 20 ? 1 : 0;
    uneven += (stream.resolution & (stream.resolution - 1)) != 0 ? 1 : 0;
    childless += std::count(first.octree.begin(), first.octree.end(), 0) > 0 ? 1 : 0;
  }
  for (const int count : {stages, images, many_images, frames, deep, uneven, childless})
    EXPECT_GT(count, 5);
}

/// Our coder, but one symbol decodes wrong.
OctreeCoder broken_decoder() {
  OctreeCoder coder = own_octree_coder();
  coder.decode = [](std::span<const uint8_t> data, const OctreeDecodeOptions& options,
                    Diagnostics& diagnostics) {
    DecodedOctreeStream decoded = decode_octree_stream(data, options, diagnostics);
    for (OctreeFields& frame : decoded.stream.frames)
      std::replace(frame.octree.begin(), frame.octree.end(), uint8_t{0xFF}, uint8_t{0xFE});
    return decoded;
  };
  return coder;
}

TEST(OctreeGenerator, FindsABrokenDecoderAndTheSmallestCase) {
  const auto failed = find_failure(octree_property(broken_decoder()), {.cases = 3000});
  ASSERT_TRUE(failed);
  EXPECT_EQ(failed->failure.text, "decode on 1 threads: other fields than were encoded");
  Choices smallest(failed->draws);
  EXPECT_EQ(random_octree(smallest).frames, (std::vector<OctreeFields>{{{0xFF}, {}}}));
}

TEST(OctreeGenerator, FindsABrokenEncoder) {
  OctreeCoder coder = own_octree_coder();
  coder.encode = [](const OctreeStream& stream, unsigned threads) {
    auto bytes = encode_octree_stream(stream, threads);
    if (threads > 1 && stream.frames.size() > 1) bytes.value().pop_back();
    return bytes;
  };
  const auto failed = find_failure(octree_property(coder), {.cases = 3000});
  ASSERT_TRUE(failed);
  EXPECT_EQ(failed->failure.text, "encode on 3 threads: other bytes than the plain coder's");
}

TEST(OctreeGenerator, FindsADecoderThatTakesCutStreamsForWhole) {
  OctreeCoder coder = own_octree_coder();
  coder.decode = [](std::span<const uint8_t> data, const OctreeDecodeOptions& options,
                    Diagnostics& diagnostics) {
    DecodedOctreeStream decoded = decode_octree_stream(data, options, diagnostics);
    if (decoded.has_header) decoded.status = {};
    return decoded;
  };
  const auto failed = find_failure(octree_property(coder), {.cases = 3000});
  ASSERT_TRUE(failed);
  EXPECT_EQ(failed->failure.kept.checks[0].check["check"], "reject");
}

TEST(OctreeGenerator, FindsTheSameForAnyNumberOfThreads) {
  const auto one = find_failure(octree_property(broken_decoder()), {.seed = 9, .threads = 1});
  const auto many = find_failure(octree_property(broken_decoder()), {.seed = 9, .threads = 5});
  ASSERT_TRUE(one && many);
  EXPECT_EQ(one->number, many->number);
  EXPECT_EQ(one->draws, many->draws);
  const auto alone = find_failure(octree_property(broken_decoder()),
                                  {.seed = 9, .first = one->number, .cases = 1});
  ASSERT_TRUE(alone);
  EXPECT_EQ(alone->draws, one->draws);
}

TEST(OctreeGenerator, AKeptCaseFailsInTheRunnerInTheSameWay) {
  const auto failed = find_failure(octree_property(broken_decoder()), {.cases = 3000});
  ASSERT_TRUE(failed);
  const TemporaryFolder folder = std::move(TemporaryFolder::make().value());
  const std::string path = folder.path() + "/new/one";
  ASSERT_TRUE(keep_case(path, "octree-1-2", "about", failed->failure.kept).ok());
  const std::vector<Suite> suites{read_suite(path).value()};
  const auto answer = [](int symbol) -> Answer {
    return {.values = {{"octreeResolution", 2},
                       {"numOfTextures", 0},
                       {"frames", {{{"octree", {symbol}}, {"voxelImageIndex", json::array()}}}}}};
  };
  const auto outcome = [&](int symbol) {
    const ToldDecoder decoder([&](const Question&) { return answer(symbol); });
    return run_suites(suites, decoder, {}).cases.at(0).checks.at(0);
  };
  EXPECT_EQ(outcome(0xFF).verdict, Verdict::passed);
  EXPECT_EQ(outcome(0xFE).verdict, Verdict::failed);
  ASSERT_TRUE(outcome(0xFE).difference);
  EXPECT_EQ(outcome(0xFE).difference->path, "/frames/0/octree/0");
}

}  // namespace
}  // namespace afx::conformance
