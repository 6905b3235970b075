// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/cloud_compare.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <string>
#include <vector>

#include "afx/builder/grid.h"
#include "afx/builder/nearest_points.h"
#include "afx/builder/point_normals.h"
#include "afx/psnr.h"
#include "codec/parallel.h"

namespace afx {
namespace {

using Nearest = NearestPoints::Nearest;

Error refused(std::string text) { return Error{Errc::bad_argument, {}, std::move(text), {}, {}}; }

Status check(const PointCloud& cloud, const std::string& name) {
  const size_t points = cloud.positions.size();
  if (points == 0) return refused("point cloud " + name + " has no points");
  const auto fits = [points](size_t values) { return values == 0 || values == points; };
  if (!fits(cloud.colours.size()) || !fits(cloud.normals.size()))
    return refused("point cloud " + name + " does not have a colour and a normal for each point");
  return {};
}

Status check(const PointCloud& a, const PointCloud& b, const CloudCompareOptions& options) {
  if (Status status = check(a, "A"); !status.ok()) return status;
  if (Status status = check(b, "B"); !status.ok()) return status;
  if (!(options.peak >= 0) || std::isinf(options.peak))
    return refused("the peak is no positive length");
  constexpr uint64_t kPointBytes = 72, kMostPoints = 0xFFFFFFFF;
  const uint64_t points = uint64_t{a.positions.size()} + b.positions.size();
  if (points > std::min(kMostPoints, options.limits.memory / kPointBytes))
    return Error{
        Errc::limit_exceeded, {}, "to compare the points takes more memory than the limit", {}, {}};
  return {};
}

std::vector<glm::vec3> normals_of(const PointCloud& cloud, const NearestPoints& index,
                                  unsigned threads) {
  if (cloud.normals.empty()) return estimate_normals(cloud.positions, index, threads);
  std::vector<glm::vec3> normals = cloud.normals;
  for (glm::vec3& normal : normals) {
    const double length = glm::length(glm::dvec3(normal));
    normal = length > 0 ? glm::vec3(glm::dvec3(normal) / length) : glm::vec3(0);
  }
  return normals;
}

glm::dvec3 rgb_of(const Rgba8& colour) { return {colour.r, colour.g, colour.b}; }

// A difference of R'G'B' as one of Y'CbCr. Source: Rec. ITU-R BT.709, item 3 (Kr = 0.2126, Kb =
// 0.0722).
glm::dvec3 to_ycbcr(const glm::dvec3& rgb) {
  const double y = 0.2126 * rgb.r + 0.7152 * rgb.g + 0.0722 * rgb.b;
  return {y, (rgb.b - y) / 1.8556, (rgb.r - y) / 1.5748};
}

// What adds up over points.
struct Sums {
  double point = 0, plane = 0;            // squared distances
  double most_point = 0, most_plane = 0;  // the largest of them
  glm::dvec3 ycbcr{0, 0, 0}, rgb{0, 0, 0};

  void add(const Sums& other) {
    point += other.point;
    plane += other.plane;
    most_point = std::max(most_point, other.most_point);
    most_plane = std::max(most_plane, other.most_plane);
    ycbcr += other.ycbcr;
    rgb += other.rgb;
  }
};

// From the points of one cloud to those of another.
class Direction {
 public:
  Direction(const PointCloud& from, const PointCloud& to, const NearestPoints& index)
      : from_(from),
        to_(to),
        index_(index),
        shift_(from.origin - to.origin),
        has_colours_(!from.colours.empty() && !to.colours.empty()) {}

  // normals   of `to`
  // matched   called with each point of `from` and its nearest; from several threads, each point
  //           once; may be empty
  [[nodiscard]] Sums measure(std::span<const glm::vec3> normals, unsigned threads,
                             const std::function<void(size_t, const Nearest&)>& matched) const {
    // Blocks are added in their order, so that the sum does not depend on threads.
    constexpr size_t kBlock = 4096;
    std::vector<Sums> blocks((from_.positions.size() + kBlock - 1) / kBlock);
    parallel_for(blocks.size(), threads, [&](size_t block) {
      const size_t end = std::min(from_.positions.size(), (block + 1) * kBlock);
      for (size_t i = block * kBlock; i < end; ++i) {
        const glm::dvec3 place = glm::dvec3(from_.positions[i]) + shift_;
        const Nearest nearest = index_.nearest(place);
        add_geometry(place, nearest, normals, blocks[block]);
        if (has_colours_) add_colour(i, nearest, blocks[block]);
        if (matched) matched(i, nearest);
      }
    });
    Sums sums;
    for (const Sums& block : blocks) sums.add(block);
    return sums;
  }

