// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/octree_colours.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "afx/octree_image_choice.h"
#include "afx/reference_projection.h"
#include "afx/srgb.h"
#include "afx/voxel_blocks.h"
#include "afx/voxel_shading.h"
#include "codec/octree_voxels.h"
#include "codec/parallel.h"

namespace afx {
namespace {

constexpr size_t kChunk = 16384;  // voxels that one task does

/// A sum of colours in linear light.
struct ColourSum {
  glm::dvec3 sum{0};
  uint64_t count = 0;

  void add(Rgba8 c) {
    sum += linear_light(c);
    ++count;
  }
  [[nodiscard]] Rgba8 mean() const { return to_srgb(sum / static_cast<double>(count)); }
};

/// The mean over the area (not empty); transparent pixels count only if there are no others.
Rgba8 mean_colour(const Picture& picture, ReferenceProjection::Area area) {
  ColourSum visible, transparent;
  for (uint32_t j = area.j0; j < area.j1; ++j) {
    for (uint32_t i = area.i0; i < area.i1; ++i) {
      const Rgba8 c = colour_at(picture, i, picture.height - 1 - j);
      (c.a != 0 ? visible : transparent).add(c);
    }
  }
  return visible.count != 0 ? visible.mean() : transparent.mean();
}

/// Colours voxels one by one from pictures of their images, and counts those that fall outside.
class Painter {
 public:
  Painter(const OctreeModel& model, unsigned level) : model_(model), level_(level) {
    finest_ = level == octree_levels(model.resolution);
    for (const ReferenceImage& image : model.images) {
      const Picture& p = image.picture;
      projections_.emplace_back(image, std::max(1U, p.width), std::max(1U, p.height));
    }
  }

  /// Whether the pictures can be read in bounded time.
  [[nodiscard]] Status check(const ColouredVoxels& voxels, unsigned threads) const {
    if (finest_ || projections_.empty()) return {};
    return check_drawable(projections_, voxels.codes, voxels.images, level_, threads);
  }

  [[nodiscard]] bool has_picture(uint8_t number) const {
    return number != 0 && !model_.images[number - 1U].picture.empty();
  }

  /// number   of an image that has a picture, from 1
  Rgba8 paint(uint64_t code, uint8_t number) {
    const ReferenceProjection& projection = projections_[number - 1U];
    const Picture& picture = model_.images[number - 1U].picture;
    const ReferenceProjection::Spot spot = projection.project(voxel_centre(code, level_));
    const ReferenceProjection::Pixel pixel = projection.pixel_at(spot);
    if (!pixel.inside) outside_[number].fetch_add(1, std::memory_order_relaxed);
    if (!finest_) {
      const auto area = projection.square(spot, std::ldexp(1.0, -static_cast<int>(level_)));
      if (area.count() > 1) return mean_colour(picture, area);
    }
    Rgba8 colour = colour_at(picture, pixel.i, picture.height - 1 - pixel.j);
    colour.a = 255;
    return colour;
  }

  void report(Diagnostics& diagnostics) const {
    for (size_t k = 1; k <= model_.images.size(); ++k) {
      const uint64_t count = outside_[k].load();
      if (count == 0) continue;
      diagnostics.warn("voxel_outside_image", Place::none(),
                       std::to_string(count) + " voxels fall outside images[" +
                           std::to_string(k - 1) + "] and take its nearest edge pixel");
    }
  }

