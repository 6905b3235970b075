// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Drawing into the framebuffer of someone else: the same pixels, in its viewport only.
#include <vector>

#include "render/gl/test_gl.h"
#include "render/test_surfels.h"

namespace afx::render {
namespace {

/// A framebuffer like a window's, filled with one colour.
struct Window {
  Window(GLsizei w, GLsizei h) : width(w), height(h) {
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, w, h, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glBindFramebuffer(GL_FRAMEBUFFER, frame.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.id(), 0);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDisable(GL_SCISSOR_TEST);
    glClearColor(1, 0, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
  }

  /// The top row first.
  [[nodiscard]] Picture picture() const {
    Picture flipped(static_cast<uint32_t>(width), static_cast<uint32_t>(height), 4);
    Picture picture = flipped;
    glBindFramebuffer(GL_FRAMEBUFFER, frame.id());
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, flipped.samples.data());
    for (uint32_t y = 0; y < picture.height; ++y)
      std::copy_n(flipped.pixel(0, y), size_t{picture.width} * 4,
                  picture.pixel(0, picture.height - 1 - y));
    return picture;
  }

  GLsizei width, height;
  GlTexture texture = GlTexture::make();
  GlFramebuffer frame = GlFramebuffer::make();
};

Scene half_sphere() {
  TestModelMaker maker(5);
  add_sphere(maker, 5, 0.4, kRed);
  Scene scene = maker.make().scene();
  scene.voxels[0].local_to_world[3] = {0.1, 0.2, 0, 1};  // so that up and down are not the same
  return scene;
}

TEST_F(GlTest, PresentFillsTheViewportWithTheSamePicture) {
  const Camera camera = looking_at_origin({0.4, 0.3, 1}, 2);
  for (const unsigned samples : {1U, 8U}) {  // one tile, several
    RenderOptions options{.width = 300, .height = 277, .background = {9, 80, 200, 255}};
    options.samples = samples;
    const RenderedImage image = gl_drawn(half_sphere(), camera, options);
    const Window window(400, 320);
    glViewport(40, 10, 300, 277);
    options.width = options.height = 5;  // not looked at
    ASSERT_TRUE(renderer_->present(camera, options).ok());
    const Picture shown = window.picture();
    for (uint32_t y = 0; y < 320; ++y) {
      for (uint32_t x = 0; x < 400; ++x) {
        const bool inside = x >= 40 && x < 340 && y >= 33 && y < 310;
        const Rgba8 expected =
            inside ? colour_at(image.picture, x - 40, y - 33) : Rgba8{255, 0, 255, 255};
        ASSERT_EQ(colour_at(shown, x, y), expected) << x << ' ' << y;
      }
    }
  }
}

TEST_F(GlTest, FramebufferAndViewportStayAsTheyAre) {
  const Window window(64, 48);
  glViewport(3, 5, 32, 20);
  RenderedImage image;
  ASSERT_TRUE(renderer_->set_scene(half_sphere()).ok());
  ASSERT_TRUE(renderer_->present(Camera{}, {}).ok());
  ASSERT_TRUE(renderer_->draw(Camera{}, {.width = 9, .height = 9}, image).ok());
  GLint frame = 0, port[4] = {};
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &frame);
  EXPECT_EQ(static_cast<GLuint>(frame), window.frame.id());
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &frame);
  EXPECT_EQ(static_cast<GLuint>(frame), window.frame.id());
  glGetIntegerv(GL_VIEWPORT, port);
  EXPECT_EQ(std::vector<GLint>(port, port + 4), (std::vector<GLint>{3, 5, 32, 20}));
}

TEST_F(GlTest, StateThatOthersLeaveDoesNotMatter) {
  const Camera camera = looking_at_origin({0.4, 0.3, 1}, 2);
  const RenderOptions options{.width = 99, .height = 77};
  const RenderedImage plain = gl_drawn(half_sphere(), camera, options);
  glEnable(GL_SCISSOR_TEST);
  glScissor(3, 4, 5, 6);
  glEnable(GL_CULL_FACE);
  glCullFace(GL_FRONT_AND_BACK);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_REVERSE_SUBTRACT);
  glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE);
  glDepthMask(GL_FALSE);
  glDepthFunc(GL_NEVER);
  glPixelStorei(GL_PACK_ROW_LENGTH, 7);
  glPixelStorei(GL_PACK_SKIP_ROWS, 3);
  const RenderedImage after = gl_drawn(half_sphere(), camera, options);
  EXPECT_EQ(plain.picture.samples, after.picture.samples);
}

}  // namespace
}  // namespace afx::render
