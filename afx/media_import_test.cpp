// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/media_import.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "afx/file_test_folder.h"
#include "afx/media_store.h"
#include "afx/octree_stream.h"
#include "bifs/mp4_builder.h"

namespace afx {
namespace {

using ::testing::HasSubstr;
using Bytes = std::vector<uint8_t>;

const std::string kMp4 = AFX_SOURCE_DIR "/conformance/suites/bifs-gpac/";
const std::string kOctree = AFX_SOURCE_DIR "/conformance/suites/octree-model/";

Bytes read_file(const std::string& path) {
  const auto file = MappedFile::open(path);
  EXPECT_TRUE(file.ok()) << path;
  return {file.value().bytes().begin(), file.value().bytes().end()};
}

class MediaImport : public testing::Test {
 protected:
  bifs::Media import(const std::string& folder, const std::string& name,
                     const std::string& format = {}) {
    auto media = import_media({name, format}, folder, {}, diagnostics_);
    EXPECT_TRUE(media.ok()) << to_string(media.error());
    return media.ok() ? std::move(media).value() : bifs::Media{};
  }
  std::string error_of(const std::string& folder, const std::string& name) {
    const auto media = import_media({name, {}}, folder, {}, diagnostics_);
    return media.ok() ? "none" : to_string(media.error());
  }

