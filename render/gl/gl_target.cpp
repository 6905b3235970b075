// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/gl/gl_target.h"

#include <algorithm>
#include <limits>

namespace afx::render {
namespace {

GlTexture texture(GLenum inner, GLenum format, GLenum type, GLsizei width, GLsizei height) {
  GlTexture made = GlTexture::make();
  glBindTexture(GL_TEXTURE_2D, made.id());
  glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(inner), width, height, 0, format, type,
               nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  return made;
}

void attach(GLenum place, const GlTexture& to) {
  glFramebufferTexture2D(GL_FRAMEBUFFER, place, GL_TEXTURE_2D, to.id(), 0);
}

Status check_framebuffer() {
  if (Status s = check_gl("making textures to draw into"); !s.ok()) return s;
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return {};
  return Error{Errc::not_available, Place::none(),
               "OpenGL cannot draw into textures of floats (expected RGBA32F and depth 32F)"};
}

/// Shaders cannot be relied on to write it: there -1 stands for it.
void put_infinity(float* first, const GlTile& tile, size_t row_length) {
  for (size_t y = 0; y < tile.height; ++y) {
    float* const row = first + y * row_length;
    for (size_t x = 0; x < tile.width; ++x)
      if (row[x] < 0) row[x] = std::numeric_limits<float>::infinity();
  }
}

}  // namespace

Status GlTarget::reserve(uint32_t width, uint32_t height, unsigned samples) {
  const auto columns = static_cast<GLsizei>(width), rows = static_cast<GLsizei>(height);
  const GLsizei wide = columns * static_cast<GLsizei>(samples);
  const GLsizei high = rows * static_cast<GLsizei>(samples);
  if (wide > width_ || high > height_) {
    width_ = std::max(width_, wide);
    height_ = std::max(height_, high);
    sums_ = texture(GL_RGBA32F, GL_RGBA, GL_FLOAT, width_, height_);
    depths_ = texture(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, width_, height_);
    samples_ = GlFramebuffer::make();
    glBindFramebuffer(GL_FRAMEBUFFER, samples_.id());
    attach(GL_COLOR_ATTACHMENT0, sums_);
    attach(GL_DEPTH_ATTACHMENT, depths_);
    if (Status s = check_framebuffer(); !s.ok()) return s;
  }
  if (columns > columns_ || rows > rows_) {
    columns_ = std::max(columns_, columns);
    rows_ = std::max(rows_, rows);
    colours_ = texture(GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, columns_, rows_);
    nearest_ = texture(GL_R32F, GL_RED, GL_FLOAT, columns_, rows_);
    pixels_ = GlFramebuffer::make();
    glBindFramebuffer(GL_FRAMEBUFFER, pixels_.id());
    attach(GL_COLOR_ATTACHMENT0, colours_);
    attach(GL_COLOR_ATTACHMENT1, nearest_);
    if (Status s = check_framebuffer(); !s.ok()) return s;
  }
  return {};
}

void GlTarget::begin_depths() const {
  glBindFramebuffer(GL_FRAMEBUFFER, samples_.id());
  constexpr GLfloat kNothing[4] = {0, 0, 0, 0};
  constexpr GLfloat kFarthest = 1;
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  glClearBufferfv(GL_COLOR, 0, kNothing);
  glClearBufferfv(GL_DEPTH, 0, &kFarthest);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDisable(GL_BLEND);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
}

void GlTarget::begin_colours() const {
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_FALSE);
  glDepthFunc(GL_LEQUAL);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_ONE, GL_ONE);
}

void GlTarget::bind_samples() const {
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, sums_.id());
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, depths_.id());
  glActiveTexture(GL_TEXTURE0);
}

void GlTarget::begin_pixels(const GlTile& tile, bool depth) const {
  glBindFramebuffer(GL_FRAMEBUFFER, pixels_.id());
  const GLenum second = depth ? GL_COLOR_ATTACHMENT1 : GL_NONE;
  const GLenum buffers[] = {GL_COLOR_ATTACHMENT0, second};
  glDrawBuffers(2, buffers);
  glViewport(0, 0, static_cast<GLsizei>(tile.width), static_cast<GLsizei>(tile.height));
}

void GlTarget::read(const GlTile& tile, RenderedImage& image) const {
  glBindFramebuffer(GL_FRAMEBUFFER, pixels_.id());
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glPixelStorei(GL_PACK_ROW_LENGTH, static_cast<GLint>(image.picture.width));
  glPixelStorei(GL_PACK_SKIP_PIXELS, 0);
  glPixelStorei(GL_PACK_SKIP_ROWS, 0);
  const auto width = static_cast<GLsizei>(tile.width), height = static_cast<GLsizei>(tile.height);
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, image.picture.pixel(tile.x, tile.y));
  if (!image.depth.empty()) {
    glReadBuffer(GL_COLOR_ATTACHMENT1);
    float* const first = &image.depth[size_t{tile.y} * image.picture.width + tile.x];
    glReadPixels(0, 0, width, height, GL_RED, GL_FLOAT, first);
    put_infinity(first, tile, image.picture.width);
  }
  glPixelStorei(GL_PACK_ROW_LENGTH, 0);
}

}  // namespace afx::render
