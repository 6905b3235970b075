// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/surface_samples.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "afx/builder/surface_paint.h"
#include "afx/srgb.h"
#include "codec/parallel.h"

namespace afx {
namespace {

Error refused(std::string text) { return Error{Errc::bad_argument, {}, std::move(text), {}, {}}; }

// A place in the unit square, number `i` of the sequence R2: steps by the powers of the root of
// x^3 = x + 1.
glm::dvec2 r2(size_t i) {
  constexpr double kRoot = 1.32471795724474602596;
  const auto n = static_cast<double>(i + 1);
  const double x = 0.5 + n / kRoot, y = 0.5 + n / (kRoot * kRoot);
  return {x - std::floor(x), y - std::floor(y)};
}

class Sampler {
 public:
  explicit Sampler(const Mesh& mesh) : mesh_(mesh), paint_(mesh) {
    area_up_to_.reserve(mesh.triangles.size());
    double sum = 0;
    for (size_t t = 0; t < mesh.triangles.size(); ++t)
      area_up_to_.push_back(sum += 0.5 * glm::length(across(t)));
  }

  [[nodiscard]] double area() const { return area_up_to_.empty() ? 0 : area_up_to_.back(); }

  // Points `first` to `last` - 1 of `count`.
  [[nodiscard]] PointCloud points(size_t first, size_t last, size_t count) const {
    PointCloud cloud;
    const double step = area() / static_cast<double>(count);
    for (size_t i = first; i < last; ++i) {
      const double at = (static_cast<double>(i) + 0.5) * step;
      const auto found = std::upper_bound(area_up_to_.begin(), area_up_to_.end() - 1, at);
      add(static_cast<size_t>(found - area_up_to_.begin()), r2(i), step, cloud);
    }
    return cloud;
  }

 private:
  [[nodiscard]] glm::dvec3 corner(size_t triangle, int k) const {
    return glm::dvec3(mesh_.positions[mesh_.triangles[triangle][k]]);
  }
  // The normal, twice as long as the area is large.
  [[nodiscard]] glm::dvec3 across(size_t triangle) const {
    const glm::dvec3 a = corner(triangle, 0);
    return glm::cross(corner(triangle, 1) - a, corner(triangle, 2) - a);
  }

  void add(size_t triangle, glm::dvec2 place, double area, PointCloud& cloud) const {
    if (place.x + place.y > 1) place = 1.0 - place;
    const glm::dvec3 normal = across(triangle);
    const double doubled = glm::length(normal);
    const double texels = paint_.texels(triangle) * area / (0.5 * doubled);
    const Paint paint = paint_.at(triangle, {place.x, place.y}, texels);
    if (paint.alpha < static_cast<double>(paint_.material(triangle).alpha_cutoff)) return;
    const glm::dvec3 a = corner(triangle, 0), b = corner(triangle, 1), c = corner(triangle, 2);
    cloud.positions.emplace_back(a + (b - a) * place.x + (c - a) * place.y);
    cloud.normals.emplace_back(normal / doubled);
    if (mesh_.has_colours) cloud.colours.push_back(to_srgb(paint.light / paint.alpha));
  }

  const Mesh& mesh_;
  SurfacePaint paint_;
  std::vector<double> area_up_to_;  // of the triangles up to and with each
};

// The number of points asked for; 0 if none are.
double points_asked(const SurfaceSampling& sampling, double area) {
  if (sampling.points > 0) return static_cast<double>(sampling.points);
  if (!(sampling.spacing > 0)) return 0;
  return std::max(1.0, std::round(area / (sampling.spacing * sampling.spacing)));
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

Result<PointCloud> sample_surface(const Mesh& mesh, const SurfaceSampling& sampling) {
  const Sampler sampler(mesh);
  if (!(sampler.area() > 0)) return refused("the mesh has no surface");
  const double asked = points_asked(sampling, sampler.area());
  if (!(asked > 0)) return refused("neither a number of points nor a spacing is given");
  constexpr double kPointBytes = 2 * (2 * sizeof(glm::vec3) + sizeof(Rgba8));
  if (!(asked * kPointBytes <= static_cast<double>(sampling.limits.memory)))
    return Error{
        Errc::limit_exceeded, {}, "so many points take more memory than the limit", {}, {}};
  const auto count = static_cast<size_t>(asked);
  constexpr size_t kBlock = 4096;
  std::vector<PointCloud> blocks((count + kBlock - 1) / kBlock);
  parallel_for(blocks.size(), sampling.threads, [&](size_t i) {
    blocks[i] = sampler.points(i * kBlock, std::min(count, (i + 1) * kBlock), count);
  });
  PointCloud cloud;
  for (PointCloud& block : blocks) {
    append(cloud.positions, block.positions);
    append(cloud.normals, block.normals);
    append(cloud.colours, block.colours);
    block = PointCloud();  // memory given back at once
  }
  if (cloud.positions.empty()) return refused("all of the surface is transparent");
  return cloud;
}

}  // namespace afx
