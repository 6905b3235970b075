// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// A picture at all sizes, for textures.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <memory>
#include <vector>

#include "afx/picture.h"
#include "codec/error.h"

namespace afx::render {

/// A picture and its halves, quarters and so on down to one pixel, each the mean of the one before
/// in linear light, weighted by alpha.
class MipPicture {
 public:
  /// RGBA, 8 bits each, the colour in display values (sRGB) multiplied by alpha, so that mixing
  /// pixels never shows the colour of what is not seen. The top row first, as in Picture: t = 1 is
  /// the upper edge. (GL takes the first row for t = 0: look it up at 1 - t.)
  struct Level {
    uint32_t width, height;
    std::vector<uint8_t> pixels;  ///< height * width * 4
  };

  /// picture   1 to 4 components, at least one pixel
  explicit MipPicture(const Picture& picture);

  /// Level k is max(1, width >> k) wide, and high likewise; as many as lead to one pixel.
  [[nodiscard]] const std::vector<Level>& levels() const { return levels_; }
  [[nodiscard]] uint32_t components() const { return components_; }
  /// Whether alpha is 1 everywhere.
  [[nodiscard]] bool opaque() const { return opaque_; }

  /// The colour at a place: display values and alpha, 0..1, not premultiplied. Between pixels and
  /// between levels it is mixed linearly; coordinates that are not finite count as 0.
  ///
  /// place     (s, t), (0, 0) the lower left corner of the picture, (1, 1) the upper right one
  /// level     log2 of how many pixels of level 0 one looks over; less than 0 as 0
  /// repeat_   false: beyond 0..1 the edge's pixels go on
  [[nodiscard]] glm::vec4 at(const glm::vec2& place, float level, bool repeat_s,
                             bool repeat_t) const;
  /// The level for at() from how (s, t) changes from one pixel of the screen to the next.
  [[nodiscard]] float level_for(const glm::vec2& to_right, const glm::vec2& down) const;

 private:
  [[nodiscard]] glm::vec4 between(const Level& level, const glm::vec2& place, bool repeat_s,
                                  bool repeat_t) const;

  std::vector<Level> levels_;
  uint32_t components_;
  bool opaque_ = true;
};

/// Those of one scene, each made once.
class MipPictures {
 public:
  /// Makes one if it is not there yet. Null does nothing.
  void add(const std::shared_ptr<const Picture>& picture);
  /// Null if it was not added.
  [[nodiscard]] const MipPicture* find(const Picture* picture) const;

 private:
  std::map<const Picture*, MipPicture> pictures_;
};

}  // namespace afx::render
