// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/reference_projection.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "codec/octree_voxels.h"
#include "codec/parallel.h"

namespace afx {
namespace {

Error bad_image(size_t number, const std::string& finding) {
  return {Errc::bad_argument, Place::none(), "images[" + std::to_string(number) + "]" + finding};
}

Status check_camera(const ReferenceImage& image, size_t number) {
  const glm::vec2 fov = image.field_of_view;
  if (!(fov.x > 0 && fov.y > 0 && std::isfinite(fov.x) && std::isfinite(fov.y))) {
    return bad_image(number, "/fieldOfView is " + std::to_string(fov.x) + " " +
                                 std::to_string(fov.y) + " (expected two lengths > 0)");
  }
  const glm::vec3 p = image.position;
  if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
    return bad_image(number, "/position is not finite");
  }
  const glm::dquat q(image.orientation);
  const double length = glm::dot(q, q);
  if (!std::isfinite(length) || !(length > 0)) {
    return bad_image(number, "/orientation is not a rotation");
  }
  return {};
}

Status check_picture(const Picture& picture, size_t number, const Limits& limits) {
  if (picture.empty()) return {};
  const uint64_t pixels = uint64_t{picture.width} * picture.height;
  if (pixels > limits.picture_pixels) {
    return Error{Errc::limit_exceeded, Place::none(),
                 "images[" + std::to_string(number) + "] has " + std::to_string(pixels) +
                     " pixels (the limit is " + std::to_string(limits.picture_pixels) + ")"};
  }
  if (picture.components < 1 || picture.components > 4) {
    return bad_image(
        number, " has " + std::to_string(picture.components) + " components (expected 1 to 4)");
  }
  if (picture.samples.size() != pixels * picture.components) {
    return bad_image(number, " has " + std::to_string(picture.samples.size()) +
                                 " samples (expected " +
                                 std::to_string(pixels * picture.components) + ")");
  }
  return {};
}

/// floor(at + 1/64) in [0, size); up to 1/64 beyond the far edge is the last.
uint32_t pixel_along(double at, uint32_t size, bool& inside) {
  const double slack = ReferenceProjection::kSlack;
  if (!(at >= -slack)) {
    inside = false;
    return 0;
  }
  const double pixel = std::floor(at + slack);
  if (pixel < size) return static_cast<uint32_t>(pixel);
  if (at > size + slack) inside = false;
  return size - 1;
}

/// The pixels that [at - half, at + half] overlaps by more than the slack, and the one of `at`.
void pixels_along(double at, double half, uint32_t size, uint32_t& first, uint32_t& end) {
  const double slack = ReferenceProjection::kSlack;
  const double own = std::floor(at + slack);
  const double low = std::min(own, std::floor(at - half + slack));
  const double high = std::max(own + 1, std::ceil(at + half - slack));
  first = static_cast<uint32_t>(std::clamp(low, 0.0, static_cast<double>(size)));
  end = static_cast<uint32_t>(std::clamp(high, 0.0, static_cast<double>(size)));
  // A centre up to the slack beyond the far edge belongs to the last pixel.
  if (first == size && at <= size + slack) first = size - 1, end = size;
}

constexpr auto kMost = static_cast<double>(kMostPixelsTouched);

/// No voxel touches more pixels of the image than this.
double most_of_a_voxel(const ReferenceProjection& projection, unsigned level) {
  const ReferenceProjection::Area largest =
      projection.square({0.5 * projection.width(), 0.5 * projection.height()},
                        std::ldexp(1.0, -static_cast<int>(level)));
  return static_cast<double>(largest.i1 - largest.i0 + uint64_t{2}) *
         static_cast<double>(largest.j1 - largest.j0 + uint64_t{2});
}

/// No more pixels are touched, if each voxel is drawn on all images, or on one.
double most_of_all(std::span<const ReferenceProjection> projections, size_t voxels,
                   unsigned level) {
  double sum = 0;
  for (const ReferenceProjection& p : projections) sum += most_of_a_voxel(p, level);
  return sum * static_cast<double>(voxels);
}
double most_of_one(std::span<const ReferenceProjection> projections, size_t voxels,
                   unsigned level) {
  double most = 0;
  for (const ReferenceProjection& p : projections) most = std::max(most, most_of_a_voxel(p, level));
  return most * static_cast<double>(voxels);
}

}  // namespace

