// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/scene_packing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "afx/file_test_folder.h"
#include "afx/media_import.h"
#include "afx/octree_image.h"
#include "afx/octree_stream.h"
#include "bifs/mp4_builder.h"
#include "nodes/scene_reader.h"
#include "nodes/scene_writer.h"

namespace afx {
namespace {

using nodes::NodeId;
using nodes::Url;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Bytes = std::vector<uint8_t>;
using Octrees = PackOptions::Octrees;

nodes::Scene scene_of(const std::string& text) {
  Diagnostics diagnostics;
  auto scene = nodes::read_scene_text(text, {}, diagnostics);
  EXPECT_TRUE(scene.ok()) << to_string(scene.error());
  return scene.ok() ? std::move(scene).value() : nodes::Scene();
}

/// A plain scene as a presentation.
bifs::Presentation presentation_of(const std::string& text) {
  bifs::Presentation presentation;
  presentation.scene = scene_of(text);
  bifs::SceneReplacement replacement;
  nodes::Scope& scope = presentation.scene.scope();
  replacement.protos = scope.protos;
  if (!scope.roots.empty()) replacement.root = scope.roots.front();
  replacement.routes = std::exchange(scope.routes, {});
  scope.roots.clear();
  presentation.units.emplace_back().commands.emplace<std::vector<bifs::Command>>().emplace_back(
      replacement);
  return presentation;
}

/// Remembers the media that the object descriptors name, and carries the scene out.
class Collector final : public bifs::PresentationSink {
 public:
  explicit Collector(bifs::LoadMedia load) : load_(std::move(load)) {}

  Status begin(const bifs::InitialObjectDescriptor&) override { return {}; }
  Status begin_frame(uint64_t, bool) override { return {}; }
  Status add(const bifs::Command&, const nodes::Scene&) override { return {}; }
  Status end_frame() override { return {}; }
  Status object_descriptors(uint64_t time, bool, const bifs::OdCommands& commands) override {
    EXPECT_EQ(time, 0U);
    for (const bifs::Descriptor& part : std::get<bifs::OdUpdate>(commands.at(0).body).objects) {
      const auto& object = std::get<bifs::ObjectDescriptor>(part.body);
      const auto* es = bifs::find_part<bifs::EsDescriptor>(object.parts);
      es_ids.push_back(es->es_id);
      sources.push_back(es->source->file);
      auto media = load_(*es->source);
      EXPECT_TRUE(media.ok()) << to_string(media.error());
      if (media.ok()) streams.emplace(object.id, std::move(media).value());
    }
    return {};
  }
  Status end() override { return {}; }

  ObjectStreams streams;
  std::vector<uint16_t> es_ids;
  std::vector<std::string> sources;

