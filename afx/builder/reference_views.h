// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The six reference images that the builder makes: one from each side of the cube.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <utility>
#include <vector>

#include "afx/octree_model.h"
#include "codec/octree.h"

namespace afx {

inline constexpr unsigned kReferenceViews = 6;

/// The camera of view 0..5: +z, -z, +x, -x, +y, -y of the cube, each looking at its centre; y is up
/// in the first four, -z in the image from the top, +z in the one from the bottom. No picture.
ReferenceImage reference_camera(unsigned view);

/// The direction from the object to the camera of a view.
glm::vec3 direction_to_camera(unsigned view);

/// Where voxels lie on the picture of a view, in integers. Gives the pixels of the rule in
/// octree_colours.h for the cameras of reference_camera().
class ReferenceView {
 public:
  /// size   of the picture, both sides
  ReferenceView(unsigned view, unsigned levels, uint32_t size);

  /// Counted from the left and from the top.
  struct Pixel {
    uint32_t x, y;
  };
  /// The pixel that the voxel's centre falls on.
  [[nodiscard]] Pixel pixel(const Voxel& voxel) const;
  /// How many voxels lie between the voxel and the near side of the cube.
  [[nodiscard]] uint32_t depth(const Voxel& voxel) const;
  /// The pixels that the voxel covers, the first and the last of them; at least pixel().
  [[nodiscard]] std::pair<Pixel, Pixel> area(const Voxel& voxel) const;

  [[nodiscard]] uint32_t size() const { return size_; }
  /// Voxels this much behind the first one on a pixel are still seen: where a pixel is wider than
  /// a voxel, a slope has several in one pixel.
  [[nodiscard]] uint32_t slack() const { return slack_; }

 private:
  struct Axis {
    uint8_t of;
    bool flipped;
  };
  [[nodiscard]] uint32_t along(Axis axis, const Voxel& voxel) const;

  Axis right_, up_, depth_;
  uint32_t last_;  // voxel number
  uint32_t size_;
  uint32_t slack_;
  std::vector<uint32_t> centre_, low_, high_;  // by voxel number: pixel from the left or from below
};

/// Draws the voxels as view `view` sees them: each pixel carries the colour of the first voxel on
/// it, or the mean in linear light of those within slack; pixels without one continue the colours
/// around them (image_fill.h). coordinates, colours   parallel seen                   parallel too:
/// becomes 1 for voxels that their pixel shows, otherwise 0
Picture draw_view(const ReferenceView& view, std::span<const Voxel> coordinates,
                  std::span<const Rgba8> colours, std::span<uint8_t> seen);

}  // namespace afx
