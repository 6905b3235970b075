// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What depth images can be taken of, whatever it is made of.
#pragma once

#include <cstddef>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "afx/builder/grid.h"
#include "afx/builder/mesh.h"
#include "afx/depth_image.h"
#include "afx/shot.h"
#include "codec/error.h"

namespace afx {

/// A model that cameras can look at: a mesh or pieces of surface (view_sources.h). For use by one
/// thread at a time; works with several itself.
class ViewSource {
 public:
  virtual ~ViewSource() = default;

  /// The smallest box around the model in a turned system.
  /// axes   its columns: the directions of the box's sides, of length 1
  [[nodiscard]] virtual Bounds bounds_along(const glm::dmat3& axes) const = 0;

  /// A DepthImage with a SimpleTexture, RGB.
  /// depth_bits   8 or 16
  /// Errors       bad_argument: camera, size or bits; limit_exceeded: more pixels or memory than
  ///              limits
  virtual Result<DepthImage> take(const Shot& shot, unsigned depth_bits) const = 0;

  /// The distances of the nearest surface alone, rows from the top; infinite where there is none.
  virtual Result<std::vector<float>> distances(const Shot& shot) const = 0;

  /// At least some `count` points, if there are as many, spread over the surface, with normals.
  virtual Result<PointCloud> samples(size_t count) const = 0;
};

}  // namespace afx
