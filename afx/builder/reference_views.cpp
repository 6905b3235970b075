// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/reference_views.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "afx/srgb.h"

namespace afx {
namespace {

// In voxels: of rounding noise.
constexpr float kNoise = 1.0F / 64;

bool is_along_an_axis(const glm::dvec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}) > 1 - 1e-6;
}

// Allows for surfaces that are seen at up to 45 degrees.
float slack_of(const ReferenceProjection& projection, const glm::dvec2& field_of_view,
               double side) {
  const double pixel =
      std::max(field_of_view.x / projection.width(), field_of_view.y / projection.height()) / side;
  const double along_an_axis = std::max(std::ceil(pixel - 1e-4) - 1, 0.0);
  return static_cast<float>(along_an_axis + (is_along_an_axis(projection.to_camera()) ? 0 : 1));
}

// Colours summed up in linear light, with their number.
struct LightSum {
  float r = 0, g = 0, b = 0;
  float count = 0;
};

void set_pixel(uint8_t* to, Rgba8 colour) {
  to[0] = colour.r;
  to[1] = colour.g;
  to[2] = colour.b;
}

}  // namespace

ReferenceView::ReferenceView(const ReferenceCamera& camera, unsigned levels)
    : projection_(camera.image, camera.width, camera.height),
      side_(std::ldexp(1.0, -static_cast<int>(levels))),
      slack_(slack_of(projection_, camera.image.field_of_view, side_)) {}

// As voxel_centre() has it.
glm::dvec3 ReferenceView::centre(const Voxel& v) const {
  return {(v.x + 0.5) * side_ - 0.5, (v.y + 0.5) * side_ - 0.5, (v.z + 0.5) * side_ - 0.5};
}

ReferenceView::Sight ReferenceView::sight(const Voxel& voxel) const {
  const glm::dvec3 point = centre(voxel);
  const ReferenceProjection::Spot spot = projection_.project(point);
  const ReferenceProjection::Pixel at = projection_.pixel_at(spot);
  const ReferenceProjection::Area area = projection_.square(spot, side_);
  const uint32_t bottom = height() - 1;
  const Pixel pixel{at.i, bottom - at.j};
  const auto depth = static_cast<float>(projection_.depth(point) / side_);
  if (area.count() == 0) return {pixel, pixel, pixel, depth};
  return {pixel, {area.i0, bottom - (area.j1 - 1)}, {area.i1 - 1, bottom - area.j0}, depth};
}

ReferenceView::Pixel ReferenceView::pixel(const Voxel& voxel) const {
  const ReferenceProjection::Pixel at = projection_.pixel_at(projection_.project(centre(voxel)));
  return {at.i, height() - 1 - at.j};
}

FirstSeen first_seen(const ReferenceView& view, std::span<const Voxel> coordinates) {
  FirstSeen first{std::vector<float>(view.pixels(), std::numeric_limits<float>::infinity()),
                  std::vector<uint32_t>(view.pixels(), FirstSeen::kNothing)};
  for (size_t i = 0; i < coordinates.size(); ++i) {
    const ReferenceView::Sight sight = view.sight(coordinates[i]);
    for (uint32_t y = sight.first.y; y <= sight.last.y; ++y)
      for (uint32_t x = sight.first.x; x <= sight.last.x; ++x) {
        const size_t place = view.place({x, y});
        if (!(sight.depth < first.depth[place])) continue;
        first.depth[place] = sight.depth;
        first.voxel[place] = static_cast<uint32_t>(i);
      }
  }
  return first;
}

bool is_seen(const ReferenceView& view, const ReferenceView::Sight& sight, const FirstSeen& first) {
  return sight.depth <= first.depth[view.place(sight.pixel)] + view.slack() + kNoise;
}

void draw_voxels(const ReferenceView& view, std::span<const Voxel> coordinates,
                 std::span<const Rgba8> colours, const std::function<bool(size_t)>& in,
                 Picture& picture, std::vector<bool>& drawn) {
  const auto& linear = srgb_to_linear();
  std::vector<LightSum> sums(view.pixels());
  for (size_t i = 0; i < coordinates.size(); ++i) {
    if (!in(i)) continue;
    LightSum& sum = sums[view.place(view.pixel(coordinates[i]))];
    sum.r += linear[colours[i].r];
    sum.g += linear[colours[i].g];
    sum.b += linear[colours[i].b];
    sum.count += 1;
  }
  for (size_t place = 0; place < sums.size(); ++place) {
    const LightSum& sum = sums[place];
    if (sum.count == 0) continue;
    drawn[place] = true;
    set_pixel(picture.samples.data() + place * 3,
              {linear_to_srgb(sum.r / sum.count), linear_to_srgb(sum.g / sum.count),
               linear_to_srgb(sum.b / sum.count), 255});
  }
}

DrawnView draw_view(const ReferenceView& view, std::span<const Voxel> coordinates,
                    std::span<const Rgba8> colours) {
  DrawnView result{Picture(view.width(), view.height(), 3), std::vector<bool>(view.pixels()),
                   std::vector<bool>(coordinates.size())};
  const FirstSeen first = first_seen(view, coordinates);
  for (size_t place = 0; place < first.voxel.size(); ++place) {
    if (first.voxel[place] == FirstSeen::kNothing) continue;
    result.drawn[place] = true;
    set_pixel(result.picture.samples.data() + place * 3, colours[first.voxel[place]]);
  }
  for (size_t i = 0; i < coordinates.size(); ++i)
    result.seen[i] = is_seen(view, view.sight(coordinates[i]), first);
  draw_voxels(
      view, coordinates, colours, [&](size_t i) { return result.seen[i]; }, result.picture,
      result.drawn);
  return result;
}

}  // namespace afx