 private:
  bifs::LoadMedia load_;
};

const char* const kOctreeText =
    "OctreeImage { octreeResolution 4 octree [ 129 2 65 ] voxelImageIndex [ 0 2 0 1 0 ] "
    "images [ DepthImage { } DepthImage { } ] }";
const OctreeFields kFields{{0x81, 0x02, 0x41}, {0, 2, 0, 1, 0}};

class ScenePacking : public testing::Test {
 protected:
  /// Packs and carries out; leaves what came of it in `scene_`, `streams_` and so on.
  void pack(const std::string& text, const PackOptions& options = {}) {
    bifs::Presentation presentation = presentation_of(text);
    const Status packed = pack_scene(presentation, folder_.path(""), options, store_, diagnostics_);
    ASSERT_TRUE(packed.ok()) << to_string(packed.error());
    Collector collector(store_.loader(folder_.path(""), {}, diagnostics_));
    ASSERT_TRUE(bifs::play(presentation, collector, diagnostics_).ok());
    scene_ = std::move(presentation.scene);
    initial_ = presentation.initial;
    streams_ = std::move(collector.streams);
    es_ids_ = collector.es_ids;
    sources_ = collector.sources;
  }
  std::vector<NamedFile> unpack(const UnpackOptions& options = {}) {
    auto files = unpack_scene(scene_, streams_, options, diagnostics_);
    EXPECT_TRUE(files.ok()) << to_string(files.error());
    return files.ok() ? std::move(files).value() : std::vector<NamedFile>();
  }
  std::string text() { return nodes::write_scene_text(scene_); }
  void expect_unpacked_equal(const std::string& original) {
    unpack();
    EXPECT_TRUE(nodes::equal(scene_, scene_of(original))) << text();
  }
  std::string warnings() const {
    std::string codes;
    for (const Warning& warning : diagnostics_.warnings()) codes += warning.code + " ";
    return codes;
  }
  void copy_vectors_picture(const std::string& name, const std::string& as) {
    const auto file = MappedFile::open(
        AFX_SOURCE_DIR "/conformance/suites/bifs-gpac/02-depthimage-imagetexture/" + name);
    const auto bytes = file.value().bytes();
    folder_.write(as, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }

  TestFolder folder_;
  MediaStore store_;
  Diagnostics diagnostics_;
  nodes::Scene scene_;
  bifs::InitialObjectDescriptor initial_;
  ObjectStreams streams_;
  std::vector<uint16_t> es_ids_;
  std::vector<std::string> sources_;
};

TEST_F(ScenePacking, AnOctreeBecomesAStreamAndComesBackEqual) {
  const std::string original = std::string("Group { children [ DEF TREE ") + kOctreeText + " ] }";
  pack(original);
  ASSERT_EQ(streams_.size(), 1U);
  const auto& [id, media] = *streams_.begin();
  EXPECT_EQ(afx_object_code(media), 6);
  EXPECT_EQ(media.bytes(0).value(), encode_octree_stream({4, 2, {kFields}}).value());
  EXPECT_EQ(text(), nodes::write_scene_text(scene_of(
                        "Group { children BitWrapper { url \"od:" + std::to_string(id) +
                        "\" node DEF TREE OctreeImage { images [ DepthImage { } DepthImage { } ] "
                        "} } }")));
  expect_unpacked_equal(original);
  EXPECT_EQ(diagnostics_.count(), 0U) << warnings();
}

TEST_F(ScenePacking, StreamsAreListedBehindThoseOfTheSceneAndTheObjectDescriptors) {
  copy_vectors_picture("color32.jpg", "a.jpg");
  pack(std::string("Group { children [ ") + kOctreeText +
       " Shape { appearance Appearance { texture ImageTexture { url \"a.jpg\" } } } ] }");
  EXPECT_EQ(bifs::scene_stream(initial_)->es_id, 1);
  EXPECT_EQ(bifs::object_descriptor_stream(initial_)->es_id, 2);
  EXPECT_THAT(es_ids_, ElementsAre(3, 4));
  EXPECT_THAT(sources_, ElementsAre("a.jpg", "octree_od3.afx"));
}

TEST_F(ScenePacking, APictureWithTheNameOfAnOctreeKeepsIt) {
  copy_vectors_picture("color32.jpg", "octree_od3.afx");
  pack(std::string("Group { children [ ") + kOctreeText +
       " Background { frontUrl \"octree_od3.afx\" } ] }");
  EXPECT_THAT(sources_, ElementsAre("octree_od3.afx", "_octree_od3.afx"));
  EXPECT_EQ(still_picture_type(streams_.at(2)), bifs::object_type::kJpeg);
  EXPECT_EQ(afx_object_code(streams_.at(3)), kOctreeImageCode);
}

TEST_F(ScenePacking, AnOctreeInTheSceneItselfHasTheSameBytes) {
  const std::string original = std::string("Group { children ") + kOctreeText + " }";
  PackOptions options;
  options.octrees = Octrees::buffer;
  pack(original, options);
  EXPECT_TRUE(streams_.empty());
  EXPECT_EQ(bifs::object_descriptor_stream(initial_), nullptr);
  const NodeId wrapper = scene_.get<std::vector<NodeId>>(scene_.roots().at(0), "children").at(0);
  const Bytes bytes = encode_octree_stream({4, 2, {kFields}}).value();
  EXPECT_EQ(scene_.get<std::string>(wrapper, "buffer"), std::string(bytes.begin(), bytes.end()));
  expect_unpacked_equal(original);
}

TEST_F(ScenePacking, WithoutIndicesTheStreamHasNoTextures) {
  const std::string original =
      "Group { children OctreeImage { octreeResolution 3 octree [ 1 1 ] images DepthImage { } } }";
  pack(original);
  EXPECT_EQ(streams_.begin()->second.bytes(0).value(),
            encode_octree_stream({3, 0, {{{1, 1}, {}}}}).value());
  expect_unpacked_equal(original);
}

TEST_F(ScenePacking, ASharedOctreeIsSharedAsABitWrapper) {
  const std::string original = std::string("Group { children [ DEF T ") + kOctreeText +
                               " DEF T_BitWrapper Group { children USE T } ] }";
  pack(original);
  EXPECT_EQ(streams_.size(), 1U);
  EXPECT_THAT(text(), HasSubstr("DEF T_BitWrapper2 BitWrapper"));
  EXPECT_THAT(text(), HasSubstr("USE T_BitWrapper2"));
  EXPECT_THAT(text(), HasSubstr("DEF T OctreeImage"));
  expect_unpacked_equal(original);
  // The same through text.
  pack(original);
  scene_ = scene_of(text());
  expect_unpacked_equal(original);
}

TEST_F(ScenePacking, AnOctreeAtTheTopIsWrappedThere) {
  pack(kOctreeText);
  ASSERT_EQ(scene_.roots().size(), 1U);
  EXPECT_EQ(scene_.type_name(scene_.roots()[0]), "BitWrapper");
  expect_unpacked_equal(kOctreeText);
}

TEST_F(ScenePacking, RoutesToAnOctreesNeighboursStay) {
  const std::string original = std::string("Group { children [ DEF S Switch { choice ") +
                               kOctreeText +
                               " } DEF V Valuator { } ] } ROUTE V.outSFInt32 TO S.whichChoice";
  pack(original);
  expect_unpacked_equal(original);
}

TEST_F(ScenePacking, OctreesThatCannotBeCodedStayWithAWarning) {
  std::string images;
  for (int i = 0; i < 128; ++i) images += "DepthImage { } ";
  const std::string original =
      "PROTO P [ ] { OctreeImage { octreeResolution 2 octree 1 } } "
      "Group { children [ P { } "
      "OctreeImage { octreeResolution 4 octree [ 129 2 ] } "
      "OctreeImage { octreeResolution 0 octree [ 1 ] } "
      "OctreeImage { octreeResolution 2 octree 1 voxelImageIndex 1 images [ " +
      images + "] } OctreeImage { } ] }";
  pack(original);
  EXPECT_TRUE(nodes::equal(scene_, scene_of(original)));
  EXPECT_TRUE(streams_.empty());
  EXPECT_EQ(warnings(), "octree_in_proto octree_not_packed octree_not_packed octree_not_packed ");
}

TEST_F(ScenePacking, ThreadsChangeNothing) {
  std::string original = "Group { children [ ";
  for (int i = 1; i < 20; ++i)
    original += "OctreeImage { octreeResolution 2 octree " + std::to_string(i) + " } ";
  original += "] }";
  pack(original);
  const std::string one = text();
  std::vector<Bytes> streams;
  for (const auto& [id, media] : streams_) streams.push_back(media.bytes(0).value());
  PackOptions options;
  options.threads = 4;
  store_ = MediaStore();
  pack(original, options);
  EXPECT_EQ(text(), one);
  size_t i = 0;
  for (const auto& [id, media] : streams_) EXPECT_EQ(media.bytes(0).value(), streams.at(i++));
  EXPECT_EQ(i, 19U);
}

TEST_F(ScenePacking, PicturesBecomeStreamsAndComeBackByteForByte) {
  copy_vectors_picture("color32.jpg", "a b.jpg");
  copy_vectors_picture("depth32.png", "d.png");
  const std::string original =
      "PROTO P [ ] { ImageTexture { url \"d.png\" } } "
      "Group { children [ Background { frontUrl [ \"none.png\" \"d.png\" ] topUrl \"./d.png\" } "
      "DepthImage { diTexture SimpleTexture { texture ImageTexture { url \"a%20b.jpg\" } "
      "depth DEF D ImageTexture { url [ \"http://a/b.png\" \"d.png\" ] } } } "
      "DepthImage { diTexture SimpleTexture { texture P { } depth USE D } } ] }";
  pack(original);
  EXPECT_EQ(streams_.size(), 2U);  // a file is one stream
  EXPECT_EQ(diagnostics_.count(), 0U) << warnings();
  const std::vector<NamedFile> files = unpack();
  EXPECT_TRUE(nodes::equal(scene_, scene_of(original))) << text();
  std::set<std::string> names;
  for (const NamedFile& file : files) {
    names.insert(file.name);
    const std::string as = file.name == "a%20b.jpg" ? "a b.jpg" : "d.png";
    EXPECT_EQ(std::string(file.bytes.begin(), file.bytes.end()), folder_.read(as)) << file.name;
  }
  // Every name that a scene prefers leads to its picture again.
  EXPECT_EQ(names, (std::set<std::string>{"a%20b.jpg", "d.png", "none.png"}));
  EXPECT_EQ(files.size(), 3U);
}

TEST_F(ScenePacking, UrlsThatLeadToNoStillPictureStay) {
  folder_.write("a.txt", "no picture");
  const std::string original =
      "Group { children [ Background { frontUrl \"none.png\" backUrl [ \"a.txt\" ] topUrl [ 5 "
      "\"a.txt\" ] } Inline { url \"a.txt\" } ] }";
  pack(original);
  EXPECT_TRUE(nodes::equal(scene_, scene_of(original)));
  EXPECT_EQ(warnings(), "missing_picture picture_not_packed ");
}

TEST_F(ScenePacking, OptionsTurnItOff) {
  copy_vectors_picture("depth32.png", "d.png");
  const std::string original =
      std::string("Group { children [ Background { topUrl \"d.png\" } ") + kOctreeText + " ] }";
  PackOptions options;
  options.pictures = false;
  options.octrees = Octrees::none;
  pack(original, options);
  EXPECT_TRUE(nodes::equal(scene_, scene_of(original)));
  EXPECT_TRUE(initial_.parts.empty());
}

TEST_F(ScenePacking, IdsThatTheSceneUsesAreNotGivenAgain) {
  pack(
      "PROTO P [ field MFURL u [ 3 ] ] { Group { } } "
      "Group { children [ Inline { url [ 2 ] } OctreeImage { octreeResolution 2 octree 1 } "
      "OctreeImage { octreeResolution 2 octree 2 } ] }");
  std::vector<uint16_t> ids;
  for (const auto& [id, media] : streams_) ids.push_back(id);
  EXPECT_THAT(ids, ElementsAre(4, 5));  // 1 is that of the initial object descriptor
}

TEST_F(ScenePacking, MoreStreamsThanIdsAreAnErrorThatChangesNothing) {
  std::string text = "Group { children [ ";
  for (int i = 0; i < 1022; ++i) text += "OctreeImage { octreeResolution 2 octree 1 } ";
  text += "] }";
  bifs::Presentation presentation = presentation_of(text);
  const Status packed = pack_scene(presentation, "", {}, store_, diagnostics_);
  ASSERT_FALSE(packed.ok());
  EXPECT_THAT(packed.error().text, HasSubstr("needs 1022 streams"));
  EXPECT_EQ(presentation.units.size(), 1U);
  EXPECT_TRUE(presentation.initial.parts.empty());
  presentation = presentation_of(text);
  PackOptions options;
  options.octrees = Octrees::buffer;
  EXPECT_TRUE(pack_scene(presentation, "", options, store_, diagnostics_).ok());
}

TEST_F(ScenePacking, OnlyAPlainSceneIsPacked) {
  bifs::Presentation two = presentation_of("Group { }");
  two.units.push_back(two.units.front());
  EXPECT_EQ(pack_scene(two, "", {}, store_, diagnostics_).error().code, Errc::bad_argument);
  bifs::Presentation none;
  EXPECT_EQ(pack_scene(none, "", {}, store_, diagnostics_).error().code, Errc::bad_argument);
}

TEST_F(ScenePacking, IdsOfSharedNodesAreGivenToTheBitWrapperToo) {
  bifs::Presentation presentation =
      presentation_of(std::string("Group { children [ DEF T ") + kOctreeText + " USE T ] }");
  const NodeId octree = presentation.scene.find_name("T");
  presentation.scene.node(octree).id = 7;
  ASSERT_TRUE(pack_scene(presentation, "", {}, store_, diagnostics_).ok());
  const NodeId wrapper = presentation.scene.find_name("T_BitWrapper");
  ASSERT_TRUE(wrapper.valid());
  EXPECT_EQ(presentation.scene.node(wrapper).id, 8U);
  EXPECT_EQ(presentation.scene.node(octree).id, 7U);
}

}  // namespace
}  // namespace afx
