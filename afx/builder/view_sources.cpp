// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/view_sources.h"

#include <glm/common.hpp>
#include <limits>

#include "afx/builder/surface_samples.h"

namespace afx {
namespace {

// A box that grows with the points put in.
class GrowingBounds {
 public:
  void add(const glm::dvec3& point) {
    bounds_.low = glm::min(bounds_.low, point);
    bounds_.high = glm::max(bounds_.high, point);
  }
  [[nodiscard]] const Bounds& bounds() const { return bounds_; }

 private:
  static constexpr double kFar = std::numeric_limits<double>::infinity();
  Bounds bounds_{glm::dvec3(kFar), glm::dvec3(-kFar)};
};

}  // namespace

Bounds MeshViews::bounds_along(const glm::dmat3& axes) const {
  GrowingBounds growing;
  const Mesh& mesh = look_.mesh();
  for (const glm::uvec3& triangle : mesh.triangles)
    for (int k = 0; k < 3; ++k) growing.add(glm::dvec3(mesh.positions[triangle[k]]) * axes);
  return growing.bounds();
}

Result<DepthImage> MeshViews::take(const Shot& shot, unsigned depth_bits) const {
  return draw_depth_image(look_, shot, depth_bits, threads_, limits_);
}

Result<std::vector<float>> MeshViews::distances(const Shot& shot) const {
  return draw_distances(look_, shot, threads_, limits_);
}

Result<PointCloud> MeshViews::samples(size_t count) const {
  return sample_surface(look_.mesh(),
                        {.points = count, .spacing = 0, .threads = threads_, .limits = limits_});
}

}  // namespace afx
