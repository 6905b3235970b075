// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/surfel_drawing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/gtc/constants.hpp>
#include <tuple>

#include "afx/srgb.h"
#include "afx/surfel_sources.h"
#include "afx/surfel_test_models.h"

namespace afx {
namespace {

Surfels surfels_or_fail(const DepthImage& image) {
  auto surfels = surfels_of(image, 1, {});
  EXPECT_TRUE(surfels.ok()) << surfels.error().text;
  return surfels.ok() ? surfels.value() : Surfels{};
}

SimpleTexture draw_or_fail(const Surfels& surfels, const DepthCamera& camera, uint32_t width,
                           uint32_t height, unsigned bits, unsigned threads = 1) {
  auto image = draw_surfels(surfels, {camera, width, height}, bits, threads, {});
  EXPECT_TRUE(image.ok()) << image.error().text;
  if (!image.ok()) return {};
  EXPECT_TRUE(check_depth_image(image.value()).ok());
  return std::get<SimpleTexture>(image.value().texture);
}

// Looks along -z from z = 0 at a box 4 wide and 4 high, 1 to 9 away.
DepthCamera plain_camera() { return {{0, 0, 0}, {1, 0, 0, 0}, true, {4, 4}, 1, 9}; }

// A square piece of side 2 * half that faces the plain camera.
void add_square(Surfels& surfels, const glm::dvec3& centre, float half, Rgba8 colour,
                bool facing = true) {
  const glm::vec3 u(half, 0, 0), v(0, half, 0);
  surfels.push_back(centre, facing ? u : v, facing ? v : u, colour);
}

Rgba8 linear_mean(std::initializer_list<Rgba8> colours) {
  const auto& linear = srgb_to_linear();
  glm::dvec3 sum(0);
  for (const Rgba8 c : colours) sum += glm::dvec3(linear[c.r], linear[c.g], linear[c.b]);
  const glm::vec3 mean(sum / static_cast<double>(colours.size()));
  return {linear_to_srgb(mean.r), linear_to_srgb(mean.g), linear_to_srgb(mean.b), 255};
}

class RoundTrip : public ::testing::TestWithParam<std::tuple<bool, unsigned, uint32_t>> {};

TEST_P(RoundTrip, InItsOwnCameraADepthImageComesBackExactly) {
  const auto [orthographic, bits, components] = GetParam();
  for (uint32_t seed = 1; seed <= 5; ++seed) {
    const DepthImage image{test_camera(orthographic),
                           rough_texture(71, 53, bits, components, seed)};
    const auto& texture = std::get<SimpleTexture>(image.texture);
    const SimpleTexture again = draw_or_fail(surfels_or_fail(image), image.camera, 71, 53, bits);
    EXPECT_EQ(again.depth.bits, bits);
    EXPECT_EQ(again.depth.samples, texture.depth.samples);
    ASSERT_EQ(again.colour.components, components == 4 ? 4U : 3U);
    if (components == 4 || components == 3) {
      EXPECT_EQ(again.colour.samples, texture.colour.samples);
    }
    for (uint32_t y = 0; y < 53; ++y)
      for (uint32_t x = 0; x < 71; ++x)
        ASSERT_EQ(colour_at(again.colour, x, y), colour_at(texture.colour, x, y));
  }
}

INSTANTIATE_TEST_SUITE_P(All, RoundTrip,
                         ::testing::Combine(::testing::Bool(), ::testing::Values(8U, 16U, 3U),
                                            ::testing::Values(1U, 3U, 4U)));

TEST(DrawSurfels, GiveTheSameForAnyNumberOfThreads) {
  Diagnostics diagnostics;
  const auto surfels = surfels_of(octree_of(sphere_voxels(6, 0.45), 6), 1, {}, diagnostics);
  ASSERT_TRUE(surfels.ok());
  DepthCamera camera;
  camera.position = {0, 0, 2};
  camera.orthographic = false;
  camera.near_plane = 1;
  camera.far_plane = 3;
  const SimpleTexture one = draw_or_fail(surfels.value(), camera, 200, 150, 16, 1);
  const SimpleTexture four = draw_or_fail(surfels.value(), camera, 200, 150, 16, 4);
  EXPECT_EQ(one.colour.samples, four.colour.samples);
  EXPECT_EQ(one.depth.samples, four.depth.samples);
}

// Seen from many sides, no line of sight passes between the voxels of a sphere to its far wall.
TEST(DrawSurfels, ASphereOfVoxelsHasNoHoles) {
  constexpr unsigned kLevels = 5;
  constexpr double kRadius = 0.42, kVoxel = 1.0 / (1 << kLevels);
  Diagnostics diagnostics;
  const auto surfels =
      surfels_of(octree_of(sphere_voxels(kLevels, kRadius), kLevels), 1, {}, diagnostics);
  ASSERT_TRUE(surfels.ok());
  constexpr uint32_t kSide = 150;  // 4.7 pixels a voxel
  std::mt19937 random(11);
  std::uniform_real_distribution<double> part(-1, 1);
  for (int view = 0; view < 40; ++view) {
    DepthCamera camera{{0, 0, 0}, {1, 0, 0, 0}, true, {1, 1}, 1, 3};
    if (view > 0)
      camera.orientation =
          glm::normalize(glm::dquat(part(random), part(random), part(random), part(random)));
    camera.position = camera.orientation * glm::dvec3(0, 0, 2);
    const SimpleTexture seen = draw_or_fail(surfels.value(), camera, kSide, kSide, 16);
    for (uint32_t y = 0; y < kSide; ++y)
      for (uint32_t x = 0; x < kSide; ++x) {
        const double dx = (x + 0.5) / kSide - 0.5, dy = (y + 0.5) / kSide - 0.5;
        const double inside = kRadius * kRadius - dx * dx - dy * dy;
        if (std::hypot(dx, dy) > kRadius - kVoxel) continue;  // the outline is as rough as voxels
        const uint16_t depth = seen.depth.samples[size_t{y} * kSide + x];
        EXPECT_NE(depth, 0) << view << ": " << x << ' ' << y;
        const double distance = depth_to_distance(depth, 65535, camera);
        // The front, as far as voxels show it; towards the rim its distance changes fast.
        const double slope = kRadius / std::max(std::sqrt(inside), 0.1);
        EXPECT_NEAR(distance, 2 - std::sqrt(inside), 1.6 * kVoxel * slope)
            << view << ": " << x << ' ' << y;
      }
  }
}

TEST(DrawSurfels, ManySmallPiecesInAPixelAreAveragedInLinearLight) {
  // Stripes of black and white, 4 to a pixel and 4 rows of them.
  Surfels surfels;
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) {
      const uint8_t grey = x % 2 == 0 ? 0 : 255;
      add_square(surfels, {(x - 7.5) / 4, (y - 7.5) / 4, -5}, 0.125F, {grey, grey, grey, 255});
    }
  const SimpleTexture seen = draw_or_fail(surfels, plain_camera(), 4, 4, 8);
  for (const uint8_t sample : seen.colour.samples) EXPECT_EQ(sample, 188);  // 0.5 in linear light
}

TEST(DrawSurfels, NoPatternOfALineInThreeIsSeenInACoarserPicture) {
  // One black column in three, wherever the pixels fall: a third is black, 2/3 of light is 213.
  Surfels surfels;
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 96; ++x) {
      const uint8_t grey = x % 3 == 0 ? 0 : 255;
      add_square(surfels, {(x - 47.5) / 24, (y - 47.5) / 24, -5}, 1 / 48.0F,
                 {grey, grey, grey, 255});
    }
  const SimpleTexture seen = draw_or_fail(surfels, plain_camera(), 32, 32, 8);
  for (const uint8_t sample : seen.colour.samples) EXPECT_NEAR(sample, 213, 12);
  const SimpleTexture coarse = draw_or_fail(surfels, plain_camera(), 10, 10, 8);
  for (const uint8_t sample : coarse.colour.samples) EXPECT_NEAR(sample, 213, 12);
}

