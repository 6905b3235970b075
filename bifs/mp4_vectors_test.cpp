// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The files of conformance/suites/bifs-gpac: what they hold, and that it survives being written.
#include "bifs/descriptor_writer.h"
#include "bifs/mp4_test_support.h"
#include "bifs/od_command.h"

namespace afx::bifs {
namespace {

using mp4_test::Bytes;
using nlohmann::json;

const json& manifest(const std::string& name) {
  static const json kManifest = [] {
    std::ifstream in(mp4_test::kMp4Folder + "manifest.json");
    return json::parse(in).at("vectors");
  }();
  for (const json& entry : kManifest) {
    if (entry.at("name") == name) return entry;
  }
  static const json kNone;
  ADD_FAILURE() << name;
  return kNone;
}

class Mp4Vector : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    bytes_ = mp4_test::read_file(GetParam() + "/scene.mp4");
    auto read = mp4_test::read(bytes_);
    ASSERT_TRUE(read.ok()) << to_string(read.error());
    movie_ = read.value();
  }
  Bytes bytes_;
  Mp4Movie movie_;
};

void expect_facts(const json& facts, const Mp4Track& track) {
  EXPECT_EQ(track.id, facts.at("id"));
  EXPECT_EQ(to_string(track.handler), facts.at("handler"));
  ASSERT_EQ(track.entries.size(), 1U);
  EXPECT_EQ(to_string(track.entries[0].type), facts.at("sampleEntry"));
  const DecoderConfig* config = decoder_config_of(track.entries[0]);
  ASSERT_NE(config, nullptr);
  EXPECT_EQ(config->object_type, facts.at("objectTypeIndication"));
  EXPECT_EQ(config->stream_type, facts.at("streamType"));
  EXPECT_EQ(track.timescale, facts.at("timescale"));
  ASSERT_EQ(track.samples.size(), facts.at("samples"));
  for (size_t i = 0; i < track.samples.size(); ++i) {
    EXPECT_EQ(track.samples[i].time, facts.at("times").at(i));
  }
  json references = json::object();
  for (const Mp4Reference& reference : track.references) {
    references[to_string(reference.type)] = reference.tracks;
  }
  EXPECT_EQ(references, facts.value("refs", json::object()));
}

TEST_P(Mp4Vector, HasTheTracksOfTheManifest) {
  const json& entry = manifest(GetParam());
  ASSERT_EQ(movie_.tracks.size(), entry.at("tracks").size());
  for (size_t i = 0; i < movie_.tracks.size(); ++i) {
    expect_facts(entry.at("tracks")[i], movie_.tracks[i]);
  }
  ASSERT_NE(scene_track(movie_), nullptr);
  EXPECT_EQ(scene_track(movie_)->id, 1U);
  const Mp4Track* objects = object_descriptor_track(movie_);
  EXPECT_EQ(objects != nullptr, movie_.tracks.size() > 1);
}

TEST_P(Mp4Vector, HasTheConfigurationsAndAccessUnitsOfTheFiles) {
  for (const json& facts : manifest(GetParam()).at("tracks")) {
    const Mp4Track* track = find_track(movie_, facts.at("id"));
    ASSERT_NE(track, nullptr);
    size_t next = 0;
    for (const std::string file : facts.value("files", json::array())) {
      const Bytes expected = mp4_test::read_file(GetParam() + "/" + file);
      if (file.ends_with("cfg.bin")) {
        EXPECT_EQ(decoder_specific_info(*es_of(track->entries[0])), expected) << file;
      } else {
        ASSERT_LT(next, track->samples.size()) << file;
        EXPECT_EQ(mp4_test::sample(bytes_, *track, next++), expected) << file;
      }
    }
    if (facts.contains("files")) {
      EXPECT_EQ(next, track->samples.size());
    }
  }
}

