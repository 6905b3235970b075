// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/mesh_look.h"

#include <gtest/gtest.h>

#include <cmath>

#include "afx/builder/test_meshes.h"

namespace afx {
namespace {

DepthCamera front(double side) { return {{0, 0, 10}, {1, 0, 0, 0}, true, {side, side}, 8, 12}; }

Picture chequered() {
  Picture picture(2, 2, 3);  // red, green / blue, white
  picture.samples = {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255};
  return picture;
}

const SimpleTexture& simple(const Result<DepthImage>& image) {
  return std::get<SimpleTexture>(image.value().texture);
}

TEST(DrawDepthImage, GivesColourAndDepthOfTheNearestSurface) {
  Mesh square = textured_square(chequered());
  square.materials[0].wrap_u = square.materials[0].wrap_v = Wrap::clamp;
  const MeshLook look(square, Shade::never);
  const auto image = draw_depth_image(look, {front(4), 16, 16}, 16, 1, {});
  ASSERT_TRUE(image.ok()) << image.error().text;
  ASSERT_TRUE(check_depth_image(image.value()).ok());
  const SimpleTexture& texture = simple(image);
  // The square covers pixels 4..11. Its plane lies in the middle between near and far plane.
  const uint16_t middle = 32768;  // 1 + 65534/2
  for (uint32_t y = 0; y < 16; ++y)
    for (uint32_t x = 0; x < 16; ++x) {
      const bool inside = x >= 4 && x < 12 && y >= 4 && y < 12;
      EXPECT_EQ(texture.depth.samples[y * 16 + x], inside ? middle : 0);
    }
  EXPECT_EQ(colour_at(texture.colour, 4, 4),
            (Rgba8{255, 0, 0, 255}));  // far from the texels' borders
  EXPECT_EQ(colour_at(texture.colour, 11, 4), (Rgba8{0, 255, 0, 255}));
  EXPECT_EQ(colour_at(texture.colour, 4, 11), (Rgba8{0, 0, 255, 255}));
  EXPECT_EQ(colour_at(texture.colour, 11, 11), (Rgba8{255, 255, 255, 255}));
}

TEST(DrawDepthImage, APixelOfManyTexelsIsTheirMeanInLinearLight) {
  Picture stripes(64, 64, 3);  // columns of black and white
  for (size_t i = 0; i < stripes.samples.size(); ++i)
    stripes.samples[i] = (i / 3) % 2 == 0 ? 0 : 255;
  const Mesh square = textured_square(stripes);
  const MeshLook look(square, Shade::never);
  const auto image = draw_depth_image(look, {front(2), 4, 4}, 8, 1, {});
  ASSERT_TRUE(image.ok());
  const Rgba8 mean = colour_at(simple(image).colour, 1, 2);
  EXPECT_NEAR(mean.r, 188, 1);  // half the light: 0.5^(1/2.4) * 1.055 - 0.055 = 0.735
}

TEST(DrawDepthImage, LooksThroughTransparentTexels) {
  Picture window(2, 1, 4);  // opaque red, transparent green
  window.samples = {255, 0, 0, 255, 0, 255, 0, 0};
  Mesh mesh = textured_square(window);
  mesh.materials[0].alpha_cutoff = 0.5F;
  const MeshLook look(mesh, Shade::never);
  const auto image = draw_depth_image(look, {front(2), 8, 8}, 8, 1, {});
  ASSERT_TRUE(image.ok());
  EXPECT_NE(simple(image).depth.samples[0], 0);
  EXPECT_EQ(simple(image).depth.samples[5], 0);  // beyond the middle texel border, green
  EXPECT_EQ(colour_at(simple(image).colour, 0, 0), (Rgba8{255, 0, 0, 255}));
}

TEST(DrawDepthImage, DepthsOfASphereAreThoseOfTheClosedForm) {
  const Mesh sphere = sphere_mesh(6);
  const MeshLook look(sphere, Shade::automatic);
  const uint32_t size = 64;
  const Shot shot{front(2.5), size, size};
  const auto image = draw_depth_image(look, shot, 16, 2, {});
  ASSERT_TRUE(image.ok());
  for (uint32_t y = 0; y < size; ++y)
    for (uint32_t x = 0; x < size; ++x) {
      const double px = ((x + 0.5) / size - 0.5) * 2.5, py = ((y + 0.5) / size - 0.5) * 2.5;
      const double r2 = px * px + py * py;
      const uint16_t depth = simple(image).depth.samples[y * size + x];
      if (r2 > 1) {
        EXPECT_EQ(depth, 0);
      }
      if (r2 > 0.9) continue;
      const double distance = depth_to_distance(depth, 65535, shot.camera);
      EXPECT_NEAR(distance, 10 - std::sqrt(1 - r2), 2e-3);
    }
}

TEST(DrawDepthImage, IsTheSameForAnyNumberOfThreads) {
  const Mesh sphere = sphere_mesh(4);
  const MeshLook look(sphere, Shade::automatic);
  const auto one = draw_depth_image(look, {front(2.5), 90, 70}, 16, 1, {});
  const auto four = draw_depth_image(look, {front(2.5), 90, 70}, 16, 4, {});
  EXPECT_EQ(simple(one).colour.samples, simple(four).colour.samples);
  EXPECT_EQ(simple(one).depth.samples, simple(four).depth.samples);
}

TEST(DrawDepthImage, RefusesWhatCannotBe) {
  const Mesh mesh = box_mesh({-1, -1, -1}, {1, 1, 1});
  const MeshLook look(mesh, Shade::never);
  EXPECT_EQ(draw_depth_image(look, {front(4), 4, 4}, 12, 1, {}).error().text,
            "the depths have 12 bits (expected 8 or 16)");
  EXPECT_EQ(draw_depth_image(look, {front(4), 0, 4}, 8, 1, {}).error().text,
            "the picture is 0 x 4 pixels (expected 1 to 65535 along a side)");
  Limits small;
  small.picture_pixels = 15;
  EXPECT_EQ(draw_depth_image(look, {front(4), 4, 4}, 8, 1, small).error().code,
            Errc::limit_exceeded);
}

TEST(DrawPicture, EdgesAreMixedByThePartThatIsCovered) {
  const Mesh box = box_mesh({-1, -1, -1}, {0.25, 1, 1}, {1, 1, 1});
  const MeshLook look(box, Shade::never);
  // Pixels of side 0.5: the box ends in the middle of a pixel.
  const auto clear = draw_picture(look, {front(4), 8, 8}, 4, {0, 0, 0, 0}, 1, {});
  ASSERT_TRUE(clear.ok());
  EXPECT_EQ(colour_at(clear.value(), 3, 4), (Rgba8{255, 255, 255, 255}));
  EXPECT_EQ(colour_at(clear.value(), 4, 4), (Rgba8{255, 255, 255, 128}));
  EXPECT_EQ(colour_at(clear.value(), 5, 4), (Rgba8{0, 0, 0, 0}));
  const auto black = draw_picture(look, {front(4), 8, 8}, 4, {0, 0, 0, 255}, 1, {});
  EXPECT_NEAR(colour_at(black.value(), 4, 4).r, 188, 1);  // half the light
  EXPECT_EQ(colour_at(black.value(), 4, 4).a, 255);
}

}  // namespace
}  // namespace afx