TEST(DrawSurfels, TheNearestIsSeen) {
  Surfels surfels;
  add_square(surfels, {0.5, 0.5, -7}, 1.4F, {255, 0, 0, 255});
  add_square(surfels, {0.5, 0.5, -3}, 0.4F, {0, 255, 0, 255});
  const SimpleTexture seen = draw_or_fail(surfels, plain_camera(), 4, 4, 8);
  EXPECT_EQ(colour_at(seen.colour, 2, 1), (Rgba8{0, 255, 0, 255}));
  EXPECT_EQ(colour_at(seen.colour, 3, 1), (Rgba8{255, 0, 0, 255}));
  EXPECT_EQ(seen.depth.samples[1 * 4 + 2], 1 + 254 * 6 / 8 + 1);  // 190.5 + 1, rounded up
  EXPECT_EQ(seen.depth.samples[1 * 4 + 3], 65);                   // 63.5 + 1, rounded up
}

TEST(DrawSurfels, ThePictureCountsItsRowsFromTheTop) {
  Surfels surfels;
  add_square(surfels, {-1.5, 1.5, -5}, 0.4F, {9, 8, 7, 255});
  const SimpleTexture seen = draw_or_fail(surfels, plain_camera(), 4, 4, 8);
  EXPECT_EQ(colour_at(seen.colour, 0, 0), (Rgba8{9, 8, 7, 255}));
  EXPECT_EQ(seen.depth.samples[0], 128);
  EXPECT_EQ(std::count(seen.depth.samples.begin(), seen.depth.samples.end(), 0), 15);
}

