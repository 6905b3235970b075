// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What the cameras of reference images see of an object's voxels.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "afx/builder/reference_cameras.h"
#include "afx/octree_model.h"
#include "afx/reference_projection.h"
#include "codec/octree.h"

namespace afx {

/// Where voxels lie on the picture of a camera, by the rule in octree_colours.h.
class ReferenceView {
 public:
  ReferenceView(const ReferenceCamera& camera, unsigned levels);

  /// Counted from the left and from the top.
  struct Pixel {
    uint32_t x, y;
  };
  /// A voxel as the camera has it.
  struct Sight {
    Pixel pixel;        ///< that its centre falls on
    Pixel first, last;  ///< the corners of the pixels that its square covers, at least `pixel`
    float depth;        ///< in voxels, along the viewing direction from the middle of the cube
  };
  [[nodiscard]] Sight sight(const Voxel& voxel) const;
  /// The first alone, where that is all.
  [[nodiscard]] Pixel pixel(const Voxel& voxel) const;

  [[nodiscard]] uint32_t width() const { return projection_.width(); }
  [[nodiscard]] uint32_t height() const { return projection_.height(); }
  [[nodiscard]] size_t pixels() const { return size_t{width()} * height(); }
  [[nodiscard]] size_t place(Pixel at) const { return size_t{at.y} * width() + at.x; }
  /// Voxels this much behind the first one on their pixel are still seen: where a pixel is wider
  /// than a voxel, or looks slanting at the grid, a surface has several in one pixel.
  [[nodiscard]] float slack() const { return slack_; }
  [[nodiscard]] const glm::dvec3& to_camera() const { return projection_.to_camera(); }

 private:
  [[nodiscard]] glm::dvec3 centre(const Voxel& voxel) const;

  ReferenceProjection projection_;
  double side_;  // of a voxel
  float slack_;
};

/// What lies first on each pixel of a view.
struct FirstSeen {
  static constexpr uint32_t kNothing = 0xFFFFFFFF;
  std::vector<float> depth;     ///< infinite where there is nothing
  std::vector<uint32_t> voxel;  ///< its number; the lowest of equals
};
/// coordinates   fewer than 2^32 - 1
FirstSeen first_seen(const ReferenceView& view, std::span<const Voxel> coordinates);

/// Whether the pixel of the voxel shows it.
bool is_seen(const ReferenceView& view, const ReferenceView::Sight& sight, const FirstSeen& first);

/// Gives pixels the mean, in linear light, of the colours of the voxels whose centres fall on them;
/// all others stay as they are.
/// in     which voxels take part, by number
/// Sets   drawn for the pixels that got a colour
void draw_voxels(const ReferenceView& view, std::span<const Voxel> coordinates,
                 std::span<const Rgba8> colours, const std::function<bool(size_t)>& in,
                 Picture& picture, std::vector<bool>& drawn);

/// A view's picture, RGB.
struct DrawnView {
  Picture picture;
  std::vector<bool> drawn;  ///< the pixels that show the object; the others are black
  std::vector<bool> seen;   ///< the voxels that their pixel shows
};

/// Draws the voxels as a camera sees them: a pixel carries the mean of the voxels seen whose
/// centres fall on it, without such one the colour of the first voxel that covers it.
///
/// coordinates, colours   parallel
DrawnView draw_view(const ReferenceView& view, std::span<const Voxel> coordinates,
                    std::span<const Rgba8> colours);

}  // namespace afx
