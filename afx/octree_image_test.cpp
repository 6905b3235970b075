// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/octree_image.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "afx/octree_stream.h"
#include "afx/scene_files.h"
#include "nodes/scene_reader.h"
#include "nodes/scene_writer.h"

namespace afx {
namespace {

namespace fs = std::filesystem;

class OctreeImage : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "octree_image_XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::vector<uint8_t>& bytes) const {
    std::ofstream(fs::path(folder_) / name, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
  }
  /// The only OctreeImage of a scene.
  Result<OctreeNode> read(const std::string& text) {
    scene_ = nodes::read_scene_text(text, {}, diagnostics_).value();
    const auto found = find_octree_images(scene_);
    EXPECT_EQ(found.size(), 1U);
    return read_octree_node(found.at(0), folder_, {}, diagnostics_);
  }

  std::string folder_;
  Diagnostics diagnostics_;
  nodes::Scene scene_;
};

const OctreeFields kFields{{0x81, 0x02, 0x41}, {0, 2, 0, 1, 0}};

TEST_F(OctreeImage, FieldsComeBackFromTheNodeMadeOfThem) {
  nodes::Scene scene;
  const OctreeNode octree{4, 2, kFields};
  scene.add_root(add_octree_image(scene, octree));
  const auto back = read(nodes::write_scene_text(scene));
  ASSERT_TRUE(back.ok()) << back.error().text;
  EXPECT_EQ(back.value().resolution, 4U);
  EXPECT_EQ(back.value().images, 2U);
  EXPECT_EQ(back.value().fields, kFields);
}

TEST_F(OctreeImage, ABitWrapperTakesItsFieldsFromTheFirstUrlThatIsThere) {
  write("a b.afx", encode_octree_stream({4, 2, {kFields}}).value());
  for (const char* url :
       {"\"a b.afx\"", "\"a%20b.afx\"", "\"file:a b.afx\"", "[ \"none.afx\" \"a b.afx\" ]"}) {
    const auto back = read(
        std::string(
            "BitWrapper { node OctreeImage { images [ DepthImage { } DepthImage { } ] } url ") +
        url + " }");
    ASSERT_TRUE(back.ok()) << url << ": " << back.error().text;
    EXPECT_EQ(back.value().fields, kFields);
    EXPECT_EQ(back.value().resolution, 4U);
  }
  EXPECT_EQ(diagnostics_.count(), 0U);
}

TEST_F(OctreeImage, ABitWrapperMayHoldItsStreamItself) {
  // One voxel: 0C 00 00 00 01 C8 40, as octree_stream_test.cpp derives it.
  const auto back = read(
      "BitWrapper { node OctreeImage { } buffer \"data:application/octet-string,0C00000001C840\" "
      "}");
  ASSERT_TRUE(back.ok()) << back.error().text;
  EXPECT_EQ(back.value().resolution, 1U);
}

TEST_F(OctreeImage, WhatABitWrapperDropsOrReplacesIsAWarning) {
  write("two.afx", encode_octree_stream({4, 2, {kFields, kFields}}).value());
  const auto back = read(
      "BitWrapper { node OctreeImage { octree 7 images [ DepthImage { } DepthImage { } ] } url "
      "\"two.afx\" }");
  ASSERT_TRUE(back.ok());
  ASSERT_EQ(diagnostics_.count(), 2U);
  EXPECT_EQ(diagnostics_.warnings()[0].code, "frames_left_out");
  EXPECT_EQ(diagnostics_.warnings()[1].code, "bitwrapper_fields");
  EXPECT_EQ(fs::path(diagnostics_.warnings()[0].file).filename(), "two.afx");
}

TEST_F(OctreeImage, SaysWhatIsWrongWithANode) {
  write("six.afx", encode_octree_stream({4, 6, {{kFields.octree, {6}}}}).value());
  const std::pair<const char*, const char*> cases[] = {
      {"OctreeImage { octreeResolution 0 }",
       "OctreeImage: field octreeResolution is 0 (expected at least 1)"},
      {"DEF A OctreeImage { octree [ 1 -1 ] }",
       "OctreeImage \"A\": field octree has -1 at position 1 (expected 0..255)"},
      {"OctreeImage { voxelImageIndex 256 }",
       "OctreeImage: field voxelImageIndex has 256 at position 0 (expected 0..255)"},
      {"BitWrapper { node OctreeImage { } }",
       "BitWrapper: has neither of url and buffer (expected one)"},
      {"BitWrapper { node OctreeImage { } url \"a\" buffer \"0x00\" }",
       "BitWrapper: has both of url and buffer (expected one)"},
      {"BitWrapper { node OctreeImage { } type 1 url \"a\" }",
       "BitWrapper: coding type 1 is not known (expected 0)"},
      {"BitWrapper { node OctreeImage { } url \"od:10\" }",
       "BitWrapper: url od:10 names an object descriptor (expected a file)"},
      {"BitWrapper { node OctreeImage { } url \"http://x/y\" }",
       "BitWrapper: url \"http://x/y\" is not a file name"},
      {"BitWrapper { node OctreeImage { } url \"six.afx\" }",
       "BitWrapper: its stream has numOfTextures 6, but its node has 0 images"},
  };
  for (const auto& [text, expected] : cases) {
    const auto back = read(text);
    ASSERT_FALSE(back.ok()) << text;
    EXPECT_EQ(back.error().text, expected);
  }
}

TEST_F(OctreeImage, AUrlReadsRegularFilesOnly) {
  for (const char* url : {"-", "/dev/zero", "."}) {
    const auto back = read(std::string("BitWrapper { node OctreeImage { } url \"") + url + "\" }");
    ASSERT_FALSE(back.ok()) << url;
    EXPECT_EQ(back.error().code, Errc::io) << url;
  }
}

TEST_F(OctreeImage, PixelTexturesHaveTheirBottomRowFirst) {
  scene_ =
      nodes::read_scene_text(
          "OctreeImage { images DepthImage { position 1 2 3 fieldOfView 4 5 "
          "diTexture SimpleTexture { texture PixelTexture { image 1 2 3 0x010203 0x040506 } } } }",
          {}, diagnostics_)
          .value();
  const auto model = read_octree_model(find_octree_images(scene_).at(0), folder_, {}, diagnostics_);
  ASSERT_TRUE(model.ok()) << model.error().text;
  ASSERT_EQ(model.value().images.size(), 1U);
  const ReferenceImage& image = model.value().images[0];
  EXPECT_EQ(image.picture.samples, (std::vector<uint8_t>{4, 5, 6, 1, 2, 3}));
  EXPECT_EQ(image.position, glm::vec3(1, 2, 3));
  EXPECT_EQ(image.field_of_view, glm::vec2(4, 5));
  EXPECT_EQ(diagnostics_.count(), 0U);
}

TEST_F(OctreeImage, AMissingPictureIsAWarning) {
  scene_ = nodes::read_scene_text(
               "OctreeImage { images [ DepthImage { orthographic FALSE } DepthImage { diTexture "
               "SimpleTexture { texture ImageTexture { url \"none.png\" } } } ] }",
               {}, diagnostics_)
               .value();
  const auto model = read_octree_model(find_octree_images(scene_).at(0), folder_, {}, diagnostics_);
  ASSERT_TRUE(model.ok());
  ASSERT_EQ(diagnostics_.count(), 3U);
  EXPECT_EQ(diagnostics_.warnings()[0].code, "perspective_image");
  EXPECT_EQ(diagnostics_.warnings()[1].code, "missing_picture");
  EXPECT_EQ(diagnostics_.warnings()[2].code, "missing_picture");
}

TEST_F(OctreeImage, AreFoundOnceInScenesWrappersAndPrototypes) {
  scene_ = nodes::read_scene_text(
               "PROTO P [ ] { OctreeImage { octreeResolution 8 } } Group { children [ DEF A "
               "OctreeImage { } USE A "
               "BitWrapper { node OctreeImage { } url \"x\" } P { } Switch { choice OctreeImage { "
               "} } ] }",
               {}, diagnostics_)
               .value();
  std::string types;
  for (const nodes::NodeView& view : find_octree_images(scene_))
    types += std::string(view.type()) + " ";
  EXPECT_EQ(types, "OctreeImage BitWrapper OctreeImage OctreeImage ");
}

TEST(SceneFiles, PercentCodesAreDecoded) {
  EXPECT_EQ(percent_decoded("a%20b%2Fc"), "a b/c");
  EXPECT_EQ(percent_decoded("100%"), "100%");
  EXPECT_EQ(percent_decoded("%zz%4"), "%zz%4");
}

}  // namespace
}  // namespace afx
