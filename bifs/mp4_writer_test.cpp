// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/mp4_writer.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "bifs/descriptor_writer.h"
#include "bifs/mp4_builder.h"
#include "bifs/mp4_test_support.h"
#include "bifs/od_command.h"

namespace afx::bifs {
namespace {

using mp4_test::Bytes;

Bytes build(Mp4Builder& builder) {
  Bytes out;
  const Status status = builder.write([&out](std::span<const uint8_t> part) -> Status {
    out.insert(out.end(), part.begin(), part.end());
    return {};
  });
  EXPECT_TRUE(status.ok()) << to_string(status.error());
  return out;
}

const std::string kPictures = "02-depthimage-imagetexture/";

/// Vector 02 from its parts.
Bytes rebuilt_pictures() {
  Mp4Builder builder;
  builder.movie.initial_object = make_initial_object(1, 2);
  const size_t scene = builder.add_track(make_scene_track(
      1, object_type::kBifs, mp4_test::read_file(kPictures + "cfg.bin"), 320, 240));
  builder.add_sample(scene, mp4_test::read_file(kPictures + "au0.bifs"), 0);
  const size_t objects = builder.add_track(make_object_descriptor_track(2, {10, 11, 12}));
  builder.add_sample(objects, mp4_test::read_file(kPictures + "od0.bin"), 0);
  builder.add_sample(objects, mp4_test::read_file(kPictures + "od1.bin"), 1000, false);
  builder.add_sample(objects, mp4_test::read_file(kPictures + "od2.bin"), 4000, false);
  const struct {
    uint32_t id;
    uint8_t type;
    const char* file;
    uint16_t width, height;
  } pictures[] = {{10, object_type::kJpeg, "color32.jpg", 32, 24},
                  {11, object_type::kPng, "depth32.png", 32, 24},
                  {12, object_type::kJpeg, "color16.jpg", 16, 16}};
  for (const auto& picture : pictures) {
    const size_t track = builder.add_track(
        make_image_track(picture.id, picture.type, picture.width, picture.height));
    builder.add_sample(track, mp4_test::read_file(kPictures + picture.file), 0);
    builder.set_last_duration(track, 1000);
  }
  return build(builder);
}

TEST(Mp4Builder, BuildsWhatGpacBuildsFromTheSameParts) {
  const auto built = mp4_test::read(rebuilt_pictures());
  const auto vector = mp4_test::read(mp4_test::read_file(kPictures + "scene.mp4"));
  ASSERT_TRUE(built.ok()) << to_string(built.error());
  Mp4Movie movie = built.value();
  const Mp4Movie& expected = vector.value();
  EXPECT_EQ(movie.next_track_id, expected.next_track_id);
  EXPECT_EQ(movie.duration, expected.duration);
  EXPECT_EQ(movie.timescale, expected.timescale);
  EXPECT_EQ(movie.compatible_brands, expected.compatible_brands);
  ASSERT_EQ(movie.tracks.size(), expected.tracks.size());
  for (size_t i = 0; i < movie.tracks.size(); ++i) {
    const Mp4Track& ours = movie.tracks[i];
    const Mp4Track& theirs = expected.tracks[i];
    EXPECT_EQ(ours.id, theirs.id);
    EXPECT_EQ(ours.handler, theirs.handler);
    EXPECT_TRUE(ours.references == theirs.references);
    EXPECT_TRUE(ours.media_header == theirs.media_header) << i;
    EXPECT_EQ(ours.width, theirs.width);
    EXPECT_EQ(ours.height, theirs.height);
    EXPECT_EQ(ours.duration, theirs.duration);
    EXPECT_EQ(ours.media_duration, theirs.media_duration);
    EXPECT_EQ(ours.entries[0].type, theirs.entries[0].type);
    EXPECT_EQ(ours.entries[0].head, theirs.entries[0].head);
    if (ours.handler != fourcc("odsm")) {  // there GPAC counts the descriptors as streams have them
      EXPECT_EQ(decoder_config_of(ours.entries[0])->buffer_bytes,
                decoder_config_of(theirs.entries[0])->buffer_bytes);
    }
    ASSERT_EQ(ours.samples.size(), theirs.samples.size());
    for (size_t s = 0; s < ours.samples.size(); ++s) {
      EXPECT_EQ(ours.samples[s].time, theirs.samples[s].time);
      EXPECT_EQ(ours.samples[s].duration, theirs.samples[s].duration);
      EXPECT_EQ(ours.samples[s].random_access, theirs.samples[s].random_access) << i << " " << s;
    }
  }
}

TEST(Mp4Builder, AnAfxStreamHasTheDescriptorThatGpacGivesIt) {
  const std::string folder = "14-bitwrapper/";
  Mp4Builder builder;
  const size_t track =
      builder.add_track(make_afx_track(40, mp4_test::read_file(folder + "t40.cfg.bin")));
  builder.add_sample(track, mp4_test::read_file(folder + "t40.au0.bin"), 0);
  builder.set_last_duration(track, 1000);
  const auto built = mp4_test::read(build(builder));
  const auto vector = mp4_test::read(mp4_test::read_file(folder + "scene.mp4"));
  ASSERT_TRUE(built.ok());
  EXPECT_TRUE(built.value().tracks[0].entries == find_track(vector.value(), 40)->entries);
}

TEST(Mp4Builder, BitRatesAreAverageAndMostInASecond) {
  Mp4Builder builder;
  const size_t track = builder.add_track(make_afx_track(1, {6}));
  const uint64_t times[] = {0, 600, 1500};
  for (const uint64_t time : times) builder.add_sample(track, Bytes(100), time);
  builder.set_last_duration(track, 500);
  const auto built = mp4_test::read(build(builder));
  ASSERT_TRUE(built.ok());
  const DecoderConfig* config = decoder_config_of(built.value().tracks[0].entries[0]);
  EXPECT_EQ(config->avg_bitrate, 1200U);  // 300 bytes in 2 s
  EXPECT_EQ(config->max_bitrate, 1600U);  // 0 and 600 ms, or 600 and 1500 ms
  EXPECT_EQ(config->buffer_bytes, 100U);
}

TEST(Mp4Builder, TimesThatCannotBeWrittenAreRefused) {
  const auto sink = [](std::span<const uint8_t>) -> Status { return {}; };
  const std::vector<std::vector<uint64_t>> cases = {{5}, {0, 10, 9}, {0, uint64_t{1} << 32}};
  for (const std::vector<uint64_t>& times : cases) {
    Mp4Builder builder;
    const size_t track = builder.add_track(make_afx_track(1, {6}));
    for (const uint64_t time : times) builder.add_sample(track, {1}, time);
    const Status status = builder.write(sink);
    ASSERT_FALSE(status.ok());
    EXPECT_EQ(status.error().code, Errc::bad_argument);
  }
}

TEST(Mp4Writer, SamplesLieInTheOrderOfTheirTimes) {
  // Two tracks of different timescales: 0, 1/2, 1 s and 0, 2/3 s.
  Mp4Builder builder;
  const size_t a = builder.add_track(make_afx_track(1, {6}));
  const size_t b = builder.add_track(make_afx_track(2, {6}));
  builder.movie.tracks[b].timescale = 3;
  builder.add_sample(a, {'A'}, 0);
  builder.add_sample(a, {'B'}, 500);
  builder.add_sample(a, {'C'}, 1000);
  builder.add_sample(b, {'x'}, 0);
  builder.add_sample(b, {'y'}, 2);
  const Bytes file = build(builder);
  EXPECT_EQ(std::string(file.end() - 5, file.end()), "AxByC");
}

TEST(Mp4Writer, EditsCompositionAndEntriesSurvive) {
  Mp4Builder builder;
  const size_t track = builder.add_track(make_afx_track(1, {6}));
  for (const uint64_t time : {0U, 40U, 80U, 120U})
    builder.add_sample(track, {1, 2, 3}, time, time == 0);
  builder.set_last_duration(track, 40);
  Mp4Track& made = builder.movie.tracks[track];
  made.edits = {{600, -1, 0x10000}, {60, 40, 0x10000}};
  made.entries.push_back(made.entries[0]);
  made.samples[2].entry = 1;
  made.samples[1].composition_offset = -40;
  made.samples[2].composition_offset = 80;
  made.boxes = {{fourcc("udta"), {9, 9}}};
  made.table_boxes = {{fourcc("sdtp"), {0, 0, 0, 0, 1, 2, 3, 4}}};
  const Bytes file = build(builder);
  const auto read = mp4_test::read(file);
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_TRUE(mp4_test::without_offsets(read.value()) == mp4_test::without_offsets(builder.movie));
  EXPECT_EQ(mp4_test::rewrite(file, read.value()), file);
}

TEST(Mp4Writer, MovieTimesFollowTheEdits) {
  Mp4Movie movie;
  Mp4Track track = make_afx_track(1, {6});
  EXPECT_EQ(movie_time(movie, track, 500), 300U);  // 1/1000 s to 1/600 s
  track.edits = {{600, -1, 0x10000}, {60, 40, 0x10000}, {0, 500, 0x10000}};
  EXPECT_EQ(movie_time(movie, track, 39), std::nullopt);
  EXPECT_EQ(movie_time(movie, track, 40), 600U);
  EXPECT_EQ(movie_time(movie, track, 139), 659U);  // 99 ms are 59.4 ticks
  EXPECT_EQ(movie_time(movie, track, 140), std::nullopt);
  EXPECT_EQ(movie_time(movie, track, 1500), 1260U);  // the last edit, of unknown length
}

TEST(Mp4Writer, DurationsFollowTheSamplesAndTheEdits) {
  Mp4Movie movie;
  movie.tracks.push_back(make_afx_track(7, {6}));
  Mp4Track& track = movie.tracks[0];
  track.samples.resize(4);
  for (Mp4Sample& sample : track.samples) sample.duration = 500;
  update_durations(movie);
  EXPECT_EQ(track.media_duration, 2000U);
  EXPECT_EQ(movie.duration, 1200U);
  EXPECT_EQ(movie.next_track_id, 8U);
  track.edits = {{60, -1, 0x10000}, {0, 500, 0x10000}};  // the last 1.5 s, 0.1 s later
  update_durations(movie);
  EXPECT_EQ(track.edits[1].duration, 900U);
  EXPECT_EQ(movie.duration, 960U);
}

TEST(Mp4Writer, WhatCannotBeWrittenIsRefused) {
  const Bytes file = mp4_test::hand_made_file({});
  const Mp4Movie good = mp4_test::read(file).value();
  const std::function<void(Mp4Movie&)> changes[] = {
      [](Mp4Movie& m) { m.timescale = 0; },
      [](Mp4Movie& m) { m.tracks[0].id = 0; },
      [](Mp4Movie& m) { m.tracks.push_back(m.tracks[0]); },
      [](Mp4Movie& m) { m.tracks[0].timescale = 0; },
      [](Mp4Movie& m) { m.tracks[0].samples[0].duration = 11; },
      [](Mp4Movie& m) { m.tracks[0].samples[1].entry = 1; },
      [](Mp4Movie& m) { m.tracks[0].samples[1].size = 5; },
      [](Mp4Movie& m) { m.tracks[0].samples[1].composition_offset = int64_t{1} << 32; },
      [](Mp4Movie& m) {
        m.initial_object = Descriptor{UnknownDescriptor{0, {}}};
      },
  };
  const Mp4SampleBytes bytes = samples_of(mp4_source(file), good, {});
  size_t number = 0;
  for (const auto& change : changes) {
    Mp4Movie movie = good;
    change(movie);
    const Bytes three(3), four(4);
    const Status status = write_mp4(
        movie, [&](size_t, size_t sample) -> Result<Bytes> { return sample == 0 ? three : four; },
        [](std::span<const uint8_t>) -> Status { return {}; });
    ASSERT_FALSE(status.ok()) << number;
    EXPECT_EQ(status.error().code, Errc::bad_argument) << number;
    ++number;
  }
}

// What FFmpeg's demuxer says, a program of its own.
class Ffprobe : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("ffprobe -version > /dev/null 2>&1") != 0) {
      GTEST_SKIP() << "ffprobe is not installed";
    }
    path_ = std::filesystem::path(testing::TempDir()) /
            ("afx_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) +
             ".mp4");
  }
  void TearDown() override {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  nlohmann::json streams(const Bytes& file) {
    std::ofstream(path_, std::ios::binary)
        .write(reinterpret_cast<const char*>(file.data()),
               static_cast<std::streamsize>(file.size()));
    const std::string command = "ffprobe -v error -count_packets -show_streams -of json '" +
                                path_.string() + "' 2>&1";  // a complaint spoils the JSON
    std::string text;
    FILE* pipe = popen(command.c_str(), "r");
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
    EXPECT_EQ(pclose(pipe), 0);
    const auto json = nlohmann::json::parse(text, nullptr, false);
    EXPECT_FALSE(json.is_discarded()) << text;
    return json.is_discarded() ? json : json.at("streams");
  }
  std::filesystem::path path_;
};

