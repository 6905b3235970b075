// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/gl/gl_pictures.h"

#include <utility>

#include "render/mip_picture.h"

namespace afx::render {

GlPicture::GlPicture(const Picture& picture)
    : texture(GlTexture::make()), components(0), opaque(true), size(0) {
  const MipPicture mip(picture);
  components = mip.components();
  opaque = mip.opaque();
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
  glBindTexture(GL_TEXTURE_2D, texture.id());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  GLint number = 0;
  for (const MipPicture::Level& level : mip.levels()) {
    const auto width = static_cast<GLsizei>(level.width);
    const auto height = static_cast<GLsizei>(level.height);
    if (width > most || height > most) continue;
    if (number == 0) size = {level.width, level.height};
    glTexImage2D(GL_TEXTURE_2D, number++, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 level.pixels.data());
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, number - 1);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

void GlPicture::bind(bool repeat_s, bool repeat_t) const {
  const auto wrap = [](bool repeat) { return repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE; };
  glBindTexture(GL_TEXTURE_2D, texture.id());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap(repeat_s));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap(repeat_t));
}

void GlPictures::add(const std::shared_ptr<const Picture>& picture, GlPictures& before) {
  if (picture == nullptr || pictures_.count(picture.get()) != 0) return;
  const auto old = before.pictures_.find(picture.get());
  if (old != before.pictures_.end()) {
    pictures_.insert(before.pictures_.extract(old));
    return;
  }
  pictures_.emplace(picture.get(), Entry{picture, std::make_unique<GlPicture>(*picture)});
}

const GlPicture* GlPictures::find(const Picture* picture) const {
  const auto found = pictures_.find(picture);
  return found == pictures_.end() ? nullptr : found->second.uploaded.get();
}

}  // namespace afx::render