TEST(DrawSurfels, TheDistanceOfASlopeIsThatAtThePixel) {
  Surfels surfels;
  surfels.push_back({0, 0, -5}, {2, 0, 2}, {0, 2, 0}, {1, 1, 1, 255});  // nearer to the right
  const SimpleTexture seen = draw_or_fail(surfels, plain_camera(), 4, 4, 16);
  for (uint32_t x = 0; x < 4; ++x) {
    const double distance = 5 - (x - 1.5);
    EXPECT_EQ(seen.depth.samples[x], distance_to_depth(distance, 65535, plain_camera())) << x;
  }
}

TEST(DrawSurfels, WithinAPixelsSideSurfacesAreOneAndBeyondAreTwo) {
  const Rgba8 red{255, 0, 0, 255}, blue{0, 0, 255, 255};
  // Pieces of half a pixel's side; a pixel is 1 wide.
  const auto seen = [&](double behind) {
    Surfels surfels;
    add_square(surfels, {0.5, 0.5, -5}, 0.25F, red);
    add_square(surfels, {0.5, 0.5, -5 - behind}, 0.25F, blue);
    return colour_at(draw_or_fail(surfels, plain_camera(), 4, 4, 8).colour, 2, 1);
  };
  EXPECT_EQ(seen(1.4), linear_mean({red, blue}));
  EXPECT_EQ(seen(1.6), red);
}

TEST(DrawSurfels, WhatFacesAwayIsSeenWhereNothingElseIs) {
  const Rgba8 red{255, 0, 0, 255}, blue{0, 0, 255, 255};
  for (const bool first : {true, false}) {
    Surfels surfels;
    if (first) add_square(surfels, {0.5, 0.5, -5}, 0.4F, red, false);
    add_square(surfels, {0.5, 0.5, -5.2}, 0.4F, blue);
    if (!first) add_square(surfels, {0.5, 0.5, -5}, 0.4F, red, false);
    add_square(surfels, {-0.5, 0.5, -5}, 0.4F, red, false);
    const SimpleTexture seen = draw_or_fail(surfels, plain_camera(), 4, 4, 16);
    EXPECT_EQ(colour_at(seen.colour, 2, 1), blue);
    EXPECT_EQ(seen.depth.samples[1 * 4 + 2], distance_to_depth(5.2, 65535, plain_camera()));
    EXPECT_EQ(colour_at(seen.colour, 1, 1), red);
  }
}