TEST_F(Ffprobe, ListsTheStreamsOfAWrittenFile) {
  const auto listed = streams(rebuilt_pictures());
  const struct {
    const char* id;
    const char* tag;
    const char* codec;
    const char* packets;
  } expected[] = {{"0x1", "mp4s", "", "1"},
                  {"0x2", "mp4s", "", "3"},
                  {"0xa", "mp4v", "mjpeg", "1"},
                  {"0xb", "mp4v", "png", "1"},
                  {"0xc", "mp4v", "mjpeg", "1"}};
  ASSERT_EQ(listed.size(), std::size(expected));
  for (size_t i = 0; i < listed.size(); ++i) {
    EXPECT_EQ(listed[i].at("id"), expected[i].id);
    EXPECT_EQ(listed[i].at("codec_tag_string"), expected[i].tag);
    EXPECT_EQ(listed[i].value("codec_name", ""), expected[i].codec);
    EXPECT_EQ(listed[i].at("nb_read_packets"), expected[i].packets);
  }
}

bool has_pictures(const Mp4Movie& movie) {
  return std::any_of(movie.tracks.begin(), movie.tracks.end(),
                     [](const Mp4Track& track) { return track.handler == fourcc("vide"); });
}

TEST_F(Ffprobe, ListsTheSameForVectorsWrittenAgain) {
  for (const std::string name : {"01-depthimage-pixeltexture", "14-bitwrapper", "24-commands-basic",
                                 "25-commands-extended"}) {
    const Bytes bytes = mp4_test::read_file(name + "/scene.mp4");
    const Mp4Movie movie = mp4_test::read(bytes).value();
    EXPECT_FALSE(has_pictures(movie));  // for those see below
    EXPECT_EQ(streams(mp4_test::rewrite(bytes, movie)), streams(bytes)) << name;
  }
}

