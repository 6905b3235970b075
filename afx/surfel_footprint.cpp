// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/surfel_footprint.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace afx {
namespace {

constexpr double kSmall = 1.5;       // pixels along a side
constexpr double kLeastArea = 1e-9;  // in pixels; thinner pieces are seen from their edge

/// The whole numbers from low to high, as far as they are 0 .. count - 1.
void limit(double low, double high, double count, uint32_t& first, uint32_t& end) {
  if (!(low < count) || !(high >= 0)) return;
  first = static_cast<uint32_t>(std::max(std::ceil(low), 0.0));
  end = static_cast<uint32_t>(std::min(std::floor(high) + 1, count));
}

}  // namespace

Error beyond_limit(const std::string& what) {
  return {Errc::limit_exceeded, Place::none(), what + " (more than the limit)"};
}

Status check_depth_bits(unsigned bits, unsigned most) {
  if (bits >= 1 && bits <= most) return {};
  return Error{Errc::bad_argument, Place::none(),
               "the depth has " + std::to_string(bits) + " bits (expected 1 to " +
                   std::to_string(most) + ")"};
}

uint32_t SurfelFootprint::first_row() const {
  if (range.count() == 0) return owns_pixel ? own_j : 0;
  return owns_pixel ? std::min(range.j0, own_j) : range.j0;
}

uint32_t SurfelFootprint::end_row() const { return std::max(range.j1, owns_pixel ? own_j + 1 : 0); }

SurfelCamera::SurfelCamera(const DepthCamera& camera, uint32_t width, uint32_t height)
    : projection_(camera),
      axes_(glm::mat3_cast(glm::normalize(camera.orientation))),
      perspective_(!camera.orthographic),
      width_(width),
      height_(height) {}

double SurfelCamera::pixel_side(double distance) const {
  const glm::dvec2 extent = projection_.extent(distance);
  return std::max(extent.x / width_, extent.y / height_);
}

SurfelFootprint SurfelCamera::footprint(const Surfels& surfels, size_t n) const {
  SurfelFootprint piece;
  const ScreenPoint middle = projection_.project(surfels.centres[n]);
  piece.centre = {middle.u * width_, middle.v * height_};
  piece.distance = middle.distance;
  if (perspective_ && !(middle.distance > 0)) return piece;
  const glm::dvec2 pixels = glm::dvec2(width_, height_) / projection_.extent(middle.distance);
  // A half side in pixels. What of it lies along the line of sight is not seen.
  const glm::dvec2 ray =
      perspective_ ? (piece.centre - 0.5 * glm::dvec2(width_, height_)) : glm::dvec2(0, 0);
  const auto seen = [&](const glm::vec3& half, double& deeper) {
    const glm::dvec3 in_camera = glm::dvec3(half) * axes_;
    deeper = -in_camera.z;
    return glm::dvec2(in_camera) * pixels - ray * (perspective_ ? deeper / middle.distance : 0);
  };
  const glm::dvec2 u = seen(surfels.u[n], piece.deeper_.x);
  const glm::dvec2 v = seen(surfels.v[n], piece.deeper_.y);
  piece.small = std::max(glm::length(u), glm::length(v)) <= kSmall / 2;
  const double cross = u.x * v.y - u.y * v.x;
  piece.area = 4 * cross;
  piece.flat_ = std::abs(piece.area) > kLeastArea;
  if (piece.flat_) {
    piece.s_ = glm::dvec2(v.y, -v.x) / cross;
    piece.t_ = glm::dvec2(-u.y, u.x) / cross;
  }
  if (perspective_) piece.bend_ = piece.deeper_ / middle.distance;
  piece.owns_pixel = piece.centre.x >= 0 && piece.centre.x < width_ && piece.centre.y >= 0 &&
                     piece.centre.y < height_;
  if (piece.owns_pixel) {
    piece.own_i = static_cast<uint32_t>(piece.centre.x);
    piece.own_j = static_cast<uint32_t>(piece.centre.y);
  }
  piece.range = range_around(piece, u, v);
  return piece;
}

PixelRange SurfelCamera::range_around(const SurfelFootprint& piece, const glm::dvec2& u,
                                      const glm::dvec2& v) const {
  // The nearest corner's picture grows most.
  const double nearest = 1 - std::abs(piece.bend_.x) - std::abs(piece.bend_.y);
  PixelRange range{0, static_cast<uint32_t>(width_), 0, static_cast<uint32_t>(height_)};
  if (!(nearest > 0)) return range;
  const glm::dvec2 reach = (glm::abs(u) + glm::abs(v)) * ((1 + 1e-6) / nearest);
  range = {};
  const glm::dvec2 middle = piece.centre - 0.5;  // centres of pixels are whole numbers
  limit(middle.x - reach.x, middle.x + reach.x, width_, range.i0, range.i1);
  limit(middle.y - reach.y, middle.y + reach.y, height_, range.j0, range.j1);
  if (range.i1 <= range.i0 || range.j1 <= range.j0) range = {};
  return range;
}

}  // namespace afx