TEST_P(Mp4Vector, ItsDescriptorsAreWrittenBackByteForByte) {
  ASSERT_TRUE(movie_.initial_object);
  const auto written = write_descriptors({*movie_.initial_object});
  ASSERT_TRUE(written.ok());
  std::string hex;
  for (const uint8_t byte : written.value()) {
    hex += "0123456789abcdef"[byte >> 4];
    hex += "0123456789abcdef"[byte & 15];
  }
  EXPECT_EQ(hex, manifest(GetParam()).at("iodsDescriptor"));
  for (const json& facts : manifest(GetParam()).at("tracks")) {
    for (const std::string file : facts.value("files", json::array())) {
      if (!file.starts_with("od")) continue;
      const Bytes sample = mp4_test::read_file(GetParam() + "/" + file);
      Diagnostics diagnostics;
      const auto commands = read_od_commands(sample, {}, diagnostics);
      ASSERT_TRUE(commands.ok()) << file;
      EXPECT_EQ(diagnostics.count(), 0U);
      EXPECT_EQ(write_od_commands(commands.value()).value(), sample) << file;
    }
  }
}

TEST_P(Mp4Vector, WrittenItReadsTheSameAndWrittenAgainItIsTheSame) {
  const Bytes first = mp4_test::rewrite(bytes_, movie_);
  const auto again = mp4_test::read(first);
  ASSERT_TRUE(again.ok()) << to_string(again.error());
  EXPECT_TRUE(mp4_test::without_offsets(again.value()) == mp4_test::without_offsets(movie_));
  for (size_t t = 0; t < movie_.tracks.size(); ++t) {
    for (size_t i = 0; i < movie_.tracks[t].samples.size(); ++i) {
      EXPECT_EQ(mp4_test::sample(first, again.value().tracks[t], i),
                mp4_test::sample(bytes_, movie_.tracks[t], i));
    }
  }
  EXPECT_EQ(mp4_test::rewrite(first, again.value()), first);
}

// 'esds' included: GPAC's is found in the written file as it is.
TEST_P(Mp4Vector, TheSampleEntriesAreWrittenAsTheyWere) {
  const Bytes first = mp4_test::rewrite(bytes_, movie_);
  size_t found = 0;
  for (size_t at = 0; at + 8 < bytes_.size(); ++at) {
    if (std::string(bytes_.begin() + static_cast<ptrdiff_t>(at + 4),
                    bytes_.begin() + static_cast<ptrdiff_t>(at + 8)) != "stsd") {
      continue;
    }
    const size_t size = bytes_[at + 2] * 256U + bytes_[at + 3];
    const auto begin = bytes_.begin() + static_cast<ptrdiff_t>(at);
    EXPECT_NE(std::search(first.begin(), first.end(), begin, begin + static_cast<ptrdiff_t>(size)),
              first.end());
    ++found;
  }
  EXPECT_EQ(found, movie_.tracks.size());
}

std::string test_name(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  for (char& c : name) c = c == '-' ? '_' : c;
  return name;
}
INSTANTIATE_TEST_SUITE_P(All, Mp4Vector, testing::ValuesIn(mp4_test::vector_names()), test_name);

TEST(Mp4Vectors, AreAllThere) { EXPECT_EQ(mp4_test::vector_names().size(), 37U); }

TEST(Mp4Vectors, PicturesAreSamplesAndAreFoundThroughTheObjectDescriptors) {
  const std::string folder = "02-depthimage-imagetexture/";
  const Bytes bytes = mp4_test::read_file(folder + "scene.mp4");
  const auto movie = mp4_test::read(bytes);
  ASSERT_TRUE(movie.ok());
  const Mp4Track* objects = object_descriptor_track(movie.value());
  ASSERT_NE(objects, nullptr);
  const char* files[] = {"color32.jpg", "depth32.png", "color16.jpg"};
  for (uint16_t i = 0; i < 3; ++i) {
    const Mp4Track* picture =
        referenced_track(movie.value(), *objects, EsIdRef{static_cast<uint16_t>(i + 1)});
    ASSERT_NE(picture, nullptr);
    EXPECT_EQ(mp4_test::sample(bytes, *picture, 0), mp4_test::read_file(folder + files[i]));
  }
  EXPECT_EQ(referenced_track(movie.value(), *objects, EsIdRef{0}), nullptr);
  EXPECT_EQ(referenced_track(movie.value(), *objects, EsIdRef{4}), nullptr);
}

}  // namespace
}  // namespace afx::bifs