  Diagnostics diagnostics_;
};

const bifs::DecoderConfig& config_of(const bifs::Media& media) {
  return *decoder_config_of(media.track.entries.at(0));
}

TEST_F(MediaImport, APictureIsOneSampleWithTheSizeOfItsHeader) {
  struct Case {
    const char* name;
    uint8_t object_type;
    uint32_t width, height;
  };
  for (const Case& c : {Case{"color32.jpg", 0x6C, 32, 24}, Case{"color16.jpg", 0x6C, 16, 16},
                        Case{"depth32.png", 0x6D, 32, 24}}) {
    const bifs::Media media = import(kMp4 + "02-depthimage-imagetexture", c.name);
    const Bytes whole = read_file(kMp4 + "02-depthimage-imagetexture/" + c.name);
    ASSERT_EQ(media.track.samples.size(), 1U);
    EXPECT_EQ(media.track.samples[0].size, whole.size());
    EXPECT_EQ(media.bytes(0).value(), whole);
    EXPECT_EQ(media.bytes(1).error().code, Errc::bad_argument);
    EXPECT_EQ(media.track.width, c.width << 16);
    EXPECT_EQ(media.track.height, c.height << 16);
    EXPECT_EQ(media.track.handler, bifs::fourcc("vide"));
    EXPECT_EQ(config_of(media).object_type, c.object_type);
    EXPECT_EQ(config_of(media).stream_type, 4);
    EXPECT_EQ(still_picture_type(media), c.object_type);
    EXPECT_FALSE(afx_object_code(media));
  }
}

TEST_F(MediaImport, AnOctreeStreamOfOneFrameIsOneSample) {
  const bifs::Media media = import(kOctree, "corner-4-y.afx");
  ASSERT_EQ(media.track.samples.size(), 1U);
  EXPECT_EQ(media.bytes(0).value(), read_file(kOctree + "corner-4-y.afx"));
  EXPECT_EQ(media.track.samples[0].duration, 0U);
  EXPECT_EQ(config_of(media).object_type, 5);
  EXPECT_EQ(config_of(media).stream_type, 3);
  EXPECT_EQ(afx_object_code(media), 6);
  EXPECT_FALSE(still_picture_type(media));
}

TEST_F(MediaImport, EachFrameOfAnOctreeStreamBecomesAStreamOfItsOwn) {
  const Bytes whole = read_file(kOctree + "frames-3.afx");
  const DecodedOctreeStream expected = decode_octree_stream(whole, {}, diagnostics_);
  const bifs::Media media = import(kOctree, "frames-3.afx");
  ASSERT_EQ(media.track.samples.size(), 3U);
  EXPECT_EQ(media.track.timescale, 1000U);
  for (size_t i = 0; i < 3; ++i) {
    const Bytes bytes = media.bytes(i).value();
    EXPECT_EQ(media.track.samples[i].size, bytes.size());
    EXPECT_EQ(media.track.samples[i].time, i * 40);
    const DecodedOctreeStream alone = decode_octree_stream(bytes, {}, diagnostics_);
    ASSERT_TRUE(alone.status.ok());
    ASSERT_EQ(alone.stream.frames.size(), 1U);
    EXPECT_EQ(alone.stream.frames[0], expected.stream.frames[i]);
    EXPECT_EQ(alone.stream.textures, expected.stream.textures);
    EXPECT_EQ(alone.stream.resolution, expected.stream.resolution);
  }
  EXPECT_EQ(diagnostics_.count(), 0U);
}

TEST_F(MediaImport, Sc3dmcIsTakenAsItIs) {
  const TestFolder folder;
  folder.write("octree.s3d", "anything");
  folder.write("other", "anything");
  const bifs::Media by_ending = import(folder.path(""), "octree.s3d");
  const bifs::Media by_format = import(folder.path(""), "other", "SC3DMC");
  for (const bifs::Media& media : {by_ending, by_format}) {
    EXPECT_EQ(afx_object_code(media), 12);
    EXPECT_EQ(media.bytes(0).value(), (Bytes{'a', 'n', 'y', 't', 'h', 'i', 'n', 'g'}));
  }
}

TEST_F(MediaImport, ATrackOfAnMp4FileIsPassedThrough) {
  const std::string folder = kMp4 + "14-bitwrapper";
  const bifs::Media afx = import(folder, "scene.mp4#40");
  EXPECT_EQ(afx_object_code(afx), 6);
  EXPECT_EQ(afx.track.samples.size(), 1U);
  EXPECT_EQ(afx.bytes(0).value(), read_file(folder + "/t40.au0.bin"));
  EXPECT_EQ(afx.track.id, 0U);
  const bifs::Media scene = import(folder, "scene.mp4#1");
  EXPECT_EQ(scene.bytes(0).value(), read_file(folder + "/au0.bifs"));
}

TEST_F(MediaImport, TimesEntriesAndEditsOfATrackAreKept) {
  bifs::Mp4Builder builder;
  bifs::Mp4Track track = bifs::make_image_track(7, bifs::object_type::kPng, 3, 2);
  track.timescale = 50;
  track.edits = {{1200, 10, 0x10000}};
  builder.movie.timescale = 1200;
  builder.add_track(track);
  builder.add_sample(0, {1, 2}, 0);
  builder.add_sample(0, {3}, 25, false);
  builder.set_last_duration(0, 35);
  std::string text;
  ASSERT_TRUE(builder
                  .write([&text](std::span<const uint8_t> part) -> Status {
                    text.append(part.begin(), part.end());
                    return {};
                  })
                  .ok());
  const TestFolder folder;
  folder.write("a.mp4", text);
  const bifs::Media media = import(folder.path(""), "a.mp4#7");
  ASSERT_EQ(media.track.samples.size(), 2U);
  EXPECT_EQ(media.track.samples[1].time, 25U);
  EXPECT_EQ(media.track.samples[1].duration, 35U);
  EXPECT_FALSE(media.track.samples[1].random_access);
  EXPECT_EQ(media.track.timescale, 50U);
  EXPECT_EQ(media.track.entries[0].head, track.entries[0].head);
  EXPECT_EQ(media.bytes(1).value(), (Bytes{3}));
  // One second in the movie's timescale 1200, in the track's 50.
  EXPECT_EQ(media.track.edits, (std::vector<bifs::Mp4Edit>{{50, 10, 0x10000}}));
}

TEST_F(MediaImport, WhatCannotBeImportedIsToldWithItsFile) {
  const TestFolder folder;
  const std::string root = folder.path("");
  folder.write("a.txt", "hello");
  folder.write("a.png", "\x89PNG\r\n\x1A\n");
  folder.write("empty", "");
  EXPECT_THAT(error_of(root, "none.png"), HasSubstr("none.png: cannot be opened"));
  EXPECT_THAT(error_of(root, "a.txt"), HasSubstr("a.txt: is no media of a kind that is known"));
  EXPECT_THAT(error_of(root, "empty"), HasSubstr("empty: is no media of a kind that is known"));
  EXPECT_THAT(error_of(root, "a.png"), HasSubstr("a.png:8: the PNG ends before it says its size"));
  EXPECT_THAT(error_of(root, "a.txt#x"), HasSubstr("a.txt#x: cannot be opened"));
  EXPECT_THAT(error_of(root, "a.txt#1"), HasSubstr("a.txt"));
  EXPECT_THAT(error_of(root, ""), HasSubstr("is a folder"));
  EXPECT_THAT(error_of(kMp4 + "14-bitwrapper", "scene.mp4#41"),
              HasSubstr("scene.mp4: has no track with the ID 41"));
  EXPECT_THAT(error_of(kMp4 + "14-bitwrapper", "scene.mp4"), HasSubstr("NAME.mp4#ID"));
}

TEST_F(MediaImport, ATruncatedOctreeStreamIsACleanError) {
  const Bytes whole = read_file(kOctree + "frames-3.afx");
  const TestFolder folder;
  for (const size_t size : {size_t{1}, size_t{7}, whole.size() / 2, whole.size() - 1}) {
    folder.write("a.afx", {reinterpret_cast<const char*>(whole.data()), size});
    EXPECT_NE(error_of(folder.path(""), "a.afx"), "none") << size;
  }
}

TEST_F(MediaImport, APictureTooLargeForAnMp4FileIsRefused) {
  const TestFolder folder;
  const char png[] = "\x89PNG\r\n\x1A\n\0\0\0\x0DIHDR\0\1\0\0\0\0\0\2";
  folder.write("a.png", {png, sizeof png - 1});
  EXPECT_THAT(error_of(folder.path(""), "a.png"), HasSubstr("65536 x 2"));
}

TEST_F(MediaImport, AStoreIsLookedIntoBeforeTheFiles) {
  const TestFolder folder;
  folder.write("b.s3d", "file");
  MediaStore store;
  store.put(
      "a.s3d",
      one_sample_media(bifs::make_afx_track(0, {6}), MappedFile::in_memory({1, 2, 3}), {}).value());
  const bifs::LoadMedia load = store.loader(folder.path(""), {}, diagnostics_);
  EXPECT_EQ(load({"a.s3d", {}}).value().bytes(0).value(), (Bytes{1, 2, 3}));
  EXPECT_EQ(load({"b.s3d", {}}).value().bytes(0).value(), (Bytes{'f', 'i', 'l', 'e'}));
  EXPECT_EQ(load({"c.s3d", {}}).error().code, Errc::io);
  EXPECT_EQ(store.find("b.s3d"), nullptr);
}

}  // namespace
}  // namespace afx
