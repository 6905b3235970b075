// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/reference_views.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "afx/builder/image_fill.h"
#include "afx/builder/octree_builder.h"
#include "afx/srgb.h"

namespace afx {
namespace {

constexpr uint8_t kX = 0, kY = 1, kZ = 2;
constexpr uint16_t kNothing = std::numeric_limits<uint16_t>::max();

// A view: its camera's turn about x or y, and which voxel coordinates run to the right, up and away
// from the camera (flipped: from the greatest to the least). Follows from turning the axes.
struct ViewRow {
  glm::vec3 to_camera;
  glm::quat turn;  // w, x, y, z
  uint8_t right, up, depth;
  bool right_flipped, up_flipped, depth_flipped;
};

const float kHalf = std::sqrt(0.5F);

const std::array<ViewRow, kReferenceViews> kViews{{
    {{0, 0, 1}, {1, 0, 0, 0}, kX, kY, kZ, false, false, true},
    {{0, 0, -1}, {0, 0, 1, 0}, kX, kY, kZ, true, false, false},
    {{1, 0, 0}, {kHalf, 0, kHalf, 0}, kZ, kY, kX, true, false, true},
    {{-1, 0, 0}, {kHalf, 0, -kHalf, 0}, kZ, kY, kX, false, false, false},
    {{0, 1, 0}, {kHalf, -kHalf, 0, 0}, kX, kZ, kY, false, true, true},
    {{0, -1, 0}, {kHalf, kHalf, 0, 0}, kX, kZ, kY, false, false, false},
}};

// The depth of the first voxel on each pixel, kNothing where there is none.
std::vector<uint16_t> first_depths(const ReferenceView& view, std::span<const Voxel> coordinates) {
  std::vector<uint16_t> depths(size_t{view.size()} * view.size(), kNothing);
  for (const Voxel& voxel : coordinates) {
    const auto depth = static_cast<uint16_t>(view.depth(voxel));
    const auto [low, high] = view.area(voxel);
    for (uint32_t y = low.y; y <= high.y; ++y)
      for (uint32_t x = low.x; x <= high.x; ++x) {
        uint16_t& at = depths[size_t{y} * view.size() + x];
        at = std::min(at, depth);
      }
  }
  return depths;
}

// Colours summed up in linear light, with their number.
struct LightSum {
  float r = 0, g = 0, b = 0;
  float count = 0;
};

void draw_first(const ReferenceView& view, std::span<const Voxel> coordinates,
                std::span<const Rgba8> colours, std::span<const uint16_t> depths,
                Picture& picture) {
  for (size_t i = 0; i < coordinates.size(); ++i) {
    const uint32_t depth = view.depth(coordinates[i]);
    const auto [low, high] = view.area(coordinates[i]);
    for (uint32_t y = low.y; y <= high.y; ++y)
      for (uint32_t x = low.x; x <= high.x; ++x) {
        if (depths[size_t{y} * view.size() + x] != depth) continue;
        uint8_t* to = picture.pixel(x, y);
        to[0] = colours[i].r;
        to[1] = colours[i].g;
        to[2] = colours[i].b;
      }
  }
}

// Where a pixel is wider than a voxel.
void draw_means(const ReferenceView& view, std::span<const Voxel> coordinates,
                std::span<const Rgba8> colours, std::span<const uint16_t> depths,
                Picture& picture) {
  const auto& linear = srgb_to_linear();
  std::vector<LightSum> sums(depths.size());
  for (size_t i = 0; i < coordinates.size(); ++i) {
    const ReferenceView::Pixel at = view.pixel(coordinates[i]);
    const size_t place = size_t{at.y} * view.size() + at.x;
    if (view.depth(coordinates[i]) > depths[place] + view.slack()) continue;
    LightSum& sum = sums[place];
    sum.r += linear[colours[i].r];
    sum.g += linear[colours[i].g];
    sum.b += linear[colours[i].b];
    sum.count += 1;
  }
  for (size_t place = 0; place < sums.size(); ++place) {
    const LightSum& sum = sums[place];
    if (sum.count == 0) continue;
    uint8_t* to = picture.samples.data() + place * 3;
    to[0] = linear_to_srgb(sum.r / sum.count);
    to[1] = linear_to_srgb(sum.g / sum.count);
    to[2] = linear_to_srgb(sum.b / sum.count);
  }
}

}  // namespace

ReferenceImage reference_camera(unsigned view) {
  ReferenceImage image;
  image.position = kViews[view].to_camera * kReferenceDistance;
  image.orientation = kViews[view].turn;
  image.field_of_view = {1, 1};
  return image;
}

glm::vec3 direction_to_camera(unsigned view) { return kViews[view].to_camera; }

ReferenceView::ReferenceView(unsigned view, unsigned levels, uint32_t size)
    : right_{kViews[view].right, kViews[view].right_flipped},
      up_{kViews[view].up, kViews[view].up_flipped},
      depth_{kViews[view].depth, kViews[view].depth_flipped},
      last_((1U << levels) - 1),
      size_(size) {
  const uint32_t voxels = last_ + 1;
  slack_ = (voxels + size - 1) / size - 1;
  const double scale = static_cast<double>(size) / voxels;
  for (uint32_t i = 0; i < voxels; ++i) {
    const auto centre = static_cast<uint32_t>(std::floor((i + 0.5) * scale + 1.0 / 64));
    const auto low = static_cast<uint32_t>(std::floor(i * scale));
    const auto end = static_cast<uint32_t>(std::floor((i + 1) * scale));
    centre_.push_back(std::min(centre, size - 1));
    low_.push_back(std::min(low, centre_.back()));
    high_.push_back(std::max(end > 0 ? end - 1 : 0, centre_.back()));
    if (slack_ > 0) low_.back() = high_.back() = centre_.back();
  }
}

uint32_t ReferenceView::along(Axis axis, const Voxel& voxel) const {
  const uint32_t number = axis.of == kX ? voxel.x : (axis.of == kY ? voxel.y : voxel.z);
  return axis.flipped ? last_ - number : number;
}

ReferenceView::Pixel ReferenceView::pixel(const Voxel& voxel) const {
  return {centre_[along(right_, voxel)], size_ - 1 - centre_[along(up_, voxel)]};
}

uint32_t ReferenceView::depth(const Voxel& voxel) const { return along(depth_, voxel); }

std::pair<ReferenceView::Pixel, ReferenceView::Pixel> ReferenceView::area(
    const Voxel& voxel) const {
  const uint32_t right = along(right_, voxel), up = along(up_, voxel);
  return {Pixel{low_[right], size_ - 1 - high_[up]}, Pixel{high_[right], size_ - 1 - low_[up]}};
}

Picture draw_view(const ReferenceView& view, std::span<const Voxel> coordinates,
                  std::span<const Rgba8> colours, std::span<uint8_t> seen) {
  Picture picture(view.size(), view.size(), 3);
  const std::vector<uint16_t> depths = first_depths(view, coordinates);
  if (view.slack() == 0)
    draw_first(view, coordinates, colours, depths, picture);
  else
    draw_means(view, coordinates, colours, depths, picture);
  for (size_t i = 0; i < coordinates.size(); ++i) {
    const ReferenceView::Pixel at = view.pixel(coordinates[i]);
    const uint16_t first = depths[size_t{at.y} * view.size() + at.x];
    seen[i] = view.depth(coordinates[i]) <= first + view.slack() ? 1 : 0;
  }
  std::vector<bool> shown(depths.size());
  for (size_t i = 0; i < depths.size(); ++i) shown[i] = depths[i] != kNothing;
  fill_unused(picture, shown);
  return picture;
}

}  // namespace afx
