// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/dibr_model.h"

#include <gtest/gtest.h>

#include <string>

#include "nodes/scene_reader.h"

namespace afx {
namespace {

constexpr const char* kImage =
    "DepthImage { diTexture SimpleTexture { texture PixelTexture { image 1 1 4 0xFF0000FF } } }";

std::vector<DibrModel> models_of(const std::string& text, const Limits& limits = {}) {
  Diagnostics diagnostics;
  const auto scene = nodes::read_scene_text(text, {}, diagnostics);
  EXPECT_TRUE(scene.ok()) << (scene.ok() ? "" : scene.error().text);
  if (!scene.ok()) return {};
  auto models = read_dibr_models(scene.value(), UrlBase(""), limits, diagnostics);
  EXPECT_TRUE(models.ok()) << (models.ok() ? "" : models.error().text);
  return models.ok() ? std::move(models).value() : std::vector<DibrModel>();
}

TEST(DibrModels, ImagesUnderOneTransformAreOneObjectInItsPlace) {
  const auto models = models_of(std::string("Group { children Transform { translation 1 2 3 "
                                            "children [ ") +
                                kImage + " " + kImage + " ] } }");
  ASSERT_EQ(models.size(), 1U);
  EXPECT_EQ(models[0].to_world[3], glm::dvec4(1, 2, 3, 1));
  ASSERT_NE(models[0].depth_images(), nullptr);
  EXPECT_EQ(models[0].depth_images()->size(), 2U);
  EXPECT_EQ(models[0].octree(), nullptr);
}

TEST(DibrModels, WhatUseShowsAgainIsReadOnce) {
  const auto models = models_of(
      "Group { children [ Transform { children DEF O OctreeImage { octreeResolution 2 octree 1 } }"
      " Transform { translation 5 0 0 children USE O } ] }");
  ASSERT_EQ(models.size(), 2U);
  EXPECT_EQ(models[0].shape, models[1].shape);
  EXPECT_EQ(models[1].to_world[3].x, 5);
  EXPECT_EQ(models[0].octree()->resolution, 2U);
}

TEST(DibrModels, InstancesOfAProtoHaveTheirOwnFields) {
  const auto models = models_of(
      "PROTO P [ field SFInt32 r 1 ] { OctreeImage { octreeResolution IS r octree 1 } }"
      "Group { children [ P { r 2 } P { r 1 } ] }");
  ASSERT_EQ(models.size(), 2U);
  EXPECT_NE(models[0].shape, models[1].shape);
  EXPECT_EQ(models[0].octree()->resolution, 2U);
  EXPECT_EQ(models[1].octree()->resolution, 1U);
}

}  // namespace
}  // namespace afx
