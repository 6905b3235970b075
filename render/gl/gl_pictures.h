// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Pictures as textures.
#pragma once

#include <cstdint>
#include <map>
#include <memory>

#include "afx/picture.h"
#include "render/gl/gl_objects.h"

namespace afx::render {

/// A picture at all sizes (render/mip_picture.h), its top row at t = 0. One that is larger than
/// OpenGL takes begins with its half, quarter and so on.
struct GlPicture {
  explicit GlPicture(const Picture& picture);
  /// Binds it to the current texture unit.
  void bind(bool repeat_s, bool repeat_t) const;

  GlTexture texture;
  uint32_t components;
  bool opaque;
  glm::vec2 size;  ///< of the first level
};

/// Those of one scene, each made once.
class GlPictures {
 public:
  /// Makes one, or takes it over from those of the scene before. Null does nothing.
  void add(const std::shared_ptr<const Picture>& picture, GlPictures& before);
  /// Null if it was not added.
  [[nodiscard]] const GlPicture* find(const Picture* picture) const;

 private:
  struct Entry {
    std::shared_ptr<const Picture> picture;
    std::unique_ptr<GlPicture> uploaded;
  };
  std::map<const Picture*, Entry> pictures_;
};

}  // namespace afx::render