 private:
  const OctreeModel& model_;
  unsigned level_;
  bool finest_ = false;
  std::vector<ReferenceProjection> projections_;
  std::array<std::atomic<uint64_t>, 256> outside_{};
};

Status check_model(const OctreeModel& model, unsigned level, const Limits& limits) {
  const unsigned levels = octree_levels(model.resolution);
  if (level > levels) {
    return Error{Errc::bad_argument, Place::none(),
                 "level " + std::to_string(level) + " of an octree of " + std::to_string(levels) +
                     " levels (expected 0 to " + std::to_string(levels) + ")"};
  }
  return check_reference_images(model.images, limits);
}

/// Codes and image numbers of the level, checked against each other and the images.
Result<ColouredVoxels> read_voxels(const OctreeModel& model, unsigned level, const Limits& limits) {
  const unsigned levels = octree_levels(model.resolution);
  ColouredVoxels voxels;
  voxels.level = level;
  auto codes = codec::octree_morton(model.fields.octree, levels, level, limits);
  if (!codes.ok()) return codes.error();
  voxels.codes = std::move(codes).value();
  // What is held at once for each voxel: code, colour, image, normals twice, and what the choice of
  // images needs; 64 bytes are above that.
  if (voxels.codes.size() > std::min<uint64_t>(limits.memory / 64, 0xffffffff)) {
    return Error{Errc::limit_exceeded, Place::none(),
                 std::to_string(voxels.codes.size()) +
                     " voxels are too many to colour (the limit is " +
                     std::to_string(limits.memory) + " bytes)"};
  }
  auto images = codec::octree_voxel_images(model.fields, levels, level, limits);
  if (!images.ok()) return images.error();
  voxels.images = std::move(images).value();
  const auto largest = std::max_element(voxels.images.begin(), voxels.images.end());
  if (largest != voxels.images.end() && *largest > model.images.size()) {
    return Error{Errc::bad_argument, Place::none(),
                 "voxelImageIndex has " + std::to_string(*largest) + " (expected at most " +
                     std::to_string(model.images.size()) + ", the number of images)"};
  }
  return voxels;
}

bool any_zero(std::span<const uint8_t> images) {
  return std::find(images.begin(), images.end(), 0) != images.end();
}

/// Gives every voxel its colour; shaded grey where its image has no picture.
void paint_all(Painter& painter, std::span<const glm::vec3> normals, unsigned threads,
               ColouredVoxels& voxels, uint64_t& without_picture) {
  voxels.colours.resize(voxels.codes.size());
  std::atomic<uint64_t> grey{0};
  parallel_for((voxels.codes.size() + kChunk - 1) / kChunk, threads, [&](size_t chunk) {
    const size_t end = std::min(voxels.codes.size(), (chunk + 1) * kChunk);
    for (size_t i = chunk * kChunk; i < end; ++i) {
      const uint8_t image = voxels.images[i];
      if (painter.has_picture(image)) {
        voxels.colours[i] = painter.paint(voxels.codes[i], image);
      } else {
        voxels.colours[i] = shaded_grey(normals[i]);
        grey.fetch_add(1, std::memory_order_relaxed);
      }
    }
  });
  without_picture = grey.load();
}

}  // namespace

Result<ColouredVoxels> colour_octree(const OctreeModel& model, unsigned level, unsigned threads,
                                     const Limits& limits, Diagnostics& diagnostics) {
  if (const Status s = check_model(model, level, limits); !s.ok()) return s.error();
  auto read = read_voxels(model, level, limits);
  if (!read.ok()) return read.error();
  ColouredVoxels voxels = std::move(read).value();
  Painter painter(model, level);

  const auto has_picture = [&](const ReferenceImage& image) { return !image.picture.empty(); };
  const bool some = std::any_of(model.images.begin(), model.images.end(), has_picture);
  const bool all = std::all_of(model.images.begin(), model.images.end(), has_picture);
  const bool choose = some && any_zero(voxels.images);
  std::vector<glm::vec3> normals;
  if (choose || !some || !all) {
    const VoxelBlocks blocks(voxels.codes);
    if (choose) {
      const Status s =
          choose_images(model.images, voxels.codes, level, voxel_normals(blocks, threads),
                        voxels.images, threads, limits);
      if (!s.ok()) return s.error();
    }
    if (!some || !all) normals = surface_normals(voxels.codes, level, blocks, threads);
  }
  if (const Status s = painter.check(voxels, threads); !s.ok()) return s.error();
  uint64_t without_picture = 0;
  paint_all(painter, normals, threads, voxels, without_picture);
  painter.report(diagnostics);
  if (without_picture != 0 && !model.images.empty()) {
    diagnostics.warn("no_picture", Place::none(),
                     std::to_string(without_picture) +
                         " voxels are drawn in shaded grey: their images have no picture");
  }
  return voxels;
}

}  // namespace afx
