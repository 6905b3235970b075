// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/shapes/look_nodes.h"

#include <glm/vec3.hpp>

#include "afx/shapes/shape_test_support.h"

namespace afx {
namespace {

Result<Look> try_look(const std::string& appearance) {
  const auto scene = scene_of("Shape { appearance " + appearance + " geometry Box {} }");
  return read_look(first_root(*scene).child("appearance"));
}
Look look_from(const std::string& appearance) {
  const auto look = try_look(appearance);
  EXPECT_TRUE(look.ok()) << (look.ok() ? "" : look.error().text);
  return look.ok() ? look.value() : Look{};
}

TEST(Look, WithoutAppearanceOrMaterialItIsUnlitWhite) {
  for (const char* text : {"NULL", "Appearance {}", "Appearance { texture ImageTexture {} }"}) {
    const Look look = look_from(text);
    EXPECT_FALSE(look.lit);
    EXPECT_EQ(look.diffuse, glm::vec3(1));
    EXPECT_EQ(look.emissive, glm::vec3(1));
    EXPECT_EQ(look.transparency, 0);
  }
}

TEST(Look, AMaterialIsDrawnIntoItsRange) {
  const Look look = look_from(
      "Appearance { material Material { diffuseColor 2 0.5 -1 specularColor 1 0 0 emissiveColor 0 "
      "1 "
      "0 ambientIntensity 0.5 shininess 7 transparency 0.25 } }");
  EXPECT_TRUE(look.lit);
  EXPECT_EQ(look.diffuse, glm::vec3(1, 0.5F, 0));
  EXPECT_EQ(look.specular, glm::vec3(1, 0, 0));
  EXPECT_EQ(look.emissive, glm::vec3(0, 1, 0));
  EXPECT_EQ(look.ambient_intensity, 0.5F);
  EXPECT_EQ(look.shininess, 1);
  EXPECT_EQ(look.transparency, 0.25F);
  EXPECT_EQ(
      try_look("Appearance { material DEF M Material { diffuseColor 0 nan 0 } }").error().text,
      "Material \"M\": field diffuseColor is 0 nan 0 (expected 0 to 1)");
}

TEST(Look, AMaterial2DIsUnlitInItsColour) {
  const Look look =
      look_from("Appearance { material Material2D { emissiveColor 0 1 0 transparency 0.5 } }");
  EXPECT_FALSE(look.lit);
  EXPECT_EQ(look.diffuse, glm::vec3(0, 1, 0));
  EXPECT_EQ(look.transparency, 0.5F);
}

TEST(Look, TheTextureSaysHowItRepeats) {
  const Look look = look_from("Appearance { texture PixelTexture { repeatT FALSE } }");
  EXPECT_TRUE(look.repeat_s);
  EXPECT_FALSE(look.repeat_t);
}

glm::vec2 transformed(const std::string& fields, glm::vec2 point) {
  const Look look =
      look_from("Appearance { textureTransform TextureTransform { " + fields + " } }");
  const glm::vec3 p = look.texture_transform * glm::vec3(point, 1);
  EXPECT_EQ(p.z, 1);
  return {p.x, p.y};
}

TEST(Look, TextureTransformMovesTurnsAndScalesInThisOrder) {
  expect_near(transformed("", {3, 4}), {3, 4});
  expect_near(transformed("scale 2 3", {1, 1}), {2, 3});
  expect_near(transformed("translation 1 0 scale 2 2", {1, 1}), {4, 2});
  expect_near(transformed("rotation 1.5707963", {1, 0}), {0, 1});
  // (1, 0) moved by (1, 0), then by the center (1, 1): (3, 1); a quarter turn: (-1, 3); scaled:
  // (-2, 9); back by the center: (-3, 8).
  expect_near(transformed("translation 1 0 center 1 1 rotation 1.5707963 scale 2 3", {1, 0}),
              {-3, 8});
  EXPECT_EQ(
      try_look("Appearance { textureTransform TextureTransform { scale inf 1 } }").error().text,
      "TextureTransform: field scale is inf 1 (expected finite numbers)");
}

TEST(Look, ATextureTransformStaysFinite) {
  EXPECT_EQ(
      try_look("Appearance { textureTransform DEF T TextureTransform { scale 1e38 1 translation "
               "99 0 } }")
          .error()
          .text,
      "TextureTransform \"T\": moves the texture beyond all size");
}

std::shared_ptr<const Picture> texture_from(const std::string& text, Diagnostics& diagnostics) {
  const auto scene = scene_of("Shape { appearance Appearance { texture " + text + " } }");
  const auto picture = read_texture(first_root(*scene).child("appearance").child("texture"),
                                    UrlBase("/nowhere"), {}, diagnostics);
  EXPECT_TRUE(picture.ok());
  return picture.ok() ? picture.value() : nullptr;
}

TEST(Texture, PixelsAreAPicture) {
  Diagnostics diagnostics;
  const auto picture = texture_from("PixelTexture { image 1 2 3 0x010203 0x040506 }", diagnostics);
  ASSERT_NE(picture, nullptr);
  EXPECT_EQ(picture->samples, (std::vector<uint8_t>{4, 5, 6, 1, 2, 3}));  // the top row first
  EXPECT_EQ(texture_from("PixelTexture {}", diagnostics), nullptr);
  EXPECT_EQ(texture_from("NULL", diagnostics), nullptr);
  EXPECT_EQ(diagnostics.count(), 0U);
}

TEST(Texture, WhatCannotBeShownIsAWarning) {
  Diagnostics diagnostics;
  EXPECT_EQ(texture_from("DEF M MovieTexture {}", diagnostics), nullptr);
  EXPECT_EQ(texture_from("ImageTexture { url \"no.png\" }", diagnostics), nullptr);
  ASSERT_EQ(diagnostics.count(), 2U);
  EXPECT_EQ(diagnostics.warnings()[0].code, "texture_not_shown");
  EXPECT_EQ(diagnostics.warnings()[0].text,
            "MovieTexture \"M\": has a texture of type MovieTexture (expected ImageTexture or "
            "PixelTexture); it is drawn without");
  EXPECT_NE(diagnostics.warnings()[1].text.find("no.png"), std::string::npos)
      << diagnostics.warnings()[1].text;
}

}  // namespace
}  // namespace afx