/// Takes out a DecoderSpecificInfo without bytes.
void drop_empty_info(Mp4SampleEntry& entry) {
  for (Descriptor& part : std::get<EsDescriptor>(entry.es->body).parts) {
    auto* config = std::get_if<DecoderConfig>(&part.body);
    if (config == nullptr) continue;
    std::erase_if(config->parts, [](const Descriptor& inner) {
      const auto* info = std::get_if<DecoderSpecificInfo>(&inner.body);
      return info != nullptr && info->bytes.empty();
    });
  }
}

// FFmpeg 5.1 does not open GPAC's own files with PNG pictures: it stops at their empty
// decoder-specific info. Without that the same files are fine, so we never write an empty one of
// our own.
TEST_F(Ffprobe, OpensFilesWithPicturesWithoutGpacsEmptyDecoderSpecificInfo) {
  for (const std::string name : {"02-depthimage-imagetexture", "13-media-object-descriptors"}) {
    const Bytes bytes = mp4_test::read_file(name + "/scene.mp4");
    Mp4Movie movie = mp4_test::read(bytes).value();
    EXPECT_TRUE(has_pictures(movie));
    for (Mp4Track& track : movie.tracks) drop_empty_info(track.entries[0]);
    EXPECT_EQ(streams(mp4_test::rewrite(bytes, movie)).size(), movie.tracks.size()) << name;
  }
}

}  // namespace
}  // namespace afx::bifs