Status check_reference_images(std::span<const ReferenceImage> reference, const Limits& limits) {
  if (reference.size() > 255) {
    return Error{Errc::bad_argument, Place::none(),
                 std::to_string(reference.size()) + " images (expected at most 255)"};
  }
  for (size_t k = 0; k < reference.size(); ++k) {
    if (Status s = check_camera(reference[k], k); !s.ok()) return s;
    if (Status s = check_picture(reference[k].picture, k, limits); !s.ok()) return s;
  }
  return {};
}

ReferenceProjection::ReferenceProjection(const ReferenceImage& image, uint32_t width,
                                         uint32_t height)
    : position_(image.position),
      scale_x_(width / double{image.field_of_view.x}),
      scale_y_(height / double{image.field_of_view.y}),
      width_(width),
      height_(height) {
  const glm::dquat q = glm::normalize(glm::dquat(image.orientation));
  right_ = q * glm::dvec3(1, 0, 0);
  up_ = q * glm::dvec3(0, 1, 0);
  back_ = q * glm::dvec3(0, 0, 1);
}

ReferenceProjection::Spot ReferenceProjection::project(const glm::dvec3& point) const {
  const glm::dvec3 from = point - position_;
  return {glm::dot(from, right_) * scale_x_ + 0.5 * width_,
          glm::dot(from, up_) * scale_y_ + 0.5 * height_};
}

double ReferenceProjection::depth(const glm::dvec3& point) const { return -glm::dot(point, back_); }

ReferenceProjection::Pixel ReferenceProjection::pixel_at(Spot place) const {
  Pixel pixel;
  pixel.i = pixel_along(place.x, width_, pixel.inside);
  pixel.j = pixel_along(place.y, height_, pixel.inside);
  return pixel;
}

ReferenceProjection::Area ReferenceProjection::square(Spot place, double side) const {
  Area area;
  pixels_along(place.x, side / 2 * scale_x_, width_, area.i0, area.i1);
  pixels_along(place.y, side / 2 * scale_y_, height_, area.j0, area.j1);
  return area;
}

glm::dvec3 voxel_centre(uint64_t code, unsigned level) {
  const Voxel v = codec::morton_decode(code);
  const double side = std::ldexp(1.0, -static_cast<int>(level));
  return {(v.x + 0.5) * side - 0.5, (v.y + 0.5) * side - 0.5, (v.z + 0.5) * side - 0.5};
}

Status check_drawable(std::span<const ReferenceProjection> projections,
                      std::span<const uint64_t> codes, std::span<const uint8_t> images,
                      unsigned level, unsigned threads) {
  if (images.empty() ? most_of_all(projections, codes.size(), level) <= kMost
                     : most_of_one(projections, codes.size(), level) <= kMost)
    return {};
  constexpr size_t kChunk = 4096;
  const double side = std::ldexp(1.0, -static_cast<int>(level));
  std::atomic<uint64_t> pixels{0};
  const auto touched = [&](const ReferenceProjection& projection, uint64_t code) {
    const auto area = projection.square(projection.project(voxel_centre(code, level)), side);
    return std::max<uint64_t>(area.count(), 1);
  };
  parallel_for((codes.size() + kChunk - 1) / kChunk, threads, [&](size_t chunk) {
    // Once there are too many, how many does not matter; whether there are does not depend on
    // order.
    if (pixels.load() > kMostPixelsTouched) return;
    const size_t end = std::min(codes.size(), (chunk + 1) * kChunk);
    uint64_t sum = 0;
    for (size_t i = chunk * kChunk; i < end && sum <= kMostPixelsTouched; ++i) {
      if (!images.empty() && images[i] != 0) sum += touched(projections[images[i] - 1U], codes[i]);
      for (size_t k = 0; images.empty() && k < projections.size(); ++k)
        sum += touched(projections[k], codes[i]);
    }
    pixels += sum;
  });
  if (pixels.load() <= kMostPixelsTouched) return {};
  return Error{Errc::limit_exceeded, Place::none(),
               "the voxels cover more than 2^31 pixels of the " +
                   std::to_string(projections.size()) +
                   " images (a field of view is very small, or the images are too many)"};
}

}  // namespace afx
