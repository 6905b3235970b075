// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/viewer/picture_source.h"

#include <gtest/gtest.h>

#include <chrono>

namespace afx::tools {
namespace {

using std::chrono::steady_clock;

class PictureSourceTest : public testing::Test {
 protected:
  PictureSourceTest() : source([this] { wake(); }) {
    const uint64_t codes[] = {0, 7};
    const Rgba8 colours[] = {{255, 0, 0, 255}, {0, 255, 0, 255}};
    auto model = std::make_shared<ViewerModel>();
    model->scene.voxels.push_back({render::VoxelTree::make(1, codes, colours).value()});
    wanted.model = model;
    wanted.camera.position = {0, 0, 4};
    wanted.width = 40;
    wanted.height = 30;
    wanted.threads = 1;
  }
  void wake() {
    const std::lock_guard lock(mutex);
    news = true;
    changed.notify_one();
  }
  /// Updates until there is another picture.
  bool next_picture(double now) {
    const auto end = steady_clock::now() + std::chrono::seconds(30);
    while (steady_clock::now() < end) {
      if (source.update(now)) return true;
      std::unique_lock lock(mutex);
      changed.wait_for(lock, std::chrono::milliseconds(20), [this] { return news; });
      news = false;
    }
    return false;
  }

  std::mutex mutex;
  std::condition_variable changed;
  bool news = false;
  Wanted wanted;
  PictureSource source;
};

TEST_F(PictureSourceTest, AQuickPictureComesFirstAFineOneWhenNothingMoves) {
  EXPECT_EQ(source.shown(), nullptr);
  source.want(wanted, 10);
  ASSERT_TRUE(next_picture(10));
  EXPECT_EQ(source.shown()->request.options.samples, 1U);
  EXPECT_EQ(source.shown()->image.picture.width, 40U);
  EXPECT_FALSE(source.is_final());
  EXPECT_NEAR(source.due(10.05).value(), PictureSource::kStill - 0.05, 1e-9);
  ASSERT_TRUE(next_picture(10.2));
  EXPECT_EQ(source.shown()->request.options.samples, 3U);
  EXPECT_TRUE(source.is_final());
  EXPECT_FALSE(source.due(10.2).has_value());
}

TEST_F(PictureSourceTest, TheSameAgainIsNotDrawnAgain) {
  source.want(wanted, 1);
  ASSERT_TRUE(next_picture(1));
  ASSERT_TRUE(next_picture(2));
  source.want(wanted, 3);
  wanted.drawn.boxes = true;
  source.want(wanted, 4);
  EXPECT_TRUE(source.is_final());
  wanted.camera.position.x = 1;
  source.want(wanted, 5);
  EXPECT_FALSE(source.is_final());
}

TEST_F(PictureSourceTest, WhatCannotBeDrawnIsSaid) {
  wanted.camera.near_plane = -1;
  source.want(wanted, 1);
  for (int i = 0; i < 500 && source.problem().empty(); ++i) {
    EXPECT_FALSE(source.update(1));
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_NE(source.problem().find("near plane"), std::string::npos);
  wanted.camera.near_plane = 1e-3;
  source.want(wanted, 2);
  ASSERT_TRUE(next_picture(2));
  EXPECT_EQ(source.problem(), "");
}

TEST(DrawOptions, ScaleThePictureButNotBelowOnePixel) {
  Wanted wanted;
  wanted.width = 1000;
  wanted.height = 3;
  const render::RenderOptions options = draw_options(wanted, 2, 0.1);
  EXPECT_EQ(options.width, 100U);
  EXPECT_EQ(options.height, 1U);
  EXPECT_EQ(options.samples, 2U);
}

}  // namespace
}  // namespace afx::tools
