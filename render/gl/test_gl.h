// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// A comparison with the software renderer.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

#include "afx/picture_io.h"
#include "render/gl/gl_objects.h"
#include "render/gl/gl_renderer.h"
#include "render/gl/test_context.h"
#include "render/test_drawing.h"

namespace afx::render {

/// How far two pictures may differ.
struct Tolerance {
  double mean = 0.1;     ///< of all components, in steps of 1/255; of each with its sign
  double apart = 0.002;  ///< part of the pixels in which a component differs by more than 8
};
/// The software renderer shades once in a pixel, OpenGL at each sample: so what is drawn on shapes
/// has smoother edges, which the mean in linear light makes a little brighter.
inline constexpr Tolerance kDrawnOnShapes{1.5, 0.1};

/// Tests that draw; they are skipped, and say why, where there is no OpenGL.
class GlTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!test_context().ok()) GTEST_SKIP() << test_context().error().text;
    const auto features = GlFeatures::find();
    if (!features.ok()) GTEST_SKIP() << features.error().text;
    // One for all tests, since shaders take long to compile. It goes before the context.
    static const Result<std::unique_ptr<GlRenderer>> made = make_gl_renderer();
    ASSERT_TRUE(made.ok()) << made.error().text;
    renderer_ = made.value().get();
  }

  RenderedImage gl_drawn(const Scene& scene, const Camera& camera, const RenderOptions& options) {
    RenderedImage image;
    const Status set = renderer_->set_scene(scene);
    EXPECT_TRUE(set.ok()) << (set.ok() ? "" : set.error().text);
    const Status done = renderer_->draw(camera, options, image);
    EXPECT_TRUE(done.ok()) << (done.ok() ? "" : done.error().text);
    return image;
  }

  /// Draws with both renderers and compares.
  void expect_same(const std::string& what, const Scene& scene, const Camera& camera,
                   RenderOptions options, const Tolerance& tolerance = {});

  GlRenderer* renderer_ = nullptr;
};

/// How two pictures differ.
struct PictureDifference {
  double mean = 0;          ///< absolute, of all components, in steps of 1/255
  double signed_mean[4]{};  ///< of each component
  int most = 0;
  double apart = 0;    ///< part of the pixels in which a component differs by more than 8
  double covered = 0;  ///< part of the pixels that have an alpha
};
/// Of pictures of the same size.
inline PictureDifference difference(const Picture& a, const Picture& b) {
  PictureDifference found;
  const size_t pixels = a.samples.size() / 4;
  for (size_t i = 0; i < pixels; ++i) {
    bool apart = false;
    for (size_t k = 0; k < 4; ++k) {
      const int step = a.samples[4 * i + k] - b.samples[4 * i + k];
      found.mean += std::abs(step);
      found.signed_mean[k] += step;
      found.most = std::max(found.most, std::abs(step));
      apart = apart || std::abs(step) > 8;
    }
    found.apart += apart ? 1 : 0;
    found.covered += b.samples[4 * i + 3] != 0 ? 1 : 0;
  }
  const auto count = static_cast<double>(pixels);
  for (double& mean : found.signed_mean) mean /= count;
  found.mean /= 4 * count;
  found.apart /= count;
  found.covered /= count;
  return found;
}

/// Where AFX_GL_PICTURES names a folder: writes both pictures and 16 times their difference there,
/// for people to look at.
inline void keep_pictures(const std::string& name, const Picture& gl, const Picture& software) {
  const char* const folder = std::getenv("AFX_GL_PICTURES");
  if (folder == nullptr) return;
  Picture apart = gl;
  for (size_t i = 0; i < apart.samples.size(); ++i) {
    const int step = gl.samples[i] - software.samples[i];
    apart.samples[i] =
        i % 4 == 3 ? uint8_t{255} : static_cast<uint8_t>(std::min(16 * std::abs(step), 255));
  }
  const std::string path = std::string(folder) + "/" + name;
  EXPECT_TRUE(write_picture(path + "-gl.png", gl, {}, true).ok());
  EXPECT_TRUE(write_picture(path + "-sw.png", software, {}, true).ok());
  EXPECT_TRUE(write_picture(path + "-apart.png", apart, {}, true).ok());
}

inline void GlTest::expect_same(const std::string& what, const Scene& scene, const Camera& camera,
                                RenderOptions options, const Tolerance& tolerance) {
  options.depth = true;
  const RenderedImage software = drawn(scene, camera, options);
  const RenderedImage gl = gl_drawn(scene, camera, options);
  ASSERT_EQ(gl.picture.samples.size(), software.picture.samples.size()) << what;
  ASSERT_EQ(gl.depth.size(), software.depth.size()) << what;
  keep_pictures(what, gl.picture, software.picture);
  const PictureDifference found = difference(gl.picture, software.picture);
  EXPECT_GT(found.covered, 0.01) << what;
  EXPECT_LT(found.mean, tolerance.mean) << what;
  EXPECT_LT(found.apart, tolerance.apart) << what;
  for (const double mean : found.signed_mean) EXPECT_LT(std::abs(mean), tolerance.mean) << what;
  size_t one_only = 0, both = 0, far = 0;
  for (size_t i = 0; i < gl.depth.size(); ++i) {
    const bool here = std::isfinite(gl.depth[i]), there = std::isfinite(software.depth[i]);
    one_only += here != there ? 1U : 0U;
    if (!here || !there) continue;
    ++both;
    far += std::abs(gl.depth[i] - software.depth[i]) > 1e-4F * software.depth[i] ? 1U : 0U;
  }
  EXPECT_LE(static_cast<double>(one_only), 0.001 * static_cast<double>(gl.depth.size())) << what;
  EXPECT_LE(static_cast<double>(far), 0.001 * static_cast<double>(both)) << what;
  if (std::getenv("AFX_GL_PICTURES") != nullptr) {
    std::printf(
        "%-28s mean %.4f most %3d apart %.5f signed %.4f %.4f %.4f %.4f depth %zu %zu/%zu\n",
        what.c_str(), found.mean, found.most, found.apart, found.signed_mean[0],
        found.signed_mean[1], found.signed_mean[2], found.signed_mean[3], one_only, far, both);
  }
}

}  // namespace afx::render