TEST(DrawSurfels, AnotherViewsPiecesDoNotChangeWhatTheCameraSawItself) {
  // The same plane, seen by the camera and by one that is a third of a pixel off.
  SimpleTexture texture = rough_texture(32, 32, 16, 3, 9);
  std::fill(texture.depth.samples.begin(), texture.depth.samples.end(), uint16_t{30000});
  SimpleTexture other = texture;
  for (uint8_t& sample : other.colour.samples) sample = static_cast<uint8_t>(255 - sample);
  DepthCamera shifted = plain_camera();
  shifted.position.x += 0.33 * 4 / 32;
  Surfels both = surfels_or_fail({plain_camera(), texture});
  const Surfels more = surfels_or_fail({shifted, other});
  for (size_t n = 0; n < more.size(); ++n)
    both.push_back(more.centres[n], more.u[n], more.v[n], more.colours[n]);
  const SimpleTexture seen = draw_or_fail(both, plain_camera(), 32, 32, 16);
  const auto& linear = srgb_to_linear();
  for (size_t n = 0; n < seen.colour.samples.size(); ++n)  // 10^-5 of the light may differ
    ASSERT_NEAR(linear[seen.colour.samples[n]], linear[texture.colour.samples[n]], 2e-3) << n;
  EXPECT_EQ(seen.depth.samples, texture.depth.samples);
}

TEST(DrawSurfels, WhatLiesOutsideOfThePlanesIsNotSeen) {
  Surfels surfels;
  add_square(surfels, {0.5, 0.5, -0.9}, 0.4F, {1, 1, 1, 255});
  add_square(surfels, {-0.5, 0.5, -9.1}, 0.4F, {2, 2, 2, 255});
  add_square(surfels, {1.5, 0.5, -1}, 0.4F, {3, 3, 3, 255});
  add_square(surfels, {-1.5, 0.5, -9}, 0.4F, {4, 4, 4, 255});
  const SimpleTexture seen = draw_or_fail(surfels, plain_camera(), 4, 4, 8);
  const std::vector<uint16_t> row(seen.depth.samples.begin() + 4, seen.depth.samples.begin() + 8);
  EXPECT_EQ(row, (std::vector<uint16_t>{1, 0, 0, 255}));
}

TEST(DrawSurfels, OpacityIsAveragedAndWhatIsTransparentIsNotSeen) {
  Surfels surfels;
  add_square(surfels, {0.5, 0.5, -5}, 0.25F, {100, 0, 0, 255});
  add_square(surfels, {0.5, 0.5, -5}, 0.25F, {100, 0, 0, 55});
  add_square(surfels, {-0.5, 0.5, -5}, 0.25F, {100, 0, 0, 0});
  const SimpleTexture seen = draw_or_fail(surfels, plain_camera(), 4, 4, 8);
  EXPECT_EQ(colour_at(seen.colour, 2, 1), (Rgba8{100, 0, 0, 155}));
  EXPECT_EQ(seen.depth.samples[1 * 4 + 1], 0);
}

TEST(DrawSurfels, RefuseWhatCannotBe) {
  const auto error = [](const Surfels& surfels, uint32_t width, unsigned bits,
                        const Limits& limits) {
    const auto drawn = draw_surfels(surfels, {plain_camera(), width, width}, bits, 1, limits);
    return drawn.ok() ? Error{Errc::io, {}, "none"} : drawn.error();
  };
  EXPECT_EQ(error({}, 0, 8, {}).text,
            "the picture is 0 x 0 pixels (expected 1 to 65535 along a side)");
  EXPECT_EQ(error({}, 4, 0, {}).text, "the depth has 0 bits (expected 1 to 16)");
  EXPECT_EQ(error({}, 4, 17, {}).text, "the depth has 17 bits (expected 1 to 16)");
  Limits few;
  few.picture_pixels = 15;
  EXPECT_EQ(error({}, 4, 8, few).text, "the picture has 4 x 4 pixels (more than the limit)");
  Surfels large;
  for (int n = 0; n < 129; ++n) add_square(large, {0, 0, -5}, 10, {});
  const Error endless = error(large, 4096, 8, {});
  EXPECT_EQ(endless.code, Errc::limit_exceeded);
  EXPECT_EQ(endless.text, "the pieces of surface touch 2164260864 pixels (more than the limit)");
  Limits little;
  little.memory = 100;
  EXPECT_EQ(error(large, 4, 8, little).text,
            "there are 129 pieces of surface (more than the limit)");
  DepthCamera bad = plain_camera();
  bad.far_plane = 1;
  EXPECT_EQ(draw_surfels({}, {bad, 4, 4}, 8, 1, {}).error().text,
            "field farPlane is 1 (expected more than nearPlane)");
}

}  // namespace
}  // namespace afx
