// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What comes from files that this project did not write.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "afx/media_import.h"
#include "afx/octree_image.h"
#include "afx/octree_stream.h"
#include "afx/scene_packing.h"
#include "bifs/config.h"
#include "bifs/decoder.h"
#include "bifs/mp4_builder.h"
#include "nodes/byte_text.h"
#include "nodes/scene_reader.h"
#include "nodes/scene_writer.h"

namespace afx {
namespace {

using nodes::NodeView;
using nodes::Url;
using ::testing::HasSubstr;
using Bytes = std::vector<uint8_t>;

bifs::Media media_of(bifs::Mp4Track track, Bytes bytes) {
  return one_sample_media(std::move(track), MappedFile::in_memory(std::move(bytes)), {}).value();
}
bifs::Media octree_media(const OctreeStream& stream) {
  return media_of(bifs::make_afx_track(0, {kOctreeImageCode}),
                  encode_octree_stream(stream).value());
}
bifs::Media picture_media(uint8_t object_type, Bytes bytes) {
  return media_of(bifs::make_image_track(0, object_type, 1, 1), std::move(bytes));
}

const OctreeStream kStream{4, 2, {{{0x81, 0x02, 0x41}, {0, 2, 0, 1, 0}}}};
const char* const kOctreeFields =
    "octreeResolution 4 octree [ 129 2 65 ] voxelImageIndex [ 0 2 0 1 0 ] ";
const char* const kImages = "images [ DepthImage { } DepthImage { } ] ";

class SceneUnpacking : public testing::Test {
 protected:
  SceneUnpacking() {
    streams_.emplace(5, octree_media(kStream));
    streams_.emplace(6, picture_media(bifs::object_type::kPng, {1, 2}));
    streams_.emplace(7, picture_media(bifs::object_type::kJpeg, {3}));
    streams_.emplace(8, media_of(bifs::make_afx_track(0, {kSc3dmcCode}), {0}));
  }
  void read(const std::string& text) {
    auto scene = nodes::read_scene_text(text, {}, diagnostics_);
    ASSERT_TRUE(scene.ok()) << to_string(scene.error());
    scene_ = std::move(scene).value();
  }
  std::vector<NamedFile> unpack(const std::string& text) {
    read(text);
    auto files = unpack_scene(scene_, streams_, options_, diagnostics_);
    EXPECT_TRUE(files.ok()) << to_string(files.error());
    return files.ok() ? std::move(files).value() : std::vector<NamedFile>();
  }
  std::string error_of(const std::string& text) {
    read(text);
    const auto files = unpack_scene(scene_, streams_, options_, diagnostics_);
    return files.ok() ? "none" : to_string(files.error());
  }
  void expect_scene(const std::string& text) {
    Diagnostics ignored;
    EXPECT_TRUE(nodes::equal(scene_, nodes::read_scene_text(text, {}, ignored).value()))
        << nodes::write_scene_text(scene_);
  }
  std::string warnings() const {
    std::string codes;
    for (const Warning& warning : diagnostics_.warnings()) codes += warning.code + " ";
    return codes;
  }
  /// The files of a scene with one texture of these urls, as "name=size", and its urls afterwards.
  std::string texture(const std::string& urls) {
    const std::vector<NamedFile> files = unpack("Background { frontUrl [ " + urls + " ] }");
    std::string result;
    for (const NamedFile& file : files)
      result += file.name + "=" + std::to_string(file.bytes.size()) + " ";
    for (const Url& url : scene_.get<std::vector<Url>>(scene_.roots().at(0), "frontUrl"))
      result += url.is_descriptor() ? "[od] " : "[" + url.text + "] ";
    return result;
  }

