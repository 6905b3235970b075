// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/mesh_surfels.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>
#include <vector>

#include "afx/builder/mesh_raster.h"
#include "afx/builder/view_plan.h"
#include "afx/builder/view_sources.h"
#include "afx/plane_cell.h"
#include "codec/parallel.h"

namespace afx {
namespace {

// Two grids meet without a gap only where both sample: so along every axis that a triangle faces
// nearly as much as the one it faces most.
bool faces(const glm::dvec3& normal, int axis) {
  constexpr double kNearly = 0.9;
  const glm::dvec3 part = glm::abs(normal);
  const double most = std::max({part.x, part.y, part.z});
  return most > 0 && part[axis] >= kNearly * most;
}

// The pieces of the triangles that face one axis.
class AxisSampler {
 public:
  AxisSampler(const MeshLook& look, const Shot& shot, int axis, double pixel,
              const MeshRaster& raster, uint64_t most)
      : look_(look),
        shot_(shot),
        projection_(shot.camera),
        axis_(axis),
        pixel_(pixel),
        raster_(raster),
        most_(most),
        found_(raster_.bands()) {}

  // Samples all bands; false if there are more pieces than `most`.
  bool run(unsigned threads) {
    parallel_for(raster_.bands(), threads,
                 [this](size_t band) { sample(static_cast<uint32_t>(band)); });
    return count_ <= most_;
  }

  void append_to(Surfels& surfels) {
    for (Surfels& band : found_) {
      for (size_t i = 0; i < band.size(); ++i)
        surfels.push_back(band.centres[i], band.u[i], band.v[i], band.colours[i]);
      band = {};
    }
  }

 private:
  void sample(uint32_t band) {
    Surfels& found = found_[band];
    uint32_t last = ~0U;
    glm::dvec3 normal(0);
    double texels = 0;
    raster_.for_each(band, [&](const Fragment& f) {
      if (count_ > most_) return;
      if (f.triangle != last) {
        last = f.triangle;
        normal = look_.normal(f.triangle);
        texels = look_.texel_density(f.triangle) * pixel_ * pixel_ /
                 std::max(0.5, std::abs(normal[axis_]));
      }
      if (!faces(normal, axis_)) return;
      const SeenSurface seen{f.distance, f.triangle, static_cast<float>(f.b),
                             static_cast<float>(f.c)};
      if (!look_.is_there(seen)) return;
      ++count_;
      const HalfSides half = plane_cell(normal, axis_, pixel_ / 2);
      const ScreenPoint at{(f.x + 0.5) / shot_.width, 1 - (f.y + 0.5) / shot_.height, f.distance};
      found.push_back(projection_.point(at), glm::vec3(half.u), glm::vec3(half.v),
                      look_.colour(seen, texels));
    });
  }

  const MeshLook& look_;
  const Shot& shot_;
  CameraProjection projection_;
  int axis_;
  double pixel_;
  const MeshRaster& raster_;
  uint64_t most_;
  std::vector<Surfels> found_;  // by band
  std::atomic<uint64_t> count_ = 0;
};

}  // namespace

Result<Surfels> surfels_of(const MeshLook& look, uint32_t resolution, unsigned threads,
                           const Limits& limits) {
  const MeshViews views(look, threads, limits);
  const double pixel = longest_side(views) / resolution;
  const uint64_t most = limits.memory / kSurfelBytes / 2;
  Surfels surfels;
  for (int axis = 2; axis >= 0; --axis) {
    glm::dvec3 direction(0);
    direction[axis] = 1;
    const Shot shot = view_from(views, direction, {resolution, true});
    const auto raster =
        MeshRaster::of(look.mesh(), shot.camera, shot.width, shot.height, threads, limits);
    if (!raster.ok()) return raster.error();
    AxisSampler sampler(look, shot, axis, pixel, raster.value(), most - surfels.size());
    if (!sampler.run(threads))
      return Error{Errc::limit_exceeded, Place::none(),
                   "the surface has more than " + std::to_string(most) + " samples"};
    sampler.append_to(surfels);
  }
  return surfels;
}

}  // namespace afx
