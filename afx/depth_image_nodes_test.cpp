// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/depth_image_nodes.h"

#include <gtest/gtest.h>

#include <string>

#include "afx/dibr_model.h"
#include "afx/file.h"
#include "afx/file_test_folder.h"
#include "afx/picture_io.h"
#include "nodes/scene_reader.h"
#include "nodes/scene_writer.h"

namespace afx {
namespace {

struct Read {
  Result<std::vector<DibrModel>> models;
  Diagnostics diagnostics;
};

// Reads the objects of a scene text.
Read read(const std::string& text, const std::string& folder = {}) {
  Diagnostics diagnostics;
  const auto scene = nodes::read_scene_text(text, {}, diagnostics);
  EXPECT_TRUE(scene.ok()) << (scene.ok() ? "" : scene.error().text);
  if (!scene.ok()) return {scene.error(), {}};
  auto models = read_dibr_models(scene.value(), UrlBase(folder), {}, diagnostics);
  return {std::move(models), std::move(diagnostics)};
}

const DepthImage& only(const Read& read) {
  return read.models.value().at(0).depth_images()->at(0);
}

std::string error_of(const std::string& text) {
  const Read got = read(text);
  return got.models.ok() ? "ok" : got.models.error().text;
}

std::string scene_with(const std::string& texture, const std::string& camera = "") {
  return "Group { children Transform { translation 0 0 5 children DepthImage { " + camera +
         " diTexture " + texture + " } } }";
}

TEST(DepthImageNodes, PixelTexturesGiveColourAndDepthWithTheBottomRowFirst) {
  const Read got = read(scene_with(
      "SimpleTexture { texture PixelTexture { image 2 2 3 0x010203 0x040506 0x070809 0x0A0B0C }"
      " depth PixelTexture { image 2 2 1 0 1 200 255 } }",
      "position 1 2 3 orthographic FALSE fieldOfView 1 0.5 nearPlane 2 farPlane 4"));
  ASSERT_TRUE(got.models.ok()) << got.models.error().text;
  EXPECT_EQ(got.models.value()[0].to_world[3].z, 5);
  const DepthImage& image = only(got);
  EXPECT_EQ(image.camera, (DepthCamera{{1, 2, 3}, {1, 0, 0, 0}, false, {1, 0.5}, 2, 4}));
  const auto& texture = std::get<SimpleTexture>(image.texture);
  EXPECT_EQ(colour_at(texture.colour, 0, 0), (Rgba8{7, 8, 9, 255}));  // the upper left pixel
  EXPECT_EQ(texture.depth.samples, (std::vector<uint16_t>{200, 255, 0, 1}));
  EXPECT_EQ(texture.dmax(), 255U);
}

TEST(DepthImageNodes, WithoutADepthFieldAlphaIsTheDepthAndTheColourOpaque) {
  const Read got = read(
      scene_with("SimpleTexture { texture PixelTexture { image 2 1 4 0x01020300 0x040506FF } }"));
  ASSERT_TRUE(got.models.ok()) << got.models.error().text;
  const auto& texture = std::get<SimpleTexture>(only(got).texture);
  EXPECT_EQ(texture.colour.components, 3U);
  EXPECT_EQ(colour_at(texture.colour, 1, 0), (Rgba8{4, 5, 6, 255}));
  EXPECT_EQ(texture.depth.samples, (std::vector<uint16_t>{0, 255}));
}

TEST(DepthImageNodes, SixteenBitsOfDepthAreReadFromAPngAsTheyAreStored) {
  const TestFolder folder;
  Picture colour(1, 2, 3);
  DeepPicture depth{1, 2, 1, 16, {0x0102, 0xFFFF}};
  const auto colours = encode_picture(colour, "png");
  const auto depths = encode_picture(depth, "png", {.colour = false});
  ASSERT_TRUE(colours.ok() && depths.ok());
  ASSERT_TRUE(write_file_atomically(folder.path("c.png"), colours.value(), true).ok());
  ASSERT_TRUE(write_file_atomically(folder.path("d.png"), depths.value(), true).ok());
  const Read got = read(scene_with("SimpleTexture { texture ImageTexture { url \"c.png\" }"
                                   " depth ImageTexture { url \"d.png\" } }"),
                        folder.path(""));
  ASSERT_TRUE(got.models.ok()) << got.models.error().text;
  const auto& texture = std::get<SimpleTexture>(only(got).texture);
  EXPECT_EQ(texture.depth.bits, 16U);
  EXPECT_EQ(texture.depth.samples, depth.samples);
}

TEST(DepthImageNodes, APointTextureListsTheDepthsOfEachPixelFromTheBottom) {
  const Read got =
      read(scene_with("PointTexture { width 2 height 2 depthNbBits 3 depth [ 1 15  0  2 9 0  0 ]"
                      " color [ 1 0 0, 0 1 0, 0 0 1 ] }"));
  ASSERT_TRUE(got.models.ok()) << got.models.error().text;
  const auto& points = std::get<PointTexture>(only(got).texture);
  EXPECT_EQ(points.depth_bits, 4U);
  EXPECT_EQ(points.dmax(), 15U);
  EXPECT_EQ(points.starts, (std::vector<uint32_t>{0, 1, 1, 3, 3}));
  EXPECT_EQ(points.depths, (std::vector<uint32_t>{15, 9, 1}));  // 0 counts as the far plane
  EXPECT_EQ(points.colours[2], (Rgba8{0, 0, 255, 255}));
  ASSERT_EQ(got.diagnostics.warnings().size(), 1U);
  EXPECT_EQ(got.diagnostics.warnings()[0].code, "zero_depth");
}

TEST(DepthImageNodes, WhatIsWrittenIsReadAgain) {
  const DepthCamera camera =
      as_in_node({{0.1, 0, 2}, glm::angleAxis(0.7, glm::dvec3(0, 1, 0)), true, {1, 2}, 1.5, 2.5});
  PointTexture points{2, 1, 32, {0, 2, 3}, {0xFFFFFFFF, 7, 0x80000000}, {}};
  points.colours = {{1, 2, 3, 255}, {4, 5, 6, 255}, {255, 0, 128, 255}};
  nodes::Scene scene;
  const auto top = scene.add("Group");
  ASSERT_TRUE(scene.append(top.value(), "children", add_depth_image(scene, camera, points)).ok());
  scene.add_root(top.value());
  const Read got = read(nodes::write_scene_text(scene, {}));
  ASSERT_TRUE(got.models.ok()) << got.models.error().text;
  DepthCamera read_again = only(got).camera;
  EXPECT_NEAR(glm::dot(read_again.orientation, camera.orientation), 1, 1e-12);
  read_again.orientation = camera.orientation;
  EXPECT_EQ(read_again, camera);
  EXPECT_EQ(std::get<PointTexture>(only(got).texture), points);
}

TEST(DepthImageNodes, ErrorsNameNodeAndField) {
  EXPECT_EQ(error_of("Group { children DepthImage { } }"),
            "DepthImage: field diTexture is NULL (expected a texture)");
  EXPECT_EQ(error_of(scene_with("SimpleTexture { }")), "SimpleTexture: has no texture");
  EXPECT_EQ(error_of(scene_with("SimpleTexture { texture PixelTexture { image 1 1 3 0 } }")),
            "SimpleTexture: has neither a depth field nor an alpha channel in its texture");
  EXPECT_EQ(error_of(scene_with("SimpleTexture { texture PixelTexture { image 1 1 3 0 }"
                                " depth PixelTexture { image 1 1 3 0 } }")),
            "SimpleTexture: depth has 3 components (expected one or two)");
  EXPECT_EQ(error_of(scene_with("SimpleTexture { texture PixelTexture { image 1 1 3 0 }"
                                " depth PixelTexture { image 2 1 1 0 0 } }")),
            "SimpleTexture: texture and depth differ in size: 1 x 1 and 2 x 1 pixels");
  EXPECT_EQ(error_of(scene_with("SimpleTexture { texture MovieTexture { } }")),
            "SimpleTexture: has a texture of type MovieTexture (expected ImageTexture or "
            "PixelTexture)");
  EXPECT_EQ(error_of(scene_with("SimpleTexture { }", "nearPlane 5 farPlane 5")),
            "DepthImage: field farPlane is 5 (expected more than nearPlane)");
}

TEST(DepthImageNodes, ErrorsOfPointsSayWhichPixelAndHowMany) {
  const auto points = [](const std::string& lists) {
    return error_of(scene_with("PointTexture { width 2 height 1 " + lists + " }"));
  };
  EXPECT_EQ(points("depth [ 1 ]"),
            "PointTexture: field depth has 1 values for 2 pixels (expected at least one a pixel)");
  EXPECT_EQ(points("depth [ 0 2 9 ]"),
            "PointTexture: field depth ends inside pixel (1, 0), after 3 values");
  EXPECT_EQ(points("depth [ 3 9 9 9 ]"),
            "PointTexture: field depth ends inside pixel (1, 0), after 4 values");
  EXPECT_EQ(points("depth [ 0 -1 ]"),
            "PointTexture: field depth: pixel (1, 0) has -1 depths (expected 0 or more)");
  EXPECT_EQ(points("depth [ 0 0 5 5 ]"),
            "PointTexture: field depth has 2 values left over after the last pixel");
  EXPECT_EQ(points("depth [ 1 256 0 ]"),
            "PointTexture: field depth: pixel (0, 0) has the depth 256 (expected at most 255)");
  EXPECT_EQ(points("depth [ 1 -7 0 ]"),
            "PointTexture: field depth: pixel (0, 0) has the depth -7 (expected 0 or more)");
  EXPECT_EQ(points("depth [ 1 7 0 ]"), "PointTexture: field color has 0 colours for 1 depths");
  EXPECT_EQ(points("depthNbBits 32 depth [ 0 0 ]"),
            "PointTexture: field depthNbBits is 32 (expected 0 to 31)");
  EXPECT_EQ(error_of(scene_with("PointTexture { width 0 height 1 }")),
            "PointTexture: field width is 0 (expected at least 1)");
}

TEST(DepthImageNodes, DepthAsAlphaIsReadBack) {
  SimpleTexture texture{Picture(2, 1, 3), {2, 1, 1, 16, {0, 40000}}};
  texture.colour.samples = {1, 2, 3, 250, 251, 252};
  const TestFolder folder;
  const auto bytes = encode_picture(with_depth_as_alpha(texture), "png");
  ASSERT_TRUE(bytes.ok());
  ASSERT_TRUE(write_file_atomically(folder.path("x.png"), bytes.value(), true).ok());
  const Read got =
      read(scene_with("SimpleTexture { texture ImageTexture { url \"x.png\" } }"), folder.path(""));
  ASSERT_TRUE(got.models.ok()) << got.models.error().text;
  const auto& back = std::get<SimpleTexture>(only(got).texture);
  EXPECT_EQ(back.colour.samples, texture.colour.samples);
  EXPECT_EQ(back.depth.samples, texture.depth.samples);
}

TEST(DepthImageNodes, DepthAsAlphaFillsAllOfItsBits) {
  SimpleTexture texture{Picture(4, 1, 1), {4, 1, 1, 10, {0, 1, 512, 1023}}};
  DeepPicture both = with_depth_as_alpha(texture);
  EXPECT_EQ(both.bits, 16U);
  EXPECT_EQ(both.samples, (std::vector<uint16_t>{0, 0, 0, 1, 0, 32768, 0, 65535}));
  texture.depth = {4, 1, 1, 2, {0, 1, 2, 3}};
  both = with_depth_as_alpha(texture);
  EXPECT_EQ(both.bits, 8U);
  EXPECT_EQ(both.samples, (std::vector<uint16_t>{0, 0, 0, 1, 0, 128, 0, 255}));
}

}  // namespace
}  // namespace afx
