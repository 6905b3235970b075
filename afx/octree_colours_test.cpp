// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/octree_colours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

#include "codec/octree_voxels.h"

namespace afx {
namespace {

constexpr float kQuarter = static_cast<float>(std::numbers::pi / 2);

/// The images of a Box Texture in this order: +z, -z, +x, -x, +y, -y; a camera before each face.
std::vector<ReferenceImage> box_images(uint32_t side) {
  const glm::vec3 up(0, 1, 0), right(1, 0, 0);
  const std::array<glm::quat, 6> turns = {glm::quat(1, 0, 0, 0),
                                          glm::angleAxis(2 * kQuarter, up),
                                          glm::angleAxis(kQuarter, up),
                                          glm::angleAxis(-kQuarter, up),
                                          glm::angleAxis(-kQuarter, right),
                                          glm::angleAxis(kQuarter, right)};
  std::vector<ReferenceImage> images;
  for (size_t k = 0; k < 6; ++k) {
    ReferenceImage image;
    image.orientation = turns[k];
    image.position = turns[k] * glm::vec3(0, 0, 10);
    image.picture = Picture(side, side, 3);
    std::fill(image.picture.samples.begin(), image.picture.samples.end(),
              static_cast<uint8_t>(10 * (k + 1)));
    images.push_back(image);
  }
  return images;
}

/// All voxels of a full cube, or those that `keep` keeps.
template <class Keep>
OctreeModel model_where(unsigned levels, const Keep& keep) {
  std::vector<uint64_t> codes;
  for (uint64_t code = 0; code < uint64_t{1} << (3 * levels); ++code) {
    if (keep(codec::morton_decode(code))) codes.push_back(code);
  }
  OctreeModel model;
  model.resolution = 1U << levels;
  model.fields.octree = codec::octree_from_morton(codes, levels);
  return model;
}
OctreeModel full_model(unsigned levels) {
  return model_where(levels, [](Voxel) { return true; });
}

ColouredVoxels coloured(const OctreeModel& model, unsigned level, Diagnostics& diagnostics,
                        unsigned threads = 2) {
  auto result = colour_octree(model, level, threads, Limits{}, diagnostics);
  EXPECT_TRUE(result.ok()) << (result.ok() ? "" : result.error().text);
  return result.ok() ? std::move(result).value() : ColouredVoxels{};
}
ColouredVoxels coloured(const OctreeModel& model, unsigned level) {
  Diagnostics diagnostics;
  ColouredVoxels voxels = coloured(model, level, diagnostics);
  EXPECT_EQ(diagnostics.count(), 0U);
  return voxels;
}

size_t place_of(const ColouredVoxels& voxels, Voxel v) {
  const auto at = std::lower_bound(voxels.codes.begin(), voxels.codes.end(), codec::morton_code(v));
  return static_cast<size_t>(at - voxels.codes.begin());
}

/// A picture whose pixel (i, j) from the lower left has red = i, green = j.
Picture ramp(uint32_t width, uint32_t height, uint32_t components) {
  Picture p(width, height, components);
  for (uint32_t j = 0; j < height; ++j) {
    for (uint32_t i = 0; i < width; ++i) {
      uint8_t* at = p.pixel(i, height - 1 - j);
      at[0] = static_cast<uint8_t>(i);
      if (components > 2) at[1] = static_cast<uint8_t>(j);
    }
  }
  return p;
}

TEST(ColourOctree, AVoxelTakesThePixelBeforeItCountedFromTheLowerLeft) {
  OctreeModel model = full_model(2);
  model.images.resize(1);
  model.images[0].picture = ramp(4, 4, 3);
  model.fields.voxel_image_index = {1};
  const ColouredVoxels voxels = coloured(model, 2);
  ASSERT_EQ(voxels.codes.size(), 64U);
  for (size_t i = 0; i < 64; ++i) {
    const Voxel v = codec::morton_decode(voxels.codes[i]);
    EXPECT_EQ(voxels.colours[i],
              (Rgba8{static_cast<uint8_t>(v.x), static_cast<uint8_t>(v.y), 0, 255}));
    EXPECT_EQ(voxels.images[i], 1);
  }
}

TEST(ColourOctree, ACentreOnAPixelBorderTakesThePixelAbove) {
  // Two voxels along x, centres at -1/4 and 1/4; with a picture 4 wide: u*w = 1 and 3, exactly.
  OctreeModel model = full_model(1);
  model.images.resize(1);
  model.images[0].picture = ramp(4, 4, 3);
  model.fields.voxel_image_index = {1};
  const ColouredVoxels voxels = coloured(model, 1);
  EXPECT_EQ(voxels.colours[0], (Rgba8{1, 1, 0, 255}));
  EXPECT_EQ(voxels.colours[3], (Rgba8{3, 3, 0, 255}));
  // Moved by a hundredth of a pixel to the left the centre still takes it, by two hundredths not.
  model.images[0].position.x = 0.01F / 4;
  EXPECT_EQ(coloured(model, 1).colours[0].r, 1);
  model.images[0].position.x = 0.02F / 4;
  EXPECT_EQ(coloured(model, 1).colours[0].r, 0);
}

TEST(ColourOctree, CentresOutsideTakeTheNearestEdgePixelAndAreCounted) {
  OctreeModel model = full_model(1);
  model.images.resize(1);
  model.images[0].picture = ramp(4, 4, 3);
  model.images[0].position.x = 0.5F;  // u*w = -1 and 1
  model.fields.voxel_image_index = {1};
  Diagnostics diagnostics;
  const ColouredVoxels voxels = coloured(model, 1, diagnostics);
  EXPECT_EQ(voxels.colours[0], (Rgba8{0, 1, 0, 255}));
  EXPECT_EQ(voxels.colours[1], (Rgba8{1, 1, 0, 255}));
  ASSERT_EQ(diagnostics.count(), 1U);
  EXPECT_EQ(diagnostics.warnings()[0].code, "voxel_outside_image");
  EXPECT_EQ(diagnostics.warnings()[0].text,
            "4 voxels fall outside images[0] and take its nearest edge pixel");
}

TEST(ColourOctree, PicturesOfOneToFourComponentsAreRead) {
  OctreeModel model = full_model(0);
  model.images.resize(1);
  model.fields.voxel_image_index = {1};
  const Rgba8 expected[] = {{9, 9, 9, 255}, {9, 9, 9, 255}, {9, 7, 5, 255}, {9, 7, 5, 255}};
  for (uint32_t n = 1; n <= 4; ++n) {
    Picture& p = model.images[0].picture;
    p = Picture(1, 1, n);
    const uint8_t samples[] = {9, n == 2 ? uint8_t{3} : uint8_t{7}, 5, 3};
    std::copy_n(samples, n, p.samples.begin());
    EXPECT_EQ(coloured(model, 0).colours[0], expected[n - 1]) << n;
  }
}

TEST(ColourOctree, WithoutIndicesTheImageThatFacesTheSurfaceIsChosen) {
  OctreeModel model = full_model(3);
  model.images = box_images(8);
  const ColouredVoxels voxels = coloured(model, 3);
  const auto image = [&](uint32_t x, uint32_t y, uint32_t z) {
    return voxels.images[place_of(voxels, {x, y, z})];
  };
  EXPECT_EQ(image(3, 4, 7), 1);  // inside the faces: normals along the axes
  EXPECT_EQ(image(3, 4, 0), 2);
  EXPECT_EQ(image(7, 4, 2), 3);
  EXPECT_EQ(image(0, 4, 2), 4);
  EXPECT_EQ(image(5, 7, 2), 5);
  EXPECT_EQ(image(5, 0, 2), 6);
  EXPECT_EQ(image(7, 4, 7), 1);  // edge between +z and +x: equal angles, the lower index
  EXPECT_EQ(image(0, 0, 0), 2);  // corner of -z, -x, -y
  EXPECT_EQ(image(7, 7, 3), 3);  // edge between +x and +y
  // Inside there is no normal: the image least far behind, ties to the lower index.
  EXPECT_EQ(image(2, 3, 4), 4);  // two behind -x, three before all others
  EXPECT_EQ(image(3, 3, 4), 1);  // three behind +z, -x and -y
  EXPECT_EQ(image(3, 3, 3), 2);
  for (size_t i = 0; i < voxels.codes.size(); ++i) {
    EXPECT_EQ(voxels.colours[i].r, 10 * voxels.images[i]);
  }
}

TEST(ColourOctree, AnImageIsNotChosenForWhatItCannotSee) {
  // A wall at z = 6 hides a wall at z = 1 from the front; the lone image behind is not facing, but
  // sees.
  OctreeModel model =
      model_where(3, [](Voxel v) { return v.z == 6 || (v.z == 1 && v.x > 0 && v.x < 7); });
  model.images = box_images(8);
  model.images.resize(2);  // +z and -z
  const ColouredVoxels voxels = coloured(model, 3);
  for (size_t i = 0; i < voxels.codes.size(); ++i) {
    const Voxel v = codec::morton_decode(voxels.codes[i]);
    EXPECT_EQ(voxels.images[i], v.z == 1 ? 2 : 1);
  }
  // One voxel side behind is still seen: of a double wall both take the image of their side.
  model = model_where(3, [](Voxel v) { return v.z == 3 || v.z == 4; });
  model.images = box_images(8);
  model.images.resize(2);
  const ColouredVoxels both = coloured(model, 3);
  EXPECT_EQ(both.images[place_of(both, {4, 4, 4})], 1);
  EXPECT_EQ(both.images[place_of(both, {4, 4, 3})], 2);
}

TEST(ColourOctree, IndicesGoBeforeTheChoice) {
  OctreeModel model = full_model(1);
  model.images = box_images(2);
  // Root undefined, then a symbol for each of the eight voxels; 0 leaves the choice.
  model.fields.voxel_image_index = {0, 6, 6, 6, 6, 5, 5, 5, 0};
  const ColouredVoxels voxels = coloured(model, 1);
  EXPECT_EQ(voxels.images, (std::vector<uint8_t>{6, 6, 6, 6, 5, 5, 5, 1}));
}

TEST(ColourOctree, ACoarserVoxelIsTheMeanInLinearLight) {
  OctreeModel model = full_model(2);
  model.images.resize(1);
  model.fields.voxel_image_index = {1};
  Picture& p = model.images[0].picture;
  p = Picture(4, 4, 4);
  for (uint32_t y = 0; y < 4; ++y) {
    for (uint32_t x = 0; x < 4; ++x) {
      const uint8_t grey = (x + y) % 2 == 0 ? 255 : 0;
      const uint8_t rgba[] = {grey, grey, grey, 255};
      std::copy_n(rgba, 4, p.pixel(x, y));
    }
  }
  for (const unsigned level : {0U, 1U}) {
    for (const Rgba8& c : coloured(model, level).colours) EXPECT_EQ(c, (Rgba8{188, 188, 188, 255}));
  }
  // Transparent pixels do not count: of the lower left quarter only the white ones stay.
  p.pixel(0, 2)[3] = 255;
  p.pixel(1, 2)[3] = 0;
  p.pixel(0, 3)[3] = 0;
  EXPECT_EQ(coloured(model, 1).colours[0], (Rgba8{255, 255, 255, 255}));
  EXPECT_EQ(coloured(model, 1).colours[1], (Rgba8{188, 188, 188, 255}));
}

TEST(ColourOctree, AMixedSubtreeHasItsImageChosenAtTheCoarserLevel) {
  OctreeModel model = full_model(1);
  model.images = box_images(2);
  model.fields.voxel_image_index = {0, 6, 6, 6, 6, 5, 5, 5, 5};
  // The root alone is one voxel without normal, and no image has anything before it.
  EXPECT_EQ(coloured(model, 0).images, std::vector<uint8_t>{1});
}

TEST(ColourOctree, WithoutImagesVoxelsAreShadedGreyAndLighterAbove) {
  const OctreeModel model = full_model(3);
  const ColouredVoxels voxels = coloured(model, 3);
  for (const Rgba8& c : voxels.colours) {
    EXPECT_TRUE(c.r == c.g && c.g == c.b && c.a == 255 && c.r > 20);
  }
  EXPECT_GT(voxels.colours[place_of(voxels, {4, 7, 4})].r,
            voxels.colours[place_of(voxels, {4, 0, 4})].r + 50);
}

TEST(ColourOctree, ImagesWithoutPicturesGiveGreyAndAWarningWithTheCount) {
  OctreeModel model = full_model(1);
  model.images.resize(3);
  model.fields.voxel_image_index = {2};
  Diagnostics diagnostics;
  const ColouredVoxels voxels = coloured(model, 1, diagnostics);
  EXPECT_EQ(voxels.colours[0].r, voxels.colours[0].b);
  ASSERT_EQ(diagnostics.count(), 1U);
  EXPECT_EQ(diagnostics.warnings()[0].code, "no_picture");
  EXPECT_EQ(diagnostics.warnings()[0].text.substr(0, 9), "8 voxels ");
}

TEST(ColourOctree, TheResultIsTheSameForAnyNumberOfThreads) {
  OctreeModel model = model_where(7, [](Voxel v) {
    const double x = v.x - 63.5, y = v.y - 63.5, z = v.z - 63.5;
    return std::abs(x * x + y * y + z * z - 2800) < 160;
  });
  model.images = box_images(50);
  for (size_t k = 0; k < 6; ++k) model.images[k].picture = ramp(50, 40, 3);
  Diagnostics diagnostics;
  const ColouredVoxels one = coloured(model, 7, diagnostics, 1);
  ASSERT_GT(one.codes.size(), 3U * 16384);  // what one task colours: fewer would run in one thread
  for (const unsigned threads : {2U, 3U, 8U}) {
    const ColouredVoxels many = coloured(model, 7, diagnostics, threads);
    EXPECT_EQ(many.colours, one.colours);
    EXPECT_EQ(many.images, one.images);
  }
}

TEST(ColourOctree, AnEmptyOctreeHasNoVoxels) {
  OctreeModel model;
  model.resolution = 256;
  model.fields.octree = {0};
  model.images = box_images(4);
  EXPECT_TRUE(coloured(model, 8).codes.empty());
}

std::string error_of(const OctreeModel& model, unsigned level, Errc code, Limits limits = {}) {
  Diagnostics diagnostics;
  const auto result = colour_octree(model, level, 2, limits, diagnostics);
  EXPECT_FALSE(result.ok());
  if (result.ok()) return "ok";
  EXPECT_EQ(result.error().code, code);
  return result.error().text;
}

TEST(ColourOctree, FieldsThatDoNotFitAreRefused) {
  OctreeModel model = full_model(2);
  EXPECT_EQ(error_of(model, 3, Errc::bad_argument),
            "level 3 of an octree of 2 levels (expected 0 to 2)");
  model.images.resize(2);
  model.fields.voxel_image_index = {3};
  EXPECT_EQ(error_of(model, 2, Errc::bad_argument),
            "voxelImageIndex has 3 (expected at most 2, the number of images)");
  model.fields.voxel_image_index = {0, 1};
  error_of(model, 2, Errc::bad_argument);
  model.fields = {};
  error_of(model, 2, Errc::bad_argument);
  model = full_model(2);
  model.images.resize(1);
  model.images[0].field_of_view = {0, 1};
  error_of(model, 2, Errc::bad_argument);
  model.images.resize(256);
  error_of(model, 2, Errc::bad_argument);
}

TEST(ColourOctree, WhatIsBeyondTheLimitsIsRefused) {
  OctreeModel model = full_model(5);
  Limits limits;
  limits.memory = 64 * 32000;
  error_of(model, 5, Errc::limit_exceeded, limits);  // 32768 voxels
  limits = {};
  limits.picture_pixels = 99;
  model.images = box_images(10);
  error_of(model, 5, Errc::limit_exceeded, limits);
}

// A field of view far smaller than a voxel: the voxels of the row before it cover the whole picture
// each. Sixteen times 2^24 pixels can be drawn, 16 * 9 times cannot.
TEST(ColourOctree, WorkThatFitsTheBudgetIsDoneAndMoreIsRefused) {
  OctreeModel model = model_where(5, [](Voxel v) { return v.x == 16 && v.y == 16 && v.z < 16; });
  model.images.resize(1);
  model.images[0].picture = Picture(4096, 4096, 1);
  model.images[0].field_of_view = {1e-4F, 1e-4F};
  model.images[0].position.x = 1.0F / 64;
  model.images[0].position.y = 1.0F / 64;
  Diagnostics diagnostics;
  EXPECT_TRUE(colour_octree(model, 5, 2, Limits{}, diagnostics).ok());
  model.images.resize(9, model.images[0]);
  EXPECT_EQ(error_of(model, 5, Errc::limit_exceeded).substr(0, 38),
            "the voxels cover more than 2^31 pixels");
}

// With indices nothing is to be chosen; at a coarser level each voxel is the mean of its square.
TEST(ColourOctree, MeansOverTooManyPixelsAreRefused) {
  OctreeModel model = full_model(6);
  model.images.resize(1);
  model.images[0].picture = Picture(16384, 16384, 1);
  model.images[0].field_of_view = {1e-6F, 1e-6F};
  model.images[0].position.x = 1.0F / 64;
  model.images[0].position.y = 1.0F / 64;
  model.fields.voxel_image_index = {1};
  EXPECT_EQ(error_of(model, 5, Errc::limit_exceeded).substr(0, 38),
            "the voxels cover more than 2^31 pixels");
}

}  // namespace
}  // namespace afx