 private:
  void add_geometry(const glm::dvec3& place, const Nearest& nearest,
                    std::span<const glm::vec3> normals, Sums& sums) const {
    double plane = 0;
    for (const uint32_t point : nearest.points()) {
      const glm::dvec3 line = place - glm::dvec3(to_.positions[point]);
      const glm::dvec3 normal(normals[point]);
      const double along = glm::dot(line, normal);
      plane += normal == glm::dvec3(0) ? nearest.squared : along * along;
    }
    plane /= static_cast<double>(nearest.count);
    sums.point += nearest.squared;
    sums.plane += plane;
    sums.most_point = std::max(sums.most_point, nearest.squared);
    sums.most_plane = std::max(sums.most_plane, plane);
  }

  void add_colour(size_t point, const Nearest& nearest, Sums& sums) const {
    glm::dvec3 there(0);
    for (const uint32_t other : nearest.points()) there += rgb_of(to_.colours[other]);
    const glm::dvec3 rgb =
        rgb_of(from_.colours[point]) - there / static_cast<double>(nearest.count);
    const glm::dvec3 ycbcr = to_ycbcr(rgb);
    sums.rgb += rgb * rgb;
    sums.ycbcr += ycbcr * ycbcr;
  }

  const PointCloud& from_;
  const PointCloud& to_;
  const NearestPoints& index_;
  glm::dvec3 shift_;
  bool has_colours_;
};

GeometryError geometry_error(double sum, double most, double count, double peak) {
  return {sum / count, std::sqrt(most), psnr_of(sum / count, 3 * peak * peak)};
}

ColourError colour_error(const glm::dvec3& sum, double count) {
  ColourError error{sum / count, {}};
  for (int k = 0; k < 3; ++k) error.psnr[k] = psnr_of(error.mean_squared[k]);
  return error;
}

CloudError error_of(const Sums& sums, size_t points, double peak, bool has_colours) {
  const auto count = static_cast<double>(points);
  CloudError error;
  error.to_point = geometry_error(sums.point, sums.most_point, count, peak);
  error.to_plane = geometry_error(sums.plane, sums.most_plane, count, peak);
  if (!has_colours) return error;
  error.ycbcr = colour_error(sums.ycbcr, count);
  error.rgb = colour_error(sums.rgb, count);
  return error;
}

GeometryError worse(const GeometryError& a, const GeometryError& b) {
  return {std::max(a.mean_squared, b.mean_squared), std::max(a.largest, b.largest),
          std::min(a.psnr, b.psnr)};
}

ColourError worse(const ColourError& a, const ColourError& b) {
  return {glm::max(a.mean_squared, b.mean_squared), glm::min(a.psnr, b.psnr)};
}

CloudError worse(const CloudError& a, const CloudError& b) {
  return {worse(a.to_point, b.to_point), worse(a.to_plane, b.to_plane), worse(a.ycbcr, b.ycbcr),
          worse(a.rgb, b.rgb)};
}

}  // namespace

Result<CloudDifference> compare_clouds(const PointCloud& a, const PointCloud& b,
                                       const CloudCompareOptions& options) {
  if (Status status = check(a, b, options); !status.ok()) return status.error();
  const NearestPoints in_a(a.positions), in_b(b.positions);
  const std::vector<glm::vec3> normals_a = normals_of(a, in_a, options.threads);
  std::vector<glm::vec3> normals_b(b.positions.size());
  const auto take_normal = [&](size_t point, const Nearest& nearest) {
    DirectionMean mean;
    for (const uint32_t other : nearest.points()) mean.add(glm::dvec3(normals_a[other]));
    normals_b[point] = glm::vec3(mean.value());
  };
  const Sums from_b = Direction(b, a, in_a).measure(normals_a, options.threads, take_normal);
  const Sums from_a = Direction(a, b, in_b).measure(normals_b, options.threads, {});
  CloudDifference difference;
  difference.peak = options.peak > 0 ? options.peak : bounds_of(a.positions).longest_side();
  difference.has_colours = !a.colours.empty() && !b.colours.empty();
  difference.a_to_b = error_of(from_a, a.positions.size(), difference.peak, difference.has_colours);
  difference.b_to_a = error_of(from_b, b.positions.size(), difference.peak, difference.has_colours);
  difference.both = worse(difference.a_to_b, difference.b_to_a);
  return difference;
}

}  // namespace afx
