// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/gl/gl_target.h"

#include <algorithm>
#include <initializer_list>
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

void bind(GLenum unit, const GlTexture& to) {
  glActiveTexture(unit);
  glBindTexture(GL_TEXTURE_2D, to.id());
  glActiveTexture(GL_TEXTURE0);
}

void clear_colours() {
  constexpr GLfloat kNothing[4] = {0, 0, 0, 0};
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glClearBufferfv(GL_COLOR, 0, kNothing);
}

void clear_depths() {
  constexpr GLfloat kFarthest = 1;
  glDepthMask(GL_TRUE);
  glClearBufferfv(GL_DEPTH, 0, &kFarthest);
}

struct Attachment {
  GLenum place;
  const GlTexture& texture;
};

/// Makes a framebuffer of these. Errors  not_available: OpenGL cannot draw into it
Status make(GlFramebuffer& framebuffer, std::initializer_list<Attachment> attachments) {
  framebuffer = GlFramebuffer::make();
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  for (const Attachment& one : attachments)
    glFramebufferTexture2D(GL_FRAMEBUFFER, one.place, GL_TEXTURE_2D, one.texture.id(), 0);
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

Status GlTarget::reserve(uint32_t width, uint32_t height, unsigned samples, bool layers) {
  const auto columns = static_cast<GLsizei>(width), rows = static_cast<GLsizei>(height);
  const GLsizei wide = columns * static_cast<GLsizei>(samples);
  const GLsizei high = rows * static_cast<GLsizei>(samples);
  const Status status = grow(wide, high, columns, rows, layers);
  if (!status.ok()) width_ = height_ = columns_ = rows_ = 0;  // all is made anew the next time
  return status;
}

Status GlTarget::grow(GLsizei wide, GLsizei high, GLsizei columns, GLsizei rows, bool layers) {
  if (wide > width_ || high > height_) {
    width_ = std::max(width_, wide);
    height_ = std::max(height_, high);
    layers_ = false;
    if (Status s = make_samples(); !s.ok()) return s;
  }
  if (layers && !layers_) {
    if (Status s = make_layers(); !s.ok()) return s;
    layers_ = true;
  }
  if (columns <= columns_ && rows <= rows_) return {};
  columns_ = std::max(columns_, columns);
  rows_ = std::max(rows_, rows);
  return make_pixels();
}

Status GlTarget::make_samples() {
  sums_ = texture(GL_RGBA32F, GL_RGBA, GL_FLOAT, width_, height_);
  depths_ = texture(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, width_, height_);
  return make(samples_, {{GL_COLOR_ATTACHMENT0, sums_}, {GL_DEPTH_ATTACHMENT, depths_}});
}

Status GlTarget::make_layers() {
  wall_colours_ = texture(GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT, width_, height_);
  wall_depths_ = texture(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, width_, height_);
  finished_ = texture(GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT, width_, height_);
  Status status =
      make(walls_, {{GL_COLOR_ATTACHMENT0, wall_colours_}, {GL_DEPTH_ATTACHMENT, wall_depths_}});
  // Without depths, which are looked up meanwhile.
  if (status.ok()) status = make(finish_, {{GL_COLOR_ATTACHMENT0, finished_}});
  if (!status.ok()) return status;
  return make(glass_, {{GL_COLOR_ATTACHMENT0, finished_}, {GL_DEPTH_ATTACHMENT, depths_}});
}

Status GlTarget::make_pixels() {
  colours_ = texture(GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, columns_, rows_);
  nearest_ = texture(GL_R32F, GL_RED, GL_FLOAT, columns_, rows_);
  return make(pixels_, {{GL_COLOR_ATTACHMENT0, colours_}, {GL_COLOR_ATTACHMENT1, nearest_}});
}

void GlTarget::begin_walls() const {
  glBindFramebuffer(GL_FRAMEBUFFER, walls_.id());
  clear_colours();
  clear_depths();
  glDisable(GL_BLEND);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
}

void GlTarget::begin_depths(bool walls) const {
  glBindFramebuffer(GL_FRAMEBUFFER, samples_.id());
  clear_colours();
  if (walls) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, walls_.id());
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_DEPTH_BUFFER_BIT,
                      GL_NEAREST);
  } else {
    clear_depths();
  }
  glDepthMask(GL_TRUE);
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

void GlTarget::begin_finish() const {
  glBindFramebuffer(GL_FRAMEBUFFER, finish_.id());
  glViewport(0, 0, width_, height_);
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
}

void GlTarget::begin_glass() const {
  glBindFramebuffer(GL_FRAMEBUFFER, glass_.id());
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

void GlTarget::bind_samples(bool finished) const {
  bind(GL_TEXTURE0, finished ? finished_ : sums_);
  bind(GL_TEXTURE1, depths_);
}

void GlTarget::bind_walls() const {
  bind(GL_TEXTURE2, wall_depths_);
  bind(GL_TEXTURE3, wall_colours_);
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
