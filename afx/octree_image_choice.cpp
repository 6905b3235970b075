// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/octree_image_choice.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <string>
#include <vector>

#include "afx/reference_projection.h"
#include "codec/parallel.h"

namespace afx {
namespace {

constexpr size_t kChunk = 16384;        // voxels that one task does
constexpr double kCosineTie = 1e-6;     // angles closer than that are equal
constexpr double kDepthTie = 1.0 / 64;  // of a voxel side: likewise for depths
constexpr uint32_t kMostBuffer = 8192;  // side of a buffer without a picture
constexpr float kFar = std::numeric_limits<float>::infinity();

/// A voxel whose image is open, and the best ones so far.
struct Candidate {
  uint32_t voxel = 0;
  float cosine = -2;    // of the best image that sees it
  float behind = kFar;  // of the image least far behind
  uint8_t facing = 0;   // those images' numbers, from 1
  uint8_t nearest = 0;
};

class Chooser {
 public:
  Chooser(std::span<const uint64_t> codes, unsigned level, std::span<const glm::vec3> normals,
          unsigned threads)
      : codes_(codes), level_(level), normals_(normals), threads_(threads) {}

  void open(std::span<const uint8_t> images) {
    for (size_t i = 0; i < images.size(); ++i) {
      if (images[i] == 0) candidates_.push_back({.voxel = static_cast<uint32_t>(i)});
    }
  }

  void consider(const ReferenceProjection& projection, uint8_t number);

  void settle(std::span<uint8_t> images) const {
    for (const Candidate& c : candidates_) {
      const uint8_t fallback = c.nearest != 0 ? c.nearest : uint8_t{1};
      images[c.voxel] = c.facing != 0 ? c.facing : fallback;
    }
  }

 private:
  void draw(const ReferenceProjection& projection);
  void judge(const ReferenceProjection& projection, uint8_t number, Candidate& candidate) const;

  template <class Task>
  void in_chunks(size_t count, const Task& task) const {
    parallel_for((count + kChunk - 1) / kChunk, threads_, [&](size_t chunk) {
      for (size_t i = chunk * kChunk; i < std::min(count, (chunk + 1) * kChunk); ++i) task(i);
    });
  }

  [[nodiscard]] double side() const { return std::ldexp(1.0, -static_cast<int>(level_)); }

  std::span<const uint64_t> codes_;
  unsigned level_;
  std::span<const glm::vec3> normals_;
  unsigned threads_;
  std::vector<Candidate> candidates_;
  std::vector<float> buffer_;  // depths, rows from below
};

/// The smaller of both is left at `place`; the order of the calls does not matter.
void keep_nearest(float& place, float depth) {
  const std::atomic_ref<float> shared(place);
  float held = shared.load(std::memory_order_relaxed);
  while (depth < held && !shared.compare_exchange_weak(held, depth, std::memory_order_relaxed)) {
  }
}

void Chooser::draw(const ReferenceProjection& projection) {
  buffer_.assign(size_t{projection.width()} * projection.height(), kFar);
  in_chunks(codes_.size(), [&](size_t i) {
    const glm::dvec3 centre = voxel_centre(codes_[i], level_);
    const auto depth = static_cast<float>(projection.depth(centre));
    const auto area = projection.square(projection.project(centre), side());
    for (uint32_t j = area.j0; j < area.j1; ++j) {
      float* row = buffer_.data() + size_t{j} * projection.width();
      for (uint32_t pixel = area.i0; pixel < area.i1; ++pixel) keep_nearest(row[pixel], depth);
    }
  });
}

void Chooser::judge(const ReferenceProjection& projection, uint8_t number, Candidate& c) const {
  const glm::dvec3 centre = voxel_centre(codes_[c.voxel], level_);
  const auto pixel = projection.pixel_at(projection.project(centre));
  if (!pixel.inside) return;
  const float front = buffer_[size_t{pixel.j} * projection.width() + pixel.i];
  const double behind = double{static_cast<float>(projection.depth(centre))} - double{front};
  if (behind < double{c.behind} - kDepthTie * side()) {
    c.behind = static_cast<float>(behind);
    c.nearest = number;
  }
  const glm::dvec3 normal(normals_[c.voxel]);
  if (normal == glm::dvec3(0) || behind > (1 + kDepthTie) * side()) return;
  const double cosine = glm::dot(normal, projection.to_camera());
  if (cosine > double{c.cosine} + kCosineTie) {
    c.cosine = static_cast<float>(cosine);
    c.facing = number;
  }
}

/// The grids of pixels of the depth buffers, one for each image; none may be beyond the limit.
Result<std::vector<ReferenceProjection>> buffers_of(std::span<const ReferenceImage> reference,
                                                    unsigned level, const Limits& limits) {
  const uint32_t without = std::min(kMostBuffer, uint32_t{1} << level);
  std::vector<ReferenceProjection> buffers;
  for (const ReferenceImage& image : reference) {
    const Picture& picture = image.picture;
    const uint32_t width = picture.empty() ? without : picture.width;
    const uint32_t height = picture.empty() ? without : picture.height;
    if (uint64_t{width} * height > limits.memory / sizeof(float)) {
      return Error{Errc::limit_exceeded, Place::none(),
                   "images[" + std::to_string(buffers.size()) +
                       "] needs a depth buffer beyond the limit of " +
                       std::to_string(limits.memory) + " bytes"};
    }
    buffers.emplace_back(image, width, height);
  }
  return buffers;
}

void Chooser::consider(const ReferenceProjection& projection, uint8_t number) {
  draw(projection);
  in_chunks(candidates_.size(), [&](size_t i) { judge(projection, number, candidates_[i]); });
}

}  // namespace

Status choose_images(std::span<const ReferenceImage> reference, std::span<const uint64_t> codes,
                     unsigned level, std::span<const glm::vec3> normals, std::span<uint8_t> images,
                     unsigned threads, const Limits& limits) {
  if (reference.empty()) return {};
  const Result<std::vector<ReferenceProjection>> buffers = buffers_of(reference, level, limits);
  if (!buffers.ok()) return buffers.error();
  if (Status s = check_drawable(buffers.value(), codes, {}, level, threads); !s.ok()) return s;
  Chooser chooser(codes, level, normals, threads);
  chooser.open(images);
  for (size_t k = 0; k < reference.size(); ++k)
    chooser.consider(buffers.value()[k], static_cast<uint8_t>(k + 1));
  chooser.settle(images);
  return {};
}

}  // namespace afx