  ObjectStreams streams_;
  UnpackOptions options_;
  Diagnostics diagnostics_;
  nodes::Scene scene_;
};

TEST_F(SceneUnpacking, FieldsReplaceThoseThatAreThereWithAWarning) {
  unpack(std::string("BitWrapper { url 5 node OctreeImage { octree 1 ") + kImages + "} }");
  expect_scene(std::string("OctreeImage { ") + kOctreeFields + kImages + "}");
  EXPECT_EQ(warnings(), "bitwrapper_fields ");
}

TEST_F(SceneUnpacking, ANameOfTheBitWrapperStaysWithTheOctree) {
  unpack(std::string("Group { children [ DEF W BitWrapper { url 5 node OctreeImage { ") + kImages +
         "} } USE W ] }");
  expect_scene(std::string("Group { children [ DEF W OctreeImage { ") + kOctreeFields + kImages +
               "} USE W ] }");
}

TEST_F(SceneUnpacking, OfSeveralSamplesTheFirstIsTaken) {
  streams_.at(5).track.samples.push_back(streams_.at(5).track.samples.front());
  unpack(std::string("BitWrapper { url 5 node OctreeImage { ") + kImages + "} }");
  expect_scene(std::string("OctreeImage { ") + kOctreeFields + kImages + "}");
  EXPECT_EQ(warnings(), "frames_left_out ");
}

TEST_F(SceneUnpacking, WhatIsNotKnownStaysWithAWarning) {
  const std::string node = std::string("node OctreeImage { ") + kImages + "}";
  for (const std::string& wrapper :
       {"BitWrapper { type 1 url 5 " + node + " }", "BitWrapper { url 8 " + node + " }",
        "BitWrapper { url 6 " + node + " }", "BitWrapper { url 99 " + node + " }",
        "BitWrapper { url \"a.afx\" " + node + " }", std::string("BitWrapper { url 5 }"),
        std::string("BitWrapper { url 5 node DepthImage { } }"),
        "PROTO P [ ] { OctreeImage { " + std::string(kImages) +
            "} } BitWrapper { url 5 node P { } }",
        "PROTO P [ field SFNode n BitWrapper { url 5 " + node + " } ] { Group { } } Group { }"}) {
    diagnostics_ = Diagnostics();
    unpack(wrapper);
    expect_scene(wrapper);
    EXPECT_EQ(warnings(), "bitwrapper_left ") << wrapper;
  }
}

TEST_F(SceneUnpacking, WhatBreaksTheRulesIsAnError) {
  const std::string images = kImages;
  EXPECT_THAT(error_of("BitWrapper { node OctreeImage { " + images + "} }"),
              HasSubstr("has neither of url and buffer (expected one)"));
  EXPECT_THAT(error_of("BitWrapper { url 5 buffer \"0x5A\" node OctreeImage { " + images + "} }"),
              HasSubstr("has both of url and buffer (expected one)"));
  EXPECT_THAT(error_of("BitWrapper { url 5 node OctreeImage { images DepthImage { } } }"),
              HasSubstr("numOfTextures 2, but its node has 1 images"));
  EXPECT_THAT(error_of("BitWrapper { buffer \"0x5A\" node OctreeImage { " + images + "} }"),
              Not(HasSubstr("none")));
  streams_.at(5) = media_of(bifs::make_afx_track(0, {kOctreeImageCode}), {0, 1, 2});
  EXPECT_THAT(error_of("BitWrapper { url 5 node OctreeImage { " + images + "} }"),
              HasSubstr("od:5:"));
}

TEST_F(SceneUnpacking, ManyOctreesOfOneStreamAreBoundedTogether) {
  // A full octree of 4096 voxels with its indices: about 5 000 symbols, 25 000 bytes.
  streams_.at(5) = octree_media({16, 2, {{Bytes(585, 0xFF), Bytes(4681, 0)}}});
  const std::string one = std::string("BitWrapper { url 5 node OctreeImage { ") + kImages + "} } ";
  options_.limits.memory = 1 << 20;
  EXPECT_EQ(error_of("Group { children [ " + one + one + one + "] }"), "none");
  std::string many;
  for (int i = 0; i < 60; ++i) many += one;
  EXPECT_THAT(error_of("Group { children [ " + many + "] }"), HasSubstr("limit"));
}

TEST_F(SceneUnpacking, APictureHasTheNameBehindItsDescriptor) {
  EXPECT_EQ(texture("6 \"a.png\""), "a.png=2 [a.png] ");
  EXPECT_EQ(texture("6 \"sub/./A b.PNG\" \"c.png\""), "sub/./A b.PNG=2 [sub/./A b.PNG] [c.png] ");
  EXPECT_EQ(texture("6 \"http://x/y.png\" \"c.png\""), "c.png=2 [http://x/y.png] [c.png] ");
  EXPECT_EQ(texture("6 \"file:c.png\""), "c.png=2 [file:c.png] ");
  EXPECT_EQ(texture("6 \"a.png\" 7 \"b.jpg\""), "a.png=2 b.jpg=1 [a.png] [b.jpg] ");
  EXPECT_EQ(diagnostics_.count(), 0U);
}

TEST_F(SceneUnpacking, APictureWithoutANameGetsOne) {
  options_.stem = "scene";
  EXPECT_EQ(texture("6"), "scene_od6.png=2 [scene_od6.png] ");
  EXPECT_EQ(texture("7 6 \"a.png\""), "scene_od7.jpg=1 a.png=2 [scene_od7.jpg] [a.png] ");
  options_.taken = {"scene_od6.png"};
  EXPECT_EQ(texture("6"), "scene_od6_2.png=2 [scene_od6_2.png] ");
  EXPECT_EQ(diagnostics_.count(), 0U);
}

TEST_F(SceneUnpacking, NoTwoPicturesAndNoOtherFileShareAName) {
  options_.taken = {"scene.png"};
  EXPECT_EQ(texture("6 \"./scene.png\""), "picture_od6.png=2 [picture_od6.png] [./scene.png] ");
  EXPECT_EQ(texture("6 \"a.png\" 7 \"x/..png/../a.png\" \"./a.png\""),
            "a.png=2 picture_od7.jpg=1 [a.png] [picture_od7.jpg] [x/..png/../a.png] [./a.png] ");
  EXPECT_EQ(texture("6 \"a.png\" 6 \"./a.png\""), "a.png=2 [a.png] [./a.png] ");
  EXPECT_EQ(warnings(), "name_taken unsafe_name ");
}

TEST_F(SceneUnpacking, HostileNamesAreNotUsed) {
  for (const char* name : {"/etc/a.png", "../a.png", "a/../../b.png", "a\\\\b.png", "c:a.png",
                           ".hidden.png", "a/.b/c.png", "a\nb.png", "a\x7F.png", "a.sh", "png",
                           ".png", "..", "-", "a.png/", "file:/etc/a.png", "file:../a.png"}) {
    diagnostics_ = Diagnostics();
    const std::string result = texture("6 \"" + std::string(name) + "\"");
    EXPECT_EQ(result.rfind("picture_od6.png=2 [picture_od6.png] [", 0), 0U) << name;
    EXPECT_EQ(warnings(), "unsafe_name ") << name;
  }
  EXPECT_FALSE(is_plain_picture_name(std::string("a\0b.png", 7)));
  EXPECT_FALSE(is_plain_picture_name(std::string(1000, 'a') + ".png"));
  EXPECT_FALSE(is_plain_picture_name(""));
  EXPECT_TRUE(is_plain_picture_name("a..b.png"));
  EXPECT_TRUE(is_plain_picture_name("./a/b.jpeg"));
}

TEST_F(SceneUnpacking, OtherStreamsStayByTheirNumbers) {
  EXPECT_EQ(texture("8 \"a.png\""), "[od] [a.png] ");
  EXPECT_EQ(texture("99"), "[od] ");
  EXPECT_EQ(warnings(), "url_left url_left ");
}

TEST_F(SceneUnpacking, PicturesAreBoundedTogether) {
  options_.limits.memory = 2;
  EXPECT_EQ(texture("7 \"a.jpg\" 7 \"b.jpg\""), "a.jpg=1 b.jpg=1 [a.jpg] [b.jpg] ");
  EXPECT_THAT(error_of("Background { frontUrl [ 7 \"a.jpg\" 6 \"b.png\" ] }"),
              HasSubstr("od:6: the pictures are beyond the limit"));
}

TEST_F(SceneUnpacking, WhatCommandsHaveDroppedIsNotLookedAt) {
  read("Group { children [ BitWrapper { node OctreeImage { } } Background { frontUrl 6 } ] }");
  scene_.scope().roots.clear();
  const auto files = unpack_scene(scene_, streams_, options_, diagnostics_);
  ASSERT_TRUE(files.ok());
  EXPECT_TRUE(files.value().empty());
}

/// The scene of a vector, as its first access unit makes it.
nodes::Scene vectors_scene(const std::string& folder) {
  const auto bytes = [&](const char* name) {
    const auto file = MappedFile::open(folder + "/" + name);
    EXPECT_TRUE(file.ok()) << name;
    return Bytes(file.value().bytes().begin(), file.value().bytes().end());
  };
  Diagnostics diagnostics;
  const auto config = bifs::read_config(bytes("cfg.bin"), 1, diagnostics);
  EXPECT_TRUE(config.ok());
  bifs::BifsDecoder decoder(config.value());
  EXPECT_TRUE(decoder.decode(bytes("au0.bifs"), diagnostics).ok());
  return decoder.take_scene();
}

TEST_F(SceneUnpacking, ThePicturesOfAVectorsFileAreThoseItWasMadeFrom) {
  const std::string folder =
      AFX_SOURCE_DIR "/conformance/suites/bifs-gpac/02-depthimage-imagetexture";
  streams_.clear();
  for (const uint16_t id : std::vector<uint16_t>{10, 11, 12}) {
    auto media = import_media({"scene.mp4#" + std::to_string(id), {}}, folder, {}, diagnostics_);
    ASSERT_TRUE(media.ok()) << to_string(media.error());
    streams_.emplace(id, std::move(media).value());
  }
  scene_ = vectors_scene(folder);
  const auto files = unpack_scene(scene_, streams_, options_, diagnostics_);
  ASSERT_TRUE(files.ok()) << to_string(files.error());
  std::map<std::string, Bytes> by_name;
  for (const NamedFile& file : files.value()) by_name.emplace(file.name, file.bytes);
  ASSERT_EQ(by_name.size(), 3U);
  for (const auto& [name, source] :
       {std::pair("picture_od10.jpg", "color32.jpg"), std::pair("picture_od11.png", "depth32.png"),
        std::pair("alternative.jpg", "color16.jpg")}) {
    const auto file = MappedFile::open(folder + "/" + source);
    const auto expected = file.value().bytes();
    EXPECT_EQ(by_name[name], Bytes(expected.begin(), expected.end())) << name;
  }
  EXPECT_THAT(nodes::write_scene_text(scene_), Not(HasSubstr("od:")));
}

TEST_F(SceneUnpacking, AVectorsStreamThatIsNoneIsAnErrorThatNamesIt) {
  const std::string folder = AFX_SOURCE_DIR "/conformance/suites/bifs-gpac/14-bitwrapper";
  streams_.clear();
  streams_.emplace(40, import_media({"scene.mp4#40", {}}, folder, {}, diagnostics_).value());
  scene_ = vectors_scene(folder);
  const auto files = unpack_scene(scene_, streams_, options_, diagnostics_);
  ASSERT_FALSE(files.ok());
  EXPECT_EQ(files.error().file, "od:40");
}

TEST_F(SceneUnpacking, AnOctreeIsReadFromAStreamWithoutUnpacking) {
  read(std::string("BitWrapper { url [ 98 5 ] node OctreeImage { ") + kImages + "} }");
  const NodeView wrapper = find_octree_images(scene_).at(0);
  const auto octree = read_octree_node(wrapper, {"", &streams_}, {}, diagnostics_);
  ASSERT_TRUE(octree.ok()) << to_string(octree.error());
  EXPECT_EQ(octree.value().fields, kStream.frames[0]);
  EXPECT_EQ(octree.value().resolution, 4U);
  EXPECT_EQ(read_octree_node(wrapper, std::string(), {}, diagnostics_).error().code,
            Errc::unsupported);
  read(std::string("BitWrapper { url 8 node OctreeImage { ") + kImages + "} }");
  const auto other =
      read_octree_node(find_octree_images(scene_).at(0), {"", &streams_}, {}, diagnostics_);
  ASSERT_FALSE(other.ok());
  EXPECT_THAT(other.error().text, HasSubstr("AFX object code 12 (expected 6, OctreeImage)"));
}

TEST_F(SceneUnpacking, PicturesOfAnOctreeAreReadFromStreams) {
  const auto picture = import_media(
      {"color32.jpg", {}},
      AFX_SOURCE_DIR "/conformance/suites/bifs-gpac/02-depthimage-imagetexture", {}, diagnostics_);
  streams_.insert_or_assign(7, picture.value());
  read(
      std::string("OctreeImage { octreeResolution 2 octree 1 images DepthImage { diTexture "
                  "SimpleTexture { texture ImageTexture { url [ 7 \"none.jpg\" ] } } } }"));
  const auto model =
      read_octree_model(find_octree_images(scene_).at(0), {"", &streams_}, {}, diagnostics_);
  ASSERT_TRUE(model.ok());
  EXPECT_EQ(model.value().images.at(0).picture.width, 32U);
  EXPECT_EQ(model.value().images.at(0).picture.height, 24U);
  EXPECT_EQ(diagnostics_.count(), 0U);
}

}  // namespace
}  // namespace afx
